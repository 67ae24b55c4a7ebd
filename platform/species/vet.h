/* vet.h -- whether a species that somebody else made may be shown.
 *
 * The core asserts what a species promises (core/morph/species.h); files promise nothing. Whatever
 * passes here breaks no assertion of core/morph and reads no table beyond its end. */
#ifndef KINGYO_PLATFORM_SPECIES_VET_H
#define KINGYO_PLATFORM_SPECIES_VET_H

#include <stdbool.h>

#include "core/morph/species.h"

#define VET_WHY_SIZE 128u

/* True: every number of `species` is finite and in its range, its graphs hold their constraint, its
 * keys' lengths are the growth curve's at their ages (within 2 %), its indices and anchors name
 * what exists, its keys are one size. False: `why` is one line without a
 * line end, "field: reason" or "key/field: reason". The tables that `species` points to are as long
 * as its counts say, when those are within MESH_VERTEX_MAX, MESH_INDEX_MAX and ANCHOR_MAX. */
bool species_vet(const struct species *species, char why[VET_WHY_SIZE]);

/* The same of one curve's graph over `key_count` keys; `curve` is its name, for `why`. */
bool species_vet_graph(const struct graph *graph, uint32_t key_count, const char *curve,
                       char why[VET_WHY_SIZE]);

/* Is `name` of 1 .. SPECIES_NAME_SIZE - 1 characters a-z, 0-9 and _, with zeros behind them? */
bool species_name_is_good(const char name[SPECIES_NAME_SIZE]);

#endif
