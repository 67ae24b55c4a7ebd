/* key_colour.c -- selects the colours of key shapes (the growth stages of a fish), evenly spaced
 * from red to blue. The table has a file of its own, so that the kiosk's growth lab and the
 * pictures of kingyoctl use the same colours. */
#include "platform/key_colour.h"

#include "core/morph/species.h"

enum { RED, ORANGE, YELLOW, LIME, GREEN, TEAL, BLUE, NAVY };

uint32_t key_colour(uint32_t key_count, uint32_t key)
{
    static const uint32_t colours[] = {
        [RED] = 0xd23a2c,   [ORANGE] = 0xdc7415, [YELLOW] = 0xc9a012, [LIME] = 0x7ba32b,
        [GREEN] = 0x2f9a4e, [TEAL] = 0x1c97a0,   [BLUE] = 0x2f6fd0,   [NAVY] = 0x27408b
    };
    static const uint8_t of_count[MORPH_KEY_MAX + 1u][MORPH_KEY_MAX] = {
        [2] = { RED, BLUE },
        [3] = { RED, GREEN, BLUE },
        [4] = { RED, ORANGE, GREEN, BLUE },
        [5] = { RED, ORANGE, GREEN, TEAL, BLUE },
        [6] = { RED, ORANGE, YELLOW, GREEN, TEAL, BLUE },
        [7] = { RED, ORANGE, YELLOW, GREEN, TEAL, BLUE, NAVY },
        [8] = { RED, ORANGE, YELLOW, LIME, GREEN, TEAL, BLUE, NAVY },
    };
    const uint32_t count = key_count < MORPH_KEY_MAX ? key_count : MORPH_KEY_MAX;
    return colours[of_count[count][key % MORPH_KEY_MAX]];
}
