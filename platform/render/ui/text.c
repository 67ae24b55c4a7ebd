/* text.c -- the user interface's text: UTF-8 decoding, translations, glyphs and their widths. */
#include "platform/render/ui/text.h"

_Static_assert(sizeof text_table / sizeof *text_table == LANGUAGE_COUNT,
               "assets/text has one file for each enum language, in its order");

const char *text_words(uint8_t language, enum text_key key)
{
    return text_table[language < LANGUAGE_COUNT ? language : LANGUAGE_JA][key];
}

/* Returns the number of bytes that follow the first byte of a UTF-8 character. 4 means an invalid
 * first byte. */
static uint32_t tail_length(unsigned char lead)
{
    if (lead < 0x80u) {
        return 0;
    }
    if (lead < 0xc2u || lead > 0xf4u) {
        return 4;
    }
    return lead < 0xe0u ? 1u : lead < 0xf0u ? 2u : 3u;
}

uint32_t text_next(const char **at)
{
    static const uint32_t lowest[4] = { 0, 0x80, 0x800, 0x10000 };
    const unsigned char *bytes = (const unsigned char *)*at;
    if (bytes[0] == 0) {
        return 0;
    }
    *at += 1;
    const uint32_t tail = tail_length(bytes[0]);
    if (tail > 3u) {
        return TEXT_MALFORMED;
    }
    uint32_t code = tail == 0 ? bytes[0] : bytes[0] & (0x3fu >> tail);
    for (uint32_t i = 1; i <= tail; i++) {
        if ((bytes[i] & 0xc0u) != 0x80u) {
            return TEXT_MALFORMED;
        }
        code = code << 6 | (bytes[i] & 0x3fu);
    }
    if (code < lowest[tail] || code > 0x10ffffu || (code >= 0xd800u && code <= 0xdfffu)) {
        return TEXT_MALFORMED;
    }
    *at += tail;
    return code;
}

const struct font_glyph *text_glyph(enum font_id font, uint32_t code)
{
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
    for (uint32_t code = text_next(&words); code != 0; code = text_next(&words)) {
        const struct font_glyph *glyph = text_glyph_or_mark(font, code);
        if (glyph != NULL) {
            width += glyph->advance_em;
            count++;
        }
    }
    return count == 0 ? 0.0f : width + spacing_em * (float)(count - 1u);
}

static size_t put_number(char *out, size_t room, uint32_t number)
{
    char digits[10];
    size_t count = 0;
    do {
        digits[count++] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0);
    if (count > room) {
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        out[i] = digits[count - 1u - i];
    }
    return count;
}

void text_number(char *out, size_t out_size, const char *words, uint32_t number)
{
    size_t used = 0;
    int placed = 0;
    while (*words != 0) {
        if (!placed && words[0] == '{' && words[1] == '}') {
            used += put_number(out + used, out_size - 1u - used, number);
            words += 2;
            placed = 1;
            continue;
        }
        const char *next = words;
        text_next(&next);
        if ((size_t)(next - words) > out_size - 1u - used) {
            break;
        }
        while (words < next) {
            out[used++] = *words++;
        }
    }
    out[used] = 0;
}
