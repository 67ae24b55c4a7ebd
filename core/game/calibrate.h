/* calibrate.h -- what a seat's controller says, set right: where it is over the tank, how level.
 *
 * A poi's sensors know their own frame, not the cabinet's: it is shifted, turned, stretched, skewed
 * against the tank. Whoever lays the poi on the tank's four marks and then flat on the still water
 * has said enough to undo that. Nine settings a seat hold it (SET_CALIBRATION and on), in
 * millionths of a metre, of a radian or of a whole, so that 0 is "nothing to set right":
 *
 *   x' = (1 + xx) x + xz z + x0      y' = y + y0      pitch' = pitch + p
 *   z' = zx x + (1 + zz) z + z0                       roll'  = roll + r
 *
 * Each of them is an entry of the ledger, and a power cut may come between two. A tenth that agrees
 * with the nine is written last (SET_CALIBRATION_CHECK): where it does not, what is there is part
 * of one map and part of another, and nothing is set right by it.
 *
 * The handle's yaw turns with x and z. Recordings hold what the controller said: it is set right
 * within the core, each tick anew. */
#ifndef KINGYO_CORE_GAME_CALIBRATE_H
#define KINGYO_CORE_GAME_CALIBRATE_H

#include <stdint.h>

#include "core/input.h"
#include "core/settings.h"

#define CALIBRATE_CORNERS 4u
#define CALIBRATE_INSET_M 0.08f    /* A mark is so far from both walls: a ring lies flat there. */
#define CALIBRATE_NEAR_M 0.02f     /* Corners that are said to be nearer are one. */
#define CALIBRATE_RESIDUAL_M 0.015f /* So far off the marks, as the root of the mean square, is a
                                      hand that aims well and an honest sensor. */
#define CALIBRATE_TILT_RAD (45.0f * F_DEG) /* More is a poi that was not laid flat. */

enum calibration_value {
    CALIBRATION_XX = 0,
    CALIBRATION_XZ,
    CALIBRATION_X0,
    CALIBRATION_ZX,
    CALIBRATION_ZZ,
    CALIBRATION_Z0,
    CALIBRATION_Y0,
    CALIBRATION_PITCH,
    CALIBRATION_ROLL,
    CALIBRATION_VALUES,
};

/* Why nothing can be made of what was said, in the order in which it is looked for. */
enum calibration_fault {
    CALIBRATION_GOOD = 0,
    CALIBRATION_NEAR,     /* Two corners are one. */
    CALIBRATION_CROSSED,  /* Their order makes no tank, or they lie in one line. */
    CALIBRATION_MIRRORED, /* They go round the other way: no hand is the mirror of another. */
    CALIBRATION_FAR,      /* More than the settings can hold: ten times a whole, or 10 m. */
    CALIBRATION_UNEVEN,   /* No such map brings all four to their marks. */
    CALIBRATION_TILTED,   /* It was not laid flat. */
    CALIBRATION_FAULTS,
};

/* What a controller said, as it said it. */
struct calibration_said {
    vec3 corner_m[CALIBRATE_CORNERS]; /* On the marks, in their order. */
    struct poi_target water;          /* Laid flat on the still water, anywhere. */
    uint8_t has_wrist;                /* 0: its angles mean nothing. */
};

/* Where the marks are on the water: far left, far right, near right, near left. */
vec3 calibration_mark(vec3 tank_size_m, uint32_t corner);

/* By least squares over the corners. `out` is filled where it is good. */
enum calibration_fault calibration_solve(const struct calibration_said *said, vec3 tank_size_m,
                                         int32_t out[CALIBRATION_VALUES]);

/* The first of a seat's settings; `seat` < POI_MAX. */
static inline uint32_t calibration_setting(uint32_t seat)
{
    return SET_CALIBRATION + seat * CALIBRATION_VALUES;
}

static inline uint32_t calibration_check_setting(uint32_t seat)
{
    return SET_CALIBRATION_CHECK + seat;
}

/* What a seat's check must be beside these; 0 for none, and for no others. */
int32_t calibration_check(const int32_t value[CALIBRATION_VALUES]);

/* Whether a seat has anything to set right, and all of it. */
int calibration_is_set(const struct settings *settings, uint32_t seat);

/* Whether it has values that were not all written. */
int calibration_is_torn(const struct settings *settings, uint32_t seat);

/* Sets right what a live controller says. What cannot be read stays as it is, and so does, to the
 * bit, all that a seat without a calibration says. */
void calibration_apply(const struct settings *settings, uint32_t seat, struct poi_input *poi);

#endif
