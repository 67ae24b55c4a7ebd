/* look.h -- what stays of one look at the stall: a few fish and how they moved since the last look,
 * the own paper, the bowl.
 *
 * A look is the past as soon as it is taken. Speeds are two places and the time between them, as an
 * eye has them; a fish that was not noticed before seems to stand still. */
#ifndef KINGYO_CORE_GAME_LOOK_H
#define KINGYO_CORE_GAME_LOOK_H

#include <stdint.h>

#include "core/game/sight.h"

#define LOOK_NO_FISH 0xffffu
#define LOOK_NEAR_MAX 24u /* More than anybody has in view at once; chosen near where it looks. */

struct look_fish {
    uint16_t fish; /* LOOK_NO_FISH: none. */
    uint8_t place; /* enum scene_place */
    uint8_t gulps;
    vec3 position_m, velocity_m_s;
    float heading_rad; /* Of the nose, as yaw. */
    float length_m;
};

/* What became of its own paper, from the picture of it. */
struct look_paper {
    float wet;      /* [0, 1], mean of what is left. */
    float left;     /* [0, 1] */
    uint8_t holds;  /* Somewhere it has a patch for a fish ... */
    uint8_t middle; /* ... and it is the middle, or nearly. */
    float x_m, z_m; /* The middle of that patch, in the poi's plane; 0 while the paper is whole. */
};

struct look {
    uint32_t tick;
    uint8_t phase, mode;
    float seconds_left;
    vec3 tank_m;
    struct sight_poi poi;
    struct sight_bowl bowl;
    struct look_paper paper;
    uint32_t rival_count;  /* Other players' pois. */
    vec3 rival_m[POI_MAX];
    uint32_t riders;       /* Fish that lie on its poi. */
    uint32_t over;         /* Fish in the water over its paper. */
    struct look_fish prey; /* The one that it follows with its eyes. */
    uint32_t near_count;   /* <= LOOK_NEAR_MAX */
    struct look_fish near[LOOK_NEAR_MAX];
};

/* One look, now: at `prey` (or LOOK_NO_FISH), and at the fish that swim shallow about
 * `attention_m`. `before` is the look before; all zero there was none. */
void look_take(struct look *look, const struct look *before, const struct sight *sight,
               uint16_t prey, vec3 attention_m);

/* Where a fish is by now, `age_s` after it was seen, if it keeps on: nobody guesses farther than
 * LOOK_FORESIGHT_S. */
#define LOOK_FORESIGHT_S 0.6f
vec3 look_foresee(const struct look_fish *seen, float age_s);

uint64_t look_hash(uint64_t hash, const struct look *look);

#endif
