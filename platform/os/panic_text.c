/* panic_text.c -- formats text without stdio, because a signal may arrive while a thread holds the
 * stdio lock. */
#include "platform/os/panic_text.h"

#include <string.h>

#include "core/base/printable.h"

void panic_put(struct panic_text *text, const char *words)
{
    while (*words && text->used + 1u < PANIC_TEXT_MAX) {
        text->out[text->used++] = *words++;
    }
    text->out[text->used] = '\0';
}

void panic_put_number(struct panic_text *text, uint32_t number)
{
    char digits[11];
    size_t at = sizeof digits - 1u;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0);
    panic_put(text, digits + at);
}

void panic_put_end(struct panic_text *text)
{
    printable(text->out);
    text->used = strlen(text->out);
    if (text->used + 1u == PANIC_TEXT_MAX) {
        text->used--;
    }
    panic_put(text, "\n");
}
