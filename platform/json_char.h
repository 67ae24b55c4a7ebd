/* json_char.h -- words that others wrote, as they may stand in JSON.
 *
 * A file's or a device's name may be anything at all, or cut off in a character. Quotes and control
 * characters would break the text, and so would what is no UTF-8: U+FFFD stands there instead. */
#ifndef KINGYO_PLATFORM_JSON_CHAR_H
#define KINGYO_PLATFORM_JSON_CHAR_H

#define JSON_CHAR_SIZE 7u /* Six bytes at most, and a zero. */

/* Writes the first character of `words`, which are not empty, as text, and returns the rest. */
const char *json_char(const char *words, char out[JSON_CHAR_SIZE]);

/* All of them on standard output, in quotes. */
void json_print(const char *words);

#endif
