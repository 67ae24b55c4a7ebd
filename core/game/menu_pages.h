/* menu_pages.h -- the pages of the operator's menu as data. Within core/game, and for the picture.
 *
 * The last tag of a page is always offered and leads back. */
#ifndef KINGYO_CORE_GAME_MENU_PAGES_H
#define KINGYO_CORE_GAME_MENU_PAGES_H

#include "core/game/menu.h"

enum menu_body {
    BODY_FREE = 0, /* The page shows something else there. */
    BODY_HUNG,     /* Large tags that hang side by side, eight at most. */
    BODY_ROWS,     /* A board for each, one under the other; those not offered leave their place. */
};

struct menu_sheet {
    uint8_t body;       /* enum menu_body */
    uint8_t body_count; /* So many tags are in it, <= 8; the others are at the foot, <= 4. */
    uint8_t tag_count;  /* Of all, <= MENU_TAG_MAX. */
    uint8_t watches;    /* START, OK, LEFT and RIGHT are shown here, not heeded. */
    uint16_t (*offers)(const struct menu *menu); /* A bit for each tag. */
    void (*take)(struct core *core, uint32_t tag, struct output *output);
};

/* `page` < MENU_PAGE_COUNT, else it asserts. */
const struct menu_sheet *menu_sheet_of(uint8_t page);

/* Another page is shown: what was pointed at there still is, or the first that is offered. */
void menu_turn(struct core *core, enum menu_page page);

/* The stall opens again; what was being learned is forgotten. */
void menu_close(struct core *core, struct output *output);

/* Where a tag is on the canvas; empty when it is not offered. */
struct overlay_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag);

/* No hand presses these four in one tick: a desktop's way back, by its quit key. The page's
 * last tag is taken, whatever is pointed at, and no press is counted. TEST is among them since
 * nothing else leads away from the page that tries the buttons. */
#define MENU_WAY_BACK ((uint32_t)(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST))

#endif
