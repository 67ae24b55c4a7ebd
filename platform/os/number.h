/* number.h -- parses and prints numbers in options and files, independent of the locale. Pure
 * functions. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Parses a decimal integer in [min, max]. Leading zeros are permitted. Returns true and sets
 * `*out`. If `text` is null or invalid, returns false and leaves `*out` unchanged. */
bool number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out);

/* Parses a decimal number in [min, max] with an optional sign, decimal point and exponent (-1.5,
 * .25, 2e-3). Returns true and sets `*out`. Otherwise returns false and leaves `*out` unchanged.
 * Rejects null, hexadecimal numbers, infinity, NaN and more than 40 characters. */
bool number_parse_decimal(const char *text, double min, double max, double *out);

/* Writes `value` with `decimals` (0 .. 6) digits after the decimal point, rounded half away from
 * zero. |value| must be less than 1e12. Returns the number of characters written to `out`. Writes
 * no terminating zero. */
#define NUMBER_FIXED_MAX 24u
uint32_t number_print_fixed(char out[NUMBER_FIXED_MAX], double value, uint32_t decimals);
