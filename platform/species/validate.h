/* validate.h -- validates an untrusted species before the species is shown.
 *
 * core/morph/species.h states conditions that the core asserts. A species from a file may violate
 * these conditions. A species that passes the validation triggers no assertion of core/morph and
 * causes no read beyond the end of a table. */
#ifndef KINGYO_PLATFORM_SPECIES_VALIDATE_H
#define KINGYO_PLATFORM_SPECIES_VALIDATE_H

#include <stdbool.h>

#include "core/morph/species.h"

#define VALIDATE_WHY_SIZE 128u

/* Returns true if `species` is valid. Every number must be finite and in its range, and the graphs
 * must satisfy their constraints. The length of each key must match the growth curve at the key's
 * age within 2 %. Indices and anchors must refer to existing elements. All keys must have the same
 * size in the species' own measure.
 *
 * If `species` is invalid, returns false and writes one line without a line end to `why`: "field:
 * reason" or "key/field: reason". The caller guarantees that each table of `species` has the length
 * that the corresponding count states, for counts up to MESH_VERTEX_MAX, MESH_INDEX_MAX and
 * ANCHOR_MAX. */
bool species_validate(const struct species *species, char why[VALIDATE_WHY_SIZE]);

/* Returns true if the deformation graph `graph` is valid for a species of `key_count` keys.
 * Otherwise returns false and writes the reason to `why`. `curve` is the name of the graph in the
 * reason. */
bool species_validate_graph(const struct graph *graph, uint32_t key_count, const char *curve,
                            char why[VALIDATE_WHY_SIZE]);

/* Returns true if `name` has 1 to SPECIES_NAME_SIZE - 1 characters a-z, 0-9 and _, followed by zero
 * bytes. */
bool species_name_is_good(const char name[SPECIES_NAME_SIZE]);

/* ---- Functions that validate.c and validate_mesh.c share ------------------------------------- */

#define VALIDATE_WHAT_SIZE 64u

struct vetting {
    const struct species *species;
    char *why; /* Buffer of VALIDATE_WHY_SIZE bytes for the reason why the species is invalid. */
};

/* Writes the reason to `v->why` and returns false. The reason is the text that `format` and its
 * arguments produce. */
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
