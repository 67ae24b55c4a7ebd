/* player.h -- the state of each player in a round. */
#ifndef KINGYO_CORE_GAME_PLAYER_H
#define KINGYO_CORE_GAME_PLAYER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

/* Distance from the rest position within which a controller counts as resting. */
#define PLAYER_STIR_M 0.03f

/* Whether a controller has moved since READY began. */
enum player_stance { STANCE_UNSEEN = 0, STANCE_RESTS, STANCE_MOVED };

struct player {
    uint8_t plays;      /* 1 if the player has had a poi in use in this round, otherwise 0. */
    uint8_t out;        /* 1 if the player's round ended before time was up, otherwise 0. */
    uint8_t handed;     /* 1 if the player has received fresh paper for this round, otherwise 0. */
    uint8_t points;     /* In the mode selection: section of the tank under the poi, from 1; 0 means
                           none. */
    uint8_t fouls;      /* Number of counted fouls, 0 .. FOUL_MAX. */
    uint8_t foul;       /* Kind of the latest foul (enum foul). */
    uint32_t foul_tick; /* Tick of the latest counted foul. */
    uint32_t offence_tick[FOUL_COUNT]; /* Tick at which the player last committed each kind of foul,
                                          counted or not. */
    uint32_t caught;
    uint32_t scoops;          /* Number of dips with the earlier sheets of this round. */
    uint32_t torn_tick;       /* Tick at which the current sheet became useless; 0 means that the
                                 sheet is usable. */
    uint32_t first_torn_tick; /* Tick at which the first sheet became useless, reduced by the
                                 earlier pauses of the round; 0 means that the sheet is usable. */
    uint32_t sheets_before;   /* Number of sheets that the player used before the current sheet. */
    uint32_t lost_ticks;      /* Duration in ticks of the current pause in which other players wait
                                 for this controller. */
    uint32_t waited_ticks; /* Total ticks in this round for which other players have waited for this
                              controller. */
    uint8_t stance;        /* Motion of the controller since READY began (enum player_stance). */
    float rest_x_m, rest_z_m; /* Rest position of the controller. In READY: position at which the
                                 controller was first seen. In the mode selection: position at the
                                 controller's last motion. */
};

/* Returns 1 if the controller at `hand_m` has left its rest position, otherwise 0. */
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
