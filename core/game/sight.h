/* sight.h -- what a person at the stall sees: the picture of the scene, asked one thing at a time.
 *
 * A bot knows the stall through these functions alone. None tells more than core_scene() shows, and
 * each tells the same (tests/unit/test_sight.c): where fish are, not where they go or what they
 * mean to do; the picture of the paper, not its strength. The eye borrows the core for the call it
 * is handed to, and keeps nothing. */
#ifndef KINGYO_CORE_GAME_SIGHT_H
#define KINGYO_CORE_GAME_SIGHT_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene.h"

struct core;

struct sight {
    const struct core *core;
    uint32_t player; /* < POI_MAX: whose poi and bowl are its own. */
};

struct sight_game {
    uint32_t tick;
    uint8_t phase, mode; /* enum scene_phase, enum game_mode */
    uint8_t fouls;       /* Its own. */
    float seconds_left;
};

struct sight_fish {
    vec3 position_m;
    struct angles angles;
    float length_m;
    float bend_rad;
    float gape, gulp; /* As in struct scene_fish. */
    uint8_t place;    /* enum scene_place */
};

struct sight_poi {
    uint8_t present;
    vec3 position_m;
    struct angles angles;
    float radius_m;
    float paper_left, water_m;
};

struct sight_bowl {
    uint8_t present;
    vec3 position_m;
    float radius_m;
};

struct sight_fan {
    uint8_t present;
    float x_m, z_m, radius_m, still_s;
};

struct sight_game sight_game(const struct sight *sight);
vec3 sight_tank_m(const struct sight *sight); /* Width, water depth, breadth. */

/* Fish are told apart by their number: < sight_fish_count(), else it asserts. */
uint32_t sight_fish_count(const struct sight *sight);
struct sight_fish sight_fish(const struct sight *sight, uint32_t fish);

/* `index` < POI_MAX, else they assert. What is not present is all zero. */
struct sight_poi sight_poi(const struct sight *sight, uint32_t index);
struct sight_bowl sight_bowl(const struct sight *sight, uint32_t index);
struct sight_fan sight_fan(const struct sight *sight, uint32_t index);

/* The picture of its own paper, `cell` < SHEET_SIDE * SHEET_SIDE, row by row from the far edge:
 * 0 a hole or beyond the ring, 1 nearly torn .. 255 whole; and 0 dry .. 255 wet. */
uint8_t sight_integrity(const struct sight *sight, uint32_t cell);
uint8_t sight_wetness(const struct sight *sight, uint32_t cell);

#endif
