/* preset.h -- tanks as data. Nothing in the code asks which preset it runs. */
#ifndef KINGYO_CORE_TANK_PRESET_H
#define KINGYO_CORE_TANK_PRESET_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/law.h"
#include "core/view.h"

enum tank_preset_id {
    TANK_PRESET_FESTIVAL = 0, /* The stall: mixed ages in a tank that fills a screen. */
    TANK_PRESET_THESIS = 1,   /* The 2013 thesis: 5 cm fish, its law to the letter. */
    TANK_PRESET_OFFICIAL = 2, /* The championship: 1,000 fish of 4 cm in 10 cm of water. */
    TANK_PRESET_COUNT,
};

struct tank_preset {
    const char *name;
    vec3 size_m;         /* Inner width (x), water depth (y), breadth (z). */
    float wall_height_m; /* Floor to rim. */
    uint32_t fish_count;
    float age_days_min, age_days_max; /* The density of ages falls toward the old as 1 / sqrt: most
                                         of a stall's fish are this summer's. */
    float length_m;                   /* 0: by age; else every fish's, about `length_spread`. */
    float length_spread;              /* [0, 0.3] either way, as a share of it, uniform. */
    float stamina_min, stamina_max;   /* [0, 1] at the start, uniform. */
    vec3 bowl_m[POI_MAX];             /* Mouth centres of the players' bowls, as they are moored:
                                         along the front and at the sides. */
    float bowl_radius_m;              /* Of its rim; fish start clear of it. */
    float temperature_c;              /* Of the water at the start. */
    float time_compression;           /* So much faster than the fish its oxygen changes. */
    uint8_t pump;                     /* Whether the air stone bubbles. */
    struct law law;
    struct view view;
};

/* `id` < TANK_PRESET_COUNT. */
const struct tank_preset *tank_preset(uint8_t id);

/* The age of a fish that draws `draw` in [0, 1). */
float tank_preset_age_days(const struct tank_preset *preset, float draw);

/* How many fish its water holds without overlap, 1 .. TANK_FISH_MAX, on `area_scale` of its floor:
 * their boxes, at the mean over its ages, then fill an eighth of it. Beyond, fish are shut in and
 * parting them comes to no end. */
uint32_t tank_preset_fish_max(const struct tank_preset *preset, float area_scale);

#endif
