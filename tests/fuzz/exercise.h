/* exercise.h -- uses a species that was found good as the kiosk and kingyoctl do. Whatever asserts
 * or reads beyond a table here was let through by species_vet(). */
#ifndef KINGYO_TESTS_FUZZ_EXERCISE_H
#define KINGYO_TESTS_FUZZ_EXERCISE_H

#include "core/morph/species.h"

void exercise(const struct species *species);

#endif
