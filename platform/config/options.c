/* options.c -- parses the command line, prints --help, and combines the sources of the settings. */
#include "platform/config/options.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "platform/config/option_table.h"

/* ---- Command line -------------------------------------------------------------------------- */

/* Returns the value of the option at argv[*index]: the text after '=', or the next argument.
 * Returns null if there is no value. If the value is the next argument, advances `*index`. */
static const char *value_of(const struct option *option, int argc, const char *const *argv,
                            int *index)
{
    const char *equals = strchr(argv[*index], '=');
    if (equals) {
        return equals + 1;
    }
    if (!option->value || *index + 1 >= argc) {
        return NULL;
    }
    const char *next = argv[*index + 1];
    const int is_optional = option->value[0] == '[';
    const char first = next[next[0] == '-']; /* A negative number is a value, so that the error
                                                message names it as invalid. */
    if (is_optional ? !isdigit((unsigned char)first) : strncmp(next, "--", 2) == 0) {
        return NULL;
    }
    ++*index;
    return next;
}

static int parse_one(struct options *options, int argc, const char *const *argv, int *index,
                     char error[OPTIONS_ERROR_MAX])
{
    const char *word = argv[*index];
    const struct option *option = NULL;
    char expects[OPTION_TEXT_MAX];
    if (strncmp(word, "--", 2) == 0) {
        option = option_find(word + 2, strcspn(word + 2, "="));
    } else if (strcmp(word, "-h") == 0) {
        option = option_find("help", 4);
    }
    if (!option) {
        snprintf(error, OPTIONS_ERROR_MAX, "unknown option '%.100s'; --help lists them", word);
        return -1;
    }
    const char *value = value_of(option, argc, argv, index);
    if (!option->value && value) {
        snprintf(error, OPTIONS_ERROR_MAX, "--%s takes no value", option->name);
        return -1;
    }
    if (option->value && option->value[0] != '[' && !value) {
        snprintf(error, OPTIONS_ERROR_MAX, "--%s needs a value: %s", option->name,
                 option_text(option, option->expects, expects));
        return -1;
    }
    if (!option->set(options, value)) {
        const char *objection = option_objects(option, value, expects);
        if (objection) {
            snprintf(error, OPTIONS_ERROR_MAX, "--%s: '%.60s': %s", option->name, value, objection);
            return -1;
        }
        snprintf(error, OPTIONS_ERROR_MAX, "--%s: '%.100s' is not right; expected %s", option->name,
                 value ? value : "", option_text(option, option->expects, expects));
        return -1;
    }
    return 0;
}

int options_parse(struct options *options, int argc, const char *const *argv,
                  char error[OPTIONS_ERROR_MAX])
{
    for (int i = 1; i < argc; i++) {
        if (parse_one(options, argc, argv, &i, error)) {
            return -1;
        }
    }
    if (options->record[0] && options->replay[0]) {
        snprintf(error, OPTIONS_ERROR_MAX, "--record and --replay cannot go together");
        return -1;
    }
    char says[OPTION_TEXT_MAX];
    if (option_too_many_fish(options, says)) {
        snprintf(error, OPTIONS_ERROR_MAX, "--fish: %s", says);
        return -1;
    }
    if (option_wires_clash(options, says)) {
        snprintf(error, OPTIONS_ERROR_MAX, "--line: %s", says);
        return -1;
    }
    return 0;
}

/* ---- Text of --help ------------------------------------------------------------------------ */

void options_print_help(void)
{
    puts(
        "kingyo: a goldfish-scooping stall. The mouse is the poi: hold the left button to dip\n"
        "it, let go to lift; the wheel tilts it, the right button levels it. While F is held\n"
        "the mouse leads a fan over the water, whose still shade gathers fish. Space starts, the\n"
        "arrows choose a mode, 5 is a coin, F2 opens the operator's menu, F3 is its service\n"
        "button, L changes the language, F11 is full screen, Esc pressed twice quits. On a\n"
        "touch screen one finger leads the poi, a second one dips it, and three press START. On\n"
        "a pad the left stick leads it, A or a trigger dips it, the right stick tilts it. Without\n"
        "a screen the bot plays, or the replay is checked, and pictures of it are written.\n");
    const struct option *option;
    for (uint32_t i = 0; (option = option_at(i)) != NULL; i++) {
        char left[40], right[OPTION_TEXT_MAX];
        snprintf(left, sizeof left, "--%s %s", option->name, option->value ? option->value : "");
        printf("  %-18s %s\n", left, option_text(option, option->help, right));
    }
    puts("\nEach player needs a controller; a seat without one waits empty, and with --poi bot\n"
         "the stall's bot plays them all. With --poi auto the first player gets the best that is\n"
         "plugged in, also while the stall is open: a USB poi, else a pad, else mouse or finger.\n"
         "Nobody's controller changes in mid-game. A championship is held in the official tank:\n"
         "the stall changes tanks for it.\n"
         "\nA recording is never written over: --record refuses a file that holds anything. It is\n"
         "whole after each second: a kiosk that is killed loses one at most, a power cut more.\n"
         "\nExit code: 0 fine; 1 the display was lost, no picture could be made, or a replay\n"
         "differs; 2 wrong option; 65 a recording that is no whole recording; 74 a path or a\n"
         "standard output that cannot be read or written, or finished rounds that could not be\n"
         "kept.");
}

/* ---- Combination of the sources of settings ------------------------------------------------ */

static void put_asked(const struct options_query_result *asked, struct settings *settings)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (asked->is_set[id]) {
            settings->value[id] = asked->value[id];
        }
    }
}

void options_first(const struct options *options, struct settings *settings)
{
    settings_reset(settings);
    put_asked(&options->machine, settings);
    put_asked(&options->file, settings);
}

void options_last(const struct options *options, struct settings *settings)
{
    put_asked(&options->words, settings);
}

int options_query(const struct options *options, uint32_t id)
{
    return options->file.is_set[id] || options->words.is_set[id];
}
