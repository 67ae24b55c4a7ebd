/* core_status.c -- the functions of core.h that return a part or a copy of the state, for programs
 * that must not depend on the structure of the state. */
#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/bot/vision.h"
#include "core/game/menu/menu.h"
#include "core/game/phases.h"

struct core_status core_status(const struct core *core)
{
    const struct game *game = &core->game;
    const struct ledger *ledger = &game->accounts.ledger;
    struct core_status status = {
        .tick = game->tick,
        .entry_id = ledger->last_id,
        .round_count = game->round_count,
        .round_s = game->round_s,
        .fish_count = core->world.tank.fish_count,
        .day = ledger->day,
        .minute = ledger->minute,
        .phase = game->phase,
        .mode = game->mode,
        .takes_pin = menu_takes_pin(game),
        .balance = ledger->balance,
    };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        status.player[i] = (struct core_player_status){
            .plays = game->player[i].plays,
            .fouls = game->player[i].fouls,
            .caught = game->player[i].caught,
            .target_pose = game->control[i].target_pose,
        };
    }
    return status;
}

const struct audits *core_audits(const struct core *core)
{
    CORE_ASSERT(core);
    return &core->game.accounts.audits;
}

struct round_record core_round_record(const struct core *core)
{
    CORE_ASSERT(core);
    return game_record(&core->game, &core->world, &core->config);
}

struct vision core_vision(const struct core *core, uint32_t player)
{
    CORE_ASSERT(core && player < POI_MAX);
    return (struct vision){ .game = &core->game, .world = &core->world, .player = player };
}

const struct ranking *core_ranking(const struct core *core)
{
    CORE_ASSERT(core);
    return &core->game.accounts.ranking;
}

bool core_final_entry(const struct core *core, const struct input *input, struct ledger_entry *out)
{
    CORE_ASSERT(core && input && out);
    return health_log_final(&core->game.accounts, &core->game.health_log, core->game.tick, input,
                            out);
}
