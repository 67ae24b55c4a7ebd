/* scoop.h -- a simulated hand that scoops repeatedly without vision, for tests of a kiosk without
 * sensors.
 *
 * One scoop presses START and holds a still shade, which attracts fish. Then the poi dips slanted
 * along the paper's plane, glides under the fish, and lifts level so that the water drains. Finally
 * the poi moves to the first player's bowl in the festival tank and tips. Each scoop dips at
 * another position, so that the scoops cover the whole tank. The functions are pure. */
#ifndef KINGYO_BOARD_POI_GADGET_SCOOP_H
#define KINGYO_BOARD_POI_GADGET_SCOOP_H

#include "board/poi-gadget/pose_glide.h"

struct scoop {
    uint32_t stroke; /* Number of strokes since the start. A scoop has SCOOP_STROKES strokes. */
    struct pose_glide glide;
};

#define SCOOP_STROKES 8u

/* Advances the hand by `seconds` and writes its pose to `out`. Initialize the struct with zeros. */
void scoop_step(struct scoop *scoop, float seconds, struct poi_report *out);

#endif
