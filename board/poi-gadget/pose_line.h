/* pose_line.h -- one pose as a line of text, in the form that scripts use and `kingyo-poi watch`
 * prints.
 *
 * [+MS] X Y Z PITCH YAW ROLL [KEY...], for example "+400 120 -50 30 -25 0 0 OK"
 *
 * [+MS] lost
 *
 * Positions are in millimetres and angles in degrees, with the axes of drivers/hid/poi_report.h.
 * With +MS, the hand glides to the pose in the given number of milliseconds. Without +MS, the hand
 * jumps to the pose. # starts a comment. The functions are pure. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_LINE_H
#define KINGYO_BOARD_POI_GADGET_POSE_LINE_H

#include <stdint.h>

#include "drivers/hid/poi_report.h"

/* Maximum size of a line with its terminating zero. Six numbers, a time and five keys need 90
 * characters. */
#define POSE_LINE_SIZE 128u
/* Maximum duration of a glide in seconds, longer than any round. */
#define POSE_LINE_GLIDE_S 600.0f

struct pose_line {
    float glide_s;            /* Duration of the glide in seconds, in [0, POSE_LINE_GLIDE_S]. */
    uint8_t lost;             /* 1 if the position of the poi is unknown. */
    uint8_t buttons;          /* Pressed buttons, enum poi_button. */
    struct poi_target target; /* Pose within +-POI_REPORT_REACH_M and one turn in each direction. */
};

/* Parses a line. Returns 1 for a pose and 0 for an empty line or a comment. Returns -1 and sets
 * `why` to a static phrase for a line that is not valid. */
int pose_line_read(struct pose_line *out, const char *text, const char **why);

/* Writes the report as a pose line without a newline. */
void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE]);

#endif
