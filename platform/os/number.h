/* number.h -- parses and prints the numbers in options and files, independent of the locale.
 * Pure. */
#ifndef KINGYO_PLATFORM_OS_NUMBER_H
#define KINGYO_PLATFORM_OS_NUMBER_H

#include <stdint.h>

/* Parses decimal digits, with leading zeros allowed, to a value in [min, max]. Returns 1 and sets
 * `*out`, else returns 0 and leaves `*out` unchanged. `text` may be null. */
int number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out);

/* Parses a decimal with an optional sign, point and exponent (-1.5, .25, 2e-3) to a value in [min,
 * max]. Returns 1 and sets `*out`, else returns 0 and leaves `*out` unchanged. Rejects hexadecimal,
 * infinity, NaN and more than 40 characters. `text` may be null. */
int number_parse_decimal(const char *text, double min, double max, double *out);

/* Writes `value`, |value| < 1e12, with `decimals` (0 .. 6) digits after the point, rounded half
 * away from zero. Returns the number of characters in `out`; no terminating zero is written. */
#define NUMBER_FIXED_MAX 24u
uint32_t number_print_fixed(char out[NUMBER_FIXED_MAX], double value, uint32_t decimals);

#endif
