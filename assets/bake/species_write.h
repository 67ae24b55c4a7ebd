/* species_write.h -- writes a species as C source. */
#ifndef KINGYO_ASSETS_BAKE_SPECIES_WRITE_H
#define KINGYO_ASSETS_BAKE_SPECIES_WRITE_H

#include <stdbool.h>
#include <stdio.h>

#include "core/morph/species.h"

/* Writes the C constant `const struct species species_ID`, in which ID is the species' name.
 * Returns false if the file could not be written completely. */
bool species_write(FILE *file, const struct species *species);

#endif
