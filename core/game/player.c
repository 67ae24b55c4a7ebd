/* player.c -- computes the hash of a player's state. */
#include "core/game/player.h"

#include "core/base/hash.h"

uint64_t player_hash(uint64_t hash, const struct player *player)
{
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
