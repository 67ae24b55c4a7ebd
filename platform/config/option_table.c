/* option_table.c -- parses command lines with a table of options, and prints the table. */
#include "platform/config/option_table.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/number.h"

#define COLUMNS 80      /* Maximum length of a line of --help. */
#define LEFT_COLUMNS 22 /* Maximum width of the column of names in --help. */

const struct option *option_table_find(const struct option_table *table, const char *name,
                                       size_t length)
{
    for (; table; table = table->base) {
        for (uint32_t i = 0; i < table->count; i++) {
            const struct option *option = &table->options[i];
            if (option->name && strlen(option->name) == length &&
                memcmp(option->name, name, length) == 0) {
                return option;
            }
        }
    }
    return NULL;
}

/* Returns true if one of the subcommands `groups` accepts the option. */
static bool is_option_accepted(const struct option *option, uint32_t groups)
{
    return option->groups == 0 || (option->groups & groups) != 0;
}

/* ---- Values -------------------------------------------------------------------------------- */

bool option_parse(const struct option *option, void *target, const char *value,
                  char why[OPTION_TEXT_MAX])
{
    void *out = (char *)target + option->offset;
    why[0] = '\0';
    CORE_ASSERT(option->kind > OPTION_HEADING && option->kind <= OPTION_ARGUMENT);
    if (option->set) {
        return option->set(target, option, value, why);
    }
    CORE_ASSERT(option->kind != OPTION_CUSTOM);
    switch (option->kind) {
    case OPTION_FLAG:
        *(uint8_t *)out = 1;
        return true;
    case OPTION_PATH:
        if (!value || value[0] == '\0' || strlen(value) >= OPTIONS_PATH_MAX) {
            return false;
        }
        memcpy(out, value, strlen(value) + 1u);
        return true;
    case OPTION_WHOLE:
        return number_parse(value, (uint32_t)option->min, (uint32_t)option->max, out);
    case OPTION_DECIMAL:
        return number_parse_decimal(value, option->min, option->max, out);
    case OPTION_CHOICE:
        for (uint8_t i = 0; value && option->choices[i]; i++) {
            if (strcmp(option->choices[i], value) == 0) {
                *(uint8_t *)out = i;
                return true;
            }
        }
        return false;
    default:
        *(const char **)out = value;
        return value && value[0];
    }
}

const char *option_expects(const struct option *option, char out[OPTION_TEXT_MAX])
{
    size_t length = 0;
    if (option->expects && !option->more) {
        return option->expects;
    }
    switch (option->kind) {
    case OPTION_WHOLE:
    case OPTION_DECIMAL:
        snprintf(out, OPTION_TEXT_MAX, "%s from %.10g to %.10g",
                 option->kind == OPTION_WHOLE ? "a whole number" : "a number", option->min,
                 option->max);
        return out;
    case OPTION_CHOICE:
        for (const char *const *choice = option->choices; *choice; choice++) {
            const char *gap = choice == option->choices ? "" : choice[1] ? ", " : " or ";
            length +=
                (size_t)snprintf(out + length, OPTION_TEXT_MAX - length, "%s%s", gap, *choice);
            CORE_ASSERT(length < OPTION_TEXT_MAX);
        }
        return out;
    default:
        if (!option->more) {
            return "a path";
        }
        length = (size_t)snprintf(out, OPTION_TEXT_MAX, "%s", option->expects);
        option->more(out + length);
        return out;
    }
}

/* ---- Command line -------------------------------------------------------------------------- */

/* Parses the option at argv[*index] and its value: the text after '=', or the next argument. If the
 * value is the next argument, advances `*index`. Returns 0. On an error writes the reason to
 * `error` and returns -1. */
static int parse_named(const struct option *option, void *target, int argc, const char *const *argv,
                       int *index, char error[OPTIONS_ERROR_MAX])
{
    char why[OPTION_TEXT_MAX], expects[OPTION_TEXT_MAX];
    const char *dashes = option->name[1] ? "--" : "-", *name = option->name;
    const char *equals = strchr(argv[*index], '='), *value = equals ? equals + 1 : NULL;
    const bool is_optional = option->value && option->value[0] == '[';
    if (!value && option->value && *index + 1 < argc) {
        const char *next = argv[*index + 1];
        /* A word that begins with one dash, such as "-3", counts as the value of the option. The
         * range check then rejects the number with a specific error message. An optional value may
         * be any word that does not look like an option. */
        if (is_optional ? next[0] != '-' || isdigit((unsigned char)next[1])
                        : strncmp(next, "--", 2) != 0) {
            value = next;
            ++*index;
        }
    }
    if (!option->value && value) {
        snprintf(error, OPTIONS_ERROR_MAX, "%s%s takes no value", dashes, name);
    } else if (option->value && !is_optional && !value) {
        snprintf(error, OPTIONS_ERROR_MAX, "%s%s needs a value: %s", dashes, name,
                 option_expects(option, expects));
    } else if (option_parse(option, target, value, why)) {
        return 0;
    } else if (why[0]) {
        snprintf(error, OPTIONS_ERROR_MAX, "%s%s: '%.60s': %s", dashes, name, value ? value : "",
                 why);
    } else {
        snprintf(error, OPTIONS_ERROR_MAX, "%s%s: '%.100s' is wrong; expected %s", dashes, name,
                 value ? value : "", option_expects(option, expects));
    }
    return -1;
}

/* Parses a word of the command line that is not an option. Returns 0. On an error writes the reason
 * to `error` and returns -1. */
