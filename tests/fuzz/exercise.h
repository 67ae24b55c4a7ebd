/* exercise.h -- uses an accepted species as the kiosk and kingyoctl do.
 *
 * If an assertion fails or a table is read beyond its end here, species_validate() accepted an
 * invalid species. */
#ifndef KINGYO_TESTS_FUZZ_EXERCISE_H
#define KINGYO_TESTS_FUZZ_EXERCISE_H

#include "core/morph/species.h"

/* Calls every function of core/morph on `species`. Ends the process if a result is invalid. */
void exercise(const struct species *species);

#endif
