/* attract.c -- attract mode: the built-in bot plays until a player dips the poi or presses
 * START. */
#include "core/core.h"
#include "core/game/paper.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"

#define SWAP_TICKS (2u * CORE_TICK_HZ) /* Time for which the bot keeps a torn poi. */
/* Fish in the bot's bowl at which the bowl is emptied, because otherwise the bot would empty the
 * tank over night. */
#define BOWL_MAX 10u

void attract_begin(struct core *core)
{
    core->game.mode = table_setup_first_mode(&core->config);
    core->game.gone_tick = 0;
    language_return(core);
    game_enter_phase(core, PHASE_ATTRACT);
    table_setup_empty_bowls(core);
    table_setup_prepare(core, core->config.preset);
    core->game.turn_tick = 0;
    session_request(core);
}

void attract_tick(struct core *core, const struct input *input, struct output *output)
{
    struct game *game = &core->game;
    const int dipped = game_dipped_player(core, input) < POI_MAX;
    if ((input->pressed & INPUT_START) || dipped || credit_is_awaited(core)) {
        mode_select_begin(core, output);
    }
    if (game->phase != PHASE_ATTRACT) {
        hints_init(&game->hints); /* Restart the hints for a new player. */
        return;
    }
    if (core->game.tick - game->phase_tick >= SESSION_TICKS_MAX) {
        session_request(core);
    }
    const int is_full = core->world.bowl[0].fish_count >= BOWL_MAX;
    const int is_free =
        core->world.poi[0].immersed <= 0.0f && core->world.poi[0].carried_count == 0;
    if (game->gone_tick == 0 && (is_full || !paper_can_hold(&core->world.poi[0].sheet))) {
        game->gone_tick = core->game.tick;
    }
    if (game->gone_tick != 0 && core->game.tick - game->gone_tick >= SWAP_TICKS && is_free) {
        table_setup_replace_poi(core, 0, core->game.tick, GAME_SERIES_ATTRACT);
        bowl_empty(&core->world.bowl[0], 0, &core->world.tank);
        game->gone_tick = 0;
    }
}
