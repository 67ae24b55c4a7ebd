/* vet_parts.h -- what vet.c (the card) and vet_mesh.c (the bodies) share. Nobody else's. */
#ifndef KINGYO_PLATFORM_SPECIES_VET_PARTS_H
#define KINGYO_PLATFORM_SPECIES_VET_PARTS_H

#include "platform/species/vet.h"

#define VET_WHAT_SIZE 64u

struct vetting {
    const struct species *species;
    char *why; /* VET_WHY_SIZE */
};

/* Writes the reason and answers false. */
__attribute__((format(printf, 2, 3))) bool vet_refuse(struct vetting *v, const char *format, ...);

/* `low` <= x <= `high`, which no not-a-number is. */
bool vet_number(struct vetting *v, const char *what, float x, float low, float high);

/* x < `count`. */
bool vet_choice(struct vetting *v, const char *what, uint32_t x, uint32_t count);

/* Both levels of detail; the card has been found good. */
bool vet_meshes(struct vetting *v);

#endif
