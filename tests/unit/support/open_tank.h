/* open_tank.h -- opens a preset of the tank with a given number of fish. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_OPEN_TANK_H
#define KINGYO_TESTS_UNIT_SUPPORT_OPEN_TANK_H

#include "core/base/panic.h"
#include "core/tank/tank.h"

/* Opens a preset with `fish_count` fish. Asserts that tank_open() succeeds. */
static inline void open_tank(struct tank *tank, uint8_t preset, uint32_t fish_count, uint32_t seed)
{
    struct tank_config config = tank_config_of(preset);
    config.fish_count = fish_count;
    config.seed = seed;
    const bool opened = tank_open(tank, &config);
    CORE_ASSERT(opened);
}

#endif
