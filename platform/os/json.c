/* json.c -- writes the tokens and the escape sequences of RFC 8259; see json.h. */
#include "platform/os/json.h"

#include <stdarg.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/number.h"

#define MALFORMED "\xEF\xBF\xBD" /* U+FFFD, the replacement character. */
/* Size of one escaped character: at most six bytes and a terminating zero. */
#define CHAR_SIZE 7u

/* Writes the first character of `words` in escaped form to `out`. A quote or a backslash is copied,
 * and the caller writes the backslash before it. Returns the size of the unescaped character in
 * bytes. */
static uint32_t escape(const char *words, char out[CHAR_SIZE])
{
    const uint32_t size = printable_utf8_size(words);
    if (size == 0) {
        snprintf(out, CHAR_SIZE, MALFORMED);
    } else if (printable_size(words) == 0) {
        snprintf(out, CHAR_SIZE, "\\u%04x", printable_code_point(words));
    } else {
        snprintf(out, CHAR_SIZE, "%.*s", (int)size, words);
    }
    return size > 0 ? size : 1u;
}

static void put_list(struct json *json, const char *format, va_list arguments)
{
    if (json->file) {
        vfprintf(json->file, format, arguments);
        return;
    }
    const int length =
        vsnprintf(json->buffer + json->used, json->size - json->used, format, arguments);
    CORE_ASSERT(length >= 0 && (size_t)length < json->size - json->used);
    json->used += (size_t)length;
}

__attribute__((format(printf, 2, 3))) static void put_json_text(struct json *json,
                                                                const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put_list(json, format, arguments);
    va_end(arguments);
}

static void put_words(struct json *json, const char *words)
{
    char one[CHAR_SIZE];
    put_json_text(json, "\"");
    while (*words) {
        const bool is_marked = words[0] == '"' || words[0] == '\\';
        words += escape(words, one);
        put_json_text(json, "%s%s", is_marked ? "\\" : "", one);
    }
    put_json_text(json, "\"");
}

/* Writes the text before an element: the comma, the line break or the blank, and the key. */
static void begin_json_element(struct json *json, const char *key)
{
    CORE_ASSERT(json->file || json->buffer);
    put_json_text(json, "%s", json->inner ? "," : "");
    if (json->breaks) {
        put_json_text(json, "\n%*s", json->indent, "");
    } else if (json->inner) {
        put_json_text(json, " ");
    }
    if (key) {
        put_words(json, key);
        put_json_text(json, ": ");
    }
    json->inner = true;
    json->breaks = false;
}

void json_open(struct json *json, const char *key, char bracket)
{
    CORE_ASSERT(bracket == '{' || bracket == '[');
    begin_json_element(json, key);
    put_json_text(json, "%c", bracket);
    json->inner = false;
}

void json_close(struct json *json, char bracket)
{
    CORE_ASSERT(bracket == '}' || bracket == ']');
    if (json->breaks) {
        put_json_text(json, "\n%*s", json->indent, "");
    }
    put_json_text(json, "%c", bracket);
    json->inner = true;
    json->breaks = false;
}

void json_line(struct json *json, uint8_t indent)
{
    json->breaks = true;
    json->indent = indent;
}

void json_value(struct json *json, const char *key, const char *format, ...)
{
    va_list arguments;
    begin_json_element(json, key);
    va_start(arguments, format);
    put_list(json, format, arguments);
    va_end(arguments);
}

void json_number(struct json *json, const char *key, double value, uint32_t decimals)
{
    char digits[NUMBER_FIXED_MAX];
    const uint32_t length = number_print_fixed(digits, value, decimals);
    json_value(json, key, "%.*s", (int)length, digits);
}

void json_bool(struct json *json, const char *key, bool value)
{
    json_value(json, key, "%s", value ? "true" : "false");
}

void json_text(struct json *json, const char *key, const char *words)
{
    CORE_ASSERT(words);
    begin_json_element(json, key);
    put_words(json, words);
}

void json_end(struct json *json)
{
    put_json_text(json, "\n");
}

void json_copy(const char *document)
{
    char one[CHAR_SIZE];
    while (*document) {
        if (strchr("\n\r\t", *document)) {
            putchar(*document++);
        } else {
            document += escape(document, one);
            fputs(one, stdout);
        }
    }
}
