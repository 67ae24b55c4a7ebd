/* attitude.h -- computes the orientation of the poi (a paper scoop with sensors) from its inertial
 * sensor. The functions are pure.
 *
 * Some inertial chips, for example the BNO055, compute the orientation as a quaternion. For other
 * chips, a complementary filter combines the rotation rate with the acceleration (Mahony, Hamel,
 * Pflimlin 2008). The gyroscope measures fast motion, and gravity corrects pitch and roll. The bias
 * of the gyroscope is measured while the poi is still.
 *
 * No sensor measures the heading. The heading therefore decays to straight ahead, so that the drift
 * of the gyroscope does not accumulate. The decay is not visible on the round ring of the poi, only
 * on its handle. */
#ifndef KINGYO_BOARD_POI_GADGET_ATTITUDE_H
#define KINGYO_BOARD_POI_GADGET_ATTITUDE_H

#include <stdint.h>

#include "core/base/vec.h"

#define GRAVITY_M_S2 9.80665f

/* Unit quaternion of the rotation from the axes of the poi to the axes of the world. */
struct quaternion {
    float w, x, y, z;
};

struct attitude {
    uint8_t knows; /* 1 after gravity was first measured, otherwise 0. */
    struct quaternion turn;
    vec3 bias_rad_s; /* Bias of the gyroscope in rad/s, in the axes of the poi. */
    float still_s;   /* Time in seconds for which the poi has been still. */
    float ahead_rad; /* Heading in rad that is reported as 0, which means straight ahead. */
    uint8_t has_ahead;
};

/* Updates the orientation from the rotation rate and the acceleration during the last `seconds`.
 * The two vectors are in the axes of the poi. A vector that is not finite changes nothing. Asserts
 * that `seconds` is at least 0. */
void attitude_add_motion(struct attitude *attitude, vec3 gyro_rad_s, vec3 accel_m_s2,
                         float seconds);

/* Sets the orientation to a quaternion that the chip computed. `turn` is the rotation from the axes
 * of the poi to the axes of the world. */
void attitude_set(struct attitude *attitude, struct quaternion turn);

/* Returns the orientation as angles. The heading decays to 0 with a time constant of about
 * `ahead_s` seconds. An `ahead_s` of 0 disables the decay. `seconds` is the time since the last
 * call. Asserts that `ahead_s` and `seconds` are at least 0. */
struct angles attitude_angles(struct attitude *attitude, float ahead_s, float seconds);

/* Returns the product a * b, the rotation that applies `b` first and then `a`. */
struct quaternion attitude_quaternion_product(struct quaternion a, struct quaternion b);

/* Converts yaw, pitch and roll to a quaternion. */
struct quaternion attitude_quaternion_of_angles(struct angles angles);

/* Converts a quaternion to yaw, pitch and roll. */
struct angles attitude_quaternion_angles(struct quaternion q);

#endif
