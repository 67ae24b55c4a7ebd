/* poi_fields.h -- the tables of the members of the poi and of the bowl (core/base/field.h). The
 * state hash and the tests read the tables. */
#pragma once

#include "core/base/field.h"

/* Members of struct poi, including all nested structs. */
extern const struct field_table poi_fields;

/* Most important members of struct poi. The table does not list the other members. */
extern const struct field_table poi_quick_fields;

extern const struct field_table bowl_fields;

/* Part of struct poi that tests hash separately. */
extern const struct field_table sheet_fields;
