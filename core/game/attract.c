/* attract.c -- attract mode, in which the built-in bot plays. Attract mode ends when a player dips
 * the poi or presses START. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/poi/paper/paper_patch.h"
#include "core/game/control/controller.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

/* Time in attract mode for which the bot keeps a torn poi before its paper is replaced. */
#define SWAP_TICKS (2u * CORE_TICK_HZ)
/* Number of fish in the bot's bowl at which the bowl is emptied into the tank. Without this limit
 * the bot would catch all fish of the tank during a night. */
#define BOWL_MAX 10u

void attract_begin(struct game *game, struct world *world, const struct core_config *config)
{
    game->mode = table_setup_first_mode(config);
    game->gone_tick = 0;
    world->tank.temper = rules_of_level(LEVEL_MASTER)->temper;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].level = LEVEL_MASTER;
    }
    session_language_reset(game, config);
    game->bowl_place = table_setup_bowl_place(world, config, false, v3(0.0f, 0.0f, 0.0f));
    game_enter_phase(game, PHASE_ATTRACT);
    table_setup_empty_bowls(world);
    table_setup_prepare(game->control, game, world, config, config->preset);
    game->turn_tick = 0;
    session_request(game);
}

void attract_tick(struct game *game, struct world *world, struct core_config *config,
                  const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ATTRACT);
    const uint32_t dipped = controller_dipped_player(game, world, input);
    const bool is_turned = input->is_turned != 0;
    const bool was_turned = game->bowl_place >= BOWL_PLACE_NEAR_LEFT;
    if (dipped < POI_MAX || (is_turned && config_has_rules(config, 12)) != was_turned) {
        const vec3 dip_m = dipped < POI_MAX ? input->poi[dipped].target.position_m : (vec3){ 0 };
        game->bowl_place =
            table_setup_bowl_place(world, config, is_turned, view_from_world(is_turned, dip_m));
    }
    if ((input->pressed & INPUT_START) || dipped < POI_MAX ||
        credit_is_awaited(&game->accounts, config, game->tick)) {
        game_mode_select_begin(game, world, config, output);
    }
    if (game->phase != PHASE_ATTRACT) {
        game->hints = (struct hints){ 0 }; /* A new player starts a game, so reset the hints. */
        return;
    }
    if (game->tick - game->phase_tick >= SESSION_TICKS_MAX) {
        session_request(game);
    }
    const bool is_full = world->bowl[0].fish_count >= BOWL_MAX;
    const bool is_free = world->poi[0].immersed <= 0.0f && world->poi[0].carried_count == 0;
    if (game->gone_tick == 0 && (is_full || !paper_can_hold(&world->poi[0].sheet))) {
        game->gone_tick = game->tick;
    }
    if (game->gone_tick != 0 && game->tick - game->gone_tick >= SWAP_TICKS && is_free) {
        table_setup_replace_poi(game, world, config, 0, game->tick, GAME_SERIES_ATTRACT);
        bowl_empty(&world->bowl[0], 0, &world->tank);
        game->gone_tick = 0;
    }
}
