/* draw_wires.h -- where three wires meet, by how long they are. Pure.
 *
 * Each wire comes out of a spool over the tank and ends at one eye on the poi's neck. Three spheres
 * meet in two points, one on each side of the spools' plane; the poi hangs under it. */
#ifndef KINGYO_POI_GADGET_DRAW_WIRES_H
#define KINGYO_POI_GADGET_DRAW_WIRES_H

#include <stdint.h>

#include "core/base/vec.h"

#define DRAW_WIRE_COUNT 3u
#define DRAW_WIRE_MAX_M 3.0f      /* The longest spools that are sold cheaply. */
#define DRAW_WIRE_SLACK_M 0.020f  /* So far they may fail to meet: sag, stretch, an eye of 5 mm. */
#define DRAW_WIRE_NEAR_M 0.100f   /* Nearer to the spools' plane a height is a guess. */

enum draw_wires_result {
    DRAW_WIRES_OK = 0,
    DRAW_WIRES_LENGTH, /* One is no length of a wire: not plugged in, or not calibrated. */
    DRAW_WIRES_APART,  /* They do not meet: one hangs slack, is caught, or is broken. */
    DRAW_WIRES_HIGH,   /* They meet within DRAW_WIRE_NEAR_M of the spools' plane. */
    DRAW_WIRES_RESULT_COUNT,
};

/* One sentence without a full stop; static. */
const char *draw_wires_text(enum draw_wires_result result);

/* Whether the spools span a plane that one can hang under: no two within 10 cm, no line. */
int draw_wires_can_tell(const vec3 spool_m[DRAW_WIRE_COUNT]);

/* The eye, in the world, of spools that can tell. `out` is kept where the result is not OK. */
enum draw_wires_result draw_wires_meet(const vec3 spool_m[DRAW_WIRE_COUNT],
                                       const float length_m[DRAW_WIRE_COUNT], vec3 *out);

/* The way back: what a simulation pulls out. */
void draw_wires_lengths(const vec3 spool_m[DRAW_WIRE_COUNT], vec3 eye_m,
                        float length_m[DRAW_WIRE_COUNT]);

#endif
