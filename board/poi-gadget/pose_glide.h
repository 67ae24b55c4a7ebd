/* pose_glide.h -- simulates a hand that moves the poi (a paper scoop) smoothly from pose to pose.
 * The functions are pure. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_GLIDE_H
#define KINGYO_BOARD_POI_GADGET_POSE_GLIDE_H

#include "board/poi-gadget/pose_line.h"

struct pose_glide {
    uint8_t begun; /* 1 after the hand has had a first pose, otherwise 0. */
    struct pose_line from, to;
    float at_s; /* Time in seconds since the start of the present motion, at most `to.glide_s`. */
};

/* Returns 1 if the hand has reached its goal, or if no goal has been set. Otherwise returns 0. */
int pose_glide_is_there(const struct pose_glide *glide);

/* Sets the next goal, which starts a new motion. If the present position is unknown, at the start
 * and after a lost pose, the hand jumps to the goal. */
void pose_glide_send(struct pose_glide *glide, const struct pose_line *to);

/* Advances the motion by `seconds`, and writes the position, the angles and the buttons to `out`.
 * pose_glide_send() must have been called before. */
void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out);

#endif
