/* perception.h -- the input of a fish's decision: parameters, tank, obstacles and shades. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_PERCEPTION_H
#define KINGYO_CORE_TANK_BEHAVIOR_PERCEPTION_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/tank/behavior_params.h"
#include "core/tank/collision/obstacle.h"
#include "core/tank/shade.h"

struct perception {
    const struct behavior_params *params;
    vec3 size_m;         /* Inner width, water depth and length of the tank. */
    float wall_follow;   /* Strength [0, 1] of the attraction of walls. */
    uint8_t ball_spaces; /* 1 if personal spaces are balls instead of boxes, otherwise 0; see struct
                            tank_config. */
    uint32_t seed, tick;
    float dt_s;        /* Time since the last decision of the deciding fish. */
    float oxygen_mg_l; /* Oxygen dissolved in the water. */
    const struct obstacle *obstacles;
    uint32_t obstacle_count;
    const struct shade *shades; /* Shades on the water. Some of the `shade_count` entries may be
                                   absent (cast.present is 0). */
    uint32_t shade_count;
};

#endif
