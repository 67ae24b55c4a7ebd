/* go_on.h -- continues to play after a power cut.
 *
 * Checks that the open round is refunded or ended exactly once, and that entry ids and sums
 * continue without a gap. */
#ifndef KINGYO_TESTS_POWER_GO_ON_H
#define KINGYO_TESTS_POWER_GO_ON_H

#include "tests/power/books.h"

/* Plays half a minute in `folder`, closes the store and opens it once more. `before` is the sum of
 * all entries on the disk, and `last_id` is the newest of these entries. Returns 0; otherwise `why`
 * names the fault. */
int go_on(const char *folder, const struct books *before, uint32_t last_id,
          char why[BOOKS_WHY_SIZE]);

#endif
