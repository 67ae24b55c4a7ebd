/* tank_fields.h -- the tables of the members of the tank (core/base/field.h). The state hash and
 * the tests read the tables. */
#pragma once

#include "core/base/field.h"

/* Table of the members of struct tank, including the members of all nested structs. */
extern const struct field_table tank_fields;

/* Table of the members of struct tank that a quick hash reads: only the poses and gaits of the
 * fish, which change every tick and determine the game. */
extern const struct field_table tank_quick_fields;

/* Tables of struct fish and struct water, which tests hash separately. */
extern const struct field_table fish_fields;
extern const struct field_table water_fields;
