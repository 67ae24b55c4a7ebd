/* bot_file.c -- the parser of bot files, and the table of their keys. */
#include "platform/ctl/play/bot_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/file.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

#define LINE_MAX_CHARS 200u
#define SHOWN 40 /* Maximum number of characters of an invalid word that an error message quotes. */
#define RANGE_MAX 64u /* Size in bytes of the buffer for the allowed values of a key. */

/* ---- Keys ------------------------------------------------------------------------------------ */

enum kind { KIND_REAL, KIND_COUNT, KIND_WORD };

struct key {
    const char *name;
    uint8_t kind; /* Type of the key's value (enum kind). */
    bool above;   /* True if the value must be greater than `min`, false if the value may also equal
                      `min`. */
    size_t offset; /* Offset of the field in struct technique, in bytes. */
    double min, max;
    const char *const *words; /* Allowed words, terminated by a null pointer. The value is the index
                                 of the word. A null `words` means that the value is a number. */
    const char *meaning;
};

static const char *const sides[] = {
    [SIDE_ANY] = "any", [SIDE_HEAD] = "head", [SIDE_TAIL] = "tail", [SIDE_COUNT] = NULL
};
static const char *const places[] = {
    [PLACE_CENTRE] = "centre", [PLACE_RIM] = "rim", [PLACE_COUNT] = NULL
};
static const char *const lifts[] = {
    [LIFT_DRAINED] = "drained", [LIFT_FAST] = "fast", [LIFT_COUNT] = NULL
};
static const char *const hunts[] = {
    [HUNT_SHADE] = "shade", [HUNT_CHASE] = "chase", [HUNT_COUNT] = NULL
};

