/* menu_pages.h -- the pages of the operator's menu as data. Within core/game, and for the picture.
 *
 * A page's tags are those of its body, from 0, and then those at its foot. The last one is always
 * offered and leads back to the page's parent. */
#ifndef KINGYO_CORE_GAME_MENU_PAGES_H
#define KINGYO_CORE_GAME_MENU_PAGES_H

#include "core/game/menu.h"

#define MENU_FOOT_MAX 5u

enum menu_body {
    BODY_FREE = 0, /* The page shows something else there. */
    BODY_HUNG,     /* Large tags that hang side by side, eight at most. */
    BODY_ROWS,     /* A board for each, one under the other; those not offered leave their place. */
    BODY_PAGES,    /* One hangs for each page whose parent this is. */
    BODY_SETTINGS, /* A row for each setting of a group; then one for each page of this one. */
    BODY_BITS,     /* A row for each bit of one setting. */
    BODY_KEYS,     /* Small tags with a digit each. */
};

struct menu_sheet {
    uint8_t parent;     /* enum menu_page; MENU_PAGE_COUNT: back is out of the menu. */
    uint8_t body;       /* enum menu_body */
    uint8_t body_count; /* So many tags are in it, <= 12, where the kind of body does not say. */
    uint8_t foot_count; /* The others, 1 .. MENU_FOOT_MAX. */
    uint8_t watches;    /* START, OK, LEFT and RIGHT are shown here, not heeded. */
    uint8_t about;      /* enum setting_group of BODY_SETTINGS, enum setting_id of BODY_BITS; enum
                           audit_group of a page of the books. */
    uint8_t returns;    /* Back is to where it was turned to from, not to the parent. */
    uint16_t (*offers)(const struct menu *menu); /* A bit for each tag; null: all. */
    void (*enter)(struct core *core);            /* It is turned to. May be null. */
    void (*take)(struct core *core, uint32_t tag, struct output *output); /* Any but the last. */
    void (*leave)(struct core *core, struct output *output); /* Back, or out. May be null. */
};

/* `page` < MENU_PAGE_COUNT, else it asserts. */
const struct menu_sheet *menu_sheet_of(uint8_t page);

/* How many tags a page has, and how many of them are in its body. */
uint32_t menu_body_count(uint8_t page);
uint32_t menu_tag_count(uint8_t page);

/* The page that a tag of a body leads to; MENU_PAGE_COUNT: none. And the tag that leads there from
 * its parent; MENU_TAG_MAX: none does. */
uint8_t menu_page_at(uint8_t page, uint32_t tag);
uint32_t menu_tag_of(uint8_t page);

/* The setting of a row, or of the page of bits that it leads to; SETTING_COUNT: none. */
uint32_t menu_setting_at(uint8_t page, uint32_t tag);

/* Of the page that is shown: a bit for each tag that can be taken. */
uint16_t menu_offers(const struct menu *menu);

/* Another page is shown: what was pointed at there still is, or the first that is offered. */
void menu_turn(struct core *core, enum menu_page page);

/* What is pointed at is taken; the last tag leads back. */
void menu_take(struct core *core, struct output *output);

/* The stall opens again; what was being learned is forgotten. */
void menu_close(struct core *core, struct output *output);

/* Where a tag is on the canvas; empty when it is not offered. */
struct overlay_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag);

/* No hand presses these four in one tick: a desktop's way back, by its quit key. The page's
 * last tag is taken, whatever is pointed at, and no press is counted. TEST is among them since
 * nothing else leads away from the page that tries the buttons. */
#define MENU_WAY_BACK ((uint32_t)(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST))

#endif
