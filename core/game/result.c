/* result.c -- the phase RESULT: shows the score for a while. A refunded round has no result,
 * because otherwise pulling the plug with a full bowl could win the same prize repeatedly. */
#include "core/core.h"
#include "core/game/phases.h"
#include "core/game/score.h"

void result_begin(struct core *core, struct output *output)
{
    core->game.paused = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core->world.poi[i].carried_count = 0; /* The time is up, so the fish return to the water. */
    }
    game_enter_phase(core, PHASE_RESULT);
    name_note_round(core, 0);
    if (!core->game.accounts.credit.came_back) {
        score_keep(core, credit_award_tickets(core), output);
    }
    output_sound(output, SOUND_RESULT, 1.0f, 0.0f);
}

void result_skip(struct core *core, struct output *output)
{
    core->game.accounts.credit.came_back = 0;
    score_keep(core, credit_award_tickets(core), output);
    name_note_round(core, 0);
}

/* Leads to the next phase. Hints learned by the players are kept for the next round. */
void result_tick(struct core *core, const struct input *input, struct output *output)
{
    const uint32_t elapsed = core->game.tick - core->game.phase_tick;
    const int dipped = game_dipped_player(core, input) < POI_MAX;
    const int goes_on = ((input->pressed & INPUT_START) && elapsed >= GAME_AGAIN_TICKS) ||
                        (dipped && elapsed >= GAME_AGAIN_DIP_TICKS) || credit_is_awaited(core);
    const int is_read = elapsed >= GAME_RESULT_TICKS;
    if ((goes_on || is_read) && name_begin(core, output)) {
        return;
    }
    if (goes_on) {
        mode_select_begin(core, output);
    } else if (is_read && !album_begin(core)) {
        attract_begin(core);
    }
}
