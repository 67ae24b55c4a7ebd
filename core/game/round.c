/* round.c -- the round: its clock, time announcements, torn paper, and its end. */
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/accounting/round_standing.h"
#include "core/game/announcements.h"
#include "core/game/control/controller.h"
#include "core/game/paper.h"
#include "core/game/pause.h"
#include "core/game/phases.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"

#define RENEW_TICKS CORE_TICK_HZ /* Time to see the hole before the paper is replaced. */

void round_begin(struct game *game, struct world *world, struct output *output)
{
    table_setup_empty_bowls(world); /* Fish that fell off a replaced poi during READY would lie in
                                       the bowls without being counted. */
    game_enter_phase(game, PHASE_ROUND);
    game->round_tick = game->tick;
    game->paused_ticks = 0;
    output_sound(output, SOUND_START, 0.8f, 0.0f);
}

/* ---- Paper ---------------------------------------------------------------------------------- */

/* Replaces torn paper when the poi is out of the water, because a replacement under water would
 * make the poi jump. */
static void renew_paper(struct game *game, struct world *world, const struct core_config *config,
                        uint32_t index)
{
    struct player *player = &game->player[index];
    const int was_seen = game->tick - player->torn_tick >= RENEW_TICKS;
    if (was_seen && world->poi[index].immersed <= 0.0f) {
        player->scoops += world->poi[index].dips;
        player->torn_tick = 0;
        player->sheets_before++;
        table_setup_replace_poi(game, world, config, index, game->tick, GAME_SERIES_SPARE);
    }
}

static void watch_paper(struct game *game, struct world *world, const struct core_config *config,
                        struct output *output)
{
    const int renews = rules_of(game->mode)->renews_paper;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &game->player[i];
        if (!player->plays || paper_can_hold(&world->poi[i].sheet)) {
            continue;
        }
        if (player->torn_tick == 0) {
            player->torn_tick = game->tick;
            player->first_torn_tick =
                player->first_torn_tick ? player->first_torn_tick : game->tick - game->paused_ticks;
            output_sound(output, SOUND_GONE, 1.0f, 0.0f);
        }
        if (renews) {
            renew_paper(game, world, config, i);
        } else {
            player->out = 1;
        }
    }
}

/* ---- End of the round ------------------------------------------------------------------------ */

static int all_are_out(const struct game *game)
{
    int played = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        if (player->plays && !player->out) {
            return 0;
        }
        played |= player->plays;
    }
    return played;
}

/* Returns 1 if a fish lies on any poi, otherwise 0. After time is up no fish can be scooped, but
 * fish on the paper may still be carried to the bowl. */
static int any_carries(const struct world *world)
{
    uint32_t carried_fish = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        carried_fish += controller_is_active(world, i) ? world->poi[i].carried_count : 0;
    }
    return carried_fish > 0;
}

static int is_over(const struct game *game, const struct world *world, uint32_t elapsed,
                   uint32_t total)
{
    const uint32_t gone_tick = game->gone_tick;
    if (gone_tick != 0 && game->tick - gone_tick >= GAME_GONE_TICKS) {
        return 1;
    }
    return elapsed >= total && (!any_carries(world) || elapsed >= total + GAME_CARRY_TICKS);
}

/* ---- Time ----------------------------------------------------------------------------------- */

static void call_time(struct game *game, uint32_t elapsed, uint32_t total, struct output *output)
{
    const enum time_call call = announcements_call_at(elapsed, total);
    if (call == CALL_COUNTDOWN) {
        output_sound(output, SOUND_TICK, 1.0f, 0.0f); /* The sound of the countdown is played in
                                                         every mode. */
    }
    if (call == CALL_NONE || !rules_of(game->mode)->calls) {
        return;
    }
    game->call = (uint8_t)call;
    game->call_tick = game->tick;
    if (call != CALL_COUNTDOWN) {
        output_sound(output, SOUND_CALL, 1.0f, 0.0f);
    }
}

/* ---- The tick ------------------------------------------------------------------------------- */

static void note_who_plays(struct game *game, const struct world *world)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->played |= game->player[i].plays;
        game->bot_played |=
            (uint8_t)(controller_is_active(world, i) && world->poi[i].link == POI_SOURCE_BOT);
    }
}

void round_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output)
{
    pause_tick(game, world);
    note_who_plays(game, world);
    health_log_note_losses(game, world, config, output);
    stand_tick(game, config, output);
    if (pause_is_over(game)) {
        credit_refund(game, config, REFUND_NO_POI, output);
        result_begin(game, world, config, output);
        return;
    }
    if (game->paused) {
        return;
    }
    const uint32_t total = game->round_s * CORE_TICK_HZ;
    const uint32_t elapsed = game->tick - game->phase_tick;
    watch_paper(game, world, config, output);
    if (game->gone_tick == 0 && all_are_out(game)) {
        game->gone_tick = game->tick;
    }
    call_time(game, elapsed, total, output);
    if (is_over(game, world, elapsed, total)) {
        result_begin(game, world, config, output);
    }
}
