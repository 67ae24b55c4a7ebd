/* menu_upkeep.c -- the menu pages that are rarely needed: the list of files, restart, factory
 * reset, and the entry of the PIN. */
#include "core/game/menu/menu_pages.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/pin.h"

_Static_assert((int)CONFIRM_BACK == (int)BOOK_BACK, "pages of the books begin there, too");

void menu_confirm_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    (void)settings;
    menu->tag[menu->page] = CONFIRM_BACK;
}

/* Requests a restart of the kiosk. When the store has saved everything, the shell ends the frame
 * loop and starts the kiosk again. */
void menu_restart_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag == CONFIRM_YES);
    (void)tag;
    menu_command(scope->menu, scope->output, COMMAND_RESTART);
}

void menu_factory_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag == CONFIRM_YES);
    (void)tag;
    if (settings_edit_factory_reset(scope)) {
        /* Request a restart, which applies the machine's configuration and the configuration files
         * again. */
        menu_command(scope->menu, scope->output, COMMAND_RESTART);
        menu_go(scope, MENU_UPKEEP);
    }
}

/* Offers the update page only if the machine can be updated. In the recording of an older program
 * the page is missing, so its tags have the same places as then. */
uint16_t menu_upkeep_enabled(const struct menu *menu)
{
    uint16_t offered = 0;
    for (uint32_t tag = 0; tag < menu_tag_count(MENU_UPKEEP, menu->rules); tag++) {
        const bool is_update = menu_page_at(MENU_UPKEEP, menu->rules, tag) == MENU_UPDATE;
        if (!is_update || menu->controllers.update != UPDATE_NONE) {
            offered |= MENU_TAG(tag);
        }
    }
    return offered;
}

uint16_t menu_update_enabled(const struct menu *menu)
{
    const bool is_ready = menu->controllers.update == UPDATE_READY;
    return (uint16_t)((is_ready ? MENU_TAG(UPDATE_START) : 0u) | MENU_TAG(UPDATE_BACK));
}

void menu_update_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    (void)settings;
    menu->tag[MENU_UPDATE] = UPDATE_BACK;
}

void menu_update_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag == UPDATE_START);
    (void)tag;
    menu_command(scope->menu, scope->output, COMMAND_UPDATE);
}

#define FILES_SHOWN 5u

uint32_t menu_files_shown(bool upright)
{
    return upright ? SCENE_FILE_MAX : FILES_SHOWN;
}

uint16_t menu_files_enabled(const struct menu *menu)
{
    const bool is_long = menu->controllers.file_count > menu_files_shown(menu->upright);
    return (uint16_t)((is_long ? MENU_TAG(FILES_MORE) : 0u) | MENU_TAG(FILES_SEEN) |
                      MENU_TAG(FILES_BACK));
}

/* Opens the page of files. The highlighted item is harmless if the operator selects it by
 * accident. */
void menu_files_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    (void)settings;
    menu->file_first = 0;
    menu->tag[MENU_FILES] =
        menu_files_enabled(menu) & MENU_TAG(FILES_MORE) ? FILES_MORE : FILES_BACK;
}

/* Shows the next rows of the list of files; after the last rows, the first rows follow. The item
 * FILES_SEEN sends a command to the shell, which acknowledges the quarantined databases. */
void menu_files_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag < FILES_BACK);
    struct menu *menu = scope->menu;
    if (tag == FILES_SEEN) {
        menu_command(menu, scope->output, COMMAND_SEEN);
        return;
    }
    const uint32_t next = menu->file_first + menu_files_shown(menu->upright);
    menu->file_first = (uint8_t)(next < menu->controllers.file_count ? next : 0u);
}

#define WAIT_TICKS (5u * CORE_TICK_HZ)
#define DOUBLINGS_MAX 5u

uint32_t menu_pin_wait_ticks(const struct settings_edit *settings_edit, uint32_t tick)
{
    const uint32_t wrong = settings_edit->pin_wrong;
    if (wrong == 0) {
        return 0;
    }
    const uint32_t wait = WAIT_TICKS << (wrong - 1u < DOUBLINGS_MAX ? wrong - 1u : DOUBLINGS_MAX);
    const uint32_t gone = tick - settings_edit->pin_tick;
    return gone < wait ? wait - gone : 0u;
}

bool menu_takes_pin(const struct game *game)
{
    const uint8_t page = game->menu.page;
    return game->phase == PHASE_MENU && (page == MENU_PIN || page == MENU_NEW_PIN);
}

void menu_pin_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    (void)settings;
    menu->pin = 0;
    menu->pin_count = 0;
    menu->tag[menu->page] = 0;
}

/* Adds a digit to the end of menu->pin, or erases all digits. Returns true if menu->pin now has all
 * of its digits. */
static bool type_pin_key(struct menu *menu, uint32_t tag)
{
    if (tag == PIN_ERASE) {
        menu->pin = 0;
        menu->pin_count = 0;
        return false;
    }
    CORE_ASSERT(tag < PIN_ERASE && menu->pin_count < MENU_PIN_DIGITS);
    menu->pin = (uint16_t)(menu->pin * 10u + (tag + 1u) % 10u);
    return ++menu->pin_count == MENU_PIN_DIGITS;
}

/* Checks the PIN after its last digit, and opens the menu or starts the lockout time. The ledger
 * contains each wrong PIN, so that the lockout time continues after a power cut. If the ledger has
 * no room, the lockout ends when the kiosk is switched off. */
void menu_pin_activate(const struct menu_scope *scope, uint32_t tag)
{
    struct settings_edit *edit = scope->settings_edit;
    const struct settings *settings = &scope->config->persistent.settings;
    const uint32_t tick = scope->game->tick;
    if (menu_pin_wait_ticks(edit, tick) > 0 || !type_pin_key(scope->menu, tag)) {
        return;
    }
    const bool is_right = pin_matches(settings->value[SET_PIN], scope->menu->pin);
    if (!is_right || edit->pin_wrong > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_PIN, .detail = (uint8_t)is_right };
        ledger_write(scope->accounts, tick, &entry, scope->output);
    }
    edit->pin_wrong = is_right ? 0u : edit->pin_wrong + (edit->pin_wrong < UINT8_MAX);
    edit->pin_tick = tick;
    if (is_right) {
        menu_go(scope, MENU_TOP);
        return;
    }
    output_sound(scope->output, SOUND_FOUL, 0.5f, 0.0f);
    menu_pin_open(scope->menu, scope->game, settings);
}

/* Sets a new PIN when its last digit has been typed. The PIN 0000 means that no PIN is required.
 * The setting contains a salted hash of the PIN, but plain digits while a recording of format 7 or
 * older is replayed. */
void menu_new_pin_activate(const struct menu_scope *scope, uint32_t tag)
{
    const struct core_config *config = scope->config;
    if (type_pin_key(scope->menu, tag)) {
        const struct rng_key key = { config->seed, scope->game->tick, 0, RNG_PIN };
        const uint32_t pin = scope->menu->pin, salt = rng_u32(key);
        settings_edit_set(scope, SET_PIN,
                          !config_has_rules(config, 8) ? (int32_t)pin : pin_hide(pin, salt));
        menu_go(scope, MENU_UPKEEP);
    }
}
