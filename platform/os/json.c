/* json.c -- writes the tokens and the escape sequences of RFC 8259; see json.h. */
#include "platform/os/json.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

/* U+FFFD, the character that replaces a byte that is not valid UTF-8. */
#define MALFORMED "\xEF\xBF\xBD"
/* Size in bytes of the buffer for one escaped character: at most six bytes and a terminating
 * zero. */
#define CHAR_SIZE 7u
#define NAME_SIZE 32u /* Maximum size in bytes of a key in the argument `format` of json_print(). */

/* Writes the first character of `words` to `out`, in escaped form if necessary. A quote or a
 * backslash is copied without the escaping backslash, which the caller writes. Returns the size in
 * bytes of the character in `words`. */
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

/* Writes the text that precedes the value of an element: the comma, the line break or the blank,
 * and the key. */
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

/* Writes the next argument as the conversion (such as %u) at the start of `format` requires.
 * Returns the position in `format` after the conversion. */
static const char *put_conversion(struct json *json, const char *key, const char *format,
                                  va_list *arguments)
{
    const size_t length = strcspn(format, "dfgsux") + 1u;
    const char type = format[length - 1u];
    if (type == 's') {
        json_text(json, key, va_arg(*arguments, const char *));
    } else if (type == 'f' || type == 'g') {
        const double value = va_arg(*arguments, double);
        if (isnan(value)) {
            json_value(json, key, "null");
        } else {
            json_value(json, key, type == 'f' ? "%.*f" : "%.*g", format[2] - '0', value);
        }
    } else if (type == 'x') {
        json_value(json, key, "\"%016llx\"", va_arg(*arguments, unsigned long long));
    } else if (format[1] == 'h') {
        json_bool(json, key, va_arg(*arguments, int) != 0);
    } else if (format[1] == 'l') {
        json_value(json, key, "%llu", va_arg(*arguments, unsigned long long));
    } else if (format[1] == 'z') {
        json_value(json, key, "%zu", va_arg(*arguments, size_t));
    } else if (type == 'd') {
        json_value(json, key, "%d", va_arg(*arguments, int));
    } else {
        json_value(json, key, "%u", va_arg(*arguments, unsigned));
    }
    return format + length;
}

void json_print(struct json *json, const char *format, ...)
{
    char name[NAME_SIZE] = "";
    va_list arguments;
    va_start(arguments, format);
    while (*format) {
        const char *key = name[0] ? name : NULL;
        const size_t length = strcspn(format, "{[%]}:, \n");
        if (length > 0) {
            CORE_ASSERT(length < sizeof name && format[length] == ':');
            snprintf(name, sizeof name, "%.*s", (int)length, format);
            format += length + 1u;
            continue;
        }
        const char *next = format + 1;
        if (*format == '%') {
            next = put_conversion(json, key, format, &arguments);
        } else if (*format == '{' || *format == '[') {
            json_open(json, key, *format);
        } else if (*format == '}' || *format == ']') {
            json_close(json, *format);
        } else if (*format == '\n') {
            json_line(json, (uint8_t)strspn(next, " "));
        }
        if (!strchr(" ,\n", *format)) {
            name[0] = '\0';
        }
        format = next;
    }
    va_end(arguments);
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
