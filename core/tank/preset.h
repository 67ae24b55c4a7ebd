/* preset.h -- the tank presets: size, fish, bowls, water and view of each tank.
 *
 * The presets are data. The code reads the values and never tests which preset is in use. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/view.h"

enum tank_preset_id {
    /* A festival stall: fish of different ages in a tank that fills a screen. */
    TANK_PRESET_FESTIVAL = 0,
    /* The tank of the 2013 thesis on goldfish behavior, with fish of 5 cm that follow the rules of
     * the thesis. */
    TANK_PRESET_THESIS = 1,
    /* The tank of the championship: 1,000 fish of 4 cm in 10 cm of water. */
    TANK_PRESET_OFFICIAL = 2,
    TANK_PRESET_COUNT,
};

struct tank_preset {
    const char *name;
    /* Inner width (x), water depth (y) and inner length toward the player (z). */
    vec3 size_m;
    float wall_height_m; /* Height of the walls from the floor to the rim. */
    uint32_t fish_count;
    /* Youngest and oldest age of a fish. The number of fish per day of age is proportional to 1 /
     * sqrt(age - age_days_min), because most fish of a stall hatched in the current summer. */
    float age_days_min, age_days_max;
    /* Mean length of all fish, varied by `length_spread`. 0 means that each fish has the length for
     * its age. */
    float length_m;
    /* Largest deviation from `length_m` as a fraction of `length_m`, [0, 0.3]. The random deviation
     * has a uniform distribution. */
    float length_spread;
    /* Range of the stamina at the start, within [0, 1]. The random stamina has a uniform
     * distribution. */
    float stamina_min, stamina_max;
    /* Centres of the mouths of the players' bowls, which float at fixed places at the front and at
     * the sides of the tank. */
    vec3 bowl_m[POI_MAX];
    float bowl_radius_m; /* Radius of a bowl's rim. Fish start outside the bowls. */
    float temperature_c; /* Initial temperature of the water. */
    /* Speed of the oxygen balance relative to real time (oxygen.h). */
    float time_compression;
    /* True if the air pump runs, so that the air stone in the tank bubbles. */
    bool pump;
    struct behavior_params params;
    /* Camera for wide screens (`view`), and camera on the short side of the tank for portrait
     * screens (`turned_view`). Both are in the player's axes (core/view.h). */
    struct view view, turned_view;
};

/* Returns the preset `id`, which must be less than TANK_PRESET_COUNT. */
const struct tank_preset *tank_preset(uint8_t id);

/* Returns the camera of a preset in the axes of the world. `is_turned` selects the camera on the
 * short side of the tank. */
struct view tank_preset_view(const struct tank_preset *preset, bool is_turned);

/* Returns the age of a fish in days. `draw` is a random number in [0, 1). */
float tank_preset_age_days(const struct tank_preset *preset, float draw);

/* Returns the largest number of fish, 1 .. TANK_FISH_MAX, in a tank whose floor area is
 * `area_scale` times the floor area of the preset. This number of fish of mean size fills 12 % of
 * the water with their body boxes. More fish would take too much computing time. */
uint32_t tank_preset_fish_max(const struct tank_preset *preset, float area_scale);
