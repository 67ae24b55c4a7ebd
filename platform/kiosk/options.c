/* options.c -- one table of options, for the command line, the configuration file and --help. */
#include "platform/kiosk/options.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/scene.h"
#include "core/tank/tank.h"
#include "platform/board.h"
#include "platform/number.h"

#define TEXT_MAX 96

struct option {
    const char *name;
    const char *value;     /* As --help names it; null: takes none; in brackets: may be left out. */
    const char *help;
    const char *expects;   /* What a right value is. with_bound() may add to it. */
    int (*set)(struct options *options, const char *value); /* 1, or 0: not a right value. */
    uint8_t only_command_line;
};

/* ---- Values --------------------------------------------------------------------------------- */

static int copy_path(char out[OPTIONS_PATH_MAX], const char *text)
{
    const size_t length = strlen(text);
    if (length == 0 || length >= OPTIONS_PATH_MAX) {
        return 0;
    }
    memcpy(out, text, length + 1);
    return 1;
}

static int set_demo(struct options *options, const char *value)
{
    options->demo = 1;
    options->demo_s = OPTIONS_DEMO_S;
    return !value || number_parse(value, OPTIONS_DEMO_S_MIN, OPTIONS_DEMO_S_MAX, &options->demo_s);
}

static int set_window(struct options *options, const char *value)
{
    char width[16];
    const char *cross = strchr(value, 'x');
    if (!cross || cross == value || (size_t)(cross - value) >= sizeof width) {
        return 0;
    }
    snprintf(width, sizeof width, "%.*s", (int)(cross - value), value);
    return number_parse(width, 320, 8192, &options->width) &&
           number_parse(cross + 1, 240, 8192, &options->height);
}

static int find_name(const char *const *names, uint8_t count, const char *value, uint8_t *out)
{
    for (uint8_t i = 0; i < count; i++) {
        if (strcmp(names[i], value) == 0) {
            *out = i;
            return 1;
        }
    }
    return 0;
}

static int set_poi(struct options *options, const char *value)
{
    static const char *const names[] = { "auto", "mouse", "pad", "usb", "bot" };
    return find_name(names, sizeof names / sizeof names[0], value, &options->poi);
}

static int set_language(struct options *options, const char *value)
{
    static const char *const names[] = { "ja", "en" };
    options->has_language = 1;
    return find_name(names, LANGUAGE_COUNT, value, &options->language);
}

static int set_seed(struct options *options, const char *value)
{
    options->has_seed = 1;
    return number_parse(value, 0, UINT32_MAX, &options->seed);
}

static int set_tank(struct options *options, const char *value)
{
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        if (strcmp(tank_preset(id)->name, value) == 0) {
            options->tank = id;
            return 1;
        }
    }
    return 0;
}

static uint32_t fish_max(uint8_t tank)
{
    return tank_preset_fish_max(tank_preset(tank), 1.0f);
}

/* Whether its tank holds them is asked when the tank is known: too_many_fish(). */
static int set_fish(struct options *options, const char *value)
{
    return number_parse(value, 1, TANK_FISH_MAX, &options->fish_count);
}

static int set_record(struct options *options, const char *value)
{
    return copy_path(options->record, value);
}

static int set_replay(struct options *options, const char *value)
{
    return copy_path(options->replay, value);
}

static int set_shots(struct options *options, const char *value)
{
    return copy_path(options->shots, value);
}

static int set_data(struct options *options, const char *value)
{
    return copy_path(options->data, value);
}

static int set_config(struct options *options, const char *value)
{
    return copy_path(options->config, value);
}

static int set_help(struct options *options, const char *value)
{
    (void)value;
    options->help = 1;
    return 1;
}

static int set_version(struct options *options, const char *value)
{
    (void)value;
    options->version = 1;
    return 1;
}

/* ---- The table ------------------------------------------------------------------------------ */

static const struct option table[] = {
    { "demo", "[SECONDS]", "let the bot play off screen and write pictures (20 s)",
      "5 to 600 seconds", set_demo, 1 },
    { "window", "WxH", "play in a window of that size; else full screen",
      "WIDTHxHEIGHT from 320x240 to 8192x8192", set_window, 0 },
    { "poi", "KIND", "who holds the poi: auto, mouse, pad, usb or bot",
      "auto, mouse, pad, usb or bot", set_poi, 0 },
    { "record", "FILE", "write the play to FILE, a new one, to be shown again", "a path",
      set_record, 0 },
    { "replay", "FILE", "show a recorded play and check it", "a path", set_replay, 1 },
    { "shots", "DIR", "where pictures go (demo: out/demo; else one each 5 s)", "a path",
      set_shots, 0 },
    { "data", "DIR", "where scores are kept (~/.local/share/kingyo)", "a path", set_data, 0 },
    { "config", "FILE", "read 'option = value' lines first; options here win", "a path",
      set_config, 1 },
    { "lang", "ja|en", "language of the stall", "ja or en", set_language, 0 },
    { "tank", "NAME", "festival (the stall), thesis (2013) or official (championship)",
      "festival, thesis or official", set_tank, 0 },
    { "seed", "N", "of everything random; equal seeds swim alike", "0 to 4294967295", set_seed, 0 },
    { "fish", "N", "how many fish; the tanks hold", "1 to", set_fish, 0 },
    { "help", NULL, "this text", NULL, set_help, 1 },
    { "version", NULL, "the version", NULL, set_version, 1 },
};

