/* vision.h -- the vision of the bot: the visible state of the game, one object per call.
 *
 * A bot reads the game only through these functions. Each returns what core_scene() shows, and
 * nothing more (tests/unit/core/game/bot/test_vision.c). A bot sees where fish are, but not their
 * plans, and the picture of the paper, but not its strength. struct vision refers to the game and
 * the world for the duration of a call and stores nothing. */
#ifndef KINGYO_CORE_GAME_BOT_VISION_H
#define KINGYO_CORE_GAME_BOT_VISION_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene.h"

struct game;
struct world;

struct vision {
    const struct game *game;
    const struct world *world;
    uint32_t player; /* Player < POI_MAX whose poi and bowl belong to the bot. */
};

struct vision_game {
    uint32_t tick;
    uint8_t phase, mode; /* enum scene_phase, enum game_mode */
    uint8_t fouls;       /* Fouls of this player. */
    float seconds_left;
};

struct vision_fish {
    vec3 position_m;
    struct angles angles;
    float length_m;
    float bend_rad;
    float gape, gulp; /* Opening of the mouth and progress of a gulp, as in struct scene_fish. */
    uint8_t place;    /* enum scene_place */
};

struct vision_poi {
    uint8_t present;
    vec3 position_m;
    struct angles angles;
    float radius_m;
    float paper_left, water_m;
};

struct vision_bowl {
    uint8_t present;
    vec3 position_m;
    float radius_m;
};

struct vision_fan {
    uint8_t present;
    float x_m, z_m, radius_m, still_s;
};

/* Returns the visible state of the game for `vision->player`; the player must be < POI_MAX. */
struct vision_game vision_game(const struct vision *vision);
vec3 vision_tank_m(const struct vision *vision); /* Returns width, water depth and breadth of the
                                                    tank. */

/* Return the number of fish, and one fish. `fish` must be < vision_fish_count(), else the function
 * asserts. */
uint32_t vision_fish_count(const struct vision *vision);
struct vision_fish vision_fish(const struct vision *vision, uint32_t fish);

/* Return one object. `index` must be < POI_MAX (fan: < SHADE_MAX), else the function asserts. An
 * object that is not present is all zero. */
struct vision_poi vision_poi(const struct vision *vision, uint32_t index);
struct vision_bowl vision_bowl(const struct vision *vision, uint32_t index);
struct vision_fan vision_fan(const struct vision *vision, uint32_t index);

/* Return a cell of the picture of the player's own paper. `cell` < SHEET_SIDE * SHEET_SIDE, row by
 * row from the far edge. Integrity: 0 hole or outside the ring, 1 nearly torn .. 255 whole.
 * Wetness: 0 dry .. 255 wet. */
uint8_t vision_integrity(const struct vision *vision, uint32_t cell);
uint8_t vision_wetness(const struct vision *vision, uint32_t cell);

#endif
