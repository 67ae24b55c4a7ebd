/* option_table.h -- one table of options for the command line, the configuration file and
 * --help. */
#ifndef KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H
#define KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H

#include <stddef.h>

#include "platform/config/options.h"

#define OPTION_TEXT_MAX 160 /* As HAL_TEXT_SIZE because a board may add text. */

struct option {
    const char *name;
    const char *value; /* Name of the value in --help; null: no value; in brackets: optional. */
    const char *help;
    const char *expects; /* Text about valid values. option_text() may extend it. */
    int (*set)(struct options *options, const char *value); /* Returns 1, or 0 if the value is
                                                               invalid. */
    /* Section of the option in the configuration file. "" for an option that a setting has
     * replaced, and that old files have before their first section. Null: not allowed in a file. */
    const char *section;
};

/* Returns the option at an index, in the order of --help, or null beyond the end. */
const struct option *option_at(uint32_t index);

/* Returns the option with that name of `length` bytes, or null. */
const struct option *option_find(const char *name, size_t length);

/* Returns `text`; for --fish also the limits of each tank, in the order of --tank's names. */
const char *option_text(const struct option *option, const char *text, char out[OPTION_TEXT_MAX]);

/* Returns why `value` is invalid if the option has a more specific message than the valid range;
 * else null. */
const char *option_objects(const struct option *option, const char *value,
                           char out[OPTION_TEXT_MAX]);

/* Returns 1 if two GPIO line options use the same line, and names the line in `says`. */
int option_wires_clash(const struct options *options, char says[OPTION_TEXT_MAX]);

/* Returns 1 if the tank is too small for the fish that the file (`is_file`) or the command line
 * sets. Then `says` contains the message without its beginning. */
int option_too_many_fish(const struct options *options, char says[OPTION_TEXT_MAX]);

#endif
