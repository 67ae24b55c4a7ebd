/* validate_parts.h -- functions shared by validate.c (the card) and validate_mesh.c (the meshes).
 * Private to them. */
#ifndef KINGYO_PLATFORM_SPECIES_VALIDATE_PARTS_H
#define KINGYO_PLATFORM_SPECIES_VALIDATE_PARTS_H

#include "platform/species/validate.h"

#define VALIDATE_WHAT_SIZE 64u

struct vetting {
    const struct species *species;
    char *why; /* Buffer of VALIDATE_WHY_SIZE bytes. */
};

/* Writes the reason and returns false. */
__attribute__((format(printf, 2, 3))) bool validate_refuse(struct vetting *v, const char *format,
                                                           ...);

/* Checks that `low` <= x <= `high`, which NaN fails. */
bool validate_number(struct vetting *v, const char *what, float x, float low, float high);

/* Checks that x < `count`. */
bool validate_choice(struct vetting *v, const char *what, uint32_t x, uint32_t count);

/* Validates both levels of detail. The card must have passed its validation. */
bool validate_meshes(struct vetting *v);

#endif
