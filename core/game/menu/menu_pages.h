/* menu_pages.h -- describes the pages of the operator's menu as data. Internal to core/game and the
 * renderer.
 *
 * The items in a page's body have the first numbers, from 0. The items at the page's foot follow.
 * The last item is always available and leads back to the page's parent. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/menu/menu.h"

#define MENU_FOOT_MAX 5u

enum menu_body {
    /* The body has no items. The page shows other content in the place of the items. */
    MENU_BODY_FREE = 0,
    MENU_BODY_TILES,    /* Large items side by side, at most eight. */
    MENU_BODY_ROWS,     /* One row for each item. The place of an unavailable item stays empty. */
    MENU_BODY_PAGES,    /* One large item for each page whose parent is this page. */
    MENU_BODY_SETTINGS, /* One row for each setting of a group, then one row for each subpage. */
    MENU_BODY_BITS,     /* One row for each bit of a setting. */
    MENU_BODY_KEYS,     /* Small items with one digit each. */
};

/* Returns a bit mask of the items of the open page that can be selected. */
typedef uint16_t menu_is_enabled(const struct menu *menu);
/* Action of a page when it opens, such as selecting its first item. */
typedef void menu_open_page(struct menu *menu, const struct game *game,
                            const struct settings *settings);
/* Runs the action of the selected item `tag`, which is not the last item of the page. */
typedef void menu_activate_page(const struct menu_scope *scope, uint32_t tag);

struct menu_page_desc {
    /* Parent page (enum menu_page). MENU_PAGE_COUNT means that the last item closes the menu. */
    uint8_t parent;
    uint8_t body; /* Kind of the page's body (enum menu_body). */
    /* Number of items in the body, <= 12; ignored if the kind of body determines the number. */
    uint8_t body_count;
    uint8_t foot_count; /* Number of items at the foot of the page, 1 .. MENU_FOOT_MAX. */
    /* True if the page displays presses of START, OK, LEFT and RIGHT, which then have no other
     * effect. */
    bool shows_presses;
    /* Topic of the page: an enum setting_group for MENU_BODY_SETTINGS, an enum setting_id for
     * MENU_BODY_BITS, or an enum audit_group for a page of statistics. */
    uint8_t topic;
    /* True if the last item leads back to the page from which this page was opened. False if the
     * last item leads to the parent page. */
    bool returns;
    /* Returns the items that can be selected. NULL means that all items are available. */
    menu_is_enabled *is_enabled;
    menu_open_page *open; /* Called when the page opens. NULL means that nothing is to be done. */
    /* Called when an item of the page is selected. NULL for a page on which only the last item and
     * other pages can be selected. */
    menu_activate_page *activate;
    /* Called when the last item is selected, and when the menu closes; NULL means that nothing
     * needs to be done. */
    void (*leave)(struct menu *menu, struct output *output);
};

/* Returns the description of `page`. Asserts that `page` < MENU_PAGE_COUNT. */
const struct menu_page_desc *menu_page_desc_of(uint8_t page);

/* menu_body_count() returns the number of items in the page's body. menu_tag_count() returns the
 * number of all items of the page. `rules` is the format whose rules the menu follows, or 0 for the
 * current rules. These functions and the functions below omit the rows of settings that are newer
 * than the format. */
uint32_t menu_body_count(uint8_t page, uint8_t rules);
uint32_t menu_tag_count(uint8_t page, uint8_t rules);

/* Returns the page that item `tag` in the body opens; MENU_PAGE_COUNT means none. */
uint8_t menu_page_at(uint8_t page, uint8_t rules, uint32_t tag);

/* Returns the setting (enum setting_id) of row `tag` of `page`: the setting that the row changes,
 * or the setting of the page that the row opens. Returns SETTING_COUNT if the row has no
 * setting. */
uint32_t menu_setting_at(uint8_t page, uint8_t rules, uint32_t tag);

/* Returns a bit mask of the items of the open page that can be selected. */
uint16_t menu_enabled(const struct menu *menu);

