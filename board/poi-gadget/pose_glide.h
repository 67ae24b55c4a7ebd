/* pose_glide.h -- a hand that goes from pose to pose, as smoothly as one does. Pure. */
#ifndef KINGYO_POI_GADGET_POSE_GLIDE_H
#define KINGYO_POI_GADGET_POSE_GLIDE_H

#include "board/poi-gadget/pose_line.h"

struct pose_glide {
    uint8_t begun; /* It has a pose. */
    struct pose_line from, to;
    float at_s;    /* Of to.glide_s. */
};

/* The hand is where it was sent; also before it was sent anywhere. */
int pose_glide_is_there(const struct pose_glide *glide);

/* Sends it on; at once where it has no place to come from: at the start, or it was lost. */
void pose_glide_send(struct pose_glide *glide, const struct pose_line *to);

/* Where it is `seconds` later: place, angles and buttons of `out`. It was sent somewhere before. */
void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out);

#endif
