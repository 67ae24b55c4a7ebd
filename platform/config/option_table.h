/* option_table.h -- declarative tables of the options of `kingyo` and of the commands of
 * `kingyoctl`.
 *
 * A table has one row for each option: the name, the kind and the range of the value, the member of
 * a structure that receives the value, and the text of --help. The functions below parse a command
 * line with a table, parse one value for config_file.c, and print a table. Only
 * option_table_print() writes to a file; all other functions are pure. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Size in bytes of the array that receives the value of an OPTION_PATH. */
#define OPTIONS_PATH_MAX 1024u
/* Size in bytes of the buffer for the error message about an invalid command line. */
#define OPTIONS_ERROR_MAX 384u
/* Size in bytes of a text about the value of one option, for example the reason why the value is
 * wrong. The size is at least HAL_TEXT_SIZE, because a board (the selected set of drivers) may
 * write the text. */
#define OPTION_TEXT_MAX 160

/* Kind of an option. The kind determines the type of the target, which is the variable that
 * receives the option's value. */
enum option_kind {
    OPTION_HEADING = 0, /* The row is not an option but a heading between the options in --help. */
    /* The option has no value. The target is a uint8_t or bool, which is set to 1. */
    OPTION_FLAG,
    OPTION_TEXT, /* The value is a text that is not empty. The target is a const char *. */
    /* The value is a path that is not empty. The target is a char[OPTIONS_PATH_MAX]. */
    OPTION_PATH,
    OPTION_WHOLE,   /* The value is a whole number in [min, max]. The target is a uint32_t. */
    OPTION_DECIMAL, /* The value is a number in [min, max]. The target is a double. */
    /* The value is one of the words in `choices`. The target is a uint8_t, which is set to the
     * index of the word, or a bool if there are two words. */
    OPTION_CHOICE,
    OPTION_CUSTOM, /* The value is parsed by the function `set`. */
    /* The row is an argument: a word of the command line without an option name. The target is a
     * const char *, unless `set` is not null. */
    OPTION_ARGUMENT,
};

struct option {
    /* Name without dashes. A name of one letter has one dash on the command line, other names have
     * two. Null for headings and arguments. */
    const char *name;
    /* Name of the option's value in --help. Null if the option has no value. A name in brackets
     * means that the value is optional. */
    const char *value;
    const char *help; /* Text of --help. The range and the default are appended to the text. */
    enum option_kind kind;
    /* Offset in bytes of the target (the member that receives the value) in the structure that the
     * caller passes to option_table_parse() as `target`. */
    size_t offset;
    double min, max;
    const char *const *choices; /* The words of an OPTION_CHOICE. The list ends with null. */
    /* Default value, which is parsed before the command line. Null if the caller sets the
     * default. */
    const char *initial;
    /* Description of the valid values in error messages. Null selects a description that is
     * generated from the kind and the range. */
    const char *expects;
    /* Callback that parses `value` for an OPTION_CUSTOM or an OPTION_ARGUMENT. `value` is null if
     * an optional value is absent. Returns true. If the value is wrong, returns false and may write
     * a specific reason to `why`. */
    bool (*set)(void *target, const struct option *option, const char *value,
                char why[OPTION_TEXT_MAX]);
    uint32_t id; /* Number that the function `set` may use, for example the id of a setting. */
    /* Callback that writes additional text to `out`. The text is appended to `help` and to
     * `expects`. May be null. */
    void (*more)(char out[OPTION_TEXT_MAX]);
    /* Bit set of the subcommands that accept the option. 0 means that all subcommands accept the
     * option. */
    uint32_t groups;
    /* Section of the configuration file in which the option is permitted. "" means that a setting
     * has replaced the option, and that only old files may contain the option, before their first
     * section. Null means that no file may contain the option. */
    const char *section;
};

/* Table of options, one row for each option. If `base` is not null, the table also has the rows of
 * the table `base`. The structure that receives the values then begins with the structure of the
 * table `base`. */
struct option_table {
    const struct option *options;
    uint32_t count;
    const struct option_table *base;
};

/* Initializer of a table with all options of the array `list`. `parent` is the member `base`. */
#define OPTION_TABLE(list, parent) { list, sizeof(list) / sizeof((list)[0]), parent }

/* Returns the option whose name is the `length` bytes at `name`, or null if there is none. */
const struct option *option_table_find(const struct option_table *table, const char *name,
                                       size_t length);

/* Parses `value` into the member of `target` that `option` describes. `value` may be null only if
 * the option's value is optional. Returns true if the value is valid. Otherwise returns false and
 * writes a specific reason to `why`, or "" if the text of option_expects() is sufficient as the
 * reason. */
bool option_parse(const struct option *option, void *target, const char *value,
                  char why[OPTION_TEXT_MAX]);

/* Returns the description of the valid values of `option`. The text is a static string or is stored
 * in `out`. */
const char *option_expects(const struct option *option, char out[OPTION_TEXT_MAX]);

/* Writes the defaults of `table` to `target`, and then parses the `argc` words of `argv`, starting
 * with argv[0]. Accepts only options whose `groups` is 0 or has a bit in common with the parameter
 * `groups`. Targets of the type const char * point to `argv`. Returns 0 if the command line is
 * valid. Otherwise returns -1 and writes one line to `error`. */
int option_table_parse(const struct option_table *table, uint32_t groups, void *target, int argc,
                       const char *const *argv, char error[OPTIONS_ERROR_MAX]);

/* Prints the headings of `table` and its options to standard output, as the text of --help. Prints
 * only options whose `groups` is 0 or has a bit in common with the parameter `groups`. Lines have
 * at most 80 columns. */
void option_table_print(const struct option_table *table, uint32_t groups);
