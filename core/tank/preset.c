/* preset.c -- defines the three tank presets with their fish and behavior parameters. */
#include "core/tank/preset.h"

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "core/tank/fish.h"

/* Largest fraction of the water that the bodies of the fish may fill. 600 fish in the festival tank
 * fill a fraction of 0.11. The simulation of a fuller tank would take too much computing time. */
#define BODY_FILL_MAX 0.12f
#define AGE_SAMPLES 32

#define UNBOUND 1e9f

/* Aspect ratio of the portrait canvas (core/game/pointer_mapping.h), so that the canvas and the
 * camera have the same scale on every portrait screen. */
#define TURNED_ASPECT (854.0f / 1400.0f)

/* Behavior parameters that all presets have in common. Lengths are in body lengths of the fish in
 * the 2013 thesis on goldfish behavior, which are 5 cm long. Section numbers are those of the 2013
 * thesis.
 *
 * Section 3.3 gives a burst speed of 15 cm/s, a swimming speed of 5.25 cm/s and a top swimming
 * speed of 7.5 cm/s. These speeds are half of the speeds that section 2.1 measures on a single
 * fish. In section 3.2 a resting fish "stands still". Real fish never stand completely still, so a
 * resting fish drifts at 0 to 0.5 cm/s. Section 3.4 gives 1 cm of personal space.
 *
 * Section 3.3 changes the heading with the gait but gives no angle. A uniform random angle within
 * 360 degrees would make the fish spin at every change of gait. Therefore the angle for a swimming
 * fish has a normal distribution with a standard deviation of 45 degrees. */
/* clang-format off */
#define THESIS_CORE                                                                                \
    .burst_speed = 3.0f, .swim_speed = 1.05f, .swim_speed_max = 1.5f, .drift_speed = 0.10f,        \
    .space_per_length = 0.2f, .turn_swim_rad = 45.0f * F_DEG

/* Behavior parameters of a fish that follows the rules of the 2013 thesis. One rule differs: the
 * stamina grows steadily while a fish gulps. Section numbers are those of the 2013 thesis.
 *
 * Section 3.1 gives a body of 5 x 2 x 1 cm. In section 3.4 a fish immediately avoids every object
 * in its personal space, including walls, and turns as fast as its gait allows. The fish predicts
 * nothing and never slows down. The personal spaces keep their size at every density: the spaces of
 * 600 fish fill 28 % of the water.
 *
 * In section 3.5 a shade attracts all fish at their present speed, including fish in a burst. In
 * section 3.6 each of four ranges of stamina has one depth, which is equal for all fish. A fish
 * gulps for 3 s when its stamina is below 25 of 100, and then has full stamina. In the thesis the
 * stamina jumps to its full value at the end of the 3 s. In this code the stamina grows steadily
 * during the 3 s, because otherwise all fish would dive at the same time. */
#define THESIS_LAW                                                                                 \
    {                                                                                              \
        THESIS_CORE, .height_per_length = 0.40f, .width_per_length = 0.20f,                        \
        .space_fill_max = UNBOUND, .turn_rest_rad = 45.0f * F_DEG, .swerve_haste = 2.0f,           \
        .wall_per_length = 0.2f, .gulp_min_s = 3.0f, .gulp_max_s = 3.0f,                           \
        .gulp_gain_per_s = 1.0f / 3.0f, .shade_draws_bursts = true,                                \
    }

/* Behavior parameters of a living wakin (a goldfish variety). The speeds are those of the 2013
 * thesis, and the behavior of living fish is added.
 *
 * A box of 5 x 2 x 1 cm, as in the 2013 thesis, holds 10 g of water, but a fish of 5 cm weighs 2.3
 * to 2.9 g. Therefore the body of the wakin is slimmer.
 *
 * With the personal spaces of the 2013 thesis, 1,000 fish of 5 cm would fill 95 % of the water of
 * the official tank, and 1,000 fish of 4 cm would fill 46 %. Therefore the spaces shrink if they
 * would fill more than 35 %.
 *
 * A fish brakes 0.15 s before contact. Braking 0.25 s before contact would reduce the speed of the
 * fish in the official tank by a tenth, and would not reduce the number of contacts. */
