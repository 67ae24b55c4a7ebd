/* panic_text.h -- formats and writes one line of text with async-signal-safe functions only. */
#ifndef KINGYO_PLATFORM_OS_PANIC_TEXT_H
#define KINGYO_PLATFORM_OS_PANIC_TEXT_H

#include <stddef.h>
#include <stdint.h>

#define PANIC_TEXT_MAX 1536u /* Size of a line in bytes. Longer text is cut. */

/* Buffer for one line of text. A structure of zeros is an empty line. */
struct panic_text {
    size_t used;
    char out[PANIC_TEXT_MAX]; /* Text of the line, with a terminating zero. */
};

/* panic_put() appends `words`; panic_put_number() appends `number` in decimal. Text beyond
 * PANIC_TEXT_MAX is dropped. */
void panic_put(struct panic_text *text, const char *words);
void panic_put_number(struct panic_text *text, uint32_t number);

/* Replaces unprintable characters (core/base/printable.h) and appends a line end. The line end is
 * written even if the line is full. */
void panic_put_end(struct panic_text *text);

#endif
