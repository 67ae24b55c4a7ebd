/* score.c -- counts the fish of each player, and builds the record of a round. */
#include "core/game/score.h"

#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/fouls.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"

/* Returns the number of fish that count. Fish caught by a foul lie in the bowl too, but do not
 * count in modes with an umpire. */
static uint32_t valid(const struct rules *rules, const struct catch_result *caught)
{
    return rules->judges ? caught->landed : caught->bowled;
}

void game_score(struct game *game, const struct world *world,
                const struct catch_result caught[POI_MAX], struct output *output)
{
    if (game->phase != PHASE_ROUND) {
        return;
    }
    const struct rules *rules = rules_of(game->mode);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (game->player[i].fouls < FOUL_MAX) {
            game->player[i].caught += valid(rules, &caught[i]);
            album_note(&game->album, world, i, valid(rules, &caught[i]));
        }
    }
    fouls_of_catch(game, world, caught, output);
}

static uint32_t hole_area_mm2(const struct sheet *sheet)
{
    return (uint32_t)(1e6f * sheet_hole_m2(sheet) + 0.5f);
}

struct round_record game_record(const struct game *game, const struct world *world,
                                const struct core_config *config)
{
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
    };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        if (player->plays) {
            record.caught += player->caught;
            record.players |= (uint8_t)(1u << i);
            record.player[i] = (struct player_record){
                .caught = player->caught,
                .scoops = player->scoops + world->poi[i].dips,
                .hole_area_mm2 = hole_area_mm2(&world->poi[i].sheet),
                .torn_tick = player->first_torn_tick,
                .sheets = 1u + player->sheets_before,
                .fouls = player->fouls,
            };
        }
    }
    return record;
}

void score_keep(struct game *game, const struct world *world, const struct core_config *config,
                uint32_t tickets, struct output *output)
{
    const int is_scored = rules_of(game->mode)->keeps_score;
    if (!game->played) {
        return;
    }
    struct ledger_entry entry = { .kind = LEDGER_ROUND,
                                  .value = (int32_t)tickets,
                                  .round = game_record(game, world, config) };
    entry.round.id = game->accounts.ledger.last_id + 1u;
    entry.round.unscored = (uint8_t)!is_scored;
    game->accounts.ledger.balance.open = PAYMENT_NONE;
    const uint32_t id = ledger_write(&game->accounts, game->tick, &entry, output);
    if (id != 0 && is_scored) {
        output->record = entry.round;
    }
    name_note_round(game, &config->persistent.settings, is_scored ? id : 0u);
}
