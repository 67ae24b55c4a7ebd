/* menu_confirm.c -- performs the actions that require confirmation: restart and factory reset. */
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

_Static_assert((int)CONFIRM_BACK == (int)BOOK_BACK, "pages of the books begin there, too");

void menu_confirm_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    game->menu.tag[game->menu.page] = CONFIRM_BACK;
}

/* Requests a restart. When the store has saved everything, the shell ends the frame loop and starts
 * the kiosk again. */
void menu_restart_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output)
{
    (void)config;
    (void)tag;
    menu_command(&game->menu, output, COMMAND_RESTART);
}

void menu_factory_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output)
{
    (void)tag;
    if (settings_edit_factory_reset(game, config, output)) {
        /* The restart applies the machine's configuration and the configuration files again. */
        menu_command(&game->menu, output, COMMAND_RESTART);
        menu_turn(game, &config->persistent.settings, MENU_UPKEEP);
    }
}
