/* tank.h -- the water, the fish that swim in it, and the obstacles.
 *
 * Axes: origin at the centre of the still surface, +x right, +y up, +z toward the player. */
#ifndef KINGYO_CORE_TANK_TANK_H
#define KINGYO_CORE_TANK_TANK_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/behavior/perception.h"
#include "core/tank/collision/broad_phase.h"
#include "core/tank/collision/contact_solver.h"
#include "core/tank/collision/obstacle.h"
#include "core/tank/fish.h"
#include "core/tank/oxygen.h"
#include "core/tank/preset.h"
#include "core/tank/shade.h"
#include "core/tank/water.h"

_Static_assert(TANK_OBSTACLE_MAX == 2u * POI_MAX, "a poi and a bowl of each player");
#define TANK_SHADE_MAX (SHADE_MAX + POI_MAX) /* Fans and hands, then the dry pois. */

struct tank {
    uint32_t seed;
    uint8_t preset;        /* enum tank_preset_id */
    uint8_t lanes, search; /* As in struct tank_config; no hash covers these two members. */
    vec3 size_m;
    float wall_height_m;
    float wall_follow;   /* As in struct tank_config. */
    uint8_t ball_spaces; /* As in struct tank_config. */
    uint32_t fish_count;
    struct fish fish[TANK_FISH_MAX];
    float space; /* Personal space beyond the body, in body lengths; fixed at the start. */
    struct water water;
    struct shade shade[TANK_SHADE_MAX];
    struct oxygen oxygen;
    uint32_t reentry_count; /* Upper bound of the fish in reentry; reentry_tick() recounts them. */
    struct broad_phase
        broad_phase; /* The results of the last query are state; broad_phase_hash() covers them. */
    struct contact_solver solver; /* Scratch memory of one tick, which no hash covers. The member
                                     stands here because a board's stack is too small. */
};

/* Parameters of a tank to open. */
struct tank_config {
    uint8_t preset;                 /* enum tank_preset_id */
    uint32_t fish_count;            /* 1 .. tank_fish_max() */
    uint32_t seed;                  /* Any value. */
    float area_scale;               /* Factor on the floor area, TANK_AREA_SCALE_MIN .. _MAX. */
    vec3 size_m;                    /* Inner size in TANK_SIDE_*_M and TANK_DEPTH_*_M; 0 selects the
                                       preset's value. */
    float wall_follow;              /* [0, 1] attraction of walls: 0 in every preset. */
    uint8_t ball_spaces;            /* 1: personal spaces are balls around the boxes, and each fish
                                       is tested against each other fish, for comparison (section
                                       3.4). */
    float stamina_min, stamina_max; /* [0, 1] at the start, uniform. */
    float temperature_c;            /* OXYGEN_TEMPERATURE_MIN_C .. _MAX_C */
    float pressure_hpa;             /* OXYGEN_PRESSURE_MIN_HPA .. _MAX_HPA */
    float oxygen_mg_l;              /* TANK_OXYGEN_SATURATED, or 0 .. OXYGEN_MAX_MG_L. */
    float time_compression;         /* 0 .. OXYGEN_TIME_COMPRESSION_MAX */
    uint8_t pump;                   /* 1 if the air stone bubbles. */
    uint8_t bowls;                  /* Number of bowls, 0 .. POI_MAX, whose places are kept clear of
                                       fish at the start. */
    uint8_t lanes;                  /* 0, 4 or 8 (core/base/simd.h): affects speed only. */
    uint8_t search;                 /* enum pair_search: affects speed only. */
};

#define TANK_OXYGEN_SATURATED (-1.0f) /* Starts with water saturated with oxygen. */

#define TANK_SIDE_MIN_M 0.30f
#define TANK_SIDE_MAX_M 2.00f
#define TANK_DEPTH_MIN_M 0.05f
#define TANK_DEPTH_MAX_M 0.50f

#define TANK_AREA_SCALE_MIN 0.05f
#define TANK_AREA_SCALE_MAX 250.0f

/* Returns the configuration of a preset with the preset's own values. */
struct tank_config tank_config_of(uint8_t preset);

/* Returns the largest number of fish of such a tank; at most TANK_FISH_MAX. */
uint32_t tank_fish_max(uint8_t preset, float area_scale);

/* Returns the largest number of fish of a tank to open, whatever its own fish count. Returns 0 if
 * its size is out of range. */
uint32_t tank_config_fish_max(const struct tank_config *config);

/* Fills `tank` with still water and fish that do not overlap. Returns 1 on success. Returns 0 if a
 * value lies outside its range; `tank` is then unchanged. Also returns 0 if the fish found no room,
 * which happens only in tanks shorter than a fish; `tank` must then not be used. */
int tank_open(struct tank *tank, const struct tank_config *config);

/* Opens a preset with `fish_count` fish. Asserts that the values are in range and that the fish
 * find room. */
void tank_init(struct tank *tank, uint8_t preset, uint32_t fish_count, uint32_t seed);

/* A fish at a given place, to stage an encounter. */
struct tank_stage {
    vec3 position_m;
    struct angles angles;
    float length_m;  /* 0: the length that the tank gave the fish. */
    float speed_m_s; /* Along the nose, >= 0. */
    float stamina;   /* [0, 1] */
    uint8_t gait;    /* GAIT_REST, GAIT_SWIM, GAIT_BURST or GAIT_SURFACE, for its longest
                        duration. */
};

/* Places the first `count` <= fish_count fish of a tank that was just opened. Bodies must be in the
 * water and apart. */
void tank_stage_all(struct tank *tank, const struct tank_stage *stages, uint32_t count);

/* Returns the behavior parameters of the tank's fish. */
const struct behavior_params *tank_behavior_params(const struct tank *tank);

/* Sets the objects over the water in this tick; called before tank_tick(). Without any call there
 * are no shades. Asserts that all values are finite. */
void tank_cast(struct tank *tank, const struct shade_cast casts[TANK_SHADE_MAX]);

/* Returns the number of swimming fish whose centre lies in such a shade, whether or not it is
 * present. */
uint32_t tank_shade_count(const struct tank *tank, const struct shade_cast *cast);

/* Advances every swimming fish by one tick (core/poi moves fish that are carried or in a bowl).
 * `obstacle_count` <= TANK_OBSTACLE_MAX. */
void tank_tick(struct tank *tank, uint32_t tick, struct obstacle *obstacles,
               uint32_t obstacle_count);

/* Returns the position of the pump's air stone: on the floor in the far left corner. */
vec3 tank_stone_m(vec3 size_m);

/* Returns the number of fish that gulp at the surface. */
uint32_t tank_surfacing_count(const struct tank *tank);

/* Return values that other modules of core/tank need. */
struct tank_bounds tank_bounds(const struct tank *tank);
struct broad_phase_search tank_search(const struct tank *tank);

/* Returns the perception of a fish in tick `tick`. The result points into the tank and at
 * `obstacles`, which may be null if there are none. */
struct perception tank_perception(const struct tank *tank, uint32_t tick,
                                  const struct obstacle *obstacles, uint32_t obstacle_count);

uint64_t tank_hash(uint64_t hash, const struct tank *tank);       /* Hashes fish and water. */
uint64_t tank_hash_quick(uint64_t hash, const struct tank *tank); /* Hashes poses and gaits of the
                                                                     fish only. */

#endif
