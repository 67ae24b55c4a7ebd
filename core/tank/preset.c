/* preset.c -- the tanks that are offered. */
#include "core/tank/preset.h"

#include "core/base/panic.h"

static const struct tank_preset presets[TANK_PRESET_COUNT] = {
    [TANK_PRESET_FESTIVAL] = {
        .name = "festival",
        /* The federation's type B tank, filled a little deeper than its 10 cm. */
        .size_m = { 0.85f, 0.12f, 0.55f },
        .wall_height_m = 0.15f,
        .fish_count = 300,
        /* 3.3 cm to 8 cm by the wakin's growth curve: ten weeks to seven months. */
        .age_days_min = 74.0f,
        .age_days_max = 222.0f,
        .stamina_min = 0.30f, /* 2013 thesis, section 3.2. */
        .stamina_max = 1.00f,
        .bowl_m = { 0.335f, 0.012f, 0.185f },
        .view = {
            .eye_m = { 0.0f, 1.00f, 0.70f },
            .target_m = { 0.0f, -0.02f, 0.034f },
            .half_height_tan = 0.247f,
            .aspect_min = 16.0f / 9.0f,
        },
    },
};

const struct tank_preset *tank_preset(uint8_t id)
{
    CORE_ASSERT(id < TANK_PRESET_COUNT);
    return &presets[id];
}
