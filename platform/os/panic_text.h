/* panic_text.h -- builds and writes one line with async-signal-safe calls only. */
#ifndef KINGYO_PLATFORM_OS_PANIC_TEXT_H
#define KINGYO_PLATFORM_OS_PANIC_TEXT_H

#include <stddef.h>
#include <stdint.h>

#define PANIC_TEXT_MAX 1536u /* Length of a log line; longer text is cut. */

/* A line of text. Zero is an empty line. */
struct panic_text {
    size_t used;
    char out[PANIC_TEXT_MAX]; /* Zero-terminated. */
};

/* Append text, or a decimal number. Text beyond PANIC_TEXT_MAX is dropped. */
void panic_put(struct panic_text *text, const char *words);
void panic_put_number(struct panic_text *text, uint32_t number);

/* Makes the line printable (core/base/printable.h) and appends the line end, even if the line is
 * full. */
void panic_put_end(struct panic_text *text);

/* Writes all bytes and retries after an interruption. Returns 0 or a negative errno. */
int panic_write(int fd, const void *bytes, size_t size);

#endif