#define LIVING_WAKIN                                                                               \
    {                                                                                              \
        THESIS_CORE, .height_per_length = 0.36f, .width_per_length = 0.20f,                        \
        .space_fill_max = 0.35f, .turn_rest_rad = 12.0f * F_DEG, .depth_stray = 0.13f,             \
        .meet_within_s = 0.8f, .meet_miss = 0.3f, .brake_s = 0.15f,                                \
        .swerve_haste = 1.5f, .wall_per_length = 0.27f, .wall_within_s = 0.65f,                    \
        .kick_rad = 25.0f * F_DEG, .glides = true, .banks = true, .flow_share = 1.0f,              \
        .shade_dwell_s = 2.5f,                                                                     \
        .shade_frights = true, .escapes = true, .air_by_oxygen = true, .gulp_min_s = 2.0f,         \
        .gulp_max_s = 5.0f, .gulp_gain_per_s = 0.02f, .stifle_per_s = 0.002f,                      \
    }
/* clang-format on */

static const struct tank_preset presets[TANK_PRESET_COUNT] = {
    [TANK_PRESET_FESTIVAL] = {
        .name = "festival",
        /* Size of the type B tank of the goldfish-scooping federation, but with 12 cm of water
         * instead of 10 cm. */
        .size_m = { 0.85f, 0.12f, 0.55f },
        .wall_height_m = 0.15f,
        .fish_count = 300,
        /* The growth curve of the wakin (a goldfish variety) gives a length of 3.3 cm at
         * `age_days_min` and of 8 cm at `age_days_max`. */
        .age_days_min = 74.0f,
        .age_days_max = 222.0f,
        .stamina_min = 0.30f, /* Section 3.2 of the 2013 thesis gives this range of the stamina. */
        .stamina_max = 1.00f,
        .bowl_m = { { 0.335f, 0.012f, 0.185f },
                    { -0.335f, 0.012f, 0.185f },
                    { 0.335f, 0.012f, -0.035f },
                    { -0.335f, 0.012f, -0.035f } },
        .bowl_radius_m = 0.080f, /* The goldfish-scooping federation allows a bowl with a diameter
                                    of at most 160 mm. */
        .temperature_c = 24.0f,
        .time_compression = 60.0f, /* One minute of play is one hour of the oxygen balance. */
        .pump = true,
        .params = LIVING_WAKIN,
        .view = {
            .eye_m = { 0.0f, 1.00f, 0.70f },
            .target_m = { 0.0f, -0.02f, -0.006f },
            .half_height_tan = 0.257f,
            .aspect_min = 16.0f / 9.0f,
        },
        .turned_view = {
            .eye_m = { 0.0f, 1.40f, 0.70f },
            .target_m = { 0.0f, -0.02f, 0.035f },
            .half_height_tan = 0.365f,
            .aspect_min = TURNED_ASPECT,
        },
    },
    [TANK_PRESET_THESIS] = {
        .name = "thesis",
        .size_m = { 1.36f, 0.20f, 0.65f }, /* Section 3.1 of the 2013 thesis gives the width and the
                                              length of the tank. Section 3.6 of the 2013 thesis
                                              gives the water depth. */
        .wall_height_m = 0.23f,
        .fish_count = 600, /* Number of fish in section 4.1 of the 2013 thesis. */
        .age_days_min = 120.0f, /* All fish are 120 days old. At this age a fish is red all over. */
        .age_days_max = 120.0f,
        .length_m = 0.05f,
        .stamina_min = 0.30f, /* Section 3.2 of the 2013 thesis gives this range of the stamina. */
        .stamina_max = 1.00f,
        .bowl_m = { { 0.53f, 0.012f, 0.225f },
                    { -0.53f, 0.012f, 0.225f },
                    { 0.53f, 0.012f, -0.02f },
                    { -0.53f, 0.012f, -0.02f } },
        .bowl_radius_m = 0.080f,
        .temperature_c = 25.0f,
        .time_compression = 1.0f,
        .params = THESIS_LAW,
        .view = {
            .eye_m = { 0.0f, 1.622f, 0.448f }, /* The camera looks down more steeply than in the
                                                  festival preset, because the tank of the 2013
                                                  thesis is twice as wide (x) as it is long (z). */
            .target_m = { 0.0f, -0.02f, -0.024f },
            .half_height_tan = 0.263f,
            .aspect_min = 16.0f / 9.0f,
        },
        .turned_view = {
            .eye_m = { 0.0f, 1.95f, 0.60f },
            .target_m = { 0.0f, -0.02f, 0.02f },
            .half_height_tan = 0.40f,
            .aspect_min = TURNED_ASPECT,
        },
    },
    [TANK_PRESET_OFFICIAL] = {
        .name = "official",
        .size_m = { 1.36f, 0.10f, 0.65f }, /* The type A tank of the goldfish-scooping federation,
                                              with 10 cm of water. */
        .wall_height_m = 0.23f,
        .fish_count = 1000,
        .age_days_min = 90.0f,
        .age_days_max = 120.0f,
        .length_m = 0.04f,
        .length_spread = 0.10f,
        .stamina_min = 0.30f,
        .stamina_max = 1.00f,
        .bowl_m = { { 0.53f, 0.012f, 0.225f },
                    { -0.53f, 0.012f, 0.225f },
                    { 0.53f, 0.012f, -0.02f },
                    { -0.53f, 0.012f, -0.02f } },
        .bowl_radius_m = 0.080f,
        .temperature_c = 25.0f, /* The rules of the goldfish-scooping federation allow water of 20
                                   to 30 C. */
        .time_compression = 1.0f,
        .params = LIVING_WAKIN,
        .view = {
            .eye_m = { 0.0f, 1.622f, 0.421f }, /* From this camera position the water is visible
                                                  over a wall that stands 13 cm above the
                                                  surface. */
            .target_m = { 0.0f, -0.02f, -0.042f },
            .half_height_tan = 0.274f,
            .aspect_min = 16.0f / 9.0f,
        },
        .turned_view = {
            .eye_m = { 0.0f, 1.95f, 0.60f },
            .target_m = { 0.0f, -0.02f, 0.02f },
            .half_height_tan = 0.42f,
            .aspect_min = TURNED_ASPECT,
        },
    },
};

