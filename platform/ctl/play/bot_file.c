/* bot_file.c -- the parser of bot files.
 *
 * Each line is checked against the table of keys in bot_keys.c. */
#include "platform/ctl/play/bot_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/play/bot_keys.h"
#include "platform/os/print.h"

#define LINE_MAX_CHARS 200u
#define SHOWN 40 /* Maximum number of characters of an invalid word that an error message quotes. */

/* ---- Lines of a bot file --------------------------------------------------------------------- */

struct parser {
    struct technique technique;
    uint32_t line;
    uint32_t base_line;
    uint32_t line_of[BOT_KEY_COUNT]; /* Line in which each key was set, counted from 1. 0 means that
                                        the key has not been set. */
    struct bot_file_problem *problem;
};

__attribute__((format(printf, 2, 3))) static int bot_file_error(struct parser *parser,
                                                                const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(parser->problem->text, sizeof parser->problem->text, format, arguments);
    va_end(arguments);
    printable(parser->problem->text);
    parser->problem->line = parser->line;
    return -1;
}

static int set_base(struct parser *parser, const char *value)
{
    for (uint32_t key = 0; key < BOT_KEY_COUNT; key++) {
        if (parser->line_of[key]) {
            return bot_file_error(parser, "base comes before all other keys, and line %u has '%s'",
                                  parser->line_of[key], bot_key_name(key));
        }
    }
    if (parser->base_line) {
        return bot_file_error(parser, "base is in line %u already", parser->base_line);
    }
    if (strcmp(value, "novice") != 0 && strcmp(value, "expert") != 0) {
        return bot_file_error(parser, "base: '%.*s' is not right; novice|expert is", SHOWN, value);
    }
    CORE_ASSERT(parser->line > 0);
    parser->base_line = parser->line;
    parser->technique = strcmp(value, "novice") == 0 ? technique_novice : technique_expert;
    return 0;
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Removes leading and trailing white space from `text` in place. Returns the first remaining
 * character. */
static char *bot_file_trim(char *text)
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

static int parse_line(struct parser *parser, char *text)
{
    for (char *c = strchr(text, '#'); c; c = strchr(c + 1, '#')) {
        if (c == text || is_blank(c[-1])) {
            *c = '\0';
            break;
        }
    }
    char *name = bot_file_trim(text);
    char *equals = strchr(name, '=');
    if (*name == '\0') {
        return 0;
    }
    if (!equals) {
        return bot_file_error(parser, "'%.*s' has no '='; key=value is right", SHOWN, name);
    }
    *equals = '\0';
    const char *value = bot_file_trim(equals + 1);
    name = bot_file_trim(name);
    if (strcmp(name, "base") == 0) {
        return set_base(parser, value);
    }
    const uint32_t key = bot_key_named(name);
    if (key == BOT_KEY_COUNT) {
        return bot_file_error(parser, "'%.*s' is no key of a bot; kingyoctl play --help lists them",
                              SHOWN, name);
    }
    if (parser->line_of[key]) {
        return bot_file_error(parser, "%s is in line %u already", name, parser->line_of[key]);
    }
    if (bot_key_set(key, value, &parser->technique)) {
        char range[BOT_KEY_RANGE_MAX];
        bot_key_range(key, range);
        return bot_file_error(parser, "%s: '%.*s' is not right; %s is", name, SHOWN, value, range);
    }
    parser->line_of[key] = parser->line;
    return 0;
}

static int parse_lines(struct parser *parser, const char *text, size_t size)
{
    const char *const end = text + size;
    char line[LINE_MAX_CHARS];
    size_t length = 0;
    while (text < end) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        length = (size_t)((stop ? stop : end) - text);
        parser->line++;
        if (length >= LINE_MAX_CHARS) {
            return bot_file_error(parser, "a line of %zu characters; %u is the most", length,
                                  LINE_MAX_CHARS - 1u);
        }
        memcpy(line, text, length);
        line[length] = '\0';
        text = stop ? stop + 1 : end;
        if (memchr(line, '\0', length)) {
            return bot_file_error(parser, "is no text");
        }
        if (parse_line(parser, line)) {
            return -1;
        }
    }
    return 0;
}

/* Checks the rules that concern several lines. The error names the later of two contradicting
 * lines, or the whole file. Returns 0, or fills the problem and returns -1. */
static int check_whole(struct parser *parser)
{
    const struct technique *technique = &parser->technique;
    const uint32_t min_line = parser->line_of[bot_key_named("reaction_min_s")];
    const uint32_t max_line = parser->line_of[bot_key_named("reaction_max_s")];
    uint32_t set = parser->base_line;
    for (uint32_t key = 0; key < BOT_KEY_COUNT; key++) {
        set += parser->line_of[key];
    }
    parser->line = min_line > max_line ? min_line : max_line;
    if (set == 0) {
        return bot_file_error(parser, "has no key; base=novice|expert is the least");
    }
    if (technique->reaction_min_s > technique->reaction_max_s) {
        return bot_file_error(parser, "reaction_min_s %g is more than reaction_max_s %g",
                              (double)technique->reaction_min_s, (double)technique->reaction_max_s);
    }
    return 0;
}

/* ---- Public functions ------------------------------------------------------------------------ */

int bot_file_parse(const char *text, size_t size, struct technique *out,
                   struct bot_file_problem *problem)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF"; /* Byte-order mark U+FEFF in UTF-8. Some
                                                             editors write the mark at the start of
                                                             a file. */
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

enum exit_code bot_file_read(const char *speaker, const char *path, struct technique *out)
{
    char text[BOT_FILE_SIZE_MAX];
    struct bot_file_problem problem = { 0 };
    FILE *file;
    if (access(path, F_OK) != 0 && errno == ENOENT) { /* A file that does not exist is most likely a
                                                         misspelt bot name, so the message lists the
                                                         bot names. */
        print_error("%s: %s: %s; novice, expert or a FILE is a bot", speaker, path,
                    strerror(errno));
        return EXIT_IO;
    }
    const enum exit_code code = ctl_file_open(speaker, path, sizeof text, &file);
    if (code != EXIT_OK) {
        return code;
    }
    errno = 0;
    const size_t size = fread(text, 1, sizeof text, file);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (error) {
        return ctl_file_error(speaker, path, sizeof text, error);
    }
    if (bot_file_parse(text, size, out, &problem)) {
        if (problem.line) {
            print_error("%s: %s:%u: %s", speaker, path, problem.line, problem.text);
        } else {
            print_error("%s: %s: %s", speaker, path, problem.text);
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
