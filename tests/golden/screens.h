/* screens.h -- every screen of the user interface with example content. The pictures of
 * tests/golden and the test of all screens (test_ui_all_screens.c) use the same list. */
#ifndef KINGYO_TESTS_SCREENS_H
#define KINGYO_TESTS_SCREENS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/render/ui/ui_screens.h"

enum screen_kind {
    SCREEN_PLAYER = 0, /* A screen for players, who stand up to 3 m away. */
    SCREEN_ALBUM,      /* The album that players see after a round. */
    SCREEN_LAB,        /* The growth lab, which a player operates within reach of the kiosk. */
    SCREEN_MENU,       /* A page of the operator's menu. */
};

#define SCREEN_NAME_SIZE 24u

struct screen {
    enum screen_kind kind;
    char name[SCREEN_NAME_SIZE]; /* Unique name, such as "ready" or "learn 3". */
};

/* Returns the number of screens. */
uint32_t screens_count(void);

/* Fills `scene` with the content of screen number `index`, which is below screens_count(), and
 * `memory` with the values that were shown before, so that no animation runs. `language` is an enum
 * language. `upright` is true for a portrait picture. Returns the description of the screen. */
struct screen screens_fill(uint32_t index, uint8_t language, bool upright, struct scene *scene,
                           struct ui_memory *memory);

#endif
