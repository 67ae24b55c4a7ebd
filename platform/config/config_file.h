/* config_file.h -- reads kingyo.conf, the operator's configuration file.
 *
 * The file has sections in brackets and "key = value" lines. A '#' at the beginning of a line or
 * after white space starts a comment. A key is the name of a setting (core/settings.h), in the
 * section of its group, or of some options (option_table.h), in their section. Before the first
 * section every key is accepted, also options that a setting has replaced, so that old files
 * without sections remain valid. A line that cannot be used is reported and skipped, because a
 * typing mistake must not prevent the start of the kiosk. */
#ifndef KINGYO_PLATFORM_CONFIG_CONFIG_FILE_H
#define KINGYO_PLATFORM_CONFIG_CONFIG_FILE_H

#include <stdio.h>

#include "platform/config/options.h"

#define CONFIG_FILE_DEFAULT "/etc/kingyo/kingyo.conf"
#define CONFIG_WARNINGS_MAX 20u /* Warnings for one file; further ones are only counted. */
/* Largest file in bytes; all keys with their comments take 5 KiB. */
#define CONFIG_SIZE_MAX (1u << 20)
/* Longest line in bytes; a longer line is skipped with a warning. */
#define CONFIG_LINE_MAX (OPTIONS_PATH_MAX + 64u)

/* Reads `path` into `options`: settings into options->file, other keys as the command line does.
 * `warn` (may be null) gets "FILE:LINE: reason", with the range of a value. Returns 0, or a
 * negative errno of regular_file_open() if the file cannot be read. */
int config_file_read(struct options *options, const char *path, void (*warn)(const char *line));

/* Writes an example file that contains only comments: every key with its purpose, range and
 * default. */
void config_file_print_defaults(FILE *out);

#endif
