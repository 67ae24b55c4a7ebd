/* skewed_twin.h -- a simulated poi controller for tests of the calibration. Its sensors use a
 * coordinate frame that is rotated and shifted relative to the frame of the tank. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_SKEWED_TWIN_H
#define KINGYO_TESTS_UNIT_SUPPORT_SKEWED_TWIN_H

#include <string.h>

#include "core/game/control/input_pose.h"

/* Transform from true positions and angles to the coordinate frame of the sensors. */
struct twin {
    float xx, xz, zx, zz;
    vec3 shift_m;
    float pitch_rad, roll_rad;
};

/* Returns the position that the sensors report for the true position `at_m`. */
static inline vec3 seen_point(const struct twin *twin, vec3 at_m)
{
    return v3(twin->xx * at_m.x + twin->xz * at_m.z + twin->shift_m.x, at_m.y + twin->shift_m.y,
              twin->zx * at_m.x + twin->zz * at_m.z + twin->shift_m.z);
}

/* Returns the pose that the sensors report for the true pose `at`. */
static inline struct poi_target seen(const struct twin *twin, struct poi_target at)
{
    const float x = -f_sin(at.angles.yaw_rad), z = -f_cos(at.angles.yaw_rad);
    return (struct poi_target){
        .position_m = seen_point(twin, at.position_m),
        .angles = { f_atan2(-(twin->xx * x + twin->xz * z), -(twin->zx * x + twin->zz * z)),
                    at.angles.pitch_rad + twin->pitch_rad, at.angles.roll_rad + twin->roll_rad },
    };
}

/* Writes calibration values and their check value into the settings of one player. */
static inline void set_values(struct settings *settings, uint32_t slot, const int32_t *value)
{
    memcpy(&settings->value[input_calibration_setting(slot)], value,
           CALIBRATION_VALUES * sizeof *value);
    settings->value[input_calibration_check_setting(slot)] = input_calibration_check(value);
}

#endif