static const struct option *find_option(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (strlen(table[i].name) == length && memcmp(table[i].name, name, length) == 0) {
            return &table[i];
        }
    }
    return NULL;
}

/* `text`, and for --fish the bounds that only the waters know, in the order of --tank's names. */
static const char *with_bound(const struct option *option, const char *text, char out[TEXT_MAX])
{
    if (option->set != set_fish) {
        return text;
    }
    snprintf(out, TEXT_MAX, "%s %u, %u or %u", text, fish_max(TANK_PRESET_FESTIVAL),
             fish_max(TANK_PRESET_THESIS), fish_max(TANK_PRESET_OFFICIAL));
    return out;
}

/* Whether the tank is too small for them; then `says` holds a line without its beginning. */
static int too_many_fish(const struct options *options, char says[TEXT_MAX])
{
    const uint32_t most = fish_max(options->tank);
    if (options->fish_count <= most) {
        return 0;
    }
    snprintf(says, TEXT_MAX, "%u is too many; the %s tank holds 1 to %u", options->fish_count,
             tank_preset(options->tank)->name, most);
    return 1;
}

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
    char expects[TEXT_MAX];
    if (strncmp(word, "--", 2) == 0) {
        option = find_option(word + 2, strcspn(word + 2, "="));
    } else if (strcmp(word, "-h") == 0) {
        option = find_option("help", 4);
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
                 with_bound(option, option->expects, expects));
        return -1;
    }
    if (!option->set(options, value)) {
        snprintf(error, OPTIONS_ERROR_MAX, "--%s: '%.100s' is not right; expected %s", option->name,
                 value ? value : "", with_bound(option, option->expects, expects));
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
    char says[TEXT_MAX];
    if (too_many_fish(options, says)) {
        snprintf(error, OPTIONS_ERROR_MAX, "--fish: %s", says);
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
                             char bound[TEXT_MAX])
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
    const struct option *option = find_option(key, strlen(key));
    if (!option || option->only_command_line) {
        *expects = "one of window, poi, record, shots, data, lang, tank, seed, fish";
        return "unknown key";
    }
    struct options tried = *options;
    *expects = with_bound(option, option->expects, bound);
    if (!option->set(&tried, trim(equals + 1))) {
        return "wrong value";
    }
    *options = tried;
    return NULL;
}

int options_read_config(struct options *options, const char *path, void (*warn)(const char *line))
{
    char line[OPTIONS_PATH_MAX + 64];
    char text[OPTIONS_ERROR_MAX + 128];
    char bound[TEXT_MAX];
    FILE *file = fopen(path, "r");
    if (!file) {
        return -errno;
    }
    errno = 0;
    for (unsigned number = 1; fgets(line, sizeof line, file); number++) {
        const char *expects = "";
        const char *wrong = read_line(options, line, &expects, bound);
        if (wrong && warn) {
            snprintf(text, sizeof text, "%.200s:%u: %s; expected %s", path, number, wrong, expects);
            warn(text);
        }
    }
    if (too_many_fish(options, bound)) {
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
         "arrows choose a mode, L changes the language, F11 is full screen, Esc quits. Without a\n"
         "screen the bot plays, and pictures of it are written.\n");
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        char left[40], right[TEXT_MAX];
        snprintf(left, sizeof left, "--%s %s", table[i].name, table[i].value ? table[i].value : "");
        printf("  %-18s %s\n", left, with_bound(&table[i], table[i].help, right));
    }
    puts("\nA recording is never written over: --record refuses a file that holds anything. It is\n"
         "whole after each second: a kiosk that is killed loses one at most, a power cut more.\n"
         "\nExit code: 0 fine; 1 the display was lost, no picture could be made, or a replay\n"
         "differs; 2 wrong option; 65 a recording that is no whole recording; 74 a path that\n"
         "cannot be read or written, or finished rounds that could not be kept.");
}
