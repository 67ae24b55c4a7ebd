/* aim.h -- which fish to go for, and by which way: geometry on what an eye has seen.
 *
 * A way goes from over the water down to a stop beside the fish and under it, then level until the
 * fish is over the place of the paper that it shall lie on. */
#ifndef KINGYO_CORE_GAME_AIM_H
#define KINGYO_CORE_GAME_AIM_H

#include <stdint.h>

#include "core/game/look.h"
#include "core/game/technique.h"

#define AIM_RING_M 0.0465f     /* The poi's outer radius, as everybody knows it. */
#define AIM_UNDER_M 0.020f     /* The ring's depth below the fish's middle. */

struct aim_way {
    float yaw_rad;
    vec3 entry_m; /* Over the water, */
    vec3 stop_m;  /* under it, beside the fish, */
    vec3 under_m; /* the ring's centre when the fish is over its place. */
};

/* Toward the far edge of a poi that is held so. */
vec3 aim_forward(float yaw_rad);

/* The way to a fish at `fish_m` for a handle turned by `yaw_rad`. Returns whether walls, floor and
 * the own bowl leave room for it. */
int aim_way_to(const struct technique *technique, const struct look *look, vec3 fish_m,
               float length_m, float yaw_rad, struct aim_way *way);

/* The fish that costs a hand at `hand_m` the least time to bring home, of those that were seen
 * near, or null; with the yaw to take it with. `age_s` is how old the look is. */
const struct look_fish *aim_choose(const struct technique *technique, const struct look *look,
                                   vec3 hand_m, float age_s, float *yaw_rad);

/* The handle's yaw that brings the technique's end of a fish over the ring first; `yaw_rad` where
 * that is any, or no wrist turns so far. */
float aim_yaw(const struct technique *technique, const struct look_fish *fish, float yaw_rad);

/* The fish seen nearest to where a ring under water is, within `reach_m`, or null. */
const struct look_fish *aim_nearest(const struct look *look, vec3 ring_m, float reach_m);

#endif
