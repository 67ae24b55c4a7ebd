/* tank.h -- the water, the shoal that swims in it, and what stands in their way.
 *
 * Axes: origin at the centre of the still surface, +x right, +y up, +z toward the player. */
#ifndef KINGYO_CORE_TANK_TANK_H
#define KINGYO_CORE_TANK_TANK_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/crowd.h"
#include "core/tank/fish.h"
#include "core/tank/obstacle.h"
#include "core/tank/oxygen.h"
#include "core/tank/part.h"
#include "core/tank/preset.h"
#include "core/tank/shade.h"
#include "core/tank/surroundings.h"
#include "core/tank/water.h"

_Static_assert(TANK_OBSTACLE_MAX == 2u * POI_MAX, "a poi and a bowl of each player");
#define TANK_SHADE_MAX (SHADE_MAX + POI_MAX) /* Fans and hands, then the dry pois. */

struct tank {
    uint32_t seed;
    uint8_t preset; /* enum tank_preset_id */
    uint8_t lanes, search; /* As in struct tank_config; no hash covers them. */
    vec3 size_m;
    float wall_height_m;
    float wall_follow;   /* As in struct tank_config, ... */
    uint8_t ball_spaces; /* ... as this. */
    uint32_t fish_count;
    struct fish fish[TANK_FISH_MAX];
    float space; /* Personal space beyond the body, in body lengths; fixed at the start. */
    struct water water;
    struct shade shade[TANK_SHADE_MAX];
    struct oxygen oxygen;
    uint32_t loose_count; /* Fish that loose.h moves, at most; its next tick counts them anew. */
    struct crowd crowd; /* What its last look found is state, which crowd_hash() covers. */
    struct part part; /* Scratch of one tick, which no hash covers; no board's stack holds it. */
};

/* A tank to open. */
struct tank_config {
    uint8_t preset;                 /* enum tank_preset_id */
    uint32_t fish_count;            /* 1 .. tank_fish_max() */
    uint32_t seed;                  /* Any value. */
    float area_scale;               /* Of the floor, TANK_AREA_SCALE_MIN .. _MAX. */
    vec3 size_m;                    /* Inner size; where 0 the preset's, else in TANK_SIDE_*_M and
                                       TANK_DEPTH_*_M. */
    float wall_follow;              /* [0, 1] how much walls draw its fish: 0 in every preset. */
    uint8_t ball_spaces;            /* Personal spaces are the balls round their boxes, and each
                                       fish is tried against each: to compare (section 3.4). */
    float stamina_min, stamina_max; /* [0, 1] at the start, uniform. */
    float temperature_c;            /* OXYGEN_TEMPERATURE_MIN_C .. _MAX_C */
    float pressure_hpa;             /* OXYGEN_PRESSURE_MIN_HPA .. _MAX_HPA */
    float oxygen_mg_l;              /* TANK_OXYGEN_SATURATED, or 0 .. OXYGEN_MAX_MG_L. */
    float time_compression;         /* 0 .. OXYGEN_TIME_COMPRESSION_MAX */
    uint8_t pump;                   /* Whether the air stone bubbles. */
    uint8_t bowls;                  /* Of whose places fish start clear, 0 .. POI_MAX. */
    uint8_t lanes;  /* 0 or 4, or 8 (core/base/lanes.h): a matter of speed alone. */
    uint8_t search; /* enum pairs_search: the same. */
};

#define TANK_OXYGEN_SATURATED (-1.0f) /* As much as the water holds, at the start. */

#define TANK_SIDE_MIN_M 0.30f
#define TANK_SIDE_MAX_M 2.00f
#define TANK_DEPTH_MIN_M 0.05f
#define TANK_DEPTH_MAX_M 0.50f

#define TANK_AREA_SCALE_MIN 0.05f
#define TANK_AREA_SCALE_MAX 250.0f

/* The preset as it stands: its own values for all. */
struct tank_config tank_config_of(uint8_t preset);

/* How many fish such a tank holds; at most TANK_FISH_MAX. */
uint32_t tank_fish_max(uint8_t preset, float area_scale);

/* The same for a tank to open; its count need not fit yet. 0 when its size is out of range. */
uint32_t tank_config_fish_max(const struct tank_config *config);

/* Fills `tank` with still water and fish that do not overlap. Returns whether it could. 0: a value
 * lies outside its range, and `tank` is untouched; or so many fish found no room in so small a
 * tank, and `tank` must not be used. That is known only of tanks that are shorter than a fish. */
int tank_open(struct tank *tank, const struct tank_config *config);

/* The same for a preset with `fish_count` fish; what does not fit is a bug and asserts. */
void tank_init(struct tank *tank, uint8_t preset, uint32_t fish_count, uint32_t seed);

/* A fish where somebody wants it, to stage an encounter. */
struct tank_stage {
    vec3 position_m;
    struct angles angles;
    float length_m;   /* 0: as the tank gave it. */
    float speed_m_s;  /* Along the nose, >= 0. */
    float stamina;    /* [0, 1] */
    uint8_t gait;     /* GAIT_REST, GAIT_SWIM or GAIT_BURST, for its longest spell. */
};

/* Puts the first `count` <= fish_count fish of a tank that was just opened. Bodies must be in the
 * water and apart. */
void tank_stage_all(struct tank *tank, const struct tank_stage *stages, uint32_t count);

/* How its fish behave. */
const struct law *tank_law(const struct tank *tank);

/* What is over the water in this tick; before tank_tick. Never called, nothing ever is. What is not
 * finite is a bug and asserts. */
void tank_cast(struct tank *tank, const struct shade_cast casts[TANK_SHADE_MAX]);

/* How many fish that swim have their middle in such a shadow, whether it falls or not. */
uint32_t tank_shade_count(const struct tank *tank, const struct shade_cast *cast);

/* One tick of every fish that swims (held and bowl fish are moved by core/poi).
 * `obstacle_count` <= TANK_OBSTACLE_MAX. */
void tank_tick(struct tank *tank, uint32_t tick, struct obstacle *obstacles,
               uint32_t obstacle_count);

/* Where the air stone of a pump lies: on the floor, in the far left corner. */
vec3 tank_stone_m(vec3 size_m);

/* Fish that gulp at the surface. */
uint32_t tank_surfacing_count(const struct tank *tank);

/* What its parts ask a tank for. */
struct tank_bounds tank_bounds(const struct tank *tank);
struct crowd_search tank_search(const struct tank *tank);

/* What a fish in it knows in tick `tick`; points into the tank and at `obstacles`, which may be
 * null when there are none. */
struct surroundings tank_surroundings(const struct tank *tank, uint32_t tick,
                                      const struct obstacle *obstacles, uint32_t obstacle_count);

uint64_t tank_hash(uint64_t hash, const struct tank *tank);       /* Fish and water. */
uint64_t tank_hash_quick(uint64_t hash, const struct tank *tank); /* Fish poses and gaits alone. */

#endif
