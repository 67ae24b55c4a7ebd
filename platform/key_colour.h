/* key_colour.h -- the colours of key shapes, the same on every graph, sheet and page. */
#ifndef KINGYO_PLATFORM_KEY_COLOUR_H
#define KINGYO_PLATFORM_KEY_COLOUR_H

#include <stdint.h>

/* Returns the colour 0xRRGGBB of key `key` out of `key_count` (2 .. MORPH_KEY_MAX), counted from
 * the youngest. Three keys are red, green and blue, as in the 2005 thesis. More keys use the
 * colours between and beyond, so that the youngest is always red and the oldest blue or navy. */
uint32_t key_colour(uint32_t key_count, uint32_t key);

#endif
