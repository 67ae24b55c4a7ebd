/* swim.h -- the motion of a fish, which turns at a bounded rate, beats its tail, glides and keeps
 * its depth. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SWIM_H
#define KINGYO_CORE_TANK_BEHAVIOR_SWIM_H

#include "core/tank/behavior_params.h"
#include "core/tank/collision/box.h"
#include "core/tank/fish.h"

/* Time constant with which a fish without tail beats loses speed. A gliding koi has a quarter of
 * the drag of a koi that beats its tail. */
#define SWIM_GLIDE_TAU_S 0.55f

/* Surfaces near a fish, added into one sum. A surface is a wall or a bowl. With the sum, a fish
 * avoids a corner as one obstacle and does not turn back and forth between two walls. All zeros
 * mean that no surface is near. */
struct swim_avoidance {
    vec3 into;    /* Weighted sum of the horizontal unit normals that point into the walls and
                     bowls. */
    float weight; /* Weight [0, 1] of the nearest wall or bowl. 1 means that the fish's nose touches
                     the surface. */
};

/* Adds the surface of a wall or bowl to `avoidance`. `normal` (unit, horizontal) points into the
 * surface. `gap_m` is the distance of the surface from the fish's centre. */
void swim_avoid_add(struct swim_avoidance *avoidance, const struct fish *fish,
                    const struct behavior_params *params, vec3 normal, float gap_m);

/* Adds the walls of a tank of `size_m` to `avoidance`. */
void swim_avoid_walls(struct swim_avoidance *avoidance, const struct fish *fish,
                      const struct behavior_params *params, vec3 size_m);

/* Turns the fish's heading along the walls and bowls of `avoidance` and a little away from them.
 * `dt_s` is the time since the last call. */
void swim_avoid_turn(struct fish *fish, const struct swim_avoidance *avoidance, float dt_s);

/* Converts the decisions of the fish (gait, depth, avoidance) into the goals in struct fish. */
void swim_resolve(struct fish *fish, const struct perception *around);

/* Applies the attraction of shades to the goals; called after swim_resolve(). The fish moves at
 * `speed_goal_m_s`, even in GAIT_REST, and turns at least as fast as a swimming fish. */
void swim_resolve_drawn(struct fish *fish, float speed_goal_m_s);

/* Advances a fish by one tick according to its goals: the fish turns, climbs, accelerates or
 * glides, and moves. The speed including pushes is at most gait_speed_max_m_s(), or the fish's own
 * speed if that is higher. Speed above the limit after a burst or an escape decays within half a
 * second. Returns the largest distance that any point of the body moved, m. */
float swim_move(struct fish *fish, const struct behavior_params *params);

/* Advances a fish in the air by one tick, for example a fish that a poi dropped. Returns 1 if the
 * fish is not yet completely in the water. Otherwise returns 0 and changes nothing. */
int swim_fall(struct fish *fish);

/* Computes the velocity of a fish from its real motion in the tick, `moved_m`. Adapts the tail beat
 * and the bend to the velocity. `forward` is the unit vector along the fish's forward axis. */
void swim_settle(struct fish *fish, vec3 moved_m, vec3 forward);

#define SWIM_FAR_M 1000.0f /* A distance longer than any tank. */

/* All fish of a tank as arrays that are indexed by fish. */
struct shoal {
    struct fish *fish;
    struct body *body;    /* Bodies of the swimming fish. The functions below leave the bodies of
                             all other fish unchanged. */
    float *way_m;         /* Sum of the largest distances that any point of a body moved since the
                             last query. */
    const vec3 *before_m; /* Positions at the start of the tick. SIMD code reads one element beyond
                             the last. */
    uint32_t count;
    const struct behavior_params *params;
    float space; /* Personal space beyond the body, in body lengths. */
};

/* Calls swim_move() for all swimming fish and updates their bodies. `lanes` is 0, 4 or 8. SIMD code
 * processes a block of `lanes` fish if the whole block swims. For a falling fish the function only
 * updates the body and adds SWIM_FAR_M to `way_m`. */
void swim_move_all(const struct shoal *shoal, uint32_t lanes);

/* Moves every swimming fish to the position of its body, adds the distance to `way_m`, and calls
 * swim_settle(). */
void swim_settle_all(const struct shoal *shoal, uint32_t lanes);

#endif
