/* pose_line.h -- one pose as a line of text: what a script says, and `kingyo-poi watch` prints.
 *
 *     [+MS] X Y Z PITCH YAW ROLL [KEY...]      "+400  120 -50 30  -25 0 0  OK"
 *     [+MS] lost
 *
 * Millimetres and degrees, axes as drivers/poi_report.h has them. +MS: the hand glides there in so
 * many milliseconds; without it, it is there at once. What follows a # is not read. Pure. */
#ifndef KINGYO_POI_GADGET_POSE_LINE_H
#define KINGYO_POI_GADGET_POSE_LINE_H

#include <stdint.h>

#include "drivers/poi_report.h"

#define POSE_LINE_SIZE 128u        /* With its end; six numbers, a time and five keys take 90. */
#define POSE_LINE_GLIDE_S 600.0f   /* Longer than any round. */

struct pose_line {
    float glide_s;            /* [0, POSE_LINE_GLIDE_S] */
    uint8_t lost;             /* The poi does not know where it is. */
    uint8_t buttons;          /* enum poi_button */
    struct poi_target target; /* Within +-POI_REPORT_REACH_M and a turn each way. */
};

/* 1: a pose; 0: a blank line or a remark; -1: none, and `why` is one phrase; static. */
int pose_line_read(struct pose_line *out, const char *text, const char **why);

/* The report as such a line, without a newline. */
void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE]);

#endif
