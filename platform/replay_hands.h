/* replay_hands.h -- what hands hold, as the bytes that differ from those before.
 *
 * A mask of pois (low half) and shades (high half), and of each of these a mask of its own, one
 * byte (a poi's link, wrist and trembling, a shade's presence), those floats that changed, as their
 * bits, and a poi's age as u16. Floats travel whole: a play must come back to the last bit, and of
 * a hand that broke each counts. */
#ifndef KINGYO_PLATFORM_REPLAY_HANDS_H
#define KINGYO_PLATFORM_REPLAY_HANDS_H

#include "core/input.h"
#include "platform/replay_bytes.h"

/* A mask of hands, each poi with a mask, a link, six floats and an age, each shade with a mask, its
 * presence and three floats. */
#define REPLAY_HANDS_BYTES                                                                         \
    (1u + POI_MAX * (1u + 1u + 6u * 4u + 2u) + SHADE_MAX * (1u + 1u + 3u * 4u))

/* Writes to `out`, at most REPLAY_HANDS_BYTES; returns how many: 0 when no hand moved. */
size_t replay_encode_hands(const struct input *before, const struct input *input, uint8_t *out);

/* Changes what the bytes name; `rest->bad` when they say what no recorder writes. */
void replay_decode_hands(struct input *input, struct replay_rest *rest);

#endif
