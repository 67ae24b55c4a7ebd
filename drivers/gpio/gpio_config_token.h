/* gpio_config_token.h -- parses tokens of a wiring text. A private part of gpio_config.c. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_CONFIG_TOKEN_H
#define KINGYO_DRIVERS_GPIO_GPIO_CONFIG_TOKEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A part of the text, whose bytes the caller owns. */
struct gpio_config_token {
    const char *at;
    size_t length;
};

bool gpio_config_token_is(struct gpio_config_token word, const char *text);

/* Returns true and removes `prefix` if `word` starts with it. */
bool gpio_config_token_parse_off(struct gpio_config_token *word, const char *prefix);

/* Splits `rest` at the first `mark`. Returns the part before it, or all of `rest` if there is no
 * mark. */
struct gpio_config_token gpio_config_token_split(struct gpio_config_token *rest, char mark);

/* Parses and removes leading digits. Returns false if there are none or if the value exceeds
 * `max`. */
bool gpio_config_token_parse_number(struct gpio_config_token *word, uint32_t max, uint32_t *out);

/* Parse two times with `mark` between them, or a single time. Valid times are 1 us to
 * GPIO_TIME_US_MAX. */
bool gpio_config_token_parse_times(struct gpio_config_token word, char mark, uint32_t *first_us,
                                   uint32_t *second_us);
bool gpio_config_token_parse_time(struct gpio_config_token word, uint32_t *out_us);

#endif
