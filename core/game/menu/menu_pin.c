/* menu_pin.c -- the pages on which the operator enters the PIN before the menu opens, and chooses a
 * new PIN. */
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"
#include "core/pin.h"

#define WAIT_TICKS (5u * CORE_TICK_HZ)
#define DOUBLINGS_MAX 5u

/* Logs a PIN entry in the ledger, so that the lockout time continues after a power cut. If the
 * ledger has no room, the lockout ends when the kiosk is switched off. */
static void note_typed(struct accounts *accounts, struct settings_edit *settings_edit,
                       uint32_t tick, int is_right, struct output *output)
{
    if (!is_right || settings_edit->pin_wrong > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_PIN, .detail = (uint8_t)is_right };
        ledger_write(accounts, tick, &entry, output);
    }
    settings_edit->pin_wrong =
        is_right ? 0u : settings_edit->pin_wrong + (settings_edit->pin_wrong < UINT8_MAX);
    settings_edit->pin_tick = tick;
}

uint32_t menu_pin_wait_ticks(const struct settings_edit *settings_edit, uint32_t tick)
{
    if (settings_edit->pin_wrong == 0) {
        return 0;
    }
    const uint32_t doublings = settings_edit->pin_wrong - 1u < DOUBLINGS_MAX
                                   ? settings_edit->pin_wrong - 1u
                                   : DOUBLINGS_MAX;
    const uint32_t wait = WAIT_TICKS << doublings, gone = tick - settings_edit->pin_tick;
    return gone < wait ? wait - gone : 0u;
}

void menu_pin_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    struct menu *menu = &game->menu;
    menu->pin = 0;
    menu->pin_count = 0;
    menu->tag[menu->page] = 0;
}

/* Adds a digit to menu->pin, or erases all digits. Returns 1 if the last digit was typed, otherwise
 * 0. After the last digit menu->pin has all digits. */
static int type(struct menu *menu, uint32_t tag)
{
    if (tag == PIN_ERASE) {
        menu->pin = 0;
        menu->pin_count = 0;
        return 0;
    }
    CORE_ASSERT(tag < PIN_ERASE && menu->pin_count < MENU_PIN_DIGITS);
    menu->pin = (uint16_t)(menu->pin * 10u + (tag + 1u) % 10u);
    return ++menu->pin_count == MENU_PIN_DIGITS;
}

void menu_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output)
{
    if (menu_pin_wait_ticks(&game->settings_edit, game->tick) > 0 || !type(&game->menu, tag)) {
        return;
    }
    const int is_right = pin_matches(config->persistent.settings.value[SET_PIN], game->menu.pin);
    note_typed(&game->accounts, &game->settings_edit, game->tick, is_right, output);
    if (is_right) {
        menu_turn(game, &config->persistent.settings, MENU_TOP);
        return;
    }
    output_sound(output, SOUND_FOUL, 0.5f, 0.0f);
    menu_pin_open(game, &config->persistent.settings);
}

/* Returns the stored form of the new PIN. Recordings of format 7 stored plain digits. */
static int32_t kept_pin(const struct menu *menu, const struct core_config *config, uint32_t tick)
{
    const uint32_t salt = rng_u32((struct rng_key){ config->seed, tick, 0, RNG_PIN });
    const uint32_t pin = menu->pin;
    return config->rules_7 ? (int32_t)pin : pin_hide(pin, salt);
}

/* Sets a new PIN. The PIN 0000 means that no PIN is required. */
void menu_new_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output)
{
    (void)output;
    if (type(&game->menu, tag)) {
        settings_edit_set(game, config, SET_PIN, kept_pin(&game->menu, config, game->tick));
        menu_turn(game, &config->persistent.settings, MENU_UPKEEP);
    }
}
