/* gamepad_imu_filter.h -- estimates the tilt of a game pad from its gyroscope and accelerometer.
 *
 * The gyroscope measures rotation without delay but drifts. The accelerometer measures the
 * direction of gravity without drift, but slowly, and shaking disturbs it. The two sensors together
 * determine pitch and roll.
 *
 * Players do not hold a game pad level, so the result is the tilt relative to a rest attitude.
 * gamepad_imu_filter_level() sets the rest attitude, which also follows slowly while the poi
 * hovers. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_IMU_FILTER_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_IMU_FILTER_H

#include <stdint.h>

#include "core/base/vec.h"

/* Largest pitch and largest roll that the filter returns. */
#define GAMEPAD_IMU_FILTER_MAX_RAD (45.0f * F_DEG)

/* State of the filter. The axes are SDL's: +x points right, +y up out of the buttons, +z toward the
 * player. */
struct gamepad_imu_filter {
    vec3 up;            /* Upward direction in the axes of the pad, a unit vector. */
    uint8_t knows_down; /* 1 after the first valid acceleration was processed, otherwise 0. */
    uint8_t knows_rest; /* 1 after the rest attitude was set, otherwise 0. */
    float rest_pitch_rad, rest_roll_rad; /* Pitch and roll of the rest attitude. */
    uint64_t turn_ns;                    /* Time up to which the rotation of the pad is included in
                                            `up`. */
    uint64_t weigh_ns;                   /* Time of the newest acceleration. */
    uint64_t rest_ns;                    /* Time of the last update of the rest attitude. */
    vec3 rate_rad_s;                     /* Rotation rate from the newest measurement. */
};

/* Sets the rotation rate that applies from `time_ns` on. Returns 0, or -1 if a component is not
 * finite; the state is then unchanged. */
int gamepad_imu_filter_add_rotation(struct gamepad_imu_filter *tilt, uint64_t time_ns,
                                    vec3 rate_rad_s);

/* Processes an acceleration that includes gravity: a pad at rest measures 9.8 m/s2 upward. Returns
 * 0, or -1 if a component is not finite; the state is then unchanged. */
int gamepad_imu_filter_add_gravity(struct gamepad_imu_filter *tilt, uint64_t time_ns, vec3 up_m_s2);

/* Makes the current attitude the rest attitude. */
void gamepad_imu_filter_level(struct gamepad_imu_filter *tilt);

/* Returns pitch and roll of the poi at `time_ns`, each within +-GAMEPAD_IMU_FILTER_MAX_RAD. Both
 * angles are 0 before the first acceleration. While `hovers` is 1 the rest attitude follows the
 * current attitude. */
struct angles gamepad_imu_filter_at(struct gamepad_imu_filter *tilt, uint64_t time_ns, int hovers);

#endif
