/* player.c -- computes the state of each player in a round, and pauses a round while a player's
 * controller is lost. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/game/control/controller.h"
#include "core/poi/world.h"

bool player_stirs(const struct player *player, vec3 hand_m)
{
    CORE_ASSERT(v3_is_finite(hand_m));
    const float x_m = hand_m.x - player->rest_x_m, z_m = hand_m.z - player->rest_z_m;
    return x_m * x_m + z_m * z_m > PLAYER_STIR_M * PLAYER_STIR_M;
}

void player_rests(struct player *player, vec3 hand_m)
{
    CORE_ASSERT(v3_is_finite(hand_m));
    player->rest_x_m = hand_m.x;
    player->rest_z_m = hand_m.z;
}

bool player_has_poi(const struct world *world, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return controller_is_active(world, index) && !controller_is_lost(world, index);
}

/* Returns the number of players who are still in the round. If `holds` is true, counts players with
 * a working controller. If `holds` is false, counts players without one. */
static uint32_t count_in(const struct game *game, const struct world *world, bool holds)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        count += player->plays && !player->out && player_has_poi(world, i) == holds;
    }
    return count;
}

void player_tick_pause(struct game *game, const struct world *world)
{
    /* True while time is left in the round. Afterwards a lost controller does not pause the
     * round. */
    const bool in_time = game_seconds_left(game, game->tick) > 0.0f;
    bool anybody_played = false;
    CORE_ASSERT(game->phase == PHASE_ROUND);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].plays |= (uint8_t)player_has_poi(world, i);
        anybody_played |= game->player[i].plays;
    }
    const uint32_t busy = count_in(game, world, true);
    /* Count for how long the other players have waited for each lost controller. If the time
     * exceeds a limit, the player of that controller is out. */
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &game->player[i];
        if (player_has_poi(world, i)) {
            player->lost_ticks = 0;
        } else if (player->plays && in_time && busy > 0 && !player->out) {
            player->lost_ticks++;
            player->waited_ticks++;
            player->out |= player->lost_ticks > GAME_LOST_TICKS_OTHERS ||
                           player->waited_ticks > GAME_WAIT_TICKS_OTHERS;
        }
    }
    game->paused = in_time && (!anybody_played || count_in(game, world, false) > 0);
    game->lost_ticks = game->paused && busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->waited_ticks += busy == 0 ? 1u : 0u;
        game->phase_tick++;
        game->paused_ticks++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}
