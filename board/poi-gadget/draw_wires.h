/* draw_wires.h -- computes the point at which three draw wires meet from the lengths of the wires.
 * The functions are pure.
 *
 * Each wire leads from a spool above the tank to an eye on the neck of the poi (a paper scoop). The
 * lengths define three spheres around the spools. The spheres meet in two points, above and below
 * the plane of the spools. The eye is at the lower point. */
#ifndef KINGYO_BOARD_POI_GADGET_DRAW_WIRES_H
#define KINGYO_BOARD_POI_GADGET_DRAW_WIRES_H

#include <stdint.h>

#include "core/base/vec.h"

#define DRAW_WIRE_COUNT 3u
/* Greatest length of a wire in metres, the longest wire of cheap spools. */
#define DRAW_WIRE_MAX_M 3.0f
/* Distance in metres by which the wires may fail to meet, because wires sag and stretch and the eye
 * is 5 mm wide. */
#define DRAW_WIRE_SLACK_M 0.020f
/* Depth in metres below the plane of the spools that the eye must exceed. Nearer to the plane, the
 * computed height is too inaccurate. */
#define DRAW_WIRE_NEAR_M 0.100f

enum draw_wires_result {
    DRAW_WIRES_OK = 0,
    /* A length is invalid, because the wire is not connected or not calibrated. */
    DRAW_WIRES_LENGTH,
    /* The wires do not meet in a point, because a wire is slack, caught or broken. */
    DRAW_WIRES_APART,
    DRAW_WIRES_HIGH, /* The wires meet less than DRAW_WIRE_NEAR_M below the plane of the spools. */
    DRAW_WIRES_RESULT_COUNT,
};

/* Returns a static text that describes the result, without a full stop. */
const char *draw_wires_text(enum draw_wires_result result);

/* Returns 1 if spools at these positions determine where the three wires meet, otherwise 0. Two
 * spools must be at least 10 cm apart, and the three spools must not lie on one line. */
int draw_wires_is_determined(const vec3 spool_m[DRAW_WIRE_COUNT]);

/* Computes the position of the eye in world axes, in metres. The spools must satisfy
 * draw_wires_is_determined(). Leaves `out` unchanged unless the result is DRAW_WIRES_OK. */
enum draw_wires_result draw_wires_meet(const vec3 spool_m[DRAW_WIRE_COUNT],
                                       const float length_m[DRAW_WIRE_COUNT], vec3 *out);

/* Computes the lengths of the wires for a position of the eye, as the inverse of draw_wires_meet().
 * The simulated sensors use this function. */
void draw_wires_lengths(const vec3 spool_m[DRAW_WIRE_COUNT], vec3 eye_m,
                        float length_m[DRAW_WIRE_COUNT]);

#endif
