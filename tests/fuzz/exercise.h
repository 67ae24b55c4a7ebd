/* exercise.h -- uses a species as the kiosk and kingyoctl do. The species must have passed
 * species_validate(). A failed assertion or a read beyond the end of a table then shows that
 * species_validate() accepts invalid species. */
#ifndef KINGYO_TESTS_FUZZ_EXERCISE_H
#define KINGYO_TESTS_FUZZ_EXERCISE_H

#include "core/morph/species.h"

/* Calls every function of core/morph on `species`. Ends the process if a result is invalid. */
void exercise(const struct species *species);

#endif
