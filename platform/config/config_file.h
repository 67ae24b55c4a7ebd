/* config_file.h -- reads kingyo.conf, the operator's configuration file.
 *
 * The file consists of sections in brackets and lines of the form "key = value". A '#' at the start
 * of a line or after white space starts a comment. A key is the name of a setting (core/settings.h)
 * or of an option (option_table.h). Each key belongs to one section and must be in this section.
 * However, any key is accepted before the first section, even an old option that a setting has
 * replaced, so that old files without sections remain valid. An invalid line is reported and
 * skipped, because a typing mistake must not prevent the start of the kiosk. */
#pragma once

#include <stdio.h>

#include "platform/config/options.h"

#define CONFIG_FILE_DEFAULT "/etc/kingyo/kingyo.conf"
/* Maximum number of warnings for one file. Additional warnings are only counted. */
#define CONFIG_WARNINGS_MAX 20u
/* Maximum file size in bytes. All keys with their comments take 5 KiB. */
#define CONFIG_SIZE_MAX (1u << 20)
/* Maximum length of a line in bytes. A longer line is skipped with a warning. */
#define CONFIG_LINE_MAX (OPTIONS_PATH_MAX + 64u)

/* Reads the file `path`. Settings are written to options->file, and other keys change `options` as
 * the command line does. Calls `warn` (may be null) for each invalid line, with "FILE:LINE: reason"
 * and the permitted range. Returns 0, or a negative errno of file_open() if the file cannot
 * be read. */
int config_file_read(struct options *options, const char *path, void (*warn)(const char *line));

/* Writes an example file that contains only comments: each key with its purpose, range and
 * default. */
void config_file_print_defaults(FILE *out);
