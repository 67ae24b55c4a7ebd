/* preset.c -- the tanks that are offered. */
#include "core/tank/preset.h"

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "core/tank/fish.h"
#include "core/tank/grid.h"

#define BODY_FILL_MAX                                                                              \
    0.12f /* Of the water. 5 s of 600 fish (0.11) leave one pair a tick a hair's                   \
             breadth deep; 800 (0.15) three, and half the pace. */
#define AGE_SAMPLES 32

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
        .bowl_radius_m = 0.075f, /* The federation allows a bowl of 160 mm at most. */
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

float tank_preset_age_days(const struct tank_preset *preset, float draw)
{
    return f_lerp(preset->age_days_min, preset->age_days_max, draw * draw);
}

uint32_t tank_preset_fish_max(const struct tank_preset *preset)
{
    const vec3 size_m = preset->size_m;
    float cubes_m3 = 0.0f;
    for (int i = 0; i < AGE_SAMPLES; i++) {
        const float draw = ((float)i + 0.5f) / (float)AGE_SAMPLES;
        const float age_days = tank_preset_age_days(preset, draw);
        const float length_m = growth_length_m(&species_wakin.growth, age_days);
        cubes_m3 += length_m * length_m * length_m;
    }
    const float body_m3 =
        FISH_HEIGHT_PER_LENGTH * FISH_WIDTH_PER_LENGTH * cubes_m3 / (float)AGE_SAMPLES;
    const float count = BODY_FILL_MAX * size_m.x * size_m.y * size_m.z / body_m3;
    return (uint32_t)f_clamp(count, 1.0f, (float)GRID_FISH_MAX);
}
