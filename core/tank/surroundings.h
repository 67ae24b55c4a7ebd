/* surroundings.h -- what a fish knows of its tank while it thinks. */
#ifndef KINGYO_CORE_TANK_SURROUNDINGS_H
#define KINGYO_CORE_TANK_SURROUNDINGS_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/tank/law.h"
#include "core/tank/obstacle.h"
#include "core/tank/shade.h"

struct surroundings {
    const struct law *law;
    vec3 size_m; /* Inner width, water depth, breadth. */
    float wall_follow; /* [0, 1] how much walls draw it. */
    uint8_t ball_spaces; /* As in struct tank_config. */
    uint32_t seed, tick;
    float dt_s; /* Since the same fish last thought. */
    float oxygen_mg_l; /* Dissolved in the water. */
    const struct obstacle *obstacles;
    uint32_t obstacle_count;
    const struct shade *shades; /* Some of them none. */
    uint32_t shade_count;
};

#endif
