/* setting_text.h -- text form of the operator's settings in kingyo.conf, on the command line and in
 * the manual.
 *
 * Adds words to the rows of core/settings' table. Pure. */
#ifndef KINGYO_PLATFORM_SETTING_TEXT_H
#define KINGYO_PLATFORM_SETTING_TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "core/settings.h"

#define SETTING_TEXT_MAX 64u   /* Size of a value: all mode names with commas. */
#define SETTING_RANGE_MAX 128u /* Size of the text for a value's range. */

/* Returns the section of kingyo.conf for a group of settings. Null: the group exists only in the
 * operator's menu (a controller's calibration). `group` < SETTING_GROUP_COUNT. */
const char *setting_section(uint32_t group);

/* Returns the setting with that name of `length` bytes, or SETTING_COUNT if no file may set such a
 * name. */
uint32_t setting_find(const char *name, size_t length);

/* Parses a value: a decimal number, the word of a choice, modes separated by commas, or a time of
 * day HH:MM. Returns 1 and sets `*out`, or returns 0 and leaves `*out` unchanged if the setting
 * does not allow the value. */
int setting_parse(uint32_t id, const char *text, int32_t *out);

/* Writes a valid value in the form that setting_parse() reads. */
void setting_print(uint32_t id, int32_t value, char out[SETTING_TEXT_MAX]);

/* Writes the allowed values: "1 to 20", "0 to 240 in steps of 5", "free, paid or event". */
void setting_range(uint32_t id, char out[SETTING_RANGE_MAX]);

/* Returns the purpose of a setting in English, one or two sentences without a line break. Returns
 * "" for a setting that no file may set. */
const char *setting_help(uint32_t id);

#endif
