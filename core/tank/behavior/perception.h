/* perception.h -- the perception of a fish: everything that its decision may use. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_PERCEPTION_H
#define KINGYO_CORE_TANK_BEHAVIOR_PERCEPTION_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/tank/behavior_params.h"
#include "core/tank/collision/obstacle.h"
#include "core/tank/shade.h"

struct perception {
    const struct behavior_params *params;
    vec3 size_m;         /* Inner width, water depth, breadth. */
    float wall_follow;   /* [0, 1] attraction of walls. */
    uint8_t ball_spaces; /* As in struct tank_config. */
    uint32_t seed, tick;
    float dt_s;        /* Time since the last decision of the same fish. */
    float oxygen_mg_l; /* Oxygen dissolved in the water. */
    const struct obstacle *obstacles;
    uint32_t obstacle_count;
    const struct shade *shades; /* Shades; some entries may be absent. */
    uint32_t shade_count;
};

#endif
