/* json.h -- writes JSON documents to a stream or to a buffer.
 *
 * The module writes the commas between the elements. Text from outside the program, for example the
 * name of a file or a device, may contain any byte: quotes, backslashes and all characters that
 * core/base/printable.h rejects are escaped, and U+FFFD replaces each byte that is not valid UTF-8.
 * Callers pass a null `key` for the elements of an array and for the document itself. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* A document that is being written. The caller sets either `file` or `buffer` and `size`, and all
 * other fields to 0. If `file` is a stream of open_memstream(3), the stream may use `buffer` and
 * `size` for its text. */
struct json {
    FILE *file;   /* Stream that receives the document, or null. */
    char *buffer; /* Buffer that receives the document with a terminating zero. */
    size_t size;  /* Size of `buffer` in bytes. A document that does not fit fails an assertion. */
    size_t used;  /* Number of bytes that were written to `buffer`. */
    /* True if the current object or array already has an element, so that the next element needs a
     * comma. */
    bool inner;
    bool breaks; /* True if the next element or bracket is on a line of its own. */
    /* Number of blanks before the next element or bracket if it is on a line of its own. */
    uint8_t indent;
};

/* Begins an object if `bracket` is '{', or an array if `bracket` is '['. */
void json_open(struct json *json, const char *key, char bracket);

/* Ends the current object (`bracket` is '}') or array (`bracket` is ']'). */
void json_close(struct json *json, char bracket);

/* Places the next element or closing bracket on a line of its own, after `indent` blanks. */
void json_line(struct json *json, uint8_t indent);

/* Writes a value that is formatted as by printf(), for example a number or true. */
__attribute__((format(printf, 3, 4))) void json_value(struct json *json, const char *key,
                                                      const char *format, ...);

/* Writes several elements. `format` has the form of the written JSON text without its quotes, for
 * example "{entries: %u, name: %s, hash: %016llx}". The format may end inside an object or array,
 * and further calls then write the rest.
 *
 * The conversions are those of printf(): %u, %d, %llu, %zu, %.Nf and %.Ng write a number, %s writes
 * a string, %016llx writes a string of 16 hexadecimal digits, and %hhd writes true or false. N has
 * one digit. For %.Nf and %.Ng, the value NaN is written as null. A line break in `format` that is
 * followed by blanks places the next element or closing bracket on a line of its own, after the
 * same number of blanks. Commas and other blanks in `format` have no effect. */
__attribute__((format(printf, 2, 3))) void json_print(struct json *json, const char *format, ...);

/* Writes true or false. */
void json_bool(struct json *json, const char *key, bool value);

/* Writes a string in quotes. */
void json_text(struct json *json, const char *key, const char *words);

/* Ends the document with a line end. */
void json_end(struct json *json);

/* Writes the JSON document `document` to standard output. Characters that printable.h rejects are
 * escaped, because valid JSON has them only inside strings. Line breaks and tabs between tokens are
 * kept. */
void json_copy(const char *document);