#define AT(field) offsetof(struct technique, field)
#define REAL(field, least, most, text)                                                             \
    { #field, KIND_REAL, false, AT(field), least, most, NULL, text }
#define SPEED(field, text) { #field, KIND_REAL, true, AT(field), 0.0, 2.0, NULL, text }
#define WORD(field, list, text) { #field, KIND_WORD, false, AT(field), 0.0, 0.0, list, text }

static const struct key keys[] = {
    REAL(wet, 0.0, 1.0, "share of the paper that is wetted before the first scoop"),
    REAL(entry_deg, 0.0, 60.0, "tilt of the paper when it enters the water; 0 is level"),
    REAL(glide_deg, 0.0, 90.0, "angle of paper and motion under water; 90 is broadside"),
    WORD(side, sides, "end of the fish under which the ring passes first"),
    WORD(place, places, "part of the paper under the fish"),
    WORD(lift, lifts, "level until the water has drained, or fast (2.5 times)"),
    WORD(hunt, hunts, "wait as a still shade, or chase at the speed of the arm"),
    { "fish_max", KIND_COUNT, false, AT(fish_max), 1.0, 8.0, NULL,
      "number of fish on the paper before the bot lifts it" },
    REAL(fish_m, 0.02, 0.1, "preferred length of a fish"),
    SPEED(arm_m_s, "speed of the arm above the water"),
    SPEED(dip_m_s, "speed into the water"),
    SPEED(glide_m_s, "speed under the water"),
    SPEED(lift_m_s, "speed out of the water"),
    SPEED(carry_m_s, "speed to the bowl"),
    REAL(drain_s, 0.0, 3.0, "time for which the water drains during a lift"),
    REAL(patience_s, 0.0, 20.0, "longest wait for a fish to come to rest"),
    REAL(aim_m, 0.0, 0.05, "largest aiming error"),
    REAL(tremor_m, 0.0, 0.01, "amplitude of the tremor"),
    REAL(reaction_min_s, 0.15, 1.0, "shortest reaction time"),
    REAL(reaction_max_s, 0.15, 1.0, "longest reaction time"),
};
#define KEY_COUNT (sizeof keys / sizeof keys[0])
_Static_assert(sizeof(struct technique) == 68, "a new field needs an entry in `keys`");

/* Returns the number of the key called `name`, or KEY_COUNT if there is no such key. */
static uint32_t find_key(const char *name)
{
    uint32_t key = 0;
    while (key < KEY_COUNT && strcmp(name, keys[key].name) != 0) {
        key++;
    }
    return key;
}

/* Parses `text` and stores the value in the field of `technique` that `key` names. Returns true. If
 * the text is invalid, leaves `technique` unchanged and returns false. */
static bool set_value(const struct key *key, const char *text, struct technique *technique)
{
    unsigned char *at = (unsigned char *)technique + key->offset;
    uint32_t count = 0;
    if (key->kind == KIND_REAL) {
        double value = 0.0;
        const bool is_valid = number_parse_decimal(text, key->min, key->max, &value);
        const float real = (float)value;
        if (!is_valid || (key->above && real <= (float)key->min)) {
            return false;
        }
        memcpy(at, &real, sizeof real);
        return true;
    }
    if (key->kind == KIND_COUNT) {
        if (!number_parse(text, (uint32_t)key->min, (uint32_t)key->max, &count)) {
            return false;
        }
    } else {
        while (key->words[count] && strcmp(text, key->words[count]) != 0) {
            count++;
        }
        if (!key->words[count]) {
            return false;
        }
    }
    *at = (unsigned char)count;
    return true;
}

/* Writes the allowed values of a key to `out`, for example "0 to 1", "over 0 to 2" or
 * "any|head|tail". */
static void write_range(const struct key *key, char out[RANGE_MAX])
{
    size_t used = 0;
    if (key->kind != KIND_WORD) {
        snprintf(out, RANGE_MAX, "%s%g to %g", key->above ? "over " : "", key->min, key->max);
        return;
    }
    for (uint32_t i = 0; key->words[i] && used < RANGE_MAX; i++) {
        used += (size_t)snprintf(out + used, RANGE_MAX - used, "%s%s", i ? "|" : "", key->words[i]);
    }
}

static void print_value(const struct key *key, const struct technique *technique)
{
    const unsigned char *at = (const unsigned char *)technique + key->offset;
    float real;
    if (key->kind == KIND_WORD) {
        printf(" %-8s", key->words[*at]);
    } else if (key->kind == KIND_COUNT) {
        printf(" %-8u", *at);
    } else {
        memcpy(&real, at, sizeof real);
        printf(" %-8g", (double)real);
    }
}

void bot_file_print_keys(void)
{
    printf(
        "\nA bot FILE has one 'key=value' on each line; '#' begins a comment. base=novice|expert,\n"
        "before all other keys, selects the values of the keys that are absent (expert). Keys:\n\n"
        "  %-15s %-14s %-8s %-8s %s\n",
        "key", "values", "novice", "expert", "meaning");
    for (uint32_t i = 0; i < KEY_COUNT; i++) {
        char range[RANGE_MAX];
        write_range(&keys[i], range);
        printf("  %-15s %-14s", keys[i].name, range);
        print_value(&keys[i], &technique_novice);
        print_value(&keys[i], &technique_expert);
        printf(" %s\n", keys[i].meaning);
    }
}

/* ---- Lines of a bot file --------------------------------------------------------------------- */

struct parser {
    struct technique technique;
    uint32_t line;
    uint32_t base_line;
    uint32_t line_of[KEY_COUNT]; /* Line in which each key was set, counted from 1. 0 means that
                                        the key has not been set. */
    struct bot_file_problem *problem;
};

__attribute__((format(printf, 2, 3))) static bool bot_file_error(struct parser *parser,
                                                                 const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(parser->problem->text, sizeof parser->problem->text, format, arguments);
    va_end(arguments);
    printable(parser->problem->text);
    parser->problem->line = parser->line;
    return false;
}

/* Returns the technique called `name`, or null if there is no such technique. */
static const struct technique *find_technique(const char *name)
{
    return strcmp(name, "novice") == 0   ? &technique_novice
           : strcmp(name, "expert") == 0 ? &technique_expert
                                         : NULL;
}

static bool set_base(struct parser *parser, const char *value)
{
    const struct technique *base = find_technique(value);
    for (uint32_t key = 0; key < KEY_COUNT; key++) {
        if (parser->line_of[key]) {
            return bot_file_error(parser, "base comes before all other keys, and line %u has '%s'",
                                  parser->line_of[key], keys[key].name);
        }
    }
    if (parser->base_line) {
        return bot_file_error(parser, "base is in line %u already", parser->base_line);
    }
    if (!base) {
        return bot_file_error(parser, "base: '%.*s' is wrong; expected novice|expert", SHOWN,
                              value);
    }
    CORE_ASSERT(parser->line > 0);
    parser->base_line = parser->line;
    parser->technique = *base;
    return true;
}

static bool parse_line(struct parser *parser, char *text)
{
    char *name = file_trim_comment(text);
    if (*name == '\0') {
        return true;
    }
    const char *value = file_cut_value(name);
    if (!value) {
        return bot_file_error(parser, "'%.*s' has no '='; expected key=value", SHOWN, name);
    }
    if (strcmp(name, "base") == 0) {
        return set_base(parser, value);
    }
    const uint32_t key = find_key(name);
    if (key == KEY_COUNT) {
        return bot_file_error(parser, "'%.*s' is no key of a bot; kingyoctl play --help lists them",
                              SHOWN, name);
    }
    if (parser->line_of[key]) {
        return bot_file_error(parser, "%s is in line %u already", name, parser->line_of[key]);
    }
    if (!set_value(&keys[key], value, &parser->technique)) {
        char range[RANGE_MAX];
        write_range(&keys[key], range);
        return bot_file_error(parser, "%s: '%.*s' is wrong; expected %s", name, SHOWN, value,
                              range);
    }
    parser->line_of[key] = parser->line;
    return true;
}

static bool parse_lines(struct parser *parser, FILE *file)
{
    char line[LINE_MAX_CHARS];
    enum file_line got;
    while ((got = file_read_line(file, line, sizeof line)) != FILE_LINE_END) {
        parser->line++;
        if (got == FILE_LINE_BAD) {
            return bot_file_error(parser,
                                  "the line has more than %u characters or contains a zero byte",
                                  LINE_MAX_CHARS - 1u);
        }
        if (!parse_line(parser, parser->line == 1 ? file_skip_mark(line) : line)) {
            return false;
        }
    }
    return true;
}

/* Checks the rules that concern several lines. The error names the later of two contradicting
 * lines, or the whole file. Returns true, or fills the problem and returns false. */
static bool check_whole(struct parser *parser)
{
    const struct technique *technique = &parser->technique;
    const uint32_t min_line = parser->line_of[find_key("reaction_min_s")];
    const uint32_t max_line = parser->line_of[find_key("reaction_max_s")];
    uint32_t set = parser->base_line;
    for (uint32_t key = 0; key < KEY_COUNT; key++) {
        set += parser->line_of[key];
    }
    parser->line = min_line > max_line ? min_line : max_line;
    if (set == 0) {
        return bot_file_error(parser, "has no key; write at least base=novice|expert");
    }
    if (technique->reaction_min_s > technique->reaction_max_s) {
        return bot_file_error(parser, "reaction_min_s %g is more than reaction_max_s %g",
                              (double)technique->reaction_min_s, (double)technique->reaction_max_s);
    }
    return true;
}

/* ---- Public functions ------------------------------------------------------------------------ */

int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem)
{
    struct parser parser = { .technique = technique_expert, .problem = problem };
    FILE *file = fmemopen((void *)text, size, "r");
    const bool good = file ? parse_lines(&parser, file) && check_whole(&parser)
                           : bot_file_error(&parser, "cannot be read");
    if (file) {
        fclose(file);
    }
    if (good) {
        *out = parser.technique;
    }
    return good ? 0 : -1;
}

enum exit_code bot_file_read(const char *prefix, const char *bot, struct technique *out)
{
    char text[BOT_FILE_SIZE_MAX];
    struct bot_file_problem problem = { 0 };
    size_t size;
    const struct technique *named = find_technique(bot);
    if (named) {
        *out = *named;
        return EXIT_OK;
    }
    if (access(bot, F_OK) != 0 && errno == ENOENT) { /* A file that does not exist is most likely a
                                                        misspelt bot name, so the message lists the
                                                        bot names. */
        return print_fail(EXIT_IO, "%s: %s: %s; a bot is novice, expert or a FILE", prefix, bot,
                          strerror(errno));
    }
    const enum exit_code code = ctl_file_read(prefix, bot, text, sizeof text, &size);
    if (code != EXIT_OK || bot_file_parse(text, size, out, &problem) == 0) {
        return code;
    }
    if (problem.line) {
        print_error("%s: %s:%u: %s", prefix, bot, problem.line, problem.text);
    } else {
        print_error("%s: %s: %s", prefix, bot, problem.text);
    }
    return EXIT_BAD_DATA;
}
