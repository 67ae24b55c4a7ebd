/* gamepad_imu_filter.h -- estimates the tilt of a game pad from its gyroscope and accelerometer.
 * Pure.
 *
 * The gyroscope measures rotation at once but drifts. The accelerometer measures the direction
 * of gravity without drift, but slowly and disturbed by shaking. Together they determine pitch
 * and roll. Players do not hold a pad level, so the result is the tilt relative to the rest
 * attitude. The rest attitude is set by LEVEL, and follows slowly while the poi hovers. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_IMU_FILTER_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_IMU_FILTER_H

#include <stdint.h>

#include "core/base/vec.h"

#define GAMEPAD_IMU_FILTER_MAX_RAD (45.0f * F_DEG) /* Largest tilt in play. */

/* State of the filter. Axes are SDL's: +x right, +y up out of the buttons, +z toward the player. */
struct gamepad_imu_filter {
    vec3 up;            /* Upward direction in the pad's axes. */
    uint8_t knows_down; /* 1 after the first valid acceleration. */
    uint8_t knows_rest;
    float rest_pitch_rad, rest_roll_rad;
    uint64_t turn_ns;  /* Time to which `up` was rotated. */
    uint64_t weigh_ns; /* Time of the newest acceleration. */
    uint64_t rest_ns;  /* Time to which the rest attitude was updated. */
    vec3 rate_rad_s;
};

/* Sets the rotation rate from `time_ns` on. Returns 0, or -1 if a component is not finite;
 * nothing then changes. */
int gamepad_imu_filter_add_rotation(struct gamepad_imu_filter *tilt, uint64_t time_ns,
                                    vec3 rate_rad_s);

/* Processes an acceleration including gravity, which is 9.8 m/s2 upward at rest. Returns 0, or
 * -1 as above. */
int gamepad_imu_filter_add_gravity(struct gamepad_imu_filter *tilt, uint64_t time_ns, vec3 up_m_s2);

/* Makes the current attitude the rest attitude. */
void gamepad_imu_filter_level(struct gamepad_imu_filter *tilt);

/* Returns pitch and roll at `time_ns` as angles of the poi, within GAMEPAD_IMU_FILTER_MAX_RAD. Both
 * are 0 before the first acceleration. While `hovers` is set the rest attitude follows the current
 * one. */
struct angles gamepad_imu_filter_at(struct gamepad_imu_filter *tilt, uint64_t time_ns, int hovers);

#endif
