/* fuzz_text.c -- fuzz target: arbitrary text as a species description. Accepted text is lofted to a
 * mesh, validated and grown. */
#include <stdio.h>

#include "platform/species/pack.h"
#include "tests/fuzz/exercise.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct species_text text;
    static struct species_slot slot;
    static FILE *nowhere;
    char why[VALIDATE_WHY_SIZE];
    nowhere = nowhere ? nowhere : fopen("/dev/null", "w");
    FILE *file = size > 0 ? fmemopen((void *)(uintptr_t)bytes, size, "r") : NULL;
    if (file && species_read(file, "fuzz.txt", nowhere, &text)) {
        pack_text(&text, &slot);
        if (species_validate(&slot.species, why)) {
            exercise(&slot.species);
        }
    }
    if (file) {
        fclose(file);
    }
    return 0;
}
