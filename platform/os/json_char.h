/* json_char.h -- escapes text from outside the program for JSON.
 *
 * The name of a file or a device may contain any byte. Quotes, backslashes and all characters that
 * core/base/printable.h rejects are escaped. U+FFFD replaces each byte that is not valid UTF-8. */
#ifndef KINGYO_PLATFORM_OS_JSON_CHAR_H
#define KINGYO_PLATFORM_OS_JSON_CHAR_H

/* Size of one escaped character: at most six bytes and a terminating zero. */
#define JSON_CHAR_SIZE 7u

/* Writes the first character of `words` in escaped form to `out`. The caller guarantees that
 * `words` is not empty. Returns the rest of `words`. */
const char *json_char(const char *words, char out[JSON_CHAR_SIZE]);

/* Writes `words` to standard output as a JSON string in quotes. */
void json_print(const char *words);

/* Writes the JSON document `json` to standard output. Characters that printable.h rejects are
 * escaped, because valid JSON has them only inside strings. Line breaks and tabs between tokens are
 * kept. */
void json_print_text(const char *json);

#endif
