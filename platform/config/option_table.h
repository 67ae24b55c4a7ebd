/* option_table.h -- declarative tables of the options of `kingyo` and of the commands of
 * `kingyoctl`.
 *
 * A table has one row for each option: the name, the kind and the range of the value, the member of
 * a structure that receives the value, and the text of --help. The functions below parse a command
 * line with a table, parse one value for config_file.c, and print a table. Only
 * option_table_print() writes to a file; all other functions are pure. */
#ifndef KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H
#define KINGYO_PLATFORM_CONFIG_OPTION_TABLE_H

#include <stddef.h>
#include <stdint.h>

/* Size in bytes of the target of an OPTION_PATH. */
#define OPTIONS_PATH_MAX 1024u
/* Size in bytes of the message about a wrong command line. */
#define OPTIONS_ERROR_MAX 384u
/* Size in bytes of a text about one value. At least HAL_TEXT_SIZE because a board may write the
 * text. */
#define OPTION_TEXT_MAX 160

/* Kind of an option. The kind determines the type of the target. */
enum option_kind {
    OPTION_HEADING = 0, /* No option: a heading between the options in --help. */
    OPTION_FLAG,        /* No value. The target is a uint8_t or bool, which is set to 1. */
    OPTION_TEXT,        /* A text that is not empty. The target is a const char *. */
    OPTION_PATH,        /* A path that is not empty. The target is a char[OPTIONS_PATH_MAX]. */
    OPTION_WHOLE,       /* A whole number in [min, max]. The target is a uint32_t. */
    OPTION_DECIMAL,     /* A number in [min, max]. The target is a double. */
    OPTION_CHOICE,      /* One of the words `choices`. The target is a uint8_t, the word's index. */
    OPTION_CUSTOM,      /* A value that the function `set` parses. */
    OPTION_ARGUMENT,    /* A word of the command line without a name. The target is a const char *,
                           unless `set` is not null. */
};

struct option {
    const char *name;  /* Name without dashes. A name of one letter has one dash on the command
                          line, other names have two. Null for headings and arguments. */
    const char *value; /* Name of the value in --help. Null if the option has no value. A name in
                          brackets means that the value is optional. */
    const char *help;  /* Text of --help. The range and the default are appended to the text. */
    enum option_kind kind;
    size_t offset; /* Offset in bytes of the target in the structure that the caller fills. */
    double min, max;
    const char *const *choices; /* The words of an OPTION_CHOICE. The list ends with null. */
    const char *initial; /* Default value, which is parsed before the command line. Null if the
                            caller sets the default. */
    const char *expects; /* Valid values in error messages. Null selects a text that is generated
                            from the kind and the range. */
    /* Parses `value` for an OPTION_CUSTOM or an OPTION_ARGUMENT. `value` is null if an optional
     * value is absent. Returns 1. Returns 0 if the value is wrong; then `why` may receive a
     * specific reason. */
    int (*set)(void *target, const struct option *option, const char *value,
               char why[OPTION_TEXT_MAX]);
    uint32_t id; /* Number for `set`, for example the id of a setting. */
    /* Writes text that is appended to `help` and to `expects`. May be null. */
    void (*more)(char out[OPTION_TEXT_MAX]);
    uint32_t groups; /* Bit set of the subcommands that accept the option. 0 means all. */
    /* Section of the option in the configuration file. "" means that a setting has replaced the
     * option; old files may have the option before the first section. Null means that no file may
     * contain the option. */
    const char *section;
};

/* Rows of options. A table whose `base` is not null also has the rows of the base table, whose
 * targets are at the start of the same structure. */
struct option_table {
    const struct option *options;
    uint32_t count;
    const struct option_table *base;
};

/* Returns the option whose name is the `length` bytes at `name`, or null if there is none. */
const struct option *option_table_find(const struct option_table *table, const char *name,
                                       size_t length);

/* Parses `value` into the member of `target` that `option` describes. `value` may be null only if
 * the value is optional. Returns 1, or 0 if the value is wrong. `why` receives a specific reason,
 * or "" if the valid values are the only reason. */
int option_parse(const struct option *option, void *target, const char *value,
                 char why[OPTION_TEXT_MAX]);

/* Returns the text about the valid values of `option`. The text is a static string or is in
 * `out`. */
const char *option_expects(const struct option *option, char out[OPTION_TEXT_MAX]);

/* Writes the defaults of `table` to `target`, and then parses the `argc` words of `argv`, from
 * argv[0] on. Accepts only options whose `groups` is 0 or has a bit in common with `groups`.
 * Targets of the type const char * point to `argv`. Returns 0. Returns -1 and writes one line to
 * `error` if the command line is wrong. */
int option_table_parse(const struct option_table *table, uint32_t groups, void *target, int argc,
                       const char *const *argv, char error[OPTIONS_ERROR_MAX]);

/* Prints the headings of `table` and the options that `groups` accepts, as option_table_parse()
 * does, for --help to standard output, in lines of at most 80 columns. */
void option_table_print(const struct option_table *table, uint32_t groups);

#endif
