/* swim.h -- how a fish moves: turns at a bounded rate, beats and glides, holds its depth. */
#ifndef KINGYO_CORE_TANK_SWIM_H
#define KINGYO_CORE_TANK_SWIM_H

#include "core/tank/body.h"
#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

#define SWIM_GLIDE_TAU_S 0.55f /* Koi: drag while gliding is a quarter of that in a burst. */

/* What a fish would run into: every near surface adds to it, so that a corner is one thing to leave
 * and not two walls that send it back and forth. Zero is open water. */
struct swim_shun {
    vec3 into;    /* Sum of horizontal unit normals into the surfaces, by weight. */
    float weight; /* [0, 1] of the nearest. */
};

/* `normal` (unit, horizontal) points into a surface, `gap_m` from the fish's centre. */
void swim_shun_add(struct swim_shun *shun, const struct fish *fish, const struct law *law,
                   vec3 normal, float gap_m);

/* The walls of a tank of `size_m`. */
void swim_shun_walls(struct swim_shun *shun, const struct fish *fish, const struct law *law,
                     vec3 size_m);

/* Bends the heading along the surfaces and a little away from them, `dt_s` after it last did. */
void swim_shun_turn(struct fish *fish, const struct swim_shun *shun, float dt_s);

/* Turns what the fish wants (gait, depth, giving way) into its orders; see struct fish. */
void swim_resolve(struct fish *fish, const struct surroundings *around);

/* After that: something draws it on at `speed_goal_m_s`, even out of its rest, and it turns as one
 * who swims. */
void swim_resolve_drawn(struct fish *fish, float speed_goal_m_s);

/* One tick by the fish's orders: turns, climbs, speeds up or glides, and moves. The horizontal
 * speed, pushes included, is at most gait_speed_max_m_s(), or the fish's own when that is more:
 * what is left of a burst or an escape runs out within half a second. Returns how far any point of
 * its body came, at most. */
float swim_move(struct fish *fish, const struct law *law);

/* A fish out of the water (dropped from a poi): falls, and gets away once it is in. Returns whether
 * it was in the air. */
int swim_fall(struct fish *fish);

/* After pushes: true velocity from the true move, then tail and body follow it. `forward` is along
 * the nose. */
void swim_settle(struct fish *fish, vec3 moved_m, vec3 forward);

#define SWIM_FAR_M 1000.0f /* Farther than any tank is long. */

/* All fish of a tank, in columns that are indexed by fish. */
struct shoal {
    struct fish *fish;
    struct body *body;    /* Of those that swim; the others' are left alone. */
    float *way_m;         /* How far any point of a body came, at most: grows. */
    const vec3 *before_m; /* Where they were when the tick began, and one more to read beyond. */
    uint32_t count;
    const struct law *law;
    float space; /* Personal space beyond the body, in body lengths. */
};

/* swim_move() for all that swim, and their bodies: by blocks of `lanes` fish (0, 4 or 8) where all
 * of a block swim, else one by one. Who falls only gets its body, and has come SWIM_FAR_M. */
void swim_move_all(const struct shoal *shoal, uint32_t lanes);

/* Takes all that swim to where their bodies are now, which is way too, and settles them. */
void swim_settle_all(const struct shoal *shoal, uint32_t lanes);

#endif
