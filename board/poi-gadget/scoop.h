/* scoop.h -- a hand that scoops, again and again, without eyes: who tests a kiosk needs no sensors.
 *
 * One scoop is START, a still shade that gathers fish, a slanted dip along the paper's plane, a
 * glide under whoever came, a level lift that drains, the way to the first player's bowl of the
 * festival tank, and the tip. Each dips elsewhere: the whole tank gets its turn. Pure. */
#ifndef KINGYO_POI_GADGET_SCOOP_H
#define KINGYO_POI_GADGET_SCOOP_H

#include "board/poi-gadget/pose_glide.h"

struct scoop {
    uint32_t stroke; /* Strokes since the start: SCOOP_STROKES to a scoop. */
    struct pose_glide glide;
};

#define SCOOP_STROKES 8u

/* Where the hand is `seconds` later. A zeroed struct is a fresh one. */
void scoop_step(struct scoop *scoop, float seconds, struct poi_report *out);

#endif
