/* option_table.h -- the table of options, used by the command line, the configuration file and
 * --help. */
#ifndef KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H
#define KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H

#include <stddef.h>

#include "platform/config/options.h"

/* Size in bytes of an option's text. At least HAL_TEXT_SIZE because a board may write the text. */
#define OPTION_TEXT_MAX 160

struct option {
    const char *name;
    const char *value; /* Name of the value in --help. Null means that the option has no value. A
                          name in brackets means that the value is optional. */
    const char *help;
    const char *expects; /* Text about valid values for error messages. option_text() may extend the
                            text. */
    int (*set)(struct options *options, const char *value); /* Parses `value` into `options`.
                                                               Returns 1, or 0 if the value is
                                                               invalid. */
    /* Section of the option in the configuration file. "" means that a setting has replaced the
     * option; old files may have the option before the first section. Null means that no file may
     * contain the option. */
    const char *section;
};

/* Returns the option at `index` in the order of --help, or null if `index` is beyond the end. */
const struct option *option_at(uint32_t index);

/* Returns the option whose name is the `length` bytes at `name`, or null if there is none. */
const struct option *option_find(const char *name, size_t length);

/* Returns `text`. For --fish, writes `text` and the maximum of each tank to `out`, in the order of
 * --tank's names, and returns `out`. */
const char *option_text(const struct option *option, const char *text, char out[OPTION_TEXT_MAX]);

/* Returns a specific reason why `value` is invalid. Returns null if the value is valid, or if the
 * error message needs only the valid range. */
const char *option_objects(const struct option *option, const char *value,
                           char out[OPTION_TEXT_MAX]);

/* Returns 1 and names the GPIO line in `says` if two GPIO line options use the same GPIO line.
 * Otherwise returns 0. */
int option_wires_clash(const struct options *options, char says[OPTION_TEXT_MAX]);

/* Returns 1 if the tank cannot hold the configured number of fish, and writes the reason to `says`.
 * Otherwise returns 0. Checks the configuration file if options->is_file is 1, otherwise the
 * command line. */
int option_too_many_fish(const struct options *options, char says[OPTION_TEXT_MAX]);

#endif
