/* player.h -- what a round knows of each who plays in it. */
#ifndef KINGYO_CORE_GAME_PLAYER_H
#define KINGYO_CORE_GAME_PLAYER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

#define PLAYER_STIR_M 0.03f /* A hand that stays within this of where it was rests. */

/* What a hand has done since READY began. */
enum player_stance { STANCE_UNSEEN = 0, STANCE_RESTS, STANCE_MOVED };

struct player {
    uint8_t plays;  /* Has held its poi in this round. */
    uint8_t out;    /* Its round is over before time is called. */
    uint8_t handed; /* Has got its fresh paper for this round. */
    uint8_t points; /* In CHOOSE: at which share of the tank its hand was, from 1; 0: nowhere. */
    uint8_t fouls;  /* 0 .. FOUL_MAX */
    uint8_t foul;   /* enum foul: the latest, ... */
    uint32_t foul_tick;                /* ... and when it was called. */
    uint32_t offence_tick[FOUL_COUNT]; /* When each kind was last committed, called or not. */
    uint32_t caught;
    uint32_t scoops;     /* With papers before the one in hand. */
    uint32_t torn_tick;  /* Since when the paper in hand can hold no fish; 0: it can. */
    uint32_t first_torn_tick; /* The same of the first of its papers, without the round's
                                 pauses before. */
    uint32_t sheets_before;   /* Papers before the one in hand. */
    uint32_t lost_ticks; /* How long others have waited for its hand without a break, ... */
    uint32_t waited_ticks; /* ... and in all of this round. */
    uint8_t stance;           /* enum player_stance, in READY ... */
    float rest_x_m, rest_z_m; /* ... and where its hand was when first seen there; in CHOOSE, where
                                 it was when it last moved on. */
};

/* Whether a hand at `hand_m` is no longer where it rested. */
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
