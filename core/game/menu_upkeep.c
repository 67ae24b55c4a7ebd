/* menu_upkeep.c -- what is asked twice: a restart, and the state of the first day. */
#include "core/core.h"
#include "core/game/menu_parts.h"

_Static_assert((int)SURE_BACK == (int)BOOK_BACK, "pages of the books begin there, too");

void menu_sure_enter(struct core *core)
{
    core->game.menu.tag[core->game.menu.page] = SURE_BACK;
}

/* The shell ends the frame loop once the store has everything, and begins anew. */
void menu_restart_take(struct core *core, uint32_t tag, struct output *output)
{
    (void)tag;
    menu_order(core, output, DESK_RESTART);
}

void menu_factory_take(struct core *core, uint32_t tag, struct output *output)
{
    (void)tag;
    if (adjust_factory(core, output)) {
        /* What the machine and its files say holds again. */
        menu_order(core, output, DESK_RESTART);
        menu_turn(core, MENU_UPKEEP);
    }
}
