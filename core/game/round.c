/* round.c -- the phases of a round: READY, the round and RESULT.
 *
 * READY takes a few seconds, in which players receive fresh paper and empty bowls, and no shadow
 * may rest over the fish. The round has a clock, time announcements and torn paper. RESULT shows
 * the score for a while. A refunded round has no result. Otherwise a player with a full bowl could
 * pull a plug repeatedly and win the same prize each time. */
#include "core/game/phases.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/poi/paper/paper_patch.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/ranking/name.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"
#include "core/input.h"
#include "core/poi/world.h"
#include "core/view.h"

void round_ready_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    game->round_count++;
    game->round_s = table_setup_round_s(config, game->mode);
    game->bot_played = 0;
    game->played = 0;
    game->paused = 0;
    game->gone_tick = 0;
    game->lost_ticks = game->waited_ticks = 0;
    game->call = CALL_NONE;
    const bool is_chosen = game->phase == PHASE_MODE_SELECT;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t level = is_chosen ? game->player[i].level : config->level;
        game->player[i] = (struct player){
            .level = rules_of(game->mode)->has_levels ? level : (uint8_t)LEVEL_MASTER,
        };
    }
    game->album = (struct album){ 0 };
    memset(world->tear_clip, 0, sizeof world->tear_clip);
    memset(world->near_miss, 0, sizeof world->near_miss);
    table_setup_empty_bowls(world);
    table_setup_prepare(game->control, game, world, config, table_setup_preset(config, game->mode));
    game_enter_phase(game, PHASE_READY);
    output_sound(output, SOUND_START, 1.0f, 0.0f);
}

/* Begins the round after READY and starts its clock. */
static void begin_round(struct game *game, struct world *world, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_READY);
    /* Empty the bowls, because fish that fell off a replaced poi during READY may lie in the bowls
     * without being counted. */
    table_setup_empty_bowls(world);
    game_enter_phase(game, PHASE_ROUND);
    game->round_tick = game->tick;
    game->paused_ticks = 0;
    output_sound(output, SOUND_START, 0.8f, 0.0f);
    output_sound(output, SOUND_WELCOME, 0.8f, 0.0f);
}

void round_ready_tick(struct game *game, struct world *world, struct core_config *config,
                      const struct input *input, struct output *output)
{
    const uint32_t elapsed = game->tick - game->phase_tick;
    const uint32_t total = rules_of(game->mode)->ready_s * CORE_TICK_HZ;
    CORE_ASSERT(game->phase == PHASE_READY);
    /* Replace the paper of each poi as soon as the poi is out of the water, because a replacement
     * under water would make the poi jump. */
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const bool clear = world->poi[i].immersed <= 0.0f || elapsed >= total / 2u;
        if (!game->player[i].handed && clear) {
            table_setup_replace_poi(game, world, config, i, game->round_count, GAME_SERIES_ROUND);
            game->player[i].handed = 1;
        }
    }
    world->tank.temper = rules_of_level(game_level(game))->temper;
    score_fouls_before_start(game->player, game, world, input->is_turned != 0, output);
    if (elapsed >= total) {
        begin_round(game, world, output);
    }
}

#define MINUTE_TICKS (60u * CORE_TICK_HZ)
#define TEN_TICKS (10u * CORE_TICK_HZ)
#define LAST_TICKS (5u * CORE_TICK_HZ)

enum time_call round_call_at(uint32_t elapsed_ticks, uint32_t total_ticks)
{
    if (elapsed_ticks >= total_ticks) {
        return elapsed_ticks == total_ticks ? CALL_TIME : CALL_NONE;
    }
    const uint32_t left_ticks = total_ticks - elapsed_ticks;
    if (left_ticks <= LAST_TICKS) {
        return left_ticks % CORE_TICK_HZ == 0 ? CALL_COUNTDOWN : CALL_NONE;
    }
    if (left_ticks <= TEN_TICKS) {
        return left_ticks == TEN_TICKS ? CALL_TEN_SECONDS : CALL_NONE;
    }
    switch (elapsed_ticks) {
    case MINUTE_TICKS:
        return CALL_ONE_MINUTE;
    case 2u * MINUTE_TICKS:
        return CALL_TWO_MINUTES;
    default:
        return CALL_NONE;
    }
}

/* Time for which the player sees the hole in the paper before the paper is replaced. */
#define RENEW_TICKS CORE_TICK_HZ

/* ---- Replacement of torn paper -------------------------------------------------------------- */

/* Handles paper that cannot hold a fish any more. The paper is replaced when the poi is out of the
 * water, because a replacement under water would make the poi jump. */
static void watch_paper(struct player players[POI_MAX], const struct game *game,
                        struct world *world, const struct core_config *config, bool is_turned,
                        struct output *output)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    const bool renews = rules_of(game->mode)->renews_paper;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &players[i];
        const struct poi *poi = &world->poi[i];
        if (!player->plays || paper_can_hold(&poi->sheet)) {
            continue;
        }
        if (player->torn_tick == 0) {
            player->torn_tick = game->tick;
            player->first_torn_tick =
                player->first_torn_tick ? player->first_torn_tick : game->tick - game->paused_ticks;
            output_sound(output, SOUND_GONE, 1.0f,
                         view_pan(is_turned, world->tank.size_m, poi->position_m));
        }
        if (!renews) {
            player->out = 1;
        } else if (game->tick - player->torn_tick >= RENEW_TICKS && poi->immersed <= 0.0f) {
            player->scoops += poi->dips;
            player->torn_tick = 0;
            player->sheets_before++;
            table_setup_replace_poi(game, world, config, i, game->tick, GAME_SERIES_SPARE);
        }
    }
}

