/* swim.h -- moves a fish, which turns at a bounded rate, beats its tail, glides and keeps its
 * depth. */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/collision/box.h"
#include "core/tank/fish.h"

/* Time constant with which a fish that glides (does not beat its tail) loses speed. */
#define SWIM_GLIDE_TAU_S 0.55f

/* Walls and bowls near a fish, combined into one direction from which the fish turns away.
 * Therefore a fish in a corner turns away from both walls at once, instead of from one wall toward
 * the other. All zeros mean that no wall or bowl is near. */
struct swim_avoidance {
    /* Sum of the horizontal unit vectors that point into the walls and bowls, each multiplied by a
     * weight [0, 1] that grows as the distance of the wall or bowl falls. */
    vec3 into;
    /* Weight [0, 1] of the nearest wall or bowl. 1 means that the fish's nose touches the wall or
     * bowl. */
    float weight;
};

/* Includes a wall or bowl in `avoidance`. `normal` is the horizontal unit vector that points into
 * the wall or bowl. `gap_m` is the distance from the fish's centre to the wall or bowl. */
void swim_avoid_add(struct swim_avoidance *avoidance, const struct fish *fish,
                    const struct behavior_params *params, vec3 normal, float gap_m);

/* Includes the walls of a tank of `size_m` in `avoidance`. */
void swim_avoid_walls(struct swim_avoidance *avoidance, const struct fish *fish,
                      const struct behavior_params *params, vec3 size_m);

/* Turns the fish's heading along the walls and bowls of `avoidance` and slightly away from these
 * walls and bowls. `dt_s` is the time since the last call. */
void swim_avoid_turn(struct fish *fish, const struct swim_avoidance *avoidance, float dt_s);

/* Converts the decisions of the fish (gait, depth, avoidance) into the goals in struct fish. */
void swim_resolve(struct fish *fish, const struct perception *around);

/* Changes the goals of a fish that a shade on the water attracts; called after swim_resolve(). The
 * fish moves at `speed_goal_m_s`, even in GAIT_REST, and turns at least as fast as a swimming
 * fish. */
void swim_resolve_drawn(struct fish *fish, float speed_goal_m_s);

/* Advances a fish by one tick according to its goals: the fish turns, climbs, accelerates or
 * glides, and moves.
 *
 * The velocity in this tick is the sum of the velocity of the fish's own swimming (forward and
 * climb) and `push_m_s` (fish.h), the velocity that other fish and the flow add. The magnitude of
 * the sum is limited to gait_speed_max_m_s(). If the fish's own forward or climb speed is higher,
 * for example in a burst or an escape, the sum is limited to that speed instead. The own speed
 * decays below gait_speed_max_m_s() within half a second after the burst or the escape.
 *
 * Returns the largest distance that any point of the body moved, m. */
float swim_move(struct fish *fish, const struct behavior_params *params);

/* Advances a fish in the air by one tick, for example a fish that a poi dropped. Returns true if
 * the fish is not yet completely in the water. Otherwise returns false and changes nothing. */
bool swim_fall(struct fish *fish);

/* Computes the velocity of a fish from its real motion in the tick, `moved_m`. Adapts the tail beat
 * and the bend to the velocity. `forward` is the unit vector along the fish's forward axis. */
void swim_settle(struct fish *fish, vec3 moved_m, vec3 forward);

/* Distance that is added to `way_m` (struct shoal) of a fish to force a new broad-phase query, the
 * search for nearby fish. The distance is longer than any tank. */
#define SWIM_FAR_M 1000.0f

/* Data of all fish of a tank. Element i of each array belongs to fish i. */
struct shoal {
    struct fish *fish;
    /* Bodies of the swimming fish. The functions below leave the bodies of all other fish
     * unchanged. */
    struct body *body;
    /* Distance that each body may have moved since the last broad-phase query: the sum, over the
     * ticks, of the largest distance that any point of the body moved. */
    float *way_m;
    /* Positions of the fish at the start of the tick. SIMD code reads one element beyond the
     * last. */
    const vec3 *before_m;
    uint32_t count;
    const struct behavior_params *params;
    float space; /* Width of the personal space around the body of a fish, in body lengths. */
};

/* Calls swim_move() for all swimming fish and updates their bodies. `lanes` is the number of SIMD
 * lanes: 4, 8, or 0 for the default (4). SIMD code processes a block of this number of fish if the
 * whole block swims. For a falling fish the function only updates the body, and adds SWIM_FAR_M to
 * `way_m`, which forces a new search for nearby fish. */
void swim_move_all(const struct shoal *shoal, uint32_t lanes);

/* Moves every swimming fish to the position of its body, adds the distance to `way_m`, and calls
 * swim_settle(). */
void swim_settle_all(const struct shoal *shoal, uint32_t lanes);
