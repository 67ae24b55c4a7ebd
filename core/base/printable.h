/* printable.h -- makes text from outside the program safe for a terminal, a log and a page.
 *
 * Names, USB strings, file contents, file names and arguments may contain any byte. A control
 * character moves the cursor of a terminal or breaks a line of a log. A bidirectional control
 * character changes the displayed order of a text. Every text from outside passes printable()
 * before it is displayed.
 *
 * The following characters are rejected: C0 controls and DEL (U+0000..U+001F, U+007F), C1 controls
 * (U+0080..U+009F), line and paragraph separators (U+2028, U+2029), and bidirectional controls
 * (U+061C, U+200E, U+200F, U+202A..U+202E, U+2066..U+2069). Every byte that is not UTF-8 as RFC
 * 3629 defines it is also rejected. */
#pragma once

#include <stdint.h>

#define PRINTABLE_MARK '?' /* Replacement for a rejected character. */
/* Code point that printable_next() returns for bytes that are not UTF-8: U+FFFD. */
#define PRINTABLE_MALFORMED 0xfffdu

/* Returns the size in bytes of the UTF-8 character at `text`, 1 to 4, or 0 if the bytes are not
 * UTF-8. `text` must end with a zero byte, for which the function returns 1. */
uint32_t printable_utf8_size(const char *text);

/* Returns the code point of the character at `text`. The caller guarantees that
 * printable_utf8_size() of `text` is not 0. */
uint32_t printable_code_point(const char *text);

/* Writes `point` as UTF-8 to `to`, 1 to 4 bytes without a zero byte at the end. `point` must be at
 * most 0x10FFFF and no surrogate. Returns the address after the last written byte. */
char *printable_put(char *to, uint32_t point);

/* Returns the code point at `*at` and advances `*at` past this code point. Returns 0 at the end of
 * the text. If the bytes at `*at` are not UTF-8, advances `*at` by one byte and returns
 * PRINTABLE_MALFORMED. */
uint32_t printable_next(const char **at);

/* Returns the number of bytes of `text` that fit into `max` bytes without splitting a UTF-8
 * character. */
uint32_t printable_fit(const char *text, uint32_t max);

/* Returns the size in bytes of the character at `text` if the character may be displayed, otherwise
 * 0. Returns 0 for the zero byte that ends `text`. */
uint32_t printable_size(const char *text);

/* Replaces each rejected character of `text`, and each byte that is not UTF-8, by PRINTABLE_MARK in
 * place. The text never becomes longer. Returns `text`. */
char *printable(char *text);
