/* result.c -- the round is over: the count stands there for a while. What was given back was no
 * round: else a plug that is pulled at a full bowl would be worth its prize again and again. */
#include "core/core.h"
#include "core/game/phases.h"
#include "core/game/score.h"

void result_begin(struct core *core, struct output *output)
{
    core->game.paused = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core->poi[i].rider_count = 0; /* Too late: they go back to the water. */
    }
    phase_enter(core, PHASE_RESULT);
    name_note_round(core, 0);
    if (!core->game.credit.came_back) {
        score_keep(core, credit_hand_out_tickets(core), output);
    }
    output_sound(output, SOUND_RESULT, 1.0f, 0.0f);
}

void result_skip(struct core *core, struct output *output)
{
    core->game.credit.came_back = 0;
    score_keep(core, credit_hand_out_tickets(core), output);
    name_note_round(core, 0);
}

/* The same players go on: they know what they have learned. */
void result_tick(struct core *core, const struct input *input, struct output *output)
{
    const uint32_t elapsed = core->tick - core->game.phase_tick;
    const int dipped = phase_dipped(core, input) < POI_MAX;
    const int goes_on = ((input->pressed & INPUT_START) && elapsed >= GAME_AGAIN_TICKS) ||
                        (dipped && elapsed >= GAME_AGAIN_DIP_TICKS) || credit_is_awaited(core);
    const int is_read = elapsed >= GAME_RESULT_TICKS;
    if ((goes_on || is_read) && name_begin(core, output)) {
        return;
    }
    if (goes_on) {
        choose_begin(core, output);
    } else if (is_read && !album_begin(core)) {
        attract_begin(core);
    }
}
