/* replay_pose_delta.h -- encodes poi and fan poses as the difference from the previous poses.
 *
 * A mask of pois (low half) and fans (high half) is followed by one record for each changed device.
 * A record is a mask of its own, one byte, the floats that changed as their bits, and a poi's age
 * as u16. The byte contains a poi's link, wrist and tremble flags, or a fan's presence. Floats are
 * stored exactly, because a replay must be equal to the last bit, even for invalid poses. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_POSE_DELTA_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_POSE_DELTA_H

#include "core/input.h"
#include "platform/replay/replay_bytes.h"

/* Largest size: a mask of devices; each poi with a mask, a link, six floats and an age; each fan
 * with a mask, its presence and three floats. */
#define REPLAY_POSE_DELTA_BYTES                                                                    \
    (1u + POI_MAX * (1u + 1u + 6u * 4u + 2u) + SHADE_MAX * (1u + 1u + 3u * 4u))

/* Writes at most REPLAY_POSE_DELTA_BYTES to `out`. Returns the number of bytes, 0 if no pose
 * changed. */
size_t replay_pose_delta_encode(const struct input *before, const struct input *input,
                                uint8_t *out);

/* Updates the fields that the bytes name. Sets `rest->bad` if the bytes contain values that no
 * recorder writes. */
void replay_pose_delta_decode(struct input *input, struct replay_rest *rest);

#endif
