/* key_colour.h -- the colours of key shapes, the same on every graph, sheet and page. */
#ifndef KINGYO_PLATFORM_KEY_COLOUR_H
#define KINGYO_PLATFORM_KEY_COLOUR_H

#include <stdint.h>

/* 0xRRGGBB of key `key` of `key_count` (2 .. MORPH_KEY_MAX), from the youngest on: red, green and
 * blue of three, as in the 2005 thesis; more take the colours between, so that red is always the
 * youngest and blue or what lies beyond it the oldest. */
uint32_t key_colour(uint32_t key_count, uint32_t key);

#endif
