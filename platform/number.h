/* number.h -- numbers as people write them in options and files. Pure. */
#ifndef KINGYO_PLATFORM_NUMBER_H
#define KINGYO_PLATFORM_NUMBER_H

#include <stdint.h>

/* Decimal digits alone (leading zeros are just zeros), a value in [min, max]: 1 with `*out` set;
 * else 0 and `*out` as it was. `text` may be null. */
int number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out);

#endif
