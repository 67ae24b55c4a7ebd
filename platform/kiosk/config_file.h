/* config_file.h -- kingyo.conf: what an operator writes instead of a command line.
 *
 * Sections in brackets, "key = value" lines, and comments from a '#' (at the beginning of a line or
 * after white space) to its end. Keys are the settings' names (core/settings.h) in the section of
 * their group, and some options' (option_table.h) in theirs. Before the first section every key may
 * stand, and the options that settings took the place of: so files without sections go on to be
 * read. A line that cannot be used is told, and passed over: a typing mistake must not keep a stall
 * closed. */
#ifndef KINGYO_PLATFORM_KIOSK_CONFIG_FILE_H
#define KINGYO_PLATFORM_KIOSK_CONFIG_FILE_H

#include <stdio.h>

#include "platform/kiosk/options.h"

#define CONFIG_FILE_DEFAULT "/etc/kingyo/kingyo.conf"
#define CONFIG_WARNINGS_MAX 20u /* Of one file; the others are only counted. */
#define CONFIG_SIZE_MAX (1u << 20) /* Bytes; all keys with their comments are 5 KiB. */
#define CONFIG_LINE_MAX (OPTIONS_PATH_MAX + 64u) /* A longer line is passed over, with a warning. */

/* Reads `path` into `options`: settings into options->file, the others as the command line would.
 * `warn` (may be null) gets "FILE:LINE: what", with the range of a value. Returns 0, or a negative
 * errno of plain_file_open() when the file cannot be read. */
int options_read_config(struct options *options, const char *path, void (*warn)(const char *line));

/* A file that says what the kiosk does without one: every key, what it is for, its range and its
 * standard, all of it in comments. */
void config_file_print_defaults(FILE *out);

#endif
