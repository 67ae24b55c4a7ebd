/* menu_upkeep.c -- actions that require confirmation: restart and factory reset. */
#include "core/core.h"
#include "core/game/menu_parts.h"

_Static_assert((int)SURE_BACK == (int)BOOK_BACK, "pages of the books begin there, too");

void menu_sure_enter(struct core *core)
{
    core->game.menu.tag[core->game.menu.page] = SURE_BACK;
}

/* Requests a restart. The shell ends the frame loop when the store has saved everything, and starts
 * the kiosk again. */
void menu_restart_take(struct core *core, uint32_t tag, struct output *output)
{
    (void)tag;
    menu_order(core, output, DESK_RESTART);
}

void menu_factory_take(struct core *core, uint32_t tag, struct output *output)
{
    (void)tag;
    if (adjust_factory(core, output)) {
        /* A restart applies the configuration of the machine and of its files again. */
        menu_order(core, output, DESK_RESTART);
        menu_turn(core, MENU_UPKEEP);
    }
}
