/* species_write.h -- a species as C source. */
#ifndef KINGYO_ASSETS_BAKE_SPECIES_WRITE_H
#define KINGYO_ASSETS_BAKE_SPECIES_WRITE_H

#include <stdbool.h>
#include <stdio.h>

#include "core/morph/species.h"

/* Writes `const struct species species_ID`. False when the file did not take it all. */
bool species_write(FILE *file, const struct species *species);

#endif
