/* menu.h -- the operator's menu: pages of items drawn as wooden tags. One item is highlighted.
 *
 * TEST opens the menu. In the menu, SERVICE, LEFT and RIGHT move the highlight. TEST, START and OK
 * select the highlighted item. The two buttons inside the cabinet (TEST and SERVICE) are therefore
 * sufficient.
 *
 * A poi over the water also moves the highlight, and a dip selects. The poi of any slot can be
 * used; the poi that moved last controls the highlight.
 *
 * The last item of each page leads back.
 *
 * While the menu is open no game is played and coins are returned, except on the page that tests
 * the input lines. On that page the meter counts a coin as a test, without a credit. TEST during a
 * round only requests confirmation, because the button is easy to press by accident and the player
 * has paid. A second press ends the round and refunds its credit. A refunded round is neither a
 * score nor a record.
 *
 * To add a page, add a name to enum menu_page, a row in menu_pages.c with its parent and actions,
 * and a row of texts in platform/render/ui/menu/ui_menu_words.c. A page that only lists other
 * pages, or a group of settings, needs no code. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/menu/menu_state.h"
#include "core/output.h"
#include "core/settings.h"

struct accounts;
struct game;
struct ledger;
struct settings_edit;
struct world;
struct core_config;

/* Parts of the state that the pages of the menu work on. An action of a page changes no other
 * part. */
struct menu_scope {
    const struct game *game; /* State that the pages read. */
    struct menu *menu;
    struct settings_edit *settings_edit;
    struct accounts *accounts;
    uint8_t *language; /* Display language, which a change of SET_LANGUAGE changes too. */
    struct core_config *config;
    struct output *output;
};

/* Returns the scope of the menu's pages for the current tick. */
struct menu_scope menu_scope_of(struct game *game, struct core_config *config,
                                struct output *output);

/* Returns true if TEST opens the menu in this tick. During a round the first press only requests
 * confirmation. */
bool menu_opens(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output);
void menu_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output);

/* Returns true while the menu asks for confirmation to end the round. While this function returns
 * true, a second TEST press ends the round. */
bool menu_is_confirming(const struct game *game);

/* Returns true while the operator tests the input lines in the menu. During the test the coin slot
 * is open, and a coin counts as a test. */
bool menu_tries_lines(const struct game *game);

/* Returns true while the menu shows a page on which a PIN is typed. */
bool menu_takes_pin(const struct game *game);

/* Returns the ticks until a PIN can be typed; 0 means immediately. A wrong PIN locks the entry for
 * 5 s. Each further wrong PIN doubles the time, up to 160 s. */
uint32_t menu_pin_wait_ticks(const struct settings_edit *settings_edit, uint32_t tick);

/* Returns the number of files that the menu's file page shows at once, each with its full text.
 * `upright` is 1 on a portrait screen. */
uint32_t menu_files_shown(bool upright);

/* Fills `out` with the visible state of the menu. */
void menu_show(const struct game *game, const struct core_config *config, struct scene_menu *out);

/* ---- Calibration page ------------------------------------------------------------------------ */

/* The menu page on which the operator calibrates a slot's poi, one mark after the other, without
 * buttons.
 *
 * The operator needs both hands for the poi, so a pose is accepted when the poi is held still for
 * 1.5 s. The poi must then move away before the next pose can be accepted. The result takes effect
 * immediately, and the page shows the corrected position. While the menu is open, the operator can
 * restore the previous calibration, and can also undo the restoration. */

/* Returns true while the operator moves the poi from mark to mark. During that time the poi does
 * not point at items. */
bool menu_calibrate_is_running(const struct calibrate *calibrate);

/* Returns for how long the operator has held the poi still, as a share of the required time, [0,
 * 1]. */
float menu_calibrate_progress(const struct calibrate *calibrate);

/* Evaluates the uncorrected poses of the controllers. Call once per tick. The function has an
 * effect only while the calibration page of the menu is open. */
void menu_calibrate_tick(const struct menu_scope *scope, const struct world *world,
                         const struct input *raw);

