/* validate.h -- validates an untrusted species before the species is shown.
 *
 * core/morph/species.h states conditions that the core asserts. A species from a file may violate
 * these conditions. A species that passes the validation triggers no assertion of core/morph and
 * causes no read beyond the end of a table. */
#pragma once

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

/* Returns true if `name` has 1 to SPECIES_NAME_SIZE - 1 characters a-z, 0-9 and _, followed by zero
 * bytes. */
bool species_name_is_good(const char name[SPECIES_NAME_SIZE]);

/* ---- Functions that pack.c, validate.c and validate_mesh.c share ----------------------------- */

/* Writes the reason to `why` and returns false. The reason is the text that `format` and its
 * arguments produce. */
__attribute__((format(printf, 2, 3))) bool validate_refuse(char why[VALIDATE_WHY_SIZE],
                                                           const char *format, ...);

/* Writes the reason as validate_refuse() does. The value of the expression is `result`. */
#define validate_fail(result, ...) (validate_refuse(__VA_ARGS__), (result))

/* Returns true if `low` <= x <= `high`. If x is outside this range or NaN, writes the reason to
 * `why` and returns false. `format` and its arguments produce the name of the value in the
 * reason. */
__attribute__((format(printf, 5, 6))) bool validate_number(char why[VALIDATE_WHY_SIZE], float x,
                                                           float low, float high,
                                                           const char *format, ...);

/* Returns true if the integer `x`, 0 to 255, is less than `count`. Otherwise writes the reason to
 * `why` and returns false. The remaining arguments are a format and its arguments, as for
 * validate_number(). */
#define validate_choice(why, x, count, ...)                                                        \
    validate_number(why, (float)(x), 0.0f, (float)((count) - 1u), __VA_ARGS__)

/* Validates the meshes of both levels of detail. The caller guarantees that the card has been
 * validated successfully. */
bool validate_meshes(const struct species *species, char why[VALIDATE_WHY_SIZE]);