/* ---- Time announcements --------------------------------------------------------------------- */

/* Plays the sound of the time announcement that is due in this tick. The sound of the countdown is
 * played in every mode. Returns the announcement if the mode `mode` shows announcements, otherwise
 * CALL_NONE. */
static enum time_call call_time(uint8_t mode, uint32_t elapsed, uint32_t total,
                                struct output *output)
{
    const enum time_call call = round_call_at(elapsed, total);
    const bool is_shown = call != CALL_NONE && rules_of(mode)->announces_time;
    if (call == CALL_COUNTDOWN) {
        output_sound(output, SOUND_TICK, 1.0f, 0.0f);
    } else if (is_shown) {
        output_sound(output, SOUND_CALL, 1.0f, 0.0f);
    }
    return is_shown ? call : CALL_NONE;
}

/* Returns the sound of the result: a cheer for a place in the ranking, a rising koto for a catch,
 * and a low string for a round without a fish. */
static enum sound result_sound(const struct game *game)
{
    uint32_t caught = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        caught += game->player[i].plays ? game->player[i].caught : 0u;
    }
    return game->name.ranked != 0 && caught > 0 ? SOUND_RECORD
           : caught > 0                         ? SOUND_WIN
                                                : SOUND_RESULT;
}

/* Ends the round, logs its result and shows the result. */
static void begin_result(struct game *game, struct world *world, const struct core_config *config,
                         struct output *output)
{
    game->paused = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        /* Return the fish on the paper to the water, because the time of the round is over. */
        world->poi[i].carried_count = 0;
    }
    game_enter_phase(game, PHASE_RESULT);
    name_note_round(&game->name, &game->accounts, &config->persistent.settings,
                    leaderboard_board(game), 0);
    if (!game->accounts.credit.came_back) {
        score_keep(&game->accounts, &game->name, game, world, config,
                   credit_award_tickets(&game->accounts, game, config), output);
        album_give_presents(&game->album, game->player, world, config);
    }
    output_sound(output, result_sound(game), 1.0f, 0.0f);
}

/* ---- Tick of the round, and its result ------------------------------------------------------ */

void round_tick(struct game *game, struct world *world, struct core_config *config,
                const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ROUND);
    player_tick_pause(game, world);
    world->tank.temper = rules_of_level(game_level(game))->temper;
    uint32_t carried_fish = 0, in_round = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        const bool is_active = controller_is_active(world, i);
        game->played |= player->plays;
        game->bot_played |= (uint8_t)(is_active && world->poi[i].link == POI_SOURCE_BOT);
        carried_fish += is_active ? world->poi[i].carried_count : 0;
    }
    if (config_has_rules(config, 8)) {
        health_log_note_losses(&game->accounts, &game->health_log, game, world, output);
    }
    round_standing_tick(&game->accounts, game, config, output);
    if (game->lost_ticks > GAME_LOST_TICKS_MAX || game->waited_ticks > GAME_WAIT_TICKS_MAX) {
        credit_refund(&game->accounts, game, config, REFUND_NO_POI, output);
        begin_result(game, world, config, output);
        return;
    }
    if (game->paused) {
        return;
    }
    const uint32_t total = game->round_s * CORE_TICK_HZ;
    const uint32_t elapsed = game->tick - game->phase_tick;
    watch_paper(game->player, game, world, config, input->is_turned != 0, output);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        in_round += game->player[i].plays && !game->player[i].out;
    }
    if (game->gone_tick == 0 && game->played && in_round == 0) {
        game->gone_tick = game->tick;
    }
    const enum time_call call = call_time(game->mode, elapsed, total, output);
    if (call != CALL_NONE) {
        game->call = (uint8_t)call;
        game->call_tick = game->tick;
    }
    /* After the time of the round is up, no fish can be scooped, but fish on the paper may still be
     * carried to the bowl for a few seconds. */
    const bool is_gone = game->gone_tick != 0 && game->tick - game->gone_tick >= GAME_GONE_TICKS;
    const bool is_late =
        elapsed >= total && (carried_fish == 0 || elapsed >= total + GAME_CARRY_TICKS);
    if (is_gone || is_late) {
        begin_result(game, world, config, output);
    }
}

void round_result_skip(struct game *game, const struct world *world,
                       const struct core_config *config, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ROUND);
    game->accounts.credit.came_back = 0;
    score_keep(&game->accounts, &game->name, game, world, config,
               credit_award_tickets(&game->accounts, game, config), output);
    name_note_round(&game->name, &game->accounts, &config->persistent.settings,
                    leaderboard_board(game), 0);
}

/* Runs one tick of the result screen. If a player starts another game or the result has been shown
 * long enough, starts the next phase: name entry, mode selection, album or attract mode.
 * Hints that the players have learned are kept for the next round. */
void round_result_tick(struct game *game, struct world *world, struct core_config *config,
                       const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_RESULT);
    const uint32_t elapsed = game->tick - game->phase_tick;
    const bool dipped = controller_dipped_player(game, world, input) < POI_MAX;
    const bool goes_on = ((input->pressed & INPUT_START) && elapsed >= GAME_AGAIN_TICKS) ||
                         (dipped && elapsed >= GAME_AGAIN_DIP_TICKS) ||
                         credit_is_awaited(&game->accounts, config, game->tick);
    const bool is_read = elapsed >= GAME_RESULT_TICKS;
    if ((goes_on || is_read) && name_begin(game, output)) {
        return;
    }
    if (goes_on) {
        game_mode_select_begin(game, world, config, output);
    } else if (is_read && !album_begin(game)) {
        attract_begin(game, world, config);
    }
}