const struct tank_preset *tank_preset(uint8_t id)
{
    CORE_ASSERT(id < TANK_PRESET_COUNT);
    return &presets[id];
}

struct view tank_preset_view(const struct tank_preset *preset, bool is_turned)
{
    struct view view = is_turned ? preset->turned_view : preset->view;
    view.eye_m = view_to_world(is_turned, view.eye_m);
    view.target_m = view_to_world(is_turned, view.target_m);
    return view;
}

float tank_preset_age_days(const struct tank_preset *preset, float draw)
{
    CORE_ASSERT(draw >= 0.0f && draw < 1.0f);
    return f_lerp(preset->age_days_min, preset->age_days_max, draw * draw);
}

uint32_t tank_preset_fish_max(const struct tank_preset *preset, float area_scale)
{
    const vec3 size_m = preset->size_m;
    float cubes_m3 = 0.0f;
    for (int i = 0; i < AGE_SAMPLES; i++) {
        const float draw = ((float)i + 0.5f) / (float)AGE_SAMPLES;
        const float age_days = tank_preset_age_days(preset, draw);
        const float length_m = preset->length_m > 0.0f
                                   ? preset->length_m
                                   : growth_length_m(&species_wakin.card.growth, age_days);
        cubes_m3 += length_m * length_m * length_m;
    }
    const float body_m3 = preset->params.height_per_length * preset->params.width_per_length *
                          cubes_m3 / (float)AGE_SAMPLES;
    const float water_m3 = area_scale * size_m.x * size_m.y * size_m.z;
    const float count = BODY_FILL_MAX * water_m3 / body_m3;
    return (uint32_t)f_clamp(count, 1.0f, (float)TANK_FISH_MAX);
}
