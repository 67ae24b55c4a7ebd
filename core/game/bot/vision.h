/* vision.h -- the vision of the bot: the visible state of the game, one object per call.
 *
 * A bot reads the game only through the functions of vision.h. Each function returns only what
 * core_scene() shows (tests/unit/core/game/bot/test_vision.c). A bot sees the positions of the
 * fish, but not the state of their behaviour. A bot also sees the picture of the paper, but not the
 * strength of the paper. struct vision refers to the game and the world for the duration of a call
 * and stores nothing. */
#pragma once

#include <stdint.h>

#include "core/game/bot/bot_state.h"

struct game;
struct world;

struct vision {
    const struct game *game;
    const struct world *world;
    uint32_t player; /* Player < POI_MAX whose poi and bowl belong to the bot. */
};

struct vision_game {
    uint32_t tick;
    uint8_t phase, mode; /* Current phase (enum scene_phase) and mode (enum game_mode). */
    uint8_t fouls;       /* Number of fouls of `vision->player`. */
    float seconds_left;
    vec3 tank_m; /* Width, water depth and breadth of the tank. */
    uint32_t fish_count;
};

struct vision_fish {
    vec3 position_m;
    struct angles angles;
    float length_m;
    float bend_rad;
    /* `gape` is the opening of the mouth, and `gulp` is the progress of a gulp of air, both as in
     * struct scene_fish. */
    float gape, gulp;
    uint8_t place; /* Place of the fish (enum scene_place). */
};

/* Returns the visible state of the game for `vision->player`. Asserts that the player is <
 * POI_MAX. */
struct vision_game vision_game(const struct vision *vision);

/* Returns the visible state of fish `fish`. Asserts that `fish` is less than the number of fish. */
struct vision_fish vision_fish(const struct vision *vision, uint32_t fish);

/* Return the visible state of one object. Assert that `index` < POI_MAX. If the object
 * is not present, all fields are 0. */
struct vision_poi vision_poi(const struct vision *vision, uint32_t index);
struct vision_bowl vision_bowl(const struct vision *vision, uint32_t index);

/* vision_integrity() and vision_wetness() return the integrity and the wetness of cell `cell` of
 * the player's own paper. `cell` is < SHEET_SIDE * SHEET_SIDE, row by row from the far edge.
 * Integrity is from 255 (whole) to 1 (nearly torn); 0 means a hole or a cell outside the ring.
 * Wetness is from 0 (dry) to 255 (wet). */
uint8_t vision_integrity(const struct vision *vision, uint32_t cell);
uint8_t vision_wetness(const struct vision *vision, uint32_t cell);
