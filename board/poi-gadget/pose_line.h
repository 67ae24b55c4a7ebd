/* pose_line.h -- one pose of the poi (a paper scoop) as a line of text. Scripts consist of pose
 * lines, and `kingyo-poi watch` prints pose lines.
 *
 * A pose line has one of two forms:
 *
 * [+MS] X Y Z PITCH YAW ROLL [KEY...], for example "+400 120 -50 30 -25 0 0 OK"
 *
 * [+MS] lost
 *
 * Positions are in millimetres and angles in degrees, in the axes of drivers/hid/poi_report.h. With
 * +MS, the hand moves smoothly to the pose in MS milliseconds. Without +MS, the hand jumps to the
 * pose. "lost" means that the position is unknown. # starts a comment. The functions are pure. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_LINE_H
#define KINGYO_BOARD_POI_GADGET_POSE_LINE_H

#include <stdint.h>

#include "drivers/hid/poi_report.h"

/* Maximum size of a line in bytes, with the terminating zero. Six numbers, a time and five keys
 * need 90 characters. */
#define POSE_LINE_SIZE 128u
/* Maximum duration of a motion in seconds, which is longer than any round of the game. */
#define POSE_LINE_GLIDE_S 600.0f

struct pose_line {
    float glide_s;            /* Duration of the motion to the pose in seconds, in [0,
                                 POSE_LINE_GLIDE_S]. */
    uint8_t lost;             /* 1 if the position of the poi is unknown, otherwise 0. */
    uint8_t buttons;          /* Bit mask of the pressed buttons (enum poi_button). */
    struct poi_target target; /* Pose of the poi. Positions are within +-POI_REPORT_REACH_M, and
                                 angles within one full turn in each direction. */
};

/* Parses a line. Returns 1 for a pose, and 0 for an empty line or a comment. If the line is
 * invalid, sets `why` to a static text and returns -1. */
int pose_line_read(struct pose_line *out, const char *text, const char **why);

/* Writes the pose of the report as a line of text without a newline. */
void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE]);

#endif
