/* preset.h -- the tank presets: size, fish, bowls, water and view of each tank.
 *
 * The presets are data. The code reads the values and never tests which preset is in use. */
#ifndef KINGYO_CORE_TANK_PRESET_H
#define KINGYO_CORE_TANK_PRESET_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/view.h"

enum tank_preset_id {
    TANK_PRESET_FESTIVAL = 0, /* A festival stall: fish of different ages in a tank that fills a
                                 screen. */
    TANK_PRESET_THESIS = 1,   /* The tank of the 2013 thesis: fish of 5 cm that follow the thesis'
                                 rules without changes. */
    TANK_PRESET_OFFICIAL = 2, /* The tank of the championship: 1,000 fish of 4 cm in 10 cm of
                                 water. */
    TANK_PRESET_COUNT,
};

struct tank_preset {
    const char *name;
    vec3 size_m;         /* Inner width (x), water depth (y) and inner length toward the player
                            (z). */
    float wall_height_m; /* Height of the walls from the floor to the rim. */
    uint32_t fish_count;
    float age_days_min, age_days_max; /* Youngest and oldest age. The number of fish per day of age
                                         falls as 1 / sqrt(age - age_days_min), because most fish of
                                         a stall hatched in the current summer. */
    float length_m;                   /* Mean length of all fish, varied by `length_spread`. 0 means
                                         that each fish has the length for its age. */
    float length_spread;              /* Largest deviation from `length_m` as a share of the length,
                                         [0, 0.3]. Lengths are uniform within the deviation. */
    float stamina_min, stamina_max;   /* Range of the stamina at the start, within [0, 1];
                                         uniform. */
    vec3 bowl_m[POI_MAX];             /* Centres of the mouths of the players' bowls, which are
                                         moored at the front and at the sides. */
    float bowl_radius_m;              /* Radius of a bowl's rim. Fish start outside the bowls. */
    float temperature_c;              /* Initial temperature of the water. */
    float time_compression;           /* Speed of the oxygen balance relative to the fish
                                         (oxygen.h). */
    uint8_t pump;                     /* 1 if the air stone bubbles, otherwise 0. */
    struct behavior_params params;
    struct view view;
};

/* Returns the preset `id`, which must be less than TANK_PRESET_COUNT. */
const struct tank_preset *tank_preset(uint8_t id);

/* Returns the age of a fish in days. `draw` is a random number in [0, 1). */
float tank_preset_age_days(const struct tank_preset *preset, float draw);

/* Returns the largest number of fish in a tank whose floor is scaled by `area_scale`, 1 ..
 * TANK_FISH_MAX. At that number the fish boxes, averaged over the ages, fill 12 % of the water.
 * With more fish the contact solver would not converge. */
uint32_t tank_preset_fish_max(const struct tank_preset *preset, float area_scale);

#endif
