/* leaderboard.h -- the leaderboard screen, which is shown after a round with a ranked player, and
 * at intervals in attract mode. */
#ifndef KINGYO_CORE_GAME_RANKING_LEADERBOARD_H
#define KINGYO_CORE_GAME_RANKING_LEADERBOARD_H

#include <stdint.h>

#include "core/game/ranking/ranking.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

/* Duration of the leaderboard screen, long enough to read ten rows. */
#define LEADERBOARD_TICKS (9u * CORE_TICK_HZ)
/* Time in attract mode between the starts of two leaderboard screens. The tank is shown between the
 * screens. */
#define LEADERBOARD_EVERY_TICKS (30u * CORE_TICK_HZ)

/* A player's best place over the leaderboards of all periods. If the places in two periods are
 * equal, the longer period counts. */
struct leaderboard_place {
    uint8_t period; /* Period of the leaderboard with the best place (enum rank_period). */
    uint8_t place;  /* Best place, from 1; 0 means not ranked. */
};

struct game;
struct world;
struct core_config;

/* Returns the best place of slot `seat` in the round with ledger id `round_id`. The place is 0 if
 * the slot is not ranked or `round_id` is 0. */
struct leaderboard_place leaderboard_best_place(const struct ranking *ranking, uint8_t mode,
                                                uint32_t round_id, uint8_t seat);

/* Enters the leaderboard phase for the round of the latest name entry. START or a dip starts a
 * game; OK turns the page. */
void leaderboard_begin(struct game *game);
void leaderboard_tick(struct game *game, struct world *world, const struct core_config *config,
                      const struct input *input, struct output *output);

/* Fills `out` with the visible leaderboard. The function also works in attract mode and in the
 * operator's menu. */
void leaderboard_show(const struct game *game, const struct core_config *config,
                      struct scene_leaderboard *out);

#endif
