/* preset.h -- the tanks as data. No code tests which preset it runs. */
#ifndef KINGYO_CORE_TANK_PRESET_H
#define KINGYO_CORE_TANK_PRESET_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/view.h"

enum tank_preset_id {
    TANK_PRESET_FESTIVAL = 0, /* The stall: mixed ages in a tank that fills a screen. */
    TANK_PRESET_THESIS = 1,   /* The 2013 thesis: 5 cm fish, its rules to the letter. */
    TANK_PRESET_OFFICIAL = 2, /* The championship: 1,000 fish of 4 cm in 10 cm of water. */
    TANK_PRESET_COUNT,
};

struct tank_preset {
    const char *name;
    vec3 size_m;         /* Inner width (x), water depth (y), breadth (z). */
    float wall_height_m; /* Height from floor to rim. */
    uint32_t fish_count;
    float age_days_min, age_days_max; /* Range of ages. The density falls toward old age as 1 /
                                         sqrt, because most fish of a stall are of this summer. */
    float length_m;                   /* 0: length by age; otherwise the mean length of all fish,
                                         varied by `length_spread`. */
    float length_spread;              /* [0, 0.3] share of the length, uniform in both
                                         directions. */
    float stamina_min, stamina_max;   /* [0, 1] at the start, uniform. */
    vec3 bowl_m[POI_MAX];             /* Mouth centres of the players' moored bowls, along the front
                                         and at the sides. */
    float bowl_radius_m;              /* Radius of a bowl's rim; fish start clear of it. */
    float temperature_c;              /* Initial temperature of the water. */
    float time_compression;           /* Speed of the oxygen relative to that of the fish. */
    uint8_t pump;                     /* 1 if the air stone bubbles. */
    struct behavior_params params;
    struct view view;
};

/* Returns the preset `id` < TANK_PRESET_COUNT. */
const struct tank_preset *tank_preset(uint8_t id);

/* Returns the age of a fish for a random draw in [0, 1). */
float tank_preset_age_days(const struct tank_preset *preset, float draw);

/* Returns the number of fish that the water holds without overlap, 1 .. TANK_FISH_MAX, on a floor
 * scaled by `area_scale`. At this number the boxes at the mean over the ages fill an eighth of the
 * water. With more fish the contact solver would not converge. */
uint32_t tank_preset_fish_max(const struct tank_preset *preset, float area_scale);

#endif
