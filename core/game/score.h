/* score.h -- scoring of a round, and its stored record. */
#ifndef KINGYO_CORE_GAME_SCORE_H
#define KINGYO_CORE_GAME_SCORE_H

#include <stdint.h>

#include "core/output.h"
#include "core/poi/catch/catch.h"

struct game;
struct world;
struct core_config;

/* Runs the last step of a tick: counts the fish that reached the bowls, as the mode's rules
 * require. */
void game_score(struct game *game, const struct world *world,
                const struct catch_result caught[POI_MAX], struct output *output);

/* Returns the record of the current round, or of the last round if none runs. The record's `id` is
 * 0. */
struct round_record game_record(const struct game *game, const struct world *world,
                                const struct core_config *config);

/* Logs the LEDGER_ROUND of a finished round that was not refunded. The entry also closes the
 * balance and updates the leaderboards. A round without players is not logged. A round in a mode
 * without a score produces no record. */
void score_keep(struct game *game, const struct world *world, const struct core_config *config,
                uint32_t tickets, struct output *output);

#endif
