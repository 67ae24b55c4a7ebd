/* json_char.c -- RFC 8259's escapes and RFC 3629's characters. */
#include "platform/json_char.h"

#include <stdio.h>

/* How many bytes the character at `c` has in UTF-8; 0: it is none (RFC 3629: no overlong form, no
 * surrogate, nothing behind U+10FFFF). Text ends with 0, which continues nothing. */
static unsigned utf8_size(const unsigned char *c)
{
    const unsigned size = c[0] < 0x80 ? 1 : c[0] < 0xC2 ? 0 : c[0] < 0xE0 ? 2 : c[0] < 0xF0 ? 3 : 4;
    const unsigned char low = c[0] == 0xE0 ? 0xA0 : c[0] == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = c[0] == 0xED ? 0x9F : c[0] == 0xF4 ? 0x8F : 0xBF;
    if (c[0] > 0xF4 || (size > 1 && (c[1] < low || c[1] > high))) {
        return 0;
    }
    for (unsigned i = 2; i < size; i++) {
        if (c[i] < 0x80 || c[i] > 0xBF) {
            return 0;
        }
    }
    return size;
}

const char *json_char(const char *words, char out[JSON_CHAR_SIZE])
{
    const unsigned char first = (unsigned char)words[0];
    const unsigned size = utf8_size((const unsigned char *)words);
    if (first == '"' || first == '\\') {
        snprintf(out, JSON_CHAR_SIZE, "\\%c", first);
    } else if (first < 0x20 || first == 0x7F) {
        snprintf(out, JSON_CHAR_SIZE, "\\u%04x", (unsigned)first);
    } else if (size == 0) {
        snprintf(out, JSON_CHAR_SIZE, "\xEF\xBF\xBD");
    } else {
        snprintf(out, JSON_CHAR_SIZE, "%.*s", (int)size, words);
    }
    return words + (size > 0 ? size : 1u);
}

void json_print(const char *words)
{
    char one[JSON_CHAR_SIZE];
    putchar('"');
    while (*words) {
        words = json_char(words, one);
        fputs(one, stdout);
    }
    putchar('"');
}
