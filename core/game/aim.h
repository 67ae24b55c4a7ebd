/* aim.h -- which fish to go for, and from which side: what the bot's eye tells its hand.
 *
 * The way in is a straight slide along the plane of the slanted paper, from above the water to a
 * stop beside the fish and under it, so that the ring cuts the water edgewise. */
#ifndef KINGYO_CORE_GAME_AIM_H
#define KINGYO_CORE_GAME_AIM_H

#include <stdint.h>

#include "core/base/vec.h"

#define AIM_NO_FISH 0xffffu
#define AIM_SLANT_RAD (-40.0f * F_DEG) /* Far edge down, while it slides in. */
#define AIM_ENTRY_Y_M 0.045f           /* Its lowest point is 15 mm over the water. */
#define AIM_UNDER_M 0.022f             /* The ring's depth below the fish's middle. */

struct core;

struct way_in {
    vec3 entry_m;  /* Over the water. */
    vec3 stop_m;   /* Under it, beside the fish. */
    vec3 under_m;  /* The ring's centre when the fish is over its best paper. */
};

/* Where a fish will be `ahead_s` from now if it keeps on, as a person would guess. */
vec3 aim_foresee(const struct core *core, uint32_t fish, float ahead_s);

/* The way in to a fish for a hand turned by `yaw_rad`. Returns whether walls, floor and bowl leave
 * room for it. */
int aim_way_in(const struct core *core, uint32_t poi, uint32_t fish, float yaw_rad,
               struct way_in *way);

/* The fish that costs least for a hand at `hand_m`, and the yaw to take it with; AIM_NO_FISH where
 * none can be had. Slow, shallow, lonely and near is cheap; head first is cheaper. */
uint16_t aim_choose(const struct core *core, uint32_t poi, vec3 hand_m, float *yaw_rad);

/* A calm fish over the ring within `reach_m` of its axis, nearest first, or AIM_NO_FISH. */
uint16_t aim_over_ring(const struct core *core, uint32_t poi, float reach_m);

#endif
