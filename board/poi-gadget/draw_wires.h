/* draw_wires.h -- computes the point where three wires meet from their lengths. The functions are
 * pure.
 *
 * Each wire comes from a spool above the tank and ends at an eye on the poi's neck. Three spheres
 * meet in two points, one on each side of the spools' plane. The poi is at the lower point. */
#ifndef KINGYO_BOARD_POI_GADGET_DRAW_WIRES_H
#define KINGYO_BOARD_POI_GADGET_DRAW_WIRES_H

#include <stdint.h>

#include "core/base/vec.h"

#define DRAW_WIRE_COUNT 3u
#define DRAW_WIRE_MAX_M 3.0f /* Maximum wire length, the longest of cheap spools. */
/* Tolerance with which the wires may fail to meet, because of sag, stretch and the 5 mm eye. */
#define DRAW_WIRE_SLACK_M 0.020f
/* Distance from the spools' plane below which the height is too inaccurate. */
#define DRAW_WIRE_NEAR_M 0.100f

enum draw_wires_result {
    DRAW_WIRES_OK = 0,
    /* A length is not valid because a wire is not plugged in or not calibrated. */
    DRAW_WIRES_LENGTH,
    /* The wires do not meet because a wire hangs slack, is caught or is broken. */
    DRAW_WIRES_APART,
    DRAW_WIRES_HIGH, /* The wires meet within DRAW_WIRE_NEAR_M of the spools' plane. */
    DRAW_WIRES_RESULT_COUNT,
};

/* Returns a static sentence about the result, without a full stop. */
const char *draw_wires_text(enum draw_wires_result result);

/* Returns whether the three spools determine a position. No two spools may be within 10 cm of each
 * other, and the spools may not lie on one line. */
int draw_wires_is_determined(const vec3 spool_m[DRAW_WIRE_COUNT]);

/* Computes the position of the eye in the world. The spools must satisfy
 * draw_wires_is_determined(). `out` is unchanged if the result is not OK. */
enum draw_wires_result draw_wires_meet(const vec3 spool_m[DRAW_WIRE_COUNT],
                                       const float length_m[DRAW_WIRE_COUNT], vec3 *out);

/* Computes the wire lengths for a position of the eye, the inverse of draw_wires_meet(). The
 * simulation uses this function. */
void draw_wires_lengths(const vec3 spool_m[DRAW_WIRE_COUNT], vec3 eye_m,
                        float length_m[DRAW_WIRE_COUNT]);

#endif