static int parse_word(const struct option_table *table, uint32_t groups, void *target,
                      const char *word, char error[OPTIONS_ERROR_MAX])
{
    char why[OPTION_TEXT_MAX] = "";
    for (; table; table = table->base) {
        for (uint32_t i = 0; i < table->count; i++) {
            const struct option *option = &table->options[i];
            const bool is_open =
                option->kind == OPTION_ARGUMENT && is_option_accepted(option, groups) &&
                (option->set || !*(const char **)((char *)target + option->offset));
            if (is_open && option_parse(option, target, word, why)) {
                return 0;
            }
            if (why[0]) {
                snprintf(error, OPTIONS_ERROR_MAX, "%s", why);
                return -1;
            }
        }
    }
    snprintf(error, OPTIONS_ERROR_MAX, "'%.100s' is not understood; --help lists the arguments",
             word);
    return -1;
}

static int parse_next(const struct option_table *table, uint32_t groups, void *target, int argc,
                      const char *const *argv, int *index, char error[OPTIONS_ERROR_MAX])
{
    const char *word = argv[*index];
    const int dash_count = word[0] != '-' ? 0 : word[1] != '-' ? 1 : 2;
    const size_t length = strcspn(word + dash_count, "=");
    if (dash_count == 0 || word[1] == '\0') {
        /* A word without a dash is an argument. The word "-" is also an argument, which means
         * standard input. */
        return parse_word(table, groups, target, word, error);
    }
    const struct option *option = option_table_find(table, word + dash_count, length);
    if (dash_count == 1 && length == 1 && word[1] == 'h') {
        option = option_table_find(table, "help", 4);
    }
    if (!option || !is_option_accepted(option, groups) || (dash_count == 1 && length != 1) ||
        (dash_count == 2 && length == 1)) {
        snprintf(error, OPTIONS_ERROR_MAX, "unknown option '%.100s'; --help lists them", word);
        return -1;
    }
    return parse_named(option, target, argc, argv, index, error);
}

int option_table_parse(const struct option_table *table, uint32_t groups, void *target, int argc,
                       const char *const *argv, char error[OPTIONS_ERROR_MAX])
{
    CORE_ASSERT(table && target && argc >= 0);
    for (const struct option_table *part = table; part; part = part->base) {
        for (uint32_t i = 0; i < part->count; i++) {
            if (part->options[i].initial) {
                const bool is_valid =
                    option_parse(&part->options[i], target, part->options[i].initial, error);
                CORE_ASSERT(is_valid);
            }
        }
    }
    for (int i = 0; i < argc; i++) {
        if (parse_next(table, groups, target, argc, argv, &i, error)) {
            return -1;
        }
    }
    return 0;
}

/* ---- Text of --help ------------------------------------------------------------------------ */

/* Writes the name and the value of an option as --help shows them. */
static void write_left(const struct option *option, char left[OPTION_TEXT_MAX])
{
    const char *name = option->name ? option->name : "",
               *value = option->value ? option->value : "";
    snprintf(left, OPTION_TEXT_MAX, "%s%s%s%s",
             !name[0]  ? ""
             : name[1] ? "--"
                       : "-",
             name, name[0] && value[0] ? " " : "", value);
}

/* Prints the words of `text`, beginning at column `column`, and breaks lines before column COLUMNS.
 * The second and all later lines begin at column `indent`. */
static void print_words(const char *text, int column, int indent)
{
    for (const char *word = text; *word;) {
        const int length = (int)strcspn(word, " ");
        if (column > indent && column + 1 + length > COLUMNS) {
            putchar('\n');
            column = 0;
        }
        const int gap = column < indent ? indent - column : 1;
        printf("%*s%.*s", gap, "", length, word);
        column += gap + length;
        word += length + (word[length] == ' ');
    }
    putchar('\n');
}

/* Prints the row of one option: its help text, and in parentheses its range and its default. */
static void print_option(const struct option *option, int indent)
{
    char left[OPTION_TEXT_MAX], range[OPTION_TEXT_MAX] = "", text[6 * OPTION_TEXT_MAX];
    const char *initial = option->initial;
    if (option->kind == OPTION_WHOLE || option->kind == OPTION_DECIMAL) {
        snprintf(range, sizeof range, "%.10g to %.10g", option->min, option->max);
    } else if (option->kind == OPTION_CHOICE) {
        option_expects(option, range);
    }
    const bool is_bracketed = range[0] || initial;
    const int length =
        snprintf(text, sizeof text, "%s%s%s%s%s%s%s", option->help, is_bracketed ? " (" : "", range,
                 range[0] && initial ? "; " : "", initial ? "default " : "", initial ? initial : "",
                 is_bracketed ? ")" : "");
    CORE_ASSERT(length > 0 && (size_t)length + OPTION_TEXT_MAX < sizeof text);
    if (option->more) {
        option->more(text + length);
    }
    write_left(option, left);
    int column = printf("  %s", left);
    if (column + 2 > indent) {
        putchar('\n');
        column = 0;
    }
    print_words(text, column, indent);
}

void option_table_print(const struct option_table *table, uint32_t groups)
{
    char left[OPTION_TEXT_MAX];
    int width = 0;
    for (int pass = 0; pass < 2; pass++) { /* The first pass measures the width of the column of
                                              names. The second pass prints the rows. */
        for (const struct option_table *part = table; part; part = part->base) {
            for (uint32_t i = 0; i < part->count; i++) {
                const struct option *option = &part->options[i];
                write_left(option, left);
                const int length = (int)strlen(left);
                if (!is_option_accepted(option, groups)) {
                    continue;
                }
                if (pass == 0) {
                    width = length > width && length <= LEFT_COLUMNS ? length : width;
                } else if (option->kind == OPTION_HEADING) {
                    puts(option->help);
                } else {
                    print_option(option, width + 4);
                }
            }
        }
    }
}
