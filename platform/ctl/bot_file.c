/* bot_file.c -- a table of keys, and one line after the other held against it. */
#include "platform/ctl/bot_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "platform/number.h"

#define LINE_MAX_CHARS 200u
#define SHOWN 40 /* Characters of a wrong word that are told again. */
#define RANGE_MAX 64u

enum kind { KIND_REAL, KIND_COUNT, KIND_WORD };

/* ---- Keys ----------------------------------------------------------------------------------- */

struct key {
    const char *name;
    uint8_t kind; /* enum kind */
    uint8_t above; /* Its least value is itself not allowed. */
    size_t offset; /* In struct technique. */
    double min, max;
    const char *const *words; /* The place of each is its value; ends in null. */
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
    { .name = #field, .kind = KIND_REAL, .offset = AT(field), .min = least, .max = most,           \
      .meaning = text }
#define SPEED(field, text)                                                                         \
    { .name = #field, .kind = KIND_REAL, .above = 1, .offset = AT(field), .max = 2.0,              \
      .meaning = text }
#define WORD(field, list, text)                                                                    \
    { .name = #field, .kind = KIND_WORD, .offset = AT(field), .words = list, .meaning = text }

static const struct key keys[] = {
    REAL(wet, 0.0, 1.0, "share of the paper that is wetted before the first scoop"),
    REAL(entry_deg, 0.0, 60.0, "slant of the paper as it goes into the water; 0 is flat"),
    REAL(glide_deg, 0.0, 90.0, "between paper and its way under water; 90 is broadside"),
    WORD(side, sides, "which end of the fish is over the ring first"),
    WORD(place, places, "what part of the paper is brought under it"),
    WORD(lift, lifts, "slanted till the water is off, or fast and flat"),
    WORD(hunt, hunts, "wait in a still shade, or chase"),
    { .name = "fish_max", .kind = KIND_COUNT, .offset = AT(fish_max), .min = 1.0, .max = 8.0,
      .meaning = "fish that it wants on the paper before it lifts" },
    SPEED(arm_m_s, "speed of its arm over the water"),
    SPEED(dip_m_s, "into the water"),
    SPEED(glide_m_s, "under the water"),
    SPEED(lift_m_s, "out of the water"),
    SPEED(carry_m_s, "to the bowl"),
    REAL(drain_s, 0.0, 3.0, "that it lets water run off"),
    REAL(patience_s, 0.0, 20.0, "that it waits for a fish to come to rest"),
    REAL(aim_m, 0.0, 0.05, "how far it misses, at most"),
    REAL(tremor_m, 0.0, 0.01, "how far its hand trembles"),
    REAL(reaction_min_s, 0.15, 1.0, "from the sight to the act, at least ..."),
    REAL(reaction_max_s, 0.15, 1.0, "... and at most"),
};
#define KEY_COUNT (sizeof keys / sizeof keys[0])

static double value_of(const struct key *key, const struct technique *technique)
{
    const unsigned char *at = (const unsigned char *)technique + key->offset;
    float real = 0.0f;
    if (key->kind != KIND_REAL) {
        return (double)*at;
    }
    memcpy(&real, at, sizeof real);
    return (double)real;
}

static void set_value(const struct key *key, struct technique *technique, double value)
{
    unsigned char *at = (unsigned char *)technique + key->offset;
    const float real = (float)value;
    if (key->kind == KIND_REAL) {
        memcpy(at, &real, sizeof real);
    } else {
        *at = (unsigned char)value;
    }
}

/* "0 to 1", "over 0 to 2", "any|head|tail". */
static void print_range(const struct key *key, char out[RANGE_MAX])
{
    size_t used = 0;
    if (key->kind != KIND_WORD) {
        snprintf(out, RANGE_MAX, "%s%g to %g", key->above ? "over " : "", key->min, key->max);
        return;
    }
    out[0] = '\0';
    for (uint32_t i = 0; key->words[i] && used < RANGE_MAX; i++) {
        used += (size_t)snprintf(out + used, RANGE_MAX - used, "%s%s", i ? "|" : "",
                                 key->words[i]);
    }
}

/* ---- Lines ---------------------------------------------------------------------------------- */

struct parser {
    struct technique technique;
    uint32_t line;
    uint32_t base_line;
    uint32_t line_of[KEY_COUNT]; /* Where each key was set; 0: nowhere so far. */
    struct bot_file_problem *problem;
};

__attribute__((format(printf, 2, 3)))
static int refuse(struct parser *parser, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(parser->problem->text, sizeof parser->problem->text, format, arguments);
    va_end(arguments);
    parser->problem->line = parser->line;
    return -1;
}

static int set_base(struct parser *parser, const char *value)
{
    for (size_t i = 0; i < KEY_COUNT; i++) {
        if (parser->line_of[i]) {
            return refuse(parser, "base comes before all other keys, and line %u has '%s'",
                          parser->line_of[i], keys[i].name);
        }
    }
    if (parser->base_line) {
        return refuse(parser, "base is in line %u already", parser->base_line);
    }
    if (strcmp(value, "novice") != 0 && strcmp(value, "expert") != 0) {
        return refuse(parser, "base: '%.*s' is not right; novice|expert is", SHOWN, value);
    }
    parser->base_line = parser->line;
    parser->technique = strcmp(value, "novice") == 0 ? technique_novice : technique_expert;
    return 0;
}

static int read_value(const struct key *key, const char *text, double *out)
{
    uint32_t count = 0;
    int right = 0;
    if (key->kind == KIND_REAL) {
        right = number_parse_decimal(text, key->min, key->max, out);
        return right && !(key->above && (float)*out <= (float)key->min);
    }
    if (key->kind == KIND_COUNT) {
        right = number_parse(text, (uint32_t)key->min, (uint32_t)key->max, &count);
    } else {
        while (key->words[count] && strcmp(text, key->words[count]) != 0) {
            count++;
        }
        right = key->words[count] != NULL;
    }
    *out = right ? (double)count : *out;
    return right;
}

static int set_key(struct parser *parser, size_t index, const char *value)
{
    const struct key *key = &keys[index];
    char range[RANGE_MAX];
    double number = 0.0;
    if (parser->line_of[index]) {
        return refuse(parser, "%s is in line %u already", key->name, parser->line_of[index]);
    }
    if (!read_value(key, value, &number)) {
        print_range(key, range);
        return refuse(parser, "%s: '%.*s' is not right; %s is", key->name, SHOWN, value, range);
    }
    set_value(key, &parser->technique, number);
    parser->line_of[index] = parser->line;
    return 0;
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Without the white space around it. */
static char *trim(char *text)
{
    size_t length = 0;
    while (is_blank(*text)) {
        text++;
    }
    length = strlen(text);
    while (length > 0 && is_blank(text[length - 1u])) {
        text[--length] = '\0';
    }
    return text;
}

static void drop_comment(char *text)
{
    for (char *c = text; *c; c++) {
        if (*c == '#' && (c == text || is_blank(c[-1]))) {
            *c = '\0';
            return;
        }
    }
}

static int parse_line(struct parser *parser, char *text)
{
    drop_comment(text);
    char *name = trim(text);
    char *equals = strchr(name, '=');
    if (*name == '\0') {
        return 0;
    }
    if (!equals) {
        return refuse(parser, "'%.*s' has no '='; key=value is right", SHOWN, name);
    }
    *equals = '\0';
    const char *value = trim(equals + 1);
    name = trim(name);
    if (strcmp(name, "base") == 0) {
        return set_base(parser, value);
    }
    for (size_t i = 0; i < KEY_COUNT; i++) {
        if (strcmp(name, keys[i].name) == 0) {
            return set_key(parser, i, value);
        }
    }
    return refuse(parser, "'%.*s' is no key of a bot; kingyoctl play --help lists them", SHOWN,
                  name);
}

/* Copies the next line, without its end, into `out`; what of the text is behind it. */
static const char *cut_line(const char *text, const char *end, char out[LINE_MAX_CHARS],
                            size_t *length)
{
    const char *stop = memchr(text, '\n', (size_t)(end - text));
    *length = (size_t)((stop ? stop : end) - text);
    if (*length < LINE_MAX_CHARS) {
        memcpy(out, text, *length);
        out[*length] = '\0';
    }
    return stop ? stop + 1 : end;
}

static int parse_lines(struct parser *parser, const char *text, size_t size)
{
    const char *const end = text + size;
    char line[LINE_MAX_CHARS];
    size_t length = 0;
    while (text < end) {
        text = cut_line(text, end, line, &length);
        parser->line++;
        if (length >= LINE_MAX_CHARS) {
            return refuse(parser, "a line of %zu characters; %u is the most", length,
                          LINE_MAX_CHARS - 1u);
        }
        if (memchr(line, '\0', length)) {
            return refuse(parser, "is no text");
        }
        if (parse_line(parser, line)) {
            return -1;
        }
    }
    return 0;
}

/* What no single line says. */
static int check_whole(struct parser *parser)
{
    uint32_t set = parser->base_line, last = 0;
    for (size_t i = 0; i < KEY_COUNT; i++) {
        set += parser->line_of[i];
        last = parser->line_of[i] > last && strncmp(keys[i].name, "reaction_", 9) == 0
                   ? parser->line_of[i]
                   : last;
    }
    parser->line = last;
    if (set == 0) {
        return refuse(parser, "has no key; base=novice|expert is the least");
    }
    if (parser->technique.reaction_min_s > parser->technique.reaction_max_s) {
        return refuse(parser, "reaction_min_s %g is more than reaction_max_s %g",
                      (double)parser->technique.reaction_min_s,
                      (double)parser->technique.reaction_max_s);
    }
    return 0;
}

/* ---- Public --------------------------------------------------------------------------------- */

int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF"; /* Some editors begin a file with it. */
    struct parser parser = { .technique = technique_expert, .problem = problem };
    if (size >= 3 && memcmp(text, byte_order_mark, 3) == 0) {
        text += 3;
        size -= 3;
    }
    if (parse_lines(&parser, text, size) || check_whole(&parser)) {
        return -1;
    }
    *out = parser.technique;
    return 0;
}

static enum exit_code tell_io(const char *speaker, const char *path, int error)
{
    fprintf(stderr, "%s: %s: %s\n", speaker, path, strerror(error));
    return EXIT_IO;
}

enum exit_code bot_file_read(const char *speaker, const char *path, struct technique *out)
{
    char text[BOT_FILE_SIZE_MAX];
    struct bot_file_problem problem = { 0 };
    FILE *file = fopen(path, "rb");
    if (!file) {
        return tell_io(speaker, path, errno);
    }
    errno = 0;
    const size_t size = fread(text, 1, sizeof text, file);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (error) {
        return tell_io(speaker, path, error);
    }
    if (size == sizeof text) {
        fprintf(stderr, "%s: %s: is longer than any bot\n", speaker, path);
        return EXIT_BAD_DATA;
    }
    if (bot_file_parse(text, size, out, &problem)) {
        if (problem.line) {
            fprintf(stderr, "%s: %s:%u: %s\n", speaker, path, problem.line, problem.text);
        } else {
            fprintf(stderr, "%s: %s: %s\n", speaker, path, problem.text);
        }
        return EXIT_BAD_DATA;
    }
    return EXIT_OK;
}

enum exit_code bot_file_named(const char *speaker, const char *bot, struct technique *out)
{
    if (strcmp(bot, "novice") == 0) {
        *out = technique_novice;
        return EXIT_OK;
    }
    if (strcmp(bot, "expert") == 0) {
        *out = technique_expert;
        return EXIT_OK;
    }
    return bot_file_read(speaker, bot, out);
}

int bot_file_same(const struct technique *a, const struct technique *b)
{
    for (size_t i = 0; i < KEY_COUNT; i++) {
        const double x = value_of(&keys[i], a), y = value_of(&keys[i], b);
        if (x < y || x > y) {
            return 0;
        }
    }
    return 1;
}

static void print_value(const struct key *key, const struct technique *technique)
{
    const double value = value_of(key, technique);
    if (key->kind == KIND_WORD) {
        printf(" %-8s", key->words[(size_t)value]);
    } else {
        printf(" %-8g", value);
    }
}

void bot_file_print_keys(void)
{
    printf("\nA bot FILE has a 'key=value' a line; '#' begins a comment. base=novice|expert,\n"
           "before all other keys, says who plays where they say nothing (expert). The others:\n\n"
           "  %-15s %-14s %-8s %-8s %s\n",
           "key", "right is", "novice", "expert", "meaning");
    for (size_t i = 0; i < KEY_COUNT; i++) {
        char range[RANGE_MAX];
        print_range(&keys[i], range);
        printf("  %-15s %-14s", keys[i].name, range);
        print_value(&keys[i], &technique_novice);
        print_value(&keys[i], &technique_expert);
        printf(" %s\n", keys[i].meaning);
    }
}
