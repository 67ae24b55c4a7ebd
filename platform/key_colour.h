/* key_colour.h -- returns the colours of key shapes for all graphs, contact sheets and
 * documentation pages. A key shape is one modelled growth stage of a fish. */
#pragma once

#include <stdint.h>

/* Returns the colour 0xRRGGBB of key shape `key`, counted from 0 for the youngest, out of
 * `key_count` (2 .. MORPH_KEY_MAX). Three key shapes are red, green and blue, as in the 2005
 * thesis. Other values of `key_count` use intermediate colours. The youngest is always red, and the
 * oldest is blue or navy. */
uint32_t key_colour(uint32_t key_count, uint32_t key);
