/* validate_parts.h -- functions that validate.c (the card) and validate_mesh.c (the meshes) share.
 * Only these two files may include this header. */
#ifndef KINGYO_PLATFORM_SPECIES_VALIDATE_PARTS_H
#define KINGYO_PLATFORM_SPECIES_VALIDATE_PARTS_H

#include "platform/species/validate.h"

#define VALIDATE_WHAT_SIZE 64u

struct vetting {
    const struct species *species;
    char *why; /* Buffer of VALIDATE_WHY_SIZE bytes for the reason why the species is invalid. */
};

/* Writes the reason to `why` of struct vetting and returns false. */
__attribute__((format(printf, 2, 3))) bool validate_refuse(struct vetting *v, const char *format,
                                                           ...);

/* Returns true if `low` <= x <= `high`. Otherwise, and if x is NaN, writes the reason and returns
 * false. */
bool validate_number(struct vetting *v, const char *what, float x, float low, float high);

/* Returns true if x < `count`. Otherwise writes the reason and returns false. */
bool validate_choice(struct vetting *v, const char *what, uint32_t x, uint32_t count);

/* Validates the meshes of both levels of detail. The caller guarantees that the card has been
 * validated successfully. */
bool validate_meshes(struct vetting *v);

#endif
