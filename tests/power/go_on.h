/* go_on.h -- after a cut the stall opens again and plays on: what was open comes back once, ids and
 * sums go on without a gap. */
#ifndef KINGYO_TESTS_POWER_GO_ON_H
#define KINGYO_TESTS_POWER_GO_ON_H

#include "tests/power/books.h"

/* Plays half a minute in `folder`, closes, and opens once more. `before` is the sum of all that was
 * on disk, whose newest entry is `last_id`. 0; else `why` says what is not so. */
int go_on(const char *folder, const struct books *before, uint32_t last_id,
          char why[BOOKS_WHY_SIZE]);

#endif
