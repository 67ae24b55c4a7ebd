/* option_table.h -- one table of options, for command line, configuration file and --help. */
#ifndef KINGYO_PLATFORM_KIOSK_OPTION_TABLE_H
#define KINGYO_PLATFORM_KIOSK_OPTION_TABLE_H

#include <stddef.h>

#include "platform/kiosk/options.h"

#define OPTION_TEXT_MAX 160 /* As HAL_TEXT_SIZE: a board has its say. */

struct option {
    const char *name;
    const char *value;     /* As --help names it; null: takes none; in brackets: may be left out. */
    const char *help;
    const char *expects;   /* What a right value is. option_says() may add to it. */
    int (*set)(struct options *options, const char *value); /* 1, or 0: not a right value. */
    /* The section of the configuration file that it stands in; "" for one that a setting has taken
     * the place of, and that old files have before their first section; null: for no file. */
    const char *section;
};

/* The option at a place of the table, in the order of --help; null beyond its end. */
const struct option *option_at(uint32_t index);

/* The option of that name, `length` bytes long; null when there is none. */
const struct option *option_find(const char *name, size_t length);

/* `text`, and for --fish the bounds that only the waters know, in the order of --tank's names. */
const char *option_says(const struct option *option, const char *text, char out[OPTION_TEXT_MAX]);

/* What is wrong with `value`, where the option can say more than what would be right; null where it
 * cannot, and where nothing is. */
const char *option_objects(const struct option *option, const char *value,
                           char out[OPTION_TEXT_MAX]);

/* Whether two wires are on one line; then `says` which. */
int option_wires_clash(const struct options *options, char says[OPTION_TEXT_MAX]);

/* Whether the tank is too small for the fish that the file (`is_file`) or the command line asks
 * for; then `says` holds a line without its beginning. */
int option_too_many_fish(const struct options *options, char says[OPTION_TEXT_MAX]);

#endif