/* Opens a page. Highlights the item that was highlighted on the last visit, or the first available
 * item. */
void menu_turn(struct menu *menu, const struct game *game, const struct settings *settings,
               enum menu_page page);

/* Opens a page as menu_turn() does. The actions of the menu's pages call this function. */
void menu_go(const struct menu_scope *scope, enum menu_page page);

/* Runs the action of the highlighted item. The last item opens the parent page. Returns true if the
 * last item closes the menu; the caller must then call menu_close(). */
bool menu_activate(const struct menu_scope *scope);

/* Closes the menu and starts attract mode. A learn wizard in progress is cancelled. */
void menu_close(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Returns the box of item `tag` on the canvas. The box is empty if the item is not in the bit mask
 * `offered`. */
struct layout_box menu_box(bool upright, uint8_t page, uint8_t rules, uint16_t offered,
                           uint32_t tag);

/* Returns true if item `tag` of `page` has two arrows: the left arrow lowers the value of the
 * row's setting, and the right arrow raises it. Under the rules of formats before 10, no row has
 * arrows. */
bool menu_has_arrows(uint8_t page, uint8_t rules, uint32_t tag);

/* Returns the box of an arrow in the row whose box is `row`. `is_left` selects the left arrow;
 * otherwise the function returns the box of the right arrow. The value is between the arrows. */
struct layout_box menu_arrow_box(struct layout_box row, bool is_left);

/* If the point `at` is on an arrow of the highlighted row, the next change of the row's value has
 * the direction of the arrow. */
void menu_aim_at_arrow(struct menu *menu, struct layout_point at);

/* Combination of buttons that means "back". A person never presses all of these buttons in the same
 * tick; the quit key of a desktop produces the combination. The page's last item is activated,
 * whichever item is highlighted, and no press is counted. TEST is included because no other button
 * leaves the page that tests the buttons. */
#define MENU_WAY_BACK ((uint32_t)(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST))

/* ---- Actions of the pages -------------------------------------------------------------------- */

#define MENU_TAG(tag) ((uint16_t)(1u << (tag)))

/* Sends the command `kind` about the selected controller to the shell (the program around the
 * core). */
void menu_command(struct menu *menu, struct output *output, enum controller_command_kind kind);

/* Actions of the pages in menu_devices.c. menu_reopen() highlights the first item of the open
 * page. */
menu_is_enabled menu_rows_enabled, menu_row_enabled, menu_learn_enabled, menu_calibrate_enabled;
menu_open_page menu_reopen, menu_calibrate_open;
menu_activate_page menu_rows_activate, menu_row_activate, menu_learn_activate,
    menu_calibrate_activate;
void menu_learn_close(struct menu *menu, struct output *output);

/* self_test.c. */
menu_is_enabled menu_self_enabled;
menu_open_page menu_self_open;
menu_activate_page menu_self_activate;

/* menu_books.c. */
menu_is_enabled menu_ranking_enabled, menu_score_enabled;
menu_open_page menu_ranking_open, menu_score_open;
menu_activate_page menu_book_activate, menu_reset_activate, menu_ranking_activate,
    menu_score_activate;

/* Actions of the pages in menu_upkeep.c. menu_confirm_open() highlights the item "Back" of a page
 * that requests confirmation, so that an accidental press does nothing. */
menu_is_enabled menu_files_enabled, menu_upkeep_enabled, menu_update_enabled;
menu_open_page menu_files_open, menu_confirm_open, menu_pin_open, menu_update_open;
menu_activate_page menu_files_activate, menu_restart_activate, menu_factory_activate,
    menu_update_activate;
menu_activate_page menu_pin_activate, menu_new_pin_activate;

/* settings_edit.c. */
menu_is_enabled menu_settings_enabled;
menu_open_page menu_settings_open;
menu_activate_page menu_settings_activate, menu_bits_activate;

/* Repeats the change of the selected setting while `is_pressed` is true, which means that the
 * button is still held or the poi is still dipped. */
void menu_settings_tick(const struct menu_scope *scope, bool is_pressed);
