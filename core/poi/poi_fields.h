/* poi_fields.h -- the tables of the members of the poi and of the bowl (core/base/field.h). The
 * state hash and the tests read the tables. */
#pragma once

#include "core/base/field.h"

/* Table of the members of struct poi, including the members of all nested structs. */
extern const struct field_table poi_fields;

/* Table of the most important members of struct poi. The quick hash reads only these members. */
extern const struct field_table poi_quick_fields;

extern const struct field_table bowl_fields;

/* Table of struct sheet (the paper of a poi), which tests hash separately. */
extern const struct field_table sheet_fields;
