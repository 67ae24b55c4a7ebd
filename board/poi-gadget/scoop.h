/* scoop.h -- simulates a hand that scoops repeatedly without vision, so that a kiosk can be tested
 * without sensors.
 *
 * For each scoop, the hand presses START and holds the poi (a paper scoop) still above the water,
 * because its shade attracts fish. The poi then enters the water slanted, in the direction of its
 * paper's plane, glides under the fish, and is lifted level so that the water drains. Finally the
 * poi moves to the bowl of the first player in the festival tank and tips. The scoops enter the
 * water at different positions that cover the whole tank. The functions are pure. */
#ifndef KINGYO_BOARD_POI_GADGET_SCOOP_H
#define KINGYO_BOARD_POI_GADGET_SCOOP_H

#include "board/poi-gadget/pose_glide.h"

struct scoop {
    uint32_t stroke; /* Number of strokes since the start. Each scoop consists of SCOOP_STROKES
                        strokes. */
    struct pose_glide glide;
};

#define SCOOP_STROKES 8u

/* Advances the hand by `seconds` and writes its pose to `out`. All fields of `scoop` must be 0
 * before the first call. */
void scoop_step(struct scoop *scoop, float seconds, struct poi_report *out);

#endif
