/* resume.h -- continues to play after a power cut.
 *
 * The round that was interrupted must be refunded or ended exactly once. The ids and totals of the
 * ledger entries must continue without a gap. */
#ifndef KINGYO_TESTS_POWER_RESUME_H
#define KINGYO_TESTS_POWER_RESUME_H

#include "tests/power/ledger_totals.h"

/* Plays half a minute in `folder`, closes the store and opens it once more. `before` has the totals
 * of all entries on the disk, and `last_id` is the id of the newest of them. Returns 0 if all
 * checks pass. Otherwise writes the fault to `why` and returns a value other than 0. */
int resume_play(const char *folder, const struct ledger_totals *before, uint32_t last_id,
                char why[LEDGER_TOTALS_WHY_SIZE]);

#endif
