/* number.h -- numbers as people write them in options and files, and as programs read them. Pure:
 * no locale has a say. */
#ifndef KINGYO_PLATFORM_NUMBER_H
#define KINGYO_PLATFORM_NUMBER_H

#include <stdint.h>

/* Decimal digits alone (leading zeros are just zeros), a value in [min, max]: 1 with `*out` set;
 * else 0 and `*out` as it was. `text` may be null. */
int number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out);

/* A decimal with an optional sign, point and exponent (-1.5, .25, 2e-3), a value in [min, max]: 1
 * with `*out` set; else 0 and `*out` as it was. No hexadecimal, infinity or NaN. At most 40
 * characters; `text` may be null. */
int number_parse_decimal(const char *text, double min, double max, double *out);

/* `value` with `decimals` 0 .. 6 digits behind a point, rounded half away from zero, with no end
 * sign: how many characters went to `out`. |value| < 1e12. */
#define NUMBER_FIXED_MAX 24u
uint32_t number_print_fixed(char out[NUMBER_FIXED_MAX], double value, uint32_t decimals);

#endif
