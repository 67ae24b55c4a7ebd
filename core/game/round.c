/* round.c -- the round: clock, announcements, torn paper, and the end of the round. */
#include "core/core.h"
#include "core/game/accounting/round_standing.h"
#include "core/game/announcements.h"
#include "core/game/control/controller.h"
#include "core/game/paper.h"
#include "core/game/pause.h"
#include "core/game/phases.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"

#define RENEW_TICKS CORE_TICK_HZ /* Time to see the hole before the paper is replaced. */

void round_begin(struct core *core, struct output *output)
{
    table_setup_empty_bowls(core); /* Fish that fell off an old poi since then would lie in the
                                      bowls without being counted. */
    game_enter_phase(core, PHASE_ROUND);
    core->game.round_tick = core->game.tick;
    core->game.paused_ticks = 0;
    output_sound(output, SOUND_START, 0.8f, 0.0f);
}

/* ---- Paper ---------------------------------------------------------------------------------- */

/* Replaces torn paper when the poi is clear of the water, so that nothing jumps. */
static void renew_paper(struct core *core, uint32_t index)
{
    struct player *player = &core->game.player[index];
    const int was_seen = core->game.tick - player->torn_tick >= RENEW_TICKS;
    if (was_seen && core->world.poi[index].immersed <= 0.0f) {
        player->scoops += core->world.poi[index].dips;
        player->torn_tick = 0;
        player->sheets_before++;
        table_setup_replace_poi(core, index, core->game.tick, GAME_SERIES_SPARE);
    }
}

static void watch_paper(struct core *core, struct output *output)
{
    const int renews = rules_of(core->game.mode)->renews_paper;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &core->game.player[i];
        if (!player->plays || paper_can_hold(&core->world.poi[i].sheet)) {
            continue;
        }
        if (player->torn_tick == 0) {
            player->torn_tick = core->game.tick;
            player->first_torn_tick = player->first_torn_tick
                                          ? player->first_torn_tick
                                          : core->game.tick - core->game.paused_ticks;
            output_sound(output, SOUND_GONE, 1.0f, 0.0f);
        }
        if (renews) {
            renew_paper(core, i);
        } else {
            player->out = 1;
        }
    }
}

/* ---- The end -------------------------------------------------------------------------------- */

static int all_are_out(const struct core *core)
{
    int played = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &core->game.player[i];
        if (player->plays && !player->out) {
            return 0;
        }
        played |= player->plays;
    }
    return played;
}

/* Returns 1 if a fish lies on any poi. After time is up no fish can be scooped, but fish on paper
 * may still be carried to the bowl. */
static int any_carries(const struct core *core)
{
    uint32_t carried_fish = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        carried_fish += controller_is_active(core, i) ? core->world.poi[i].carried_count : 0;
    }
    return carried_fish > 0;
}

static int is_over(const struct core *core, uint32_t elapsed, uint32_t total)
{
    const uint32_t gone_tick = core->game.gone_tick;
    if (gone_tick != 0 && core->game.tick - gone_tick >= GAME_GONE_TICKS) {
        return 1;
    }
    return elapsed >= total && (!any_carries(core) || elapsed >= total + GAME_CARRY_TICKS);
}

/* ---- Time ----------------------------------------------------------------------------------- */

static void call_time(struct core *core, uint32_t elapsed, uint32_t total, struct output *output)
{
    const enum time_call call = announcements_call_at(elapsed, total);
    if (call == CALL_COUNTDOWN) {
        output_sound(output, SOUND_TICK, 1.0f, 0.0f); /* The countdown sounds in every mode. */
    }
    if (call == CALL_NONE || !rules_of(core->game.mode)->calls) {
        return;
    }
    core->game.call = (uint8_t)call;
    core->game.call_tick = core->game.tick;
    if (call != CALL_COUNTDOWN) {
        output_sound(output, SOUND_CALL, 1.0f, 0.0f);
    }
}

/* ---- The tick ------------------------------------------------------------------------------- */

static void note_who_plays(struct core *core)
{
    struct game *game = &core->game;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->played |= game->player[i].plays;
        game->bot_played |=
            (uint8_t)(controller_is_active(core, i) && core->world.poi[i].link == POI_SOURCE_BOT);
    }
}

void round_tick(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    pause_tick(core);
    note_who_plays(core);
    health_log_note_losses(core, output);
    stand_tick(core, output);
    if (pause_is_over(core)) {
        credit_refund(core, REFUND_NO_POI, output);
        result_begin(core, output);
        return;
    }
    if (game->paused) {
        return;
    }
    const uint32_t total = game->round_s * CORE_TICK_HZ;
    const uint32_t elapsed = core->game.tick - game->phase_tick;
    watch_paper(core, output);
    if (game->gone_tick == 0 && all_are_out(core)) {
        game->gone_tick = core->game.tick;
    }
    call_time(core, elapsed, total, output);
    if (is_over(core, elapsed, total)) {
        result_begin(core, output);
    }
}
