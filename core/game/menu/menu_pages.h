/* menu_pages.h -- describes the pages of the operator's menu as data. Internal to core/game and the
 * renderer.
 *
 * The items in a page's body have the first numbers, from 0. The items at the page's foot follow.
 * The last item is always available and leads back to the page's parent. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_PAGES_H
#define KINGYO_CORE_GAME_MENU_MENU_PAGES_H

#include <stdint.h>

#include "core/game/menu/menu.h"

#define MENU_FOOT_MAX 5u

enum menu_body {
    MENU_BODY_FREE = 0, /* The body has no items; the page shows other content in its place. */
    MENU_BODY_TILES,    /* Large items side by side, at most eight. */
    MENU_BODY_ROWS,     /* One row for each item. The place of an unavailable item stays empty. */
    MENU_BODY_PAGES,    /* One large item for each page whose parent is this page. */
    MENU_BODY_SETTINGS, /* One row for each setting of a group, then one row for each subpage. */
    MENU_BODY_BITS,     /* One row for each bit of a setting. */
    MENU_BODY_KEYS,     /* Small items with one digit each. */
};

struct menu_page_desc {
    uint8_t parent;     /* Parent page (enum menu_page). MENU_PAGE_COUNT means that the last item
                           closes the menu. */
    uint8_t body;       /* Kind of body (enum menu_body). */
    uint8_t body_count; /* Number of items in the body, <= 12; ignored if the kind of body
                           determines the number. */
    uint8_t foot_count; /* Number of items at the foot, 1 .. MENU_FOOT_MAX. */
    uint8_t watches;    /* 1 if the page displays START, OK, LEFT and RIGHT, which then have no
                           other effect; otherwise 0. */
    uint8_t about;      /* Topic of the page: an enum setting_group for MENU_BODY_SETTINGS, an enum
                           setting_id for MENU_BODY_BITS, or an enum audit_group for a page of
                           statistics. */
    uint8_t returns;    /* 1 if the last item leads back to the page from which this page was
                           opened. 0 if the last item leads to the parent page. */
    uint16_t (*offers)(const struct menu *menu); /* Returns a bit mask of the available items. NULL
                                                    means that all items are available. */
    /* Called when the page opens; NULL means that nothing needs to be done. */
    void (*enter)(struct game *game, const struct settings *settings);
    /* Called when any item except the last item is selected. A page may change settings, which are
     * part of `config`. */
    void (*take)(struct game *game, struct core_config *config, uint32_t tag,
                 struct output *output);
    /* Called when the last item is selected, and when the menu closes; NULL means that nothing
     * needs to be done. */
    void (*leave)(struct menu *menu, struct output *output);
};

/* Returns the description of `page`. Asserts that `page` < MENU_PAGE_COUNT. */
const struct menu_page_desc *menu_page_desc_of(uint8_t page);

/* menu_body_count() returns the number of items in the page's body. menu_tag_count() returns the
 * number of all items of the page. */
uint32_t menu_body_count(uint8_t page);
uint32_t menu_tag_count(uint8_t page);

/* menu_page_at() returns the page that item `tag` in the body opens; MENU_PAGE_COUNT means none.
 * menu_tag_of() returns the item of the parent that opens `page`; MENU_TAG_MAX means none. */
uint8_t menu_page_at(uint8_t page, uint32_t tag);
uint32_t menu_tag_of(uint8_t page);

/* Returns the setting in row `tag` of `page`, or the setting of the bit page that the row opens.
 * SETTING_COUNT means none. */
uint32_t menu_setting_at(uint8_t page, uint32_t tag);

/* Returns a bit mask of the items of the open page that can be selected. */
uint16_t menu_enabled(const struct menu *menu);

/* Opens a page. Highlights the item that was highlighted on the last visit, or the first available
 * item. */
void menu_turn(struct game *game, const struct settings *settings, enum menu_page page);

/* Activates the highlighted item. The last item opens the parent page or closes the menu. */
void menu_activate(struct game *game, struct world *world, struct core_config *config,
                   struct output *output);

/* Closes the menu and starts attract mode. A learn wizard in progress is cancelled. */
void menu_close(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Returns the box of item `tag` on the canvas. The box is empty if the item is not in the bit mask
 * `offered`. */
struct layout_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag);

/* Combination of buttons that stands for "back". A person never presses all of these buttons in the
 * same tick; the quit key of a desktop produces the combination. The page's last item is activated,
 * whichever item is highlighted, and no press is counted. TEST is included because no other button
 * leaves the page that tests the buttons. */
#define MENU_WAY_BACK ((uint32_t)(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST))

/* ---- Actions of the pages -------------------------------------------------------------------- */

#define MENU_TAG(tag) ((uint16_t)(1u << (tag)))

/* Sends a command about the selected controller to the shell. */
void menu_command(struct menu *menu, struct output *output, enum controller_command_kind kind);

/* The following functions are in menu_devices.c. */
uint16_t menu_rows_enabled(const struct menu *menu);
void menu_rows_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);
uint16_t menu_row_enabled(const struct menu *menu);
void menu_row_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output);
uint16_t menu_learn_enabled(const struct menu *menu);
void menu_learn_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);
void menu_learn_close(struct menu *menu, struct output *output);
/* Highlights the first item of the open page. */
void menu_reopen(struct game *game, const struct settings *settings);
uint16_t menu_calibrate_enabled(const struct menu *menu);
void menu_calibrate_open(struct game *game, const struct settings *settings);
void menu_calibrate_activate(struct game *game, struct core_config *config, uint32_t tag,
                             struct output *output);

/* The following functions are in self_test.c. */
uint16_t menu_self_enabled(const struct menu *menu);
void menu_self_open(struct game *game, const struct settings *settings);
void menu_self_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);

/* The following functions are in menu_books.c. */
void menu_book_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);
void menu_reset_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);
uint16_t menu_ranking_enabled(const struct menu *menu);
void menu_ranking_open(struct game *game, const struct settings *settings);
void menu_ranking_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);
uint16_t menu_score_enabled(const struct menu *menu);
void menu_score_open(struct game *game, const struct settings *settings);
void menu_score_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);

/* The following functions are in menu_upkeep.c. */
uint16_t menu_files_enabled(const struct menu *menu);
void menu_files_open(struct game *game, const struct settings *settings);
void menu_files_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);
/* Highlights the item "Back" of a page that requests confirmation, so that an accidental press does
 * nothing. */
void menu_confirm_open(struct game *game, const struct settings *settings);
void menu_restart_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);
void menu_factory_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);
void menu_pin_open(struct game *game, const struct settings *settings);
void menu_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output);
void menu_new_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);

/* The following functions are in settings_edit.c. */
uint16_t menu_settings_enabled(const struct menu *menu);
void menu_settings_open(struct game *game, const struct settings *settings);
void menu_settings_activate(struct game *game, struct core_config *config, uint32_t tag,
                            struct output *output);
void menu_bits_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);

/* Continues to change a value while the button or poi that selected the value is still pressed. */
void menu_settings_tick(struct game *game, struct core_config *config, int is_pressed,
                        struct output *output);

#endif
