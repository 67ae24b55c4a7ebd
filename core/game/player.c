/* player.c -- computes the state of each player in a round, and pauses a round while a player's
 * controller is lost. */
#include "core/game/phases.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/control/controller.h"
#include "core/game/game.h"
#include "core/poi/world.h"

int player_stirs(const struct player *player, vec3 hand_m)
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

uint64_t player_hash(uint64_t hash, const struct player *player)
{
    CORE_ASSERT(player->fouls <= FOUL_MAX);
    CORE_ASSERT(player->stance <= STANCE_MOVED);
    const uint32_t words[] = {
        player->plays,      player->out,          player->handed,          player->points,
        player->fouls,      player->foul,         player->foul_tick,       player->caught,
        player->scoops,     player->torn_tick,    player->first_torn_tick, player->sheets_before,
        player->lost_ticks, player->waited_ticks, player->stance
    };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < FOUL_COUNT; i++) {
        hash = hash_u32(hash, player->offence_tick[i]);
    }
    hash = hash_float(hash, player->rest_x_m);
    return hash_float(hash, player->rest_z_m);
}

int player_has_poi(const struct world *world, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return controller_is_active(world, index) && !controller_is_lost(world, index);
}

/* Returns the number of players who are still in the round. If `holds` is 1, counts players with a
 * working controller. If `holds` is 0, counts players without one. */
static uint32_t count_in(const struct game *game, const struct world *world, int holds)
{
    CORE_ASSERT(holds == 0 || holds == 1);
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        count += player->plays && !player->out && player_has_poi(world, i) == holds;
    }
    return count;
}

void player_tick_pause(struct game *game, const struct world *world)
{
    const int in_time = game_seconds_left(game, game->tick) > 0.0f; /* After time is up the round
                                                                       does not pause. */
    int anybody_played = 0;
    CORE_ASSERT(game->phase == PHASE_ROUND);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].plays |= (uint8_t)player_has_poi(world, i);
        anybody_played |= game->player[i].plays;
    }
    const uint32_t busy = count_in(game, world, 1);
    /* A player without a controller is out of the round when the other players have waited longer
     * than a limit. */
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
    game->paused = in_time && (!anybody_played || count_in(game, world, 0) > 0);
    game->lost_ticks = game->paused && busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->waited_ticks += busy == 0 ? 1u : 0u;
        game->phase_tick++;
        game->paused_ticks++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}