/* ---- Self-test page -------------------------------------------------------------------------- */

/* The self-test before the kiosk opens: one page that tests everything a player uses, and shows the
 * state of the machine.
 *
 * Automatic checks finish within twenty seconds. The checks cover a ledger entry that the store
 * confirms, the clock, the frame rate, and files rejected at startup. A check without a result
 * after twenty seconds is bad. The shell adds the state of the machine (struct scene_machine),
 * which never becomes part of the core's state.
 *
 * The operator confirms what only a person can notice: the sound, the lamp and the coin slot. The
 * operator also presses each button, inserts a coin, and moves each poi in all three directions.
 *
 * An untested part is not ready, unless the kiosk does not use the part. A kiosk without input
 * lines does not use the lamp and the coin slot. A kiosk in free play does not use coins. */

/* Runs the checks while the self-test page of the menu is open. Call once per tick. */
void self_test_tick(const struct menu_scope *scope, const struct input *input);

/* Writes the results of the automatic checks to `out`, for self_test_result(). */
void self_test_show(const struct game *game, const struct core_config *config,
                    struct scene_self_test *out);

/* Returns true in the first half of each second while the question about the lamp and the coin slot
 * is open. While the function returns true, the lamp is lit and the coin slot is closed. */
bool self_test_shows(const struct game *game);

/* Evaluates the data of the core and of the devices in `scene`. Writes the state of each check
 * (enum self_check) to `state`. Returns the check to display next, or SELF_CHECKS if the kiosk is
 * ready. Checks are displayed in the following order: checks that the operator must perform, bad
 * checks, checks that need attention, checks without a result. */
uint32_t self_test_result(const struct scene *scene, uint8_t state[SELF_CHECKS]);

/* Returns the number of checks whose state is not SELF_GOOD. */
uint32_t self_test_left(const uint8_t state[SELF_CHECKS]);

/* ---- Changes of settings --------------------------------------------------------------------- */

/* Functions that change settings while the kiosk runs. A change takes effect immediately. The
 * ledger entry is written when the value has not changed for SETTINGS_EDIT_REST_TICKS.
 *
 * A caller, such as a page of the operator's menu, only calls settings_edit_set(). A later
 * settings_edit_tick() logs each changed value. A setting is therefore not lost if the ledger's
 * ring buffer is full or the menu is closed quickly. A value that is stepped twenty times produces
 * one entry. */

/* Initializes `settings_edit` with the settings in `config`. Invalid values are replaced by
 * defaults. The resulting settings count as already logged. */
void settings_edit_init(struct settings_edit *settings_edit, const struct core_config *config);

/* Returns the highest value that setting `id` can have in this kiosk. The tank's capacity limits
 * the number of fish. */
int32_t settings_edit_max(const struct core_config *config, uint32_t id);

/* Sets setting `id` to `value`. settings_allows() must permit the value, which must not exceed
 * settings_edit_max(). A new number of fish or players takes effect when attract mode next
 * begins. */
void settings_edit_set(const struct menu_scope *scope, uint32_t id, int32_t value);

/* Moves setting `id` up or down by `step_count` steps, at most to the end of its range. A step
 * beyond the end continues at the opposite end. Returns true if the new value is at the end. */
bool settings_edit_step(const struct menu_scope *scope, uint32_t id, bool is_down,
                        uint32_t step_count);

/* Resets every setting to its default, empties the balance, and logs both changes in one entry.
 * Returns true, or changes nothing and returns false if the ledger's ring buffer has no room. */
bool settings_edit_factory_reset(const struct menu_scope *scope);

/* Logs changed settings after SETTINGS_EDIT_REST_TICKS without a further change. Call once per tick
 * in every phase. */
void settings_edit_tick(const struct menu_scope *scope);

/* Returns true if every change of a setting is on disk. */
bool settings_edit_is_saved(const struct ledger *ledger, const struct settings_edit *settings_edit,
                            const struct settings *settings);
