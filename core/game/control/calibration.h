/* calibration.h -- calibration of a slot's controller: corrects the position over the tank and the
 * tilt.
 *
 * A sensor measures in its own frame, which is shifted, rotated, scaled and skewed against the
 * tank. The operator places the poi on four marks of the tank and then flat on the still water. The
 * measured poses determine the correction. Nine settings per slot, beginning at SET_CALIBRATION,
 * store the correction in millionths of a metre, of a radian or of 1. A value of 0 means no
 * correction. The corrected pose (x', y', z', pitch', roll') is:
 *
 *   x' = (1 + xx) * x + xz * z + x0      y' = y + y0      pitch' = pitch + p
 *   z' = zx * x + (1 + zz) * z + z0                       roll'  = roll + r
 *
 * Each setting is a separate ledger entry, and a power cut may occur between two entries. A check
 * value is therefore written last (SET_CALIBRATION_CHECK). If the check value does not match the
 * nine settings, the correction is incomplete and is not applied.
 *
 * The handle's yaw rotates with x and z. Recordings store the uncorrected pose; the core corrects
 * the pose in every tick. */
#ifndef KINGYO_CORE_GAME_CONTROL_CALIBRATION_H
#define KINGYO_CORE_GAME_CONTROL_CALIBRATION_H

#include <stdint.h>

#include "core/input.h"
#include "core/settings.h"

#define CALIBRATE_CORNERS 4u
/* Distance of a mark from each of the two nearest walls, at which the ring can lie flat. */
#define CALIBRATE_INSET_M 0.08f
/* Distance of two measured corners below which they count as the same corner. */
#define CALIBRATE_NEAR_M 0.02f
/* Largest allowed root mean square error at the marks. With careful aiming and a working sensor the
 * error stays below this limit. */
#define CALIBRATE_RESIDUAL_M 0.015f
/* Largest allowed tilt. A larger tilt means that the poi did not lie flat. */
#define CALIBRATE_TILT_RAD (45.0f * F_DEG)

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

/* Results of a calibration: CALIBRATION_GOOD, or the reason for its rejection, in the order of the
 * checks. */
enum calibration_fault {
    CALIBRATION_GOOD = 0,
    CALIBRATION_NEAR,     /* Two measured corners are at the same place. */
    CALIBRATION_CROSSED,  /* The corners were not measured in the order of a rectangle's corners, or
                             all lie on one line. */
    CALIBRATION_MIRRORED, /* The corners are in mirrored order, which no rotation of the sensor can
                             cause. */
    CALIBRATION_FAR,      /* The correction exceeds the range of the settings, which is a factor of
                             10 or 10 m. */
    CALIBRATION_UNEVEN,   /* No linear map brings all four corners close to their marks. */
    CALIBRATION_TILTED,   /* The poi did not lie flat on the water. */
    CALIBRATION_FAULTS,
};

/* Uncorrected poses measured during a calibration. */
struct calibration_said {
    vec3 corner_m[CALIBRATE_CORNERS]; /* Poses on the marks, in the order of calibration_mark(). */
    struct poi_target water;          /* Pose while the poi lies flat anywhere on the still
                                         water. */
    uint8_t has_wrist;                /* 1 if the controller measures angles, otherwise 0. */
};

/* Returns the position of mark `corner` on the water: far left, far right, near right, near
 * left. */
vec3 calibration_mark(vec3 tank_size_m, uint32_t corner);

/* Computes the correction by least squares over the corners. Returns CALIBRATION_GOOD and fills
 * `out`, or returns the reason for the rejection and leaves `out` unchanged. */
enum calibration_fault calibration_solve(const struct calibration_said *said, vec3 tank_size_m,
                                         int32_t out[CALIBRATION_VALUES]);

/* Returns the id of the first calibration setting of slot `seat`, which must be < POI_MAX. */
static inline uint32_t calibration_setting(uint32_t seat)
{
    return SET_CALIBRATION + seat * CALIBRATION_VALUES;
}

static inline uint32_t calibration_check_setting(uint32_t seat)
{
    return SET_CALIBRATION_CHECK + seat;
}

/* Returns the check value for nine calibration values. The check value is 0 only if all nine values
 * are 0. */
int32_t calibration_check(const int32_t value[CALIBRATION_VALUES]);

/* Returns 1 if slot `seat` has a complete calibration whose values are not all 0, otherwise 0. */
int calibration_is_set(const struct settings *settings, uint32_t seat);

/* Returns 1 if slot `seat` has calibration values without a matching check value, otherwise 0. */
int calibration_is_torn(const struct settings *settings, uint32_t seat);

/* Corrects the pose of a live controller in place. An invalid pose stays unchanged. Without a
 * calibration of the slot, every pose stays unchanged bit for bit. */
void calibration_apply(const struct settings *settings, uint32_t seat, struct poi_input *poi);

#endif
