/* setting_text.h -- the operator's settings as people write them: in kingyo.conf, on the command
 * line and in the manual. Pure: rows of core/settings' table with words. */
#ifndef KINGYO_PLATFORM_SETTING_TEXT_H
#define KINGYO_PLATFORM_SETTING_TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "core/settings.h"

#define SETTING_TEXT_MAX 64u   /* A value: every mode's name, and commas. */
#define SETTING_RANGE_MAX 128u /* What a value may be. */

/* The section of kingyo.conf that a group's settings stand in; null: that group is not for files,
 * only for the operator's menu (a controller's calibration). `group` < SETTING_GROUP_COUNT. */
const char *setting_section(uint32_t group);

/* The setting with that name, `length` bytes long; SETTING_COUNT when no file may name one so. */
uint32_t setting_find(const char *name, size_t length);

/* 1 and `*out`, or 0 and `*out` as it was: `text` is no value that the setting may have. A number
 * is decimal; a choice is its word; modes are words between commas; a time of day is HH:MM. */
int setting_parse(uint32_t id, const char *text, int32_t *out);

/* A value that setting_allows(), as setting_parse() reads it. */
void setting_print(uint32_t id, int32_t value, char out[SETTING_TEXT_MAX]);

/* What would be right: "1 to 20", "0 to 240 in steps of 5", "free, paid or event". */
void setting_range(uint32_t id, char out[SETTING_RANGE_MAX]);

/* What it is good for, in English; one sentence or two without a line break. "" for a setting that
 * is not for files. */
const char *setting_help(uint32_t id);

#endif
