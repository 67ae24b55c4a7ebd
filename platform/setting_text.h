/* setting_text.h -- converts the operator's settings to and from the text in kingyo.conf, on the
 * command line and in the manual.
 *
 * The module adds section names, value names and help texts to the setting table of
 * core/settings.h. Pure functions. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/settings.h"

/* Size in bytes of a value's text. The longest text is the list of all mode names. */
#define SETTING_TEXT_MAX 64u
#define SETTING_RANGE_MAX 128u /* Size in bytes of the text for a value's range. */

/* Returns the section of kingyo.conf for a group of settings, or null if the group exists only
 * in the operator's menu (a controller's calibration). `group` must be less than
 * SETTING_GROUP_COUNT. */
const char *setting_section(uint32_t group);

/* Returns the id of the setting whose name is the `length` bytes at `name`. Returns SETTING_COUNT
 * if there is no such setting, or if no file may set it. */
uint32_t setting_find(const char *name, size_t length);

/* Parses a value: a decimal number, the name of a choice, mode names separated by commas, or a time
 * of day HH:MM. Returns true and sets `*out`. If the setting does not permit the value, returns
 * false and leaves `*out` unchanged. */
bool setting_parse(uint32_t id, const char *text, int32_t *out);

/* Writes a valid value in the form that setting_parse() reads. */
void setting_print(uint32_t id, int32_t value, char out[SETTING_TEXT_MAX]);

/* Writes the permitted values, for example "1 to 20", "0 to 240 in steps of 5" or "free, paid or
 * event". */
void setting_range(uint32_t id, char out[SETTING_RANGE_MAX]);

/* Returns one or two English sentences that describe the setting, without a line break. Returns ""
 * for a setting that no file may set. */
const char *setting_help(uint32_t id);
