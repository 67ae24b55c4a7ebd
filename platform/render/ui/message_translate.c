/* message_translate.c -- finds the pattern that produced an English line, and fills in the
 * pattern's translation. */
#include "platform/render/ui/message_translate.h"

#include <stdbool.h>
#include <string.h>

#include "platform/render/ui/text.h"

#define GAPS_MAX 6u /* Maximum number of gaps for names and figures in a line. */
/* Maximum depth of messages that contain messages, such as "no store: PATH: disk I/O error;
 * ...". */
#define DEPTH_MAX 3u

struct span {
    const char *at;
    size_t size;
};

struct sink {
    char *out;
    size_t used, size;
};

/* Appends bytes to the sink and drops the bytes that do not fit. Patterns contain no multi-byte
 * character, so that no character of a pattern is cut in the middle. */
static void message_translate_put(struct sink *sink, const char *at, size_t size)
{
    size_t room = sink->size - 1u - sink->used;
    if (size > room) {
        size = room;
        while (size > 0 && ((unsigned char)at[size] & 0xc0u) == 0x80u) {
            size--;
        }
        sink->size = sink->used + size + 1u; /* After this assignment the sink has no room left, so
                                                that later bytes are dropped. */
    }
    memcpy(sink->out + sink->used, at, size);
    sink->used += size;
    sink->out[sink->used] = '\0';
}

static bool starts_with(struct span text, const char *literal, size_t size)
{
    return text.size >= size && memcmp(text.at, literal, size) == 0;
}

/* Returns the position of the first occurrence of `literal` in `text`. Returns a position past the
 * end if `text` does not contain `literal`. An empty literal matches at the end of `text`. */
static size_t message_translate_find(struct span text, const char *literal, size_t size)
{
    size_t at = size == 0 ? text.size : 0;
    while (at <= text.size &&
           !starts_with((struct span){ text.at + at, text.size - at }, literal, size)) {
        at++;
    }
    return at;
}

/* Returns true if `line` matches `pattern`, and writes the text of each gap {} to `gap`. A gap ends
 * at the first occurrence of the literal text that follows the gap in the pattern. The last literal
 * text must be at the end of the line. */
static bool matches(struct span line, const char *pattern, struct span gap[GAPS_MAX])
{
    const char *brace = strstr(pattern, "{}");
    size_t literal = brace ? (size_t)(brace - pattern) : strlen(pattern);
    if (!starts_with(line, pattern, literal)) {
        return false;
    }
    struct span rest = { line.at + literal, line.size - literal };
    for (uint32_t i = 0; brace && i < GAPS_MAX; i++) {
        pattern = brace + 2;
        brace = strstr(pattern, "{}");
        literal = brace ? (size_t)(brace - pattern) : strlen(pattern);
        const size_t at = brace                  ? message_translate_find(rest, pattern, literal)
                          : rest.size >= literal ? rest.size - literal
                                                 : rest.size + 1u;
        if (at > rest.size ||
            !starts_with((struct span){ rest.at + at, rest.size - at }, pattern, literal)) {
            return false;
        }
        gap[i] = (struct span){ rest.at, at };
        rest = (struct span){ rest.at + at + literal, rest.size - at - literal };
    }
    return rest.size == 0;
}

static enum text_key pattern_of(struct span line, struct span gap[GAPS_MAX])
{
    for (uint32_t key = TEXT_SAYS_NO_PICTURE; key <= TEXT_SAYS_NO_ROOM; key++) {
        if (matches(line, text_words(LANGUAGE_EN, (enum text_key)key), gap)) {
            return (enum text_key)key;
        }
    }
    return TEXT_COUNT;
}

static void write(struct sink *sink, uint8_t language, struct span line, uint32_t depth);

/* Writes the translation of `key` with the gaps filled in. The text of a gap is translated too if
 * it is a message, such as the reason of a failure. */
static void message_translate_fill_gap(struct sink *sink, uint8_t language, enum text_key key,
                                       const struct span gap[GAPS_MAX], uint32_t depth)
{
    const char *words = text_words(language, key);
    uint32_t next = 0;
    for (const char *brace; (brace = strstr(words, "{}")) != NULL && next < GAPS_MAX; next++) {
        message_translate_put(sink, words, (size_t)(brace - words));
        write(sink, language, gap[next], depth + 1u);
        words = brace + 2;
    }
    message_translate_put(sink, words, strlen(words));
}

/* Translates the whole line if its pattern is known. Otherwise translates each part that "; "
 * separates. The recursion depth is at most DEPTH_MAX. */
static void write(struct sink *sink, uint8_t language, struct span line, uint32_t depth)
{
    struct span gap[GAPS_MAX] = { { NULL, 0 } };
    enum text_key key = depth < DEPTH_MAX ? pattern_of(line, gap) : TEXT_COUNT;
    for (size_t half; key == TEXT_COUNT && depth < DEPTH_MAX &&
                      (half = message_translate_find(line, "; ", 2)) < line.size;) {
        const struct span remark = { line.at, half };
        key = pattern_of(remark, gap);
        if (key != TEXT_COUNT) {
            message_translate_fill_gap(sink, language, key, gap, depth);
        } else {
            message_translate_put(sink, remark.at, remark.size);
        }
        message_translate_put(sink, "; ", 2);
        line = (struct span){ line.at + half + 2u, line.size - half - 2u };
        key = pattern_of(line, gap);
    }
    if (key != TEXT_COUNT) {
        message_translate_fill_gap(sink, language, key, gap, depth);
    } else {
        message_translate_put(sink, line.at, line.size);
    }
}

void message_translate(char *out, size_t out_size, uint8_t language, const char *line)
{
    struct sink sink = { .out = out, .size = out_size };
    out[0] = '\0';
    write(&sink, language, (struct span){ line, strlen(line) }, 0);
}
