/* ready.c -- the phase READY: a few seconds in which players receive fresh paper and empty bowls.
 * No shadow may rest over the fish. */
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/fouls.h"
#include "core/game/phases.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"

void ready_begin(struct game *game, struct world *world, const struct core_config *config,
                 struct output *output)
{
    game->round_count++;
    game->round_s = table_setup_round_s(config, game->mode);
    game->bot_played = 0;
    game->played = 0;
    game->paused = 0;
    game->gone_tick = 0;
    game->lost_ticks = game->waited_ticks = 0;
    game->call = CALL_NONE;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i] = (struct player){ 0 };
    }
    album_clear(&game->album);
    table_setup_empty_bowls(world);
    table_setup_prepare(game, world, config, table_setup_preset(config, game->mode));
    game_enter_phase(game, PHASE_READY);
    output_sound(output, SOUND_START, 1.0f, 0.0f);
}

/* Replaces each poi's paper as soon as the poi is out of the water, because a replacement under
 * water would make the poi jump. */
static void hand_out_paper(struct game *game, struct world *world, const struct core_config *config,
                           uint32_t elapsed, uint32_t total)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int clear = world->poi[i].immersed <= 0.0f || elapsed >= total / 2u;
        if (!game->player[i].handed && clear) {
            table_setup_replace_poi(game, world, config, i, game->round_count, GAME_SERIES_ROUND);
            game->player[i].handed = 1;
        }
    }
}

void ready_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output)
{
    const uint32_t elapsed = game->tick - game->phase_tick;
    const uint32_t total = rules_of(game->mode)->ready_s * CORE_TICK_HZ;
    hand_out_paper(game, world, config, elapsed, total);
    fouls_before_start(game, world, output);
    if (elapsed >= total) {
        round_begin(game, world, output);
    }
}
