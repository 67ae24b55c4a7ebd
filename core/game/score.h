/* score.h -- scoring of a round, and its stored record. */
#ifndef KINGYO_CORE_GAME_SCORE_H
#define KINGYO_CORE_GAME_SCORE_H

#include <stdint.h>

#include "core/output.h"
#include "core/poi/catch/catch.h"

struct core;

/* Runs the last step of a tick: counts the fish that reached the bowls, by the mode's rules. */
void game_score(struct core *core, const struct catch_result caught[POI_MAX],
                struct output *output);

/* Returns the record of the current or the last round, with `id` 0. */
struct round_record game_record(const struct core *core);

/* Logs the LEDGER_ROUND of a finished, not refunded round, which also closes the balance and
 * updates the leaderboard. A round without players is not logged, and a round without a score
 * produces no record. */
void score_keep(struct core *core, uint32_t tickets, struct output *output);

#endif
