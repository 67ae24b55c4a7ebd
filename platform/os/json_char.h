/* json_char.h -- escapes text from outside the program for JSON.
 *
 * The name of a file or a device may hold any byte. Quotes, backslashes and every character that
 * core/base/printable.h rejects are escaped. U+FFFD replaces a byte that is not UTF-8. */
#ifndef KINGYO_PLATFORM_OS_JSON_CHAR_H
#define KINGYO_PLATFORM_OS_JSON_CHAR_H

#define JSON_CHAR_SIZE 7u /* At most six bytes and a terminating zero. */

/* Writes the first character of `words`, which must not be empty, as it appears in a JSON string.
 * Returns the rest of `words`. */
const char *json_char(const char *words, char out[JSON_CHAR_SIZE]);

/* Writes `words` as a JSON string, with its quotes, to standard output. */
void json_print(const char *words);

/* Writes complete JSON text to standard output unchanged, except for characters that printable.h
 * rejects. Such characters are escaped because in JSON they can only appear in a string. Line
 * breaks and tabs between tokens are kept. */
void json_print_text(const char *json);

#endif
