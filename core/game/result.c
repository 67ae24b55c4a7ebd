/* result.c -- the phase RESULT, which shows the score for a while. A refunded round has no result.
 * Otherwise a player with a full bowl could pull a plug repeatedly and win the same prize each
 * time. */
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/phases.h"
#include "core/game/score.h"

void result_begin(struct game *game, struct world *world, const struct core_config *config,
                  struct output *output)
{
    game->paused = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        world->poi[i].carried_count = 0; /* The time is up, so the fish return to the water. */
    }
    game_enter_phase(game, PHASE_RESULT);
    name_note_round(game, &config->persistent.settings, 0);
    if (!game->accounts.credit.came_back) {
        score_keep(game, world, config, credit_award_tickets(game, config), output);
    }
    output_sound(output, SOUND_RESULT, 1.0f, 0.0f);
}

void result_skip(struct game *game, const struct world *world, const struct core_config *config,
                 struct output *output)
{
    game->accounts.credit.came_back = 0;
    score_keep(game, world, config, credit_award_tickets(game, config), output);
    name_note_round(game, &config->persistent.settings, 0);
}

/* Starts the next phase after the result. Hints that the players have learned are kept for the next
 * round. */
void result_tick(struct game *game, struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output)
{
    const uint32_t elapsed = game->tick - game->phase_tick;
    const int dipped = game_dipped_player(game, world, input) < POI_MAX;
    const int goes_on = ((input->pressed & INPUT_START) && elapsed >= GAME_AGAIN_TICKS) ||
                        (dipped && elapsed >= GAME_AGAIN_DIP_TICKS) ||
                        credit_is_awaited(&game->accounts, config, game->tick);
    const int is_read = elapsed >= GAME_RESULT_TICKS;
    if ((goes_on || is_read) && name_begin(game, output)) {
        return;
    }
    if (goes_on) {
        mode_select_begin(game, world, config, output);
    } else if (is_read && !album_begin(game)) {
        attract_begin(game, world, config);
    }
}
