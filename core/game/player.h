/* player.h -- the state of each player in a round. */
#ifndef KINGYO_CORE_GAME_PLAYER_H
#define KINGYO_CORE_GAME_PLAYER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

#define PLAYER_STIR_M 0.03f /* Distance within which a controller counts as resting. */

/* Motion of a controller since READY began. */
enum player_stance { STANCE_UNSEEN = 0, STANCE_RESTS, STANCE_MOVED };

struct player {
    uint8_t plays;      /* 1: the player has had a poi in use in this round. */
    uint8_t out;        /* 1: the player's round ended before time was up. */
    uint8_t handed;     /* 1: the player has received fresh paper for this round. */
    uint8_t points;     /* In CHOOSE: section of the tank under the poi, from 1; 0: none. */
    uint8_t fouls;      /* 0 .. FOUL_MAX */
    uint8_t foul;       /* enum foul of the latest foul. */
    uint32_t foul_tick; /* Tick of the latest counted foul. */
    uint32_t offence_tick[FOUL_COUNT]; /* Tick at which each kind was last committed, counted or
                                          not. */
    uint32_t caught;
    uint32_t scoops;          /* Number of dips with the earlier sheets of this round. */
    uint32_t torn_tick;       /* Tick at which the current sheet became useless; 0: usable. */
    uint32_t first_torn_tick; /* Tick at which the first sheet became useless, without earlier
                                 pauses of the round; 0: usable. */
    uint32_t sheets_before;   /* Number of sheets before the current one. */
    uint32_t lost_ticks;      /* Ticks for which others have waited for this controller without a
                                 break. */
    uint32_t waited_ticks; /* Ticks in this round for which others have waited for this controller,
                              in total. */
    uint8_t stance;        /* enum player_stance, in READY. */
    float rest_x_m, rest_z_m; /* Rest position of the controller: in READY, where it was first seen;
                                 in CHOOSE, where it last moved. */
};

/* Returns 1 if the controller at `hand_m` has left its rest position. */
static inline int player_stirs(const struct player *player, vec3 hand_m)
{
    const float x_m = hand_m.x - player->rest_x_m, z_m = hand_m.z - player->rest_z_m;
    return x_m * x_m + z_m * z_m > PLAYER_STIR_M * PLAYER_STIR_M;
}

static inline void player_rests(struct player *player, vec3 hand_m)
{
    player->rest_x_m = hand_m.x;
    player->rest_z_m = hand_m.z;
}

uint64_t player_hash(uint64_t hash, const struct player *player);

#endif
