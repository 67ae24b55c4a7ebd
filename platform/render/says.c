/* says.c -- finds the pattern that a line was made from, and fills another language's. */
#include "platform/render/says.h"

#include <stdbool.h>
#include <string.h>

#include "platform/render/text.h"

#define GAPS_MAX 6u  /* As many names and figures as the longest line has. */
#define DEPTH_MAX 3u /* A line in a line in a line: "no store: PATH: disk I/O error; ..." */

struct span {
    const char *at;
    size_t size;
};

struct sink {
    char *out;
    size_t used, size;
};

/* A pattern has no character of several bytes that could be cut: what is too much is left out. */
static void put(struct sink *sink, const char *at, size_t size)
{
    size_t room = sink->size - 1u - sink->used;
    if (size > room) {
        size = room;
        while (size > 0 && ((unsigned char)at[size] & 0xc0u) == 0x80u) {
            size--;
        }
        sink->size = sink->used + size + 1u; /* Full. */
    }
    memcpy(sink->out + sink->used, at, size);
    sink->used += size;
    sink->out[sink->used] = '\0';
}

static bool starts_with(struct span text, const char *literal, size_t size)
{
    return text.size >= size && memcmp(text.at, literal, size) == 0;
}

/* Where a literal is found first in `text`; past its end: nowhere. An empty one is at the end. */
static size_t find(struct span text, const char *literal, size_t size)
{
    size_t at = size == 0 ? text.size : 0;
    while (at <= text.size &&
           !starts_with((struct span){ text.at + at, text.size - at }, literal, size)) {
        at++;
    }
    return at;
}

/* Whether `line` was made from `pattern`; then what stood in each gap. A gap ends where the letters
 * behind it are found first, the last one where they end the line. */
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
        const size_t at = brace               ? find(rest, pattern, literal)
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

/* What stood in a gap may be a line itself: why something was refused. */
static void fill(struct sink *sink, uint8_t language, enum text_key key,
                 const struct span gap[GAPS_MAX], uint32_t depth)
{
    const char *words = text_words(language, key);
    uint32_t next = 0;
    for (const char *brace; (brace = strstr(words, "{}")) != NULL && next < GAPS_MAX; next++) {
        put(sink, words, (size_t)(brace - words));
        write(sink, language, gap[next], depth + 1u);
        words = brace + 2;
    }
    put(sink, words, strlen(words));
}

/* All of it, if that is known; else remark by remark. No deeper than DEPTH_MAX. */
static void write(struct sink *sink, uint8_t language, struct span line, uint32_t depth)
{
    struct span gap[GAPS_MAX] = { { NULL, 0 } };
    enum text_key key = depth < DEPTH_MAX ? pattern_of(line, gap) : TEXT_COUNT;
    for (size_t half; key == TEXT_COUNT && depth < DEPTH_MAX &&
                      (half = find(line, "; ", 2)) < line.size;) {
        const struct span remark = { line.at, half };
        key = pattern_of(remark, gap);
        if (key != TEXT_COUNT) {
            fill(sink, language, key, gap, depth);
        } else {
            put(sink, remark.at, remark.size);
        }
        put(sink, "; ", 2);
        line = (struct span){ line.at + half + 2u, line.size - half - 2u };
        key = pattern_of(line, gap);
    }
    if (key != TEXT_COUNT) {
        fill(sink, language, key, gap, depth);
    } else {
        put(sink, line.at, line.size);
    }
}

void says(char *out, size_t out_size, uint8_t language, const char *line)
{
    struct sink sink = { .out = out, .size = out_size };
    out[0] = '\0';
    write(&sink, language, (struct span){ line, strlen(line) }, 0);
}
