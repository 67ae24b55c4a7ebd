/* json_char.c -- writes the escape sequences of RFC 8259; see json_char.h. */
#include "platform/os/json_char.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "core/base/printable.h"

#define MALFORMED "\xEF\xBF\xBD" /* U+FFFD, the replacement character. */

/* Writes the first character of `words`, which must not be a quote or a backslash. Returns the
 * character's size in bytes. */
static uint32_t put_char(const char *words, char out[JSON_CHAR_SIZE])
{
    const uint32_t size = printable_utf8_size(words);
    if (size == 0) {
        snprintf(out, JSON_CHAR_SIZE, MALFORMED);
    } else if (printable_size(words) == 0) {
        snprintf(out, JSON_CHAR_SIZE, "\\u%04x", printable_code_point(words));
    } else {
        snprintf(out, JSON_CHAR_SIZE, "%.*s", (int)size, words);
    }
    return size > 0 ? size : 1u;
}

const char *json_char(const char *words, char out[JSON_CHAR_SIZE])
{
    if (words[0] == '"' || words[0] == '\\') {
        snprintf(out, JSON_CHAR_SIZE, "\\%c", words[0]);
        return words + 1;
    }
    return words + put_char(words, out);
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

void json_print_text(const char *json)
{
    char one[JSON_CHAR_SIZE];
    while (*json) {
        if (strchr("\n\r\t", *json)) {
            putchar(*json++);
        } else {
            json += put_char(json, one);
            fputs(one, stdout);
        }
    }
}
