/* exercise.h -- uses a species as the kiosk and kingyoctl do.
 *
 * The species must have passed species_validate(). If an assertion fails or a read goes beyond the
 * end of a table, species_validate() accepted an invalid species. */
#ifndef KINGYO_TESTS_FUZZ_EXERCISE_H
#define KINGYO_TESTS_FUZZ_EXERCISE_H

#include "core/morph/species.h"

/* Calls every function of core/morph on `species`. Ends the process if a result is invalid. */
void exercise(const struct species *species);

#endif
