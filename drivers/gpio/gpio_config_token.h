/* gpio_config_token.h -- parses tokens of a wiring text, such as "debounce=5ms". A private part of
 * gpio_config.c. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_CONFIG_TOKEN_H
#define KINGYO_DRIVERS_GPIO_GPIO_CONFIG_TOKEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A part of the wiring text. The caller owns the bytes, which are not terminated by 0. */
struct gpio_config_token {
    const char *at;
    size_t length;
};

/* Returns true if `word` equals `text`. */
bool gpio_config_token_is(struct gpio_config_token word, const char *text);

/* Returns true and removes `prefix` from `word` if `word` starts with `prefix`, otherwise returns
 * false. */
bool gpio_config_token_parse_off(struct gpio_config_token *word, const char *prefix);

/* Splits `rest` at the first `mark`. Returns the part before the mark and keeps the part after the
 * mark in `rest`. If there is no mark, returns all of `rest`. */
struct gpio_config_token gpio_config_token_split(struct gpio_config_token *rest, char mark);

/* Parses leading digits into `out` and removes them from `word`. Returns false if there are no
 * digits or if the value exceeds `max`. */
bool gpio_config_token_parse_number(struct gpio_config_token *word, uint32_t max, uint32_t *out);

/* Parses two times that are separated by `mark`. Returns false unless each time is 1 us to
 * GPIO_TIME_US_MAX. */
bool gpio_config_token_parse_times(struct gpio_config_token word, char mark, uint32_t *first_us,
                                   uint32_t *second_us);
/* Parses a single time. Returns false unless the time is 1 us to GPIO_TIME_US_MAX. */
bool gpio_config_token_parse_time(struct gpio_config_token word, uint32_t *out_us);

#endif
