/* score.c -- detects fouls, such as a shadow held over the water before the start or a forbidden
 * way to catch a fish. Counts the fish of each player, and builds the record of a round. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/lab/lab.h"
#include "core/game/ranking/name.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"
#include "core/view.h"

/* Records a foul of kind `kind` by `player`. Also counts the foul if the mode counts fouls, and
 * then plays the whistle at the stereo position `pan`. */
static void commit_foul(struct player *player, const struct game *game, enum foul kind, float pan,
                        struct output *output)
{
    CORE_ASSERT(kind < FOUL_COUNT);
    const uint32_t last_tick = player->offence_tick[kind];
    player->offence_tick[kind] = game->tick;
    if (!rules_of(game->mode)->counts_fouls || player->fouls >= FOUL_MAX ||
        (last_tick != 0 && game->tick - last_tick < FOUL_APART_TICKS)) {
        return;
    }
    player->fouls++;
    player->foul = (uint8_t)kind;
    player->foul_tick = game->tick;
    player->out |= player->fouls == FOUL_MAX;
    output_sound(output, SOUND_FOUL, 1.0f, pan);
}

/* Returns the stereo position of the bowl of player `index`. */
static float pan_of_bowl(const struct world *world, uint32_t index, bool is_turned)
{
    return view_pan(is_turned, world->tank.size_m, world->bowl[index].position_m);
}

/* ---- Fouls before the start of the round ---------------------------------------------------- */

/* Updates `stance`: whether the player has moved the controller since READY began. The function
 * uses the controller's pose and not the poi's pose, because a new tank or a new source moves the
 * poi without the player. After the view changes, a pointer refers to a different point of the
 * water, and its pose jumps in the next frames. The rest position is therefore updated until
 * FOUL_SETTLE_TICKS. */
static void watch_stance(struct player *player, const struct game *game, const struct world *world,
                         uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const uint8_t link = world->poi[index].link;
    if (!player_has_poi(world, index)) {
        /* Forget the motion of a player without a controller, because a broken cable is no foul. */
        player->stance = STANCE_UNSEEN;
    } else if (link == POI_SOURCE_LIVE || link == POI_SOURCE_BOT) {
        const vec3 hand_m = link == POI_SOURCE_LIVE
                                ? game->control[index].validation.newest.position_m
                                : game->control[index].target_pose.position_m;
        if (player->stance == STANCE_UNSEEN || game->tick - game->phase_tick < FOUL_SETTLE_TICKS) {
            player->stance = STANCE_RESTS;
            player_rests(player, hand_m);
        } else if (player_stirs(player, hand_m)) {
            player->stance = STANCE_MOVED;
        }
    }
}

/* Records a foul by each player whose shadow has rested over fish for FOUL_SHADE_S. The time of a
 * shadow counts only from the start of READY, even if the shadow was already present before. */
void score_fouls_before_start(struct player player[POI_MAX], const struct game *game,
                              const struct world *world, bool is_turned, struct output *output)
{
    const float ready_s = (float)(game->tick - game->phase_tick) * CORE_TICK_S;
    const struct tank *tank = &world->tank;
    CORE_ASSERT(game->phase == PHASE_READY);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct shade *const shades[] = { &tank->shade[i], &tank->shade[SHADE_MAX + i] };
        bool is_foul = false;
        watch_stance(&player[i], game, world, i);
        /* A shadow of a fan is always a foul. A shadow of a poi is a foul only if the player moved
         * the controller. */
        for (uint32_t k = 0; k < (player[i].stance == STANCE_MOVED ? 2u : 1u); k++) {
            is_foul |= shades[k]->cast.present &&
                       f_min(shades[k]->still_s, ready_s) >= FOUL_SHADE_S &&
                       tank_shade_count(tank, &shades[k]->cast) > 0;
        }
        if (world->bowl[i].present && is_foul) {
            commit_foul(&player[i], game, FOUL_SHADE, pan_of_bowl(world, i, is_turned), output);
        }
    }
}

/* ---- Score and record of the round ----------------------------------------------------------- */

void game_score(struct player player[POI_MAX], struct album *album, const struct game *game,
                const struct world *world, const struct catch_result caught[POI_MAX],
                bool is_turned, struct output *output)
{
    if (game->phase != PHASE_ROUND) {
        return;
    }
    /* In modes with an umpire, fish caught by a foul do not count, although these fish lie in the
     * bowl too. */
    const bool counts_fouls = rules_of(game->mode)->counts_fouls;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint32_t valid = counts_fouls ? caught[i].landed : caught[i].bowled;
        if (player[i].fouls < FOUL_MAX) {
            player[i].caught += valid;
            album_note(album, world, i, valid);
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (!player_has_poi(world, i) || game->paused) {
            /* Record no foul, because the player does not control the poi at present. */
            continue;
        }
        const float pan = pan_of_bowl(world, i, is_turned);
        if (caught[i].poured > 0) {
            commit_foul(&player[i], game, FOUL_POURED, pan, output);
        }
        if (caught[i].walled > 0) {
            commit_foul(&player[i], game, FOUL_WALL, pan, output);
        }
    }
}

uint8_t game_level(const struct game *game)
{
    uint8_t easiest = LEVEL_MASTER;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const bool takes_part =
            game->player[i].plays || game->control[i].holder != POI_SOURCE_ABSENT;
        if (takes_part && game->player[i].level > easiest) {
            easiest = game->player[i].level;
        }
    }
    return easiest;
}

struct round_record game_record(const struct game *game, const struct world *world,
                                const struct core_config *config)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    struct round_record record = {
        .seed = config->seed,
        .start_tick = game->round_tick,
        .end_tick =
            (game->phase == PHASE_RESULT ? game->phase_tick : game->tick) - game->paused_ticks,
        .fish_count = (uint16_t)world->tank.fish_count,
        .round_s = (uint16_t)game->round_s,
        .preset = world->tank.preset,
        .by_bot = game->bot_played,
        .mode = game->mode,
        .grade = table_setup_grade(config, game->mode),
        .level = game_level(game),
    };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        if (player->plays) {
            record.caught += player->caught;
            record.players |= (uint8_t)(1u << i);
            record.player[i] = (struct player_record){
                .caught = player->caught,
                .scoops = player->scoops + world->poi[i].dips,
                .hole_area_mm2 = (uint32_t)(1e6f * sheet_hole_m2(&world->poi[i].sheet) + 0.5f),
                .torn_tick = player->first_torn_tick,
                .sheets = 1u + player->sheets_before,
                .fouls = player->fouls,
            };
        }
    }
    return record;
}

void score_keep(struct accounts *accounts, struct name *name, const struct game *game,
                const struct world *world, const struct core_config *config, uint32_t tickets,
                struct output *output)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    const bool is_scored = rules_of(game->mode)->keeps_score;
    if (!game->played) {
        return;
    }
    struct ledger_entry entry = { .kind = LEDGER_ROUND,
                                  .value = (int32_t)tickets,
                                  .round = game_record(game, world, config) };
    entry.round.id = accounts->ledger.last_id + 1u;
    entry.round.unscored = (uint8_t)!is_scored;
    accounts->ledger.balance.open = PAYMENT_NONE;
    const uint32_t id = ledger_write(accounts, game->tick, &entry, output);
    name_note_round(name, accounts, &config->persistent.settings, leaderboard_board(game),
                    is_scored ? id : 0u);
}
