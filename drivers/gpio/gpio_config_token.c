/* gpio_config_token.c -- parses the tokens, numbers and times of a wiring text. */
#include "drivers/gpio/gpio_config_token.h"

#include <ctype.h>
#include <string.h>

#include "drivers/gpio/gpio_config.h"

bool gpio_config_token_is(struct gpio_config_token word, const char *text)
{
    return word.length == strlen(text) && memcmp(word.at, text, word.length) == 0;
}

bool gpio_config_token_parse_off(struct gpio_config_token *word, const char *prefix)
{
    const size_t length = strlen(prefix);
    if (word->length < length || memcmp(word->at, prefix, length) != 0) {
        return false;
    }
    *word = (struct gpio_config_token){ word->at + length, word->length - length };
    return true;
}

struct gpio_config_token gpio_config_token_split(struct gpio_config_token *rest, char mark)
{
    const char *at = rest->length ? memchr(rest->at, mark, rest->length) : NULL;
    const size_t length = at ? (size_t)(at - rest->at) : rest->length;
    const size_t taken = at ? length + 1u : length;
    const struct gpio_config_token first = { rest->at, length };
    *rest = (struct gpio_config_token){ rest->at + taken, rest->length - taken };
    return first;
}

bool gpio_config_token_parse_number(struct gpio_config_token *word, uint32_t max, uint32_t *out)
{
    uint64_t value = 0;
    size_t i = 0;
    while (i < word->length && isdigit((unsigned char)word->at[i])) {
        value = value * 10u + (uint64_t)(word->at[i] - '0');
        if (value > max) {
            return false;
        }
        i++;
    }
    *word = (struct gpio_config_token){ word->at + i, word->length - i };
    *out = (uint32_t)value;
    return i > 0;
}

bool gpio_config_token_parse_time(struct gpio_config_token word, uint32_t *out_us)
{
    static const struct {
        const char *unit;
        uint32_t us;
    } units[] = { { "us", 1 }, { "ms", 1000 }, { "s", 1000000 } };
    uint32_t number;
    if (!gpio_config_token_parse_number(&word, GPIO_TIME_US_MAX, &number)) {
        return false;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (gpio_config_token_is(word, units[i].unit)) {
            *out_us = number * units[i].us;
            return number >= 1 && number <= GPIO_TIME_US_MAX / units[i].us;
        }
    }
    return false;
}

bool gpio_config_token_parse_times(struct gpio_config_token word, char mark, uint32_t *first_us,
                                   uint32_t *second_us)
{
    const struct gpio_config_token first = gpio_config_token_split(&word, mark);
    return gpio_config_token_parse_time(first, first_us) &&
           gpio_config_token_parse_time(word, second_us);
}
