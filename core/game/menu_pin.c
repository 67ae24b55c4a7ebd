/* menu_pin.c -- four digits before the menu opens, and how they are chosen. */
#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/menu_parts.h"

#define WAIT_TICKS (5u * CORE_TICK_HZ)
#define DOUBLINGS_MAX 5u

uint32_t menu_pin_wait_ticks(const struct core *core)
{
    const struct adjust *adjust = &core->game.adjust;
    if (adjust->pin_wrong == 0) {
        return 0;
    }
    const uint32_t doublings =
        adjust->pin_wrong - 1u < DOUBLINGS_MAX ? adjust->pin_wrong - 1u : DOUBLINGS_MAX;
    const uint32_t wait = WAIT_TICKS << doublings, gone = core->tick - adjust->pin_tick;
    return gone < wait ? wait - gone : 0u;
}

void menu_pin_enter(struct core *core)
{
    struct menu *menu = &core->game.menu;
    menu->pin = 0;
    menu->pin_count = 0;
    menu->tag[menu->page] = 0;
}

/* Whether the last digit was typed; they are then in menu->pin. */
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

void menu_pin_take(struct core *core, uint32_t tag, struct output *output)
{
    struct adjust *adjust = &core->game.adjust;
    if (menu_pin_wait_ticks(core) > 0 || !type(core, tag)) {
        return;
    }
    if (core->game.menu.pin == core->config.memory.settings.value[SET_PIN]) {
        adjust->pin_wrong = 0;
        menu_turn(core, MENU_TOP);
        return;
    }
    output_sound(output, SOUND_FOUL, 0.5f, 0.0f);
    adjust->pin_wrong += adjust->pin_wrong < UINT8_MAX;
    adjust->pin_tick = core->tick;
    menu_pin_enter(core);
}

/* 0000 asks for none from now on. */
void menu_new_pin_take(struct core *core, uint32_t tag, struct output *output)
{
    (void)output;
    if (type(core, tag)) {
        adjust_set(core, SET_PIN, core->game.menu.pin);
        menu_turn(core, MENU_UPKEEP);
    }
}
