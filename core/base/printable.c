/* printable.c -- encodes and decodes UTF-8 (RFC 3629), and determines which characters may be
 * displayed. */
#include "core/base/printable.h"

struct span {
    uint32_t first, last;
};

/* Ranges of code points that must not be displayed; printable.h gives the reasons. Each range
 * includes `first` and `last`. */
static const struct span refused[] = {
    { 0x0000, 0x001F }, { 0x007F, 0x009F }, { 0x061C, 0x061C },
    { 0x200E, 0x200F }, { 0x2028, 0x202E }, { 0x2066, 0x2069 },
};

#define REFUSED_COUNT (sizeof refused / sizeof refused[0])

/* Rejects overlong forms, surrogates and code points above U+10FFFF, as RFC 3629 requires. The zero
 * byte at the end of `text` is not a continuation byte, so no byte after the zero byte is read. */
uint32_t printable_utf8_size(const char *text)
{
    const unsigned char *c = (const unsigned char *)text;
    const uint32_t size = c[0] < 0x80 ? 1 : c[0] < 0xC2 ? 0 : c[0] < 0xE0 ? 2 : c[0] < 0xF0 ? 3 : 4;
    const unsigned char low = c[0] == 0xE0 ? 0xA0 : c[0] == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = c[0] == 0xED ? 0x9F : c[0] == 0xF4 ? 0x8F : 0xBF;
    if (c[0] > 0xF4 || (size > 1 && (c[1] < low || c[1] > high))) {
        return 0;
    }
    for (uint32_t i = 2; i < size; i++) {
        if (c[i] < 0x80 || c[i] > 0xBF) {
            return 0;
        }
    }
    return size;
}

uint32_t printable_code_point(const char *text)
{
    const unsigned char *c = (const unsigned char *)text;
    const uint32_t size = printable_utf8_size(text);
    uint32_t point = size == 1 ? c[0] : c[0] & (0x7Fu >> size);
    for (uint32_t i = 1; i < size; i++) {
        point = point << 6 | (c[i] & 0x3Fu);
    }
    return point;
}

char *printable_put(char *to, uint32_t point)
{
    static const unsigned char first[] = { 0x00, 0xC0, 0xE0, 0xF0 };
    const uint32_t more = point < 0x80 ? 0 : point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
    *to++ = (char)(first[more] | point >> 6 * more);
    for (uint32_t i = more; i > 0; i--) {
        *to++ = (char)(0x80u | (point >> 6 * (i - 1u) & 0x3Fu));
    }
    return to;
}

uint32_t printable_next(const char **at)
{
    const uint32_t size = printable_utf8_size(*at);
    const uint32_t point = size > 0 ? printable_code_point(*at) : PRINTABLE_MALFORMED;
    *at += size > 0 ? size * (point > 0) : 1u; /* At the end of the text, `*at` does not advance. */
    return point;
}

uint32_t printable_fit(const char *text, uint32_t max)
{
    uint32_t length = 0;
    while (length < max && text[length]) {
        length++;
    }
    while (length > 0 && ((unsigned char)text[length] & 0xc0u) == 0x80u) {
        length--;
    }
    return length;
}

uint32_t printable_size(const char *text)
{
    const uint32_t size = printable_utf8_size(text);
    const uint32_t point = size > 0 ? printable_code_point(text) : 0;
    for (uint32_t i = 0; i < REFUSED_COUNT; i++) {
        if (point >= refused[i].first && point <= refused[i].last) {
            return 0;
        }
    }
    return size;
}

char *printable(char *text)
{
    const char *from = text;
    char *to = text;
    while (*from) {
        const uint32_t shown = printable_size(from);
        const uint32_t size = printable_utf8_size(from);
        if (shown == 0) {
            *to++ = PRINTABLE_MARK;
        }
        for (uint32_t i = 0; i < shown; i++) {
            *to++ = from[i];
        }
        from += size > 0 ? size : 1u;
    }
    *to = '\0';
    return text;
}
