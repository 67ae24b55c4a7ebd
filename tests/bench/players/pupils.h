/* pupils.h -- pairs of simulated players that prove the aids of the lessons: one player ignores a
 * sign on the screen, and the other player follows the sign. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_PUPILS_H
#define KINGYO_TESTS_BENCH_PLAYERS_PUPILS_H

#include "tests/bench/players/sim_player.h"

/* A pair of players with the same fault. */
struct pupil {
    uint8_t sign; /* Sign that cures the fault (enum scene_hint or enum player_sign). */
    const char *name, *fault;
    struct habits ignores; /* Habits of the player who ignores the sign. */
    /* Habits of the other player, who has the habits `cured` after the sign is seen. */
    struct habits follows;
    struct habits cured;
};

#define PUPILS_MAX 16u

/* Writes the pairs to `pupils` and returns their number. `pupils` must stay valid, because the
 * habits refer to it. */
uint32_t pupils_init(struct pupil pupils[PUPILS_MAX]);

#endif
