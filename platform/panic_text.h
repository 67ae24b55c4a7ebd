/* panic_text.h -- builds and writes a line with async-signal-safe calls alone. */
#ifndef KINGYO_PLATFORM_PANIC_TEXT_H
#define KINGYO_PLATFORM_PANIC_TEXT_H

#include <stddef.h>
#include <stdint.h>

#define PANIC_TEXT_MAX 1536u /* As long as a line of the log; what is longer is cut. */

/* Zero is an empty line. */
struct panic_text {
    size_t used;
    char out[PANIC_TEXT_MAX]; /* Zero-terminated. */
};

void panic_put(struct panic_text *text, const char *words);
void panic_put_number(struct panic_text *text, uint32_t number);

/* Makes the line printable (core/base/printable.h) and ends it, also one that is full. */
void panic_put_end(struct panic_text *text);

/* Writes all bytes, also after an interruption. Returns 0 or a negative errno. */
int panic_write(int fd, const void *bytes, size_t size);

#endif
