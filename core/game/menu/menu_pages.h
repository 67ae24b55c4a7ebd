/* menu_pages.h -- the pages of the operator's menu as data. Internal to core/game and the renderer.
 *
 * The items of a page are those of its body, from 0, followed by those at its foot. The last item
 * is always on offer and leads back to the page's parent. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_PAGES_H
#define KINGYO_CORE_GAME_MENU_MENU_PAGES_H

#include "core/game/menu/menu.h"

#define MENU_FOOT_MAX 5u

enum menu_body {
    MENU_BODY_FREE = 0, /* The body has no items; the page shows other content there. */
    MENU_BODY_TILES,    /* Large items side by side, eight at most. */
    MENU_BODY_ROWS,     /* A row per item; an item not on offer leaves its place empty. */
    MENU_BODY_PAGES,    /* A large item for each page with this parent. */
    MENU_BODY_SETTINGS, /* A row for each setting of a group, then one for each subpage. */
    MENU_BODY_BITS,     /* A row for each bit of one setting. */
    MENU_BODY_KEYS,     /* Small items with a digit each. */
};

struct menu_page_desc {
    uint8_t parent;     /* enum menu_page; MENU_PAGE_COUNT: back closes the menu. */
    uint8_t body;       /* enum menu_body */
    uint8_t body_count; /* Number of items in the body, <= 12, unless the kind of body determines
                           it. */
    uint8_t foot_count; /* Number of items at the foot, 1 .. MENU_FOOT_MAX. */
    uint8_t watches;    /* 1: the page displays START, OK, LEFT and RIGHT, which have no other
                           effect here. */
    uint8_t about;      /* enum setting_group of MENU_BODY_SETTINGS, enum setting_id of
                           MENU_BODY_BITS, or enum audit_group of a page of statistics. */
    uint8_t returns;    /* 1: back leads to the page from which this one was opened, not to the
                           parent. */
    uint16_t (*offers)(const struct menu *menu); /* Returns a bit for each item on offer. NULL: all
                                                    items. */
    /* Called when the page opens; NULL: nothing to do. */
    void (*enter)(struct game *game, const struct settings *settings);
    /* Called when any item but the last is selected. A page may change settings, which are part of
     * `config`. */
    void (*take)(struct game *game, struct core_config *config, uint32_t tag,
                 struct output *output);
    /* Called when the last item leads back, and when the menu closes; NULL: nothing to do. */
    void (*leave)(struct menu *menu, struct output *output);
};

/* Returns the description of `page`. `page` must be < MENU_PAGE_COUNT, else the function
 * asserts. */
const struct menu_page_desc *menu_page_desc_of(uint8_t page);

/* Return the number of items in the page's body, and on the whole page. */
uint32_t menu_body_count(uint8_t page);
uint32_t menu_tag_count(uint8_t page);

/* Return the page that a body item opens (MENU_PAGE_COUNT: none), and the item of the parent that
 * opens `page` (MENU_TAG_MAX: none). */
uint8_t menu_page_at(uint8_t page, uint32_t tag);
uint32_t menu_tag_of(uint8_t page);

/* Returns the setting of a row, or of the bit page that the row opens; SETTING_COUNT: none. */
uint32_t menu_setting_at(uint8_t page, uint32_t tag);

/* Returns a bit for each item of the open page that can be selected. */
uint16_t menu_enabled(const struct menu *menu);

/* Opens a page. The item highlighted on its last visit is highlighted again, or the first one on
 * offer. */
void menu_turn(struct game *game, const struct settings *settings, enum menu_page page);

/* Activates the highlighted item; the last item leads back. */
void menu_activate(struct game *game, struct world *world, struct core_config *config,
                   struct output *output);

/* Closes the menu and starts attract mode. A learn wizard in progress is cancelled. */
void menu_close(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Returns the box of an item on the canvas; an empty box if the item is not on offer. */
struct layout_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag);

/* Buttons that a person never presses in the same tick; the quit key of a desktop produces them as
 * "back". The page's last item is activated, whatever is highlighted, and no press is counted. TEST
 * is included because no other button leaves the page that tests the buttons. */
#define MENU_WAY_BACK ((uint32_t)(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST))

#endif
