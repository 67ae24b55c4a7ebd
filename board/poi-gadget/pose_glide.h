/* pose_glide.h -- a simulated hand that moves smoothly from pose to pose. The functions are
 * pure. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_GLIDE_H
#define KINGYO_BOARD_POI_GADGET_POSE_GLIDE_H

#include "board/poi-gadget/pose_line.h"

struct pose_glide {
    uint8_t begun; /* 1 if the hand has a pose. */
    struct pose_line from, to;
    float at_s; /* Seconds since the start of the glide, up to to.glide_s. */
};

/* Returns whether the hand has reached its goal. Also returns true if no goal was set yet. */
int pose_glide_is_there(const struct pose_glide *glide);

/* Sets the next goal. The hand jumps to the goal if it has no present position, which is the case
 * at the start and after a lost pose. */
void pose_glide_send(struct pose_glide *glide, const struct pose_line *to);

/* Advances the hand by `seconds`, and writes position, angles and buttons to `out`. A goal must
 * have been set before. */
void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out);

#endif
