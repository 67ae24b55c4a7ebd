/* options.c -- the command line, the configuration file, --help, and what they ask of the stall. */
#include "platform/kiosk/options.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "platform/kiosk/option_table.h"

/* ---- Command line --------------------------------------------------------------------------- */

/* The value of the option at argv[*index]: behind '=', or the next word, or null. */
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
    const char first = next[next[0] == '-']; /* A negative number is a value, if a wrong one. */
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
                 option_says(option, option->expects, expects));
        return -1;
    }
    if (!option->set(options, value)) {
        const char *objection = option_objects(option, value, expects);
        if (objection) {
            snprintf(error, OPTIONS_ERROR_MAX, "--%s: '%.60s': %s", option->name, value, objection);
            return -1;
        }
        snprintf(error, OPTIONS_ERROR_MAX, "--%s: '%.100s' is not right; expected %s", option->name,
                 value ? value : "", option_says(option, option->expects, expects));
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

/* ---- Configuration file --------------------------------------------------------------------- */

/* `text` without the white space around it; cut in place. */
static char *trim(char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    size_t length = strlen(text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) {
        text[--length] = '\0';
    }
    return text;
}

/* A '#' inside a word is part of it: a path may hold one. */
static void cut_comment(char *line)
{
    for (char *hash = strchr(line, '#'); hash; hash = strchr(hash + 1, '#')) {
        if (hash == line || isspace((unsigned char)hash[-1])) {
            *hash = '\0';
            return;
        }
    }
}

/* Null when the line is fine, else what is wrong with it. `*expects` may say more. */
static const char *read_line(struct options *options, char *line, const char **expects,
                             char bound[OPTION_TEXT_MAX])
{
    cut_comment(line);
    char *key = trim(line);
    if (*key == '\0') {
        return NULL;
    }
    char *equals = strchr(key, '=');
    if (!equals) {
        *expects = "key = value";
        return "no '='";
    }
    *equals = '\0';
    key = trim(key);
    const struct option *option = option_find(key, strlen(key));
    if (!option || option->only_command_line) {
        *expects = "one of window, poi, usb, line, mode, grade, players, coins, tickets, record, "
                   "shots, data, lang, tank, seed, fish";
        return "unknown key";
    }
    struct options tried = *options;
    const char *value = trim(equals + 1);
    const char *objection = option_objects(option, value, bound);
    if (objection) {
        return objection;
    }
    *expects = option_says(option, option->expects, bound);
    if (!option->set(&tried, value)) {
        return "wrong value";
    }
    if (option_wires_clash(&tried, bound)) {
        *expects = "";
        return bound;
    }
    *options = tried;
    return NULL;
}

int options_read_config(struct options *options, const char *path, void (*warn)(const char *line))
{
    char line[OPTIONS_PATH_MAX + 64];
    char text[OPTIONS_ERROR_MAX + 256];
    char bound[OPTION_TEXT_MAX];
    FILE *file = fopen(path, "r");
    if (!file) {
        return -errno;
    }
    errno = 0;
    unsigned wrong_count = 0;
    for (unsigned number = 1; fgets(line, sizeof line, file); number++) {
        const char *expects = "";
        const char *wrong = read_line(options, line, &expects, bound);
        wrong_count += wrong != NULL;
        if (wrong && warn && wrong_count <= OPTIONS_WARNINGS_MAX) {
            snprintf(text, sizeof text, "%.200s:%u: %s%s%s", path, number, wrong,
                     expects[0] ? "; expected " : "", expects);
            warn(text);
        }
    }
    if (wrong_count > OPTIONS_WARNINGS_MAX && warn) {
        snprintf(text, sizeof text, "%.200s: and %u more; is this a configuration file at all?",
                 path, wrong_count - OPTIONS_WARNINGS_MAX);
        warn(text);
    }
    if (option_too_many_fish(options, bound)) {
        snprintf(text, sizeof text, "%.200s: fish: %s", path, bound);
        options->fish_count = 0;
        if (warn) {
            warn(text);
        }
    }
    const int error = ferror(file) ? (errno ? -errno : -EIO) : 0; /* A folder. */
    fclose(file);
    return error;
}

/* ---- Help ----------------------------------------------------------------------------------- */

void options_print_help(void)
{
    puts("kingyo: a goldfish-scooping stall. The mouse is the poi: hold the left button to dip\n"
         "it, let go to lift; the wheel tilts it, the right button levels it. While F is held\n"
         "the mouse leads a fan over the water, whose still shade gathers fish. Space starts, the\n"
         "arrows choose a mode, 5 is a coin, F2 opens the operator's menu, F3 is its service\n"
         "button, L changes the language, F11 is full screen, Esc quits. On a touch screen one\n"
         "finger leads the poi, a second one dips it, and three press START. On a pad the left\n"
         "stick leads it, A or a trigger dips it, the right stick tilts it. Without a screen the\n"
         "bot plays, and pictures of it are written.\n");
    const struct option *option;
    for (uint32_t i = 0; (option = option_at(i)) != NULL; i++) {
        char left[40], right[OPTION_TEXT_MAX];
        snprintf(left, sizeof left, "--%s %s", option->name, option->value ? option->value : "");
        printf("  %-18s %s\n", left, option_says(option, option->help, right));
    }
    puts("\nEach player needs a controller; a seat without one waits empty, and with --poi bot\n"
         "the stall's bot plays them all. With --poi auto the first player gets the best that is\n"
         "plugged in, also while the stall is open: a USB poi, else a pad, else mouse or finger.\n"
         "Nobody's controller changes in mid-game. A championship is held in the official tank:\n"
         "the stall changes tanks for it.\n"
         "\nA recording is never written over: --record refuses a file that holds anything. It is\n"
         "whole after each second: a kiosk that is killed loses one at most, a power cut more.\n"
         "\nExit code: 0 fine; 1 the display was lost, no picture could be made, or a replay\n"
         "differs; 2 wrong option; 65 a recording that is no whole recording; 74 a path that\n"
         "cannot be read or written, or finished rounds that could not be kept.");
}

/* ---- What it means -------------------------------------------------------------------------- */

void options_stall(const struct options *options, uint8_t modes, struct core_config *core)
{
    core->preset = options->tank;
    core->fish_count = options->fish_count;
    core->language = options->language;
    core->modes = options->modes ? options->modes : modes;
    core->grade = options->grade;
    core->players = options->players;
    core->credit_coins = options->coins;
    core->ticket_fish = options->tickets;
}

uint32_t options_players(const struct options *options)
{
    return options->players ? options->players : 1u;
}
