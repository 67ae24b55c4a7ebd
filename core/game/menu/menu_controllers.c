/* menu_controllers.c -- selects controllers, and runs the learn wizard for an unknown
 * controller. */
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

/* ---- All controllers ------------------------------------------------------------------------ */

uint16_t menu_rows_enabled(const struct menu *menu)
{
    uint16_t offers = MENU_TAG(ROWS_BACK);
    for (uint32_t row = 0; row < CONTROLLER_MAX; row++) {
        offers |= menu->controllers.state[row] != CONTROLLER_NONE ? MENU_TAG(row) : 0;
    }
    return offers;
}

void menu_rows_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output)
{
    (void)output;
    game->menu.row = (uint8_t)tag;
    menu_turn(game, &config->persistent.settings, MENU_CONTROLLER);
}

/* ---- One controller ------------------------------------------------------------------------- */

/* Highlights the first item of the open page, because the page now shows a different controller. */
void menu_reopen(struct game *game, const struct settings *settings)
{
    (void)settings;
    game->menu.tag[game->menu.page] = 0;
}

uint16_t menu_row_enabled(const struct menu *menu)
{
    static const uint16_t by_state[CONTROLLER_STATE_COUNT] = {
        [CONTROLLER_FREE] = MENU_TAG(ROW_CHOOSE) | MENU_TAG(ROW_LEARN),
        [CONTROLLER_ACTIVE] = MENU_TAG(ROW_RELEASE) | MENU_TAG(ROW_LEARN),
        [CONTROLLER_LOST] = MENU_TAG(ROW_RELEASE), /* The learn wizard needs a connected
                                                      controller. */
        [CONTROLLER_DENIED] = MENU_TAG(ROW_CHOOSE) | MENU_TAG(ROW_RELEASE), /* The permission may
                                                                               have been granted
                                                                               after the first
                                                                               attempt. */
    };
    return by_state[menu->controllers.state[menu->row]] | MENU_TAG(ROW_BACK);
}

void menu_row_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output)
{
    if (tag == ROW_LEARN) {
        menu_command(&game->menu, output, COMMAND_LEARN);
        menu_turn(game, &config->persistent.settings, MENU_LEARN);
        return;
    }
    menu_command(&game->menu, output, tag == ROW_CHOOSE ? COMMAND_CHOOSE : COMMAND_RELEASE);
}

/* ---- Learn wizard --------------------------------------------------------------------------- */

uint16_t menu_learn_enabled(const struct menu *menu)
{
    switch (menu->controllers.learn_step) {
    case LEARN_NONE:
        return MENU_TAG(LEARNS_END); /* The wizard has not started, or the controller is
                                        disconnected. */
    case LEARN_TRY:
    case LEARN_NOT_SAVED: /* Another attempt to save may succeed, for example after an SD card was
                             inserted. */
        return MENU_TAG(LEARNS_KEEP) | MENU_TAG(LEARNS_AGAIN) | MENU_TAG(LEARNS_END);
    case LEARN_FAILED:
        return MENU_TAG(LEARNS_AGAIN) | MENU_TAG(LEARNS_END);
    default:
        return MENU_TAG(LEARNS_NEXT) | MENU_TAG(LEARNS_END);
    }
}

void menu_learn_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output)
{
    switch (tag) {
    case LEARNS_NEXT:
        menu_command(&game->menu, output, COMMAND_LEARN_NEXT);
        break;
    case LEARNS_KEEP:
        menu_command(&game->menu, output, COMMAND_LEARN_KEEP);
        menu_turn(game, &config->persistent.settings, MENU_CONTROLLERS);
        break;
    default:
        menu_command(&game->menu, output, COMMAND_LEARN);
        break;
    }
}

void menu_learn_close(struct menu *menu, struct output *output)
{
    menu_command(menu, output, COMMAND_LEARN_END);
}
