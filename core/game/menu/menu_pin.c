/* menu_pin.c -- entry of the PIN before the menu opens, and choice of a new PIN. */
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/menu/menu_internal.h"
#include "core/pin.h"

#define WAIT_TICKS (5u * CORE_TICK_HZ)
#define DOUBLINGS_MAX 5u

/* Logs a PIN entry in the ledger, so that the lockout time continues after a power cut. If the
 * ledger has no room, the lockout still applies until power-off. */
static void note_typed(struct core *core, int is_right, struct output *output)
{
    struct settings_edit *settings_edit = &core->game.settings_edit;
    if (!is_right || settings_edit->pin_wrong > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_PIN, .detail = (uint8_t)is_right };
        ledger_write(core, &entry, output);
    }
    settings_edit->pin_wrong =
        is_right ? 0u : settings_edit->pin_wrong + (settings_edit->pin_wrong < UINT8_MAX);
    settings_edit->pin_tick = core->game.tick;
}

uint32_t menu_pin_wait_ticks(const struct core *core)
{
    const struct settings_edit *settings_edit = &core->game.settings_edit;
    if (settings_edit->pin_wrong == 0) {
        return 0;
    }
    const uint32_t doublings = settings_edit->pin_wrong - 1u < DOUBLINGS_MAX
                                   ? settings_edit->pin_wrong - 1u
                                   : DOUBLINGS_MAX;
    const uint32_t wait = WAIT_TICKS << doublings, gone = core->game.tick - settings_edit->pin_tick;
    return gone < wait ? wait - gone : 0u;
}

void menu_pin_open(struct core *core)
{
    struct menu *menu = &core->game.menu;
    menu->pin = 0;
    menu->pin_count = 0;
    menu->tag[menu->page] = 0;
}

/* Adds a digit, or erases all. Returns 1 if the last digit was typed; menu->pin then has all
 * digits. */
static int type(struct core *core, uint32_t tag)
{
    struct menu *menu = &core->game.menu;
    if (tag == PIN_ERASE) {
        menu->pin = 0;
        menu->pin_count = 0;
        return 0;
    }
    CORE_ASSERT(tag < PIN_ERASE && menu->pin_count < MENU_PIN_DIGITS);
    menu->pin = (uint16_t)(menu->pin * 10u + (tag + 1u) % 10u);
    return ++menu->pin_count == MENU_PIN_DIGITS;
}

void menu_pin_activate(struct core *core, uint32_t tag, struct output *output)
{
    if (menu_pin_wait_ticks(core) > 0 || !type(core, tag)) {
        return;
    }
    const int is_right =
        pin_matches(core->config.persistent.settings.value[SET_PIN], core->game.menu.pin);
    note_typed(core, is_right, output);
    if (is_right) {
        menu_turn(core, MENU_TOP);
        return;
    }
    output_sound(output, SOUND_FOUL, 0.5f, 0.0f);
    menu_pin_open(core);
}

/* Returns the stored form of the new PIN. Recordings of format 7 stored plain digits. */
static int32_t kept_pin(const struct core *core)
{
    const uint32_t salt =
        rng_u32((struct rng_key){ core->config.seed, core->game.tick, 0, RNG_PIN });
    const uint32_t pin = core->game.menu.pin;
    return core->config.rules_7 ? (int32_t)pin : pin_hide(pin, salt);
}

/* Sets a new PIN; 0000 disables the PIN. */
void menu_new_pin_activate(struct core *core, uint32_t tag, struct output *output)
{
    (void)output;
    if (type(core, tag)) {
        settings_edit_set(core, SET_PIN, kept_pin(core));
        menu_turn(core, MENU_UPKEEP);
    }
}
