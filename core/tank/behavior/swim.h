/* swim.h -- the motion of a fish: turns at a bounded rate, beats and glides, keeps its depth. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SWIM_H
#define KINGYO_CORE_TANK_BEHAVIOR_SWIM_H

#include "core/tank/behavior/perception.h"
#include "core/tank/collision/body.h"
#include "core/tank/fish.h"

#define SWIM_GLIDE_TAU_S 0.55f /* Koi: the drag of a glide is a quarter of that of a burst. */

/* The surfaces in front of a fish. Every near surface adds to the sum, so that a fish leaves a
 * corner as one obstacle instead of turning back and forth between two walls. Zero is open
 * water. */
struct swim_avoidance {
    vec3 into;    /* Weighted sum of the horizontal unit normals into the surfaces. */
    float weight; /* [0, 1] weight of the nearest surface. */
};

/* Adds a surface. `normal` (unit, horizontal) points into it; `gap_m` is its distance from the
 * fish's centre. */
void swim_avoid_add(struct swim_avoidance *avoidance, const struct fish *fish,
                    const struct behavior_params *params, vec3 normal, float gap_m);

/* Adds the walls of a tank of `size_m`. */
void swim_avoid_walls(struct swim_avoidance *avoidance, const struct fish *fish,
                      const struct behavior_params *params, vec3 size_m);

/* Bends the heading along the surfaces and a little away from them; `dt_s` is the time since the
 * last call. */
void swim_avoid_turn(struct fish *fish, const struct swim_avoidance *avoidance, float dt_s);

/* Converts the decisions of the fish (gait, depth, avoidance) into its goals; see struct fish. */
void swim_resolve(struct fish *fish, const struct perception *around);

/* Applies an attraction after swim_resolve(). The fish moves at `speed_goal_m_s`, even out of a
 * rest, and turns like a swimming fish. */
void swim_resolve_drawn(struct fish *fish, float speed_goal_m_s);

/* Advances one tick by the fish's goals: turns, climbs, accelerates or glides, and moves. The
 * horizontal speed, pushes included, is at most gait_speed_max_m_s(), or the fish's own speed if
 * that is higher. The excess of a burst or an escape decays within half a second. Returns the
 * largest distance that any point of the body moved. */
float swim_move(struct fish *fish, const struct behavior_params *params);

/* Advances a fish out of the water (dropped from a poi): it falls, and swims away once it is in the
 * water. Returns 1 if it was in the air. */
int swim_fall(struct fish *fish);

/* Computes the true velocity from the true motion after pushes; tail and body follow it. `forward`
 * is along the nose. */
void swim_settle(struct fish *fish, vec3 moved_m, vec3 forward);

#define SWIM_FAR_M 1000.0f /* Longer than any tank. */

/* All fish of a tank, in columns that are indexed by fish. */
struct shoal {
    struct fish *fish;
    struct body *body;    /* Bodies of the fish that swim; other bodies are unchanged. */
    float *way_m;         /* Largest distance that any point of a body moved; accumulates. */
    const vec3 *before_m; /* Positions at the start of the tick; SIMD code reads one element beyond
                             the last. */
    uint32_t count;
    const struct behavior_params *params;
    float space; /* Personal space beyond the body, in body lengths. */
};

/* Runs swim_move() for all swimming fish and updates their bodies. Blocks of `lanes` fish (0, 4 or
 * 8) use SIMD if all fish of the block swim. A falling fish gets only its body and a distance of
 * SWIM_FAR_M. */
void swim_move_all(const struct shoal *shoal, uint32_t lanes);

/* Moves all swimming fish to their bodies, adds that motion to `way_m`, and settles them. */
void swim_settle_all(const struct shoal *shoal, uint32_t lanes);

#endif
