/* score.h -- what counts, and what is kept of a round. */
#ifndef KINGYO_CORE_GAME_SCORE_H
#define KINGYO_CORE_GAME_SCORE_H

#include <stdint.h>

#include "core/output.h"
#include "core/poi/catch.h"

struct core;

/* The last step of a tick: what came into the bowls counts as the mode's rules say. */
void game_score(struct core *core, const struct catch_result caught[POI_MAX],
                struct output *output);

/* The round that runs, or was the last to run, in figures; `id` is 0. */
struct round_record game_record(const struct core *core);

/* At the end of a round that was not given back: its LEDGER_ROUND, which closes the purse, and with
 * it its place in the ranking. A round that nobody played leaves none, one without a score no
 * record. */
void score_keep(struct core *core, uint32_t tickets, struct output *output);

#endif
