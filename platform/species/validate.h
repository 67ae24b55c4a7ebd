/* validate.h -- validates an untrusted species before it is shown.
 *
 * The core asserts the conditions of core/morph/species.h, but a file may violate these conditions.
 * A species that passes the validation triggers no assertion of core/morph and causes no read
 * beyond the end of a table. */
#ifndef KINGYO_PLATFORM_SPECIES_VALIDATE_H
#define KINGYO_PLATFORM_SPECIES_VALIDATE_H

#include <stdbool.h>

#include "core/morph/species.h"

#define VALIDATE_WHY_SIZE 128u

/* Returns true if `species` is valid. Every number must be finite and in its range, and the graphs
 * must satisfy their constraints. The lengths of the keys must match the growth curve at the keys'
 * ages (within 2 %). Indices and anchors must refer to existing elements, and all keys must have
 * the same size.
 *
 * If `species` is invalid, returns false, and `why` is one line without a line end, "field: reason"
 * or "key/field: reason". The caller guarantees that the tables of `species` are as long as its
 * counts state, for counts up to MESH_VERTEX_MAX, MESH_INDEX_MAX and ANCHOR_MAX. */
bool species_validate(const struct species *species, char why[VALIDATE_WHY_SIZE]);

/* Validates the graph of one curve over `key_count` keys. `curve` is the curve's name for the error
 * message. Returns true if the graph is valid, otherwise false with the reason in `why`. */
bool species_validate_graph(const struct graph *graph, uint32_t key_count, const char *curve,
                            char why[VALIDATE_WHY_SIZE]);

/* Returns true if `name` has 1 to SPECIES_NAME_SIZE - 1 characters a-z, 0-9 and _, followed by zero
 * bytes. */
bool species_name_is_good(const char name[SPECIES_NAME_SIZE]);

#endif
