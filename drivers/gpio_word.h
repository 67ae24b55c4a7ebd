/* gpio_word.h -- the words that wiring is written with. gpio_wires.c's own. */
#ifndef KINGYO_DRIVERS_GPIO_WORD_H
#define KINGYO_DRIVERS_GPIO_WORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A piece of the text: its bytes are the caller's. */
struct gpio_word {
    const char *at;
    size_t length;
};

bool gpio_word_is(struct gpio_word word, const char *text);

/* Whether `word` begins with `prefix`, which is then taken off. */
bool gpio_word_takes_off(struct gpio_word *word, const char *prefix);

/* The part of `rest` before `mark`, and `rest` behind it; all of it where there is no mark. */
struct gpio_word gpio_word_split(struct gpio_word *rest, char mark);

/* Digits up to `max`, taken off the front. */
bool gpio_word_takes_number(struct gpio_word *word, uint32_t max, uint32_t *out);

/* Two times of 1 us to GPIO_TIME_US_MAX with `mark` between them; one that is read alone. */
bool gpio_word_reads_times(struct gpio_word word, char mark, uint32_t *first_us,
                           uint32_t *second_us);
bool gpio_word_reads_time(struct gpio_word word, uint32_t *out_us);

#endif
