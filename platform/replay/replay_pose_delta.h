/* replay_pose_delta.h -- encodes the poses of pois and fans as the difference from the previous
 * poses.
 *
 * The first byte is a mask of the pois (low half) and fans (high half) that changed. One record for
 * each changed device follows. A record is a mask, one byte, the floats that changed, and a poi's
 * age as u16. The byte contains a poi's link, wrist and tremble flags, or a fan's presence. Floats
 * are stored with all their bits, because a replay must be identical even for invalid poses. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_POSE_DELTA_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_POSE_DELTA_H

#include "core/input.h"
#include "platform/replay/replay_bytes.h"

/* Maximum size in bytes: the mask of devices; for each poi a mask, a byte, six floats and an age;
 * for each fan a mask, a byte and three floats. */
#define REPLAY_POSE_DELTA_BYTES                                                                    \
    (1u + POI_MAX * (1u + 1u + 6u * 4u + 2u) + SHADE_MAX * (1u + 1u + 3u * 4u))

/* Writes at most REPLAY_POSE_DELTA_BYTES to `out`. Returns the number of bytes, or 0 if no pose
 * changed. */
size_t replay_pose_delta_encode(const struct input *before, const struct input *input,
                                uint8_t *out);

/* Updates the fields of `input` that the bytes contain. Sets rest->bad to 1 if the bytes contain
 * values that no recorder writes. */
void replay_pose_delta_decode(struct input *input, struct replay_rest *rest);

#endif
