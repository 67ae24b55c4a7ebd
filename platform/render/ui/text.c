/* text.c -- the user interface's text: UTF-8 decoding, translations, glyphs and their widths. */
#include "platform/render/ui/text.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

_Static_assert(sizeof text_table / sizeof *text_table == LANGUAGE_COUNT,
               "assets/text has one file for each enum language, in its order");

const char *text_words(uint8_t language, enum text_key key)
{
    CORE_ASSERT((uint32_t)key < TEXT_COUNT);
    return text_table[language < LANGUAGE_COUNT ? language : LANGUAGE_JA][key];
}

const struct font_glyph *text_glyph(enum font_id font, uint32_t code)
{
    CORE_ASSERT((uint32_t)font < FONT_COUNT);
    const struct font *face = &asset_fonts[font];
    uint32_t low = 0, high = face->glyph_count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2u;
        if (face->glyphs[middle].code < code) {
            low = middle + 1u;
        } else {
            high = middle;
        }
    }
    return low < face->glyph_count && face->glyphs[low].code == code ? &face->glyphs[low] : NULL;
}

const struct font_glyph *text_glyph_or_mark(enum font_id font, uint32_t code)
{
    const struct font_glyph *glyph = text_glyph(font, code);
    return glyph != NULL ? glyph : text_glyph(font, '?');
}

float text_width_em(enum font_id font, const char *words, float spacing_em)
{
    float width = 0.0f;
    uint32_t count = 0;
    for (uint32_t code = printable_next(&words); code != 0; code = printable_next(&words)) {
        const struct font_glyph *glyph = text_glyph_or_mark(font, code);
        if (glyph != NULL) {
            width += glyph->advance_em;
            count++;
        }
    }
    return count == 0 ? 0.0f : width + spacing_em * (float)(count - 1u);
}

#define GAPS_MAX 6u /* Maximum number of gaps {} (places for a name or a number) in one text. */
/* Maximum depth to which a message inside a message is translated. For example, "no store: PATH:
 * disk I/O error; ..." contains the message "disk I/O error". */
#define DEPTH_MAX 3u

struct span {
    const char *at;
    size_t size;
};

struct sink {
    char *out;
    size_t used, size;
};

/* Appends text to the output buffer. If the text does not fit, appends only the characters that fit
 * and drops all later text. */
static void sink_put(struct sink *sink, const char *at, size_t size)
{
    CORE_ASSERT(sink->used < sink->size);
    size_t room = sink->size - 1u - sink->used;
    if (size > room) {
        size = printable_fit(at, (uint32_t)room);
        /* This assignment makes the buffer full, so that all later text is dropped. */
        sink->size = sink->used + size + 1u;
    }
    memcpy(sink->out + sink->used, at, size);
    sink->used += size;
    sink->out[sink->used] = '\0';
}

void text_number(char *out, size_t out_size, const char *words, uint32_t number)
{
    CORE_ASSERT(out_size > 0);
    struct sink sink = { .out = out, .size = out_size };
    const char *const gap = strstr(words, "{}");
    out[0] = '\0';
    sink_put(&sink, words, gap ? (size_t)(gap - words) : strlen(words));
    if (gap) {
        char digits[12];
        const size_t count = (size_t)snprintf(digits, sizeof digits, "%u", number);
        /* The number is written only if all of its digits fit, because a cut number would be
         * wrong. */
        if (count < sink.size - sink.used) {
            sink_put(&sink, digits, count);
        }
        sink_put(&sink, gap + 2, strlen(gap + 2));
    }
}

static bool starts_with(struct span text, const char *literal, size_t size)
{
    return text.size >= size && memcmp(text.at, literal, size) == 0;
}

/* Returns the position of the first occurrence of `literal` in `text`. If `text` does not contain
 * `literal`, returns a position past the end of `text`. If `literal` is empty, returns the end of
 * `text`. */
static size_t find_literal(struct span text, const char *literal, size_t size)
{
    size_t at = size == 0 ? text.size : 0;
    while (at <= text.size &&
           !starts_with((struct span){ text.at + at, text.size - at }, literal, size)) {
        at++;
    }
    return at;
}

/* Returns true if `line` matches `pattern`, and writes the part of `line` that stands for each gap
 * {} to `gap`. Such a part ends at the first occurrence of the literal text that follows the gap in
 * the pattern. The last literal text must be at the end of `line`. */
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
        const size_t at = brace                  ? find_literal(rest, pattern, literal)
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
    for (uint32_t key = TEXT_MESSAGE_NO_PICTURE; key <= TEXT_MESSAGE_NO_ROOM; key++) {
        if (matches(line, text_words(LANGUAGE_EN, (enum text_key)key), gap)) {
            return (enum text_key)key;
        }
    }
    return TEXT_COUNT;
}

static void write_translated_line(struct sink *sink, uint8_t language, struct span line,
                                  uint32_t depth);

/* Writes the text `key` in `language`, with the gaps filled with the texts in `gap`. If the text in
 * a gap is itself a message, such as the reason of a failure, this text is translated too. */
static void write_pattern(struct sink *sink, uint8_t language, enum text_key key,
                          const struct span gap[GAPS_MAX], uint32_t depth)
{
    const char *words = text_words(language, key);
    uint32_t next = 0;
    for (const char *brace;
         (brace = strstr(words, "{}")) != NULL && next < GAPS_MAX && gap[next].at != NULL; next++) {
        sink_put(sink, words, (size_t)(brace - words));
        write_translated_line(sink, language, gap[next], depth + 1u);
        words = brace + 2;
    }
    sink_put(sink, words, strlen(words));
}

/* Translates the whole line if a pattern matches the line. Otherwise translates each part of the
 * line between separators "; ". The recursion depth is at most DEPTH_MAX. */
static void write_translated_line(struct sink *sink, uint8_t language, struct span line,
                                  uint32_t depth)
{
    struct span gap[GAPS_MAX] = { { NULL, 0 } };
    enum text_key key = depth < DEPTH_MAX ? pattern_of(line, gap) : TEXT_COUNT;
    for (size_t half; key == TEXT_COUNT && depth < DEPTH_MAX &&
                      (half = find_literal(line, "; ", 2)) < line.size;) {
        const struct span remark = { line.at, half };
        key = pattern_of(remark, gap);
        if (key != TEXT_COUNT) {
            write_pattern(sink, language, key, gap, depth);
        } else {
            sink_put(sink, remark.at, remark.size);
        }
        sink_put(sink, "; ", 2);
        line = (struct span){ line.at + half + 2u, line.size - half - 2u };
        key = pattern_of(line, gap);
    }
    if (key != TEXT_COUNT) {
        write_pattern(sink, language, key, gap, depth);
    } else {
        sink_put(sink, line.at, line.size);
    }
}

void text_translate(char *out, size_t out_size, uint8_t language, const char *line)
{
    CORE_ASSERT(out_size > 0);
    struct sink sink = { .out = out, .size = out_size };
    out[0] = '\0';
    write_translated_line(&sink, language, (struct span){ line, strlen(line) }, 0);
}
