/* attitude.h -- computes the orientation of the poi from its inertial sensor. The functions are
 * pure.
 *
 * Some chips compute a quaternion (BNO055). For other chips, this module fuses rotation rate and
 * acceleration with a complementary filter (Mahony, Hamel, Pflimlin 2008). The gyroscope gives the
 * fast motion, and gravity corrects pitch and roll. The gyroscope's bias is measured while the poi
 * is still. No sensor measures the direction in which the player faces. The heading therefore
 * decays to straight ahead, so that the drift of several minutes does not accumulate. The decay is
 * not visible on the round ring, only on its handle. */
#ifndef KINGYO_BOARD_POI_GADGET_ATTITUDE_H
#define KINGYO_BOARD_POI_GADGET_ATTITUDE_H

#include <stdint.h>

#include "core/base/vec.h"

#define GRAVITY_M_S2 9.80665f

/* Unit quaternion that rotates from the axes of the poi to the axes of the world. */
struct quaternion {
    float w, x, y, z;
};

struct attitude {
    uint8_t knows; /* 1 if gravity was measured. */
    struct quaternion turn;
    vec3 bias_rad_s; /* Bias of the gyroscope, in the axes of the poi. */
    float still_s;   /* Seconds for which the poi has been still. */
    float ahead_rad; /* Heading that counts as straight ahead. */
    uint8_t has_ahead;
};

/* Updates the orientation with a rotation rate and an acceleration over the last `seconds`, in the
 * axes of the poi. */
void attitude_add_motion(struct attitude *attitude, vec3 gyro_rad_s, vec3 accel_m_s2,
                         float seconds);

/* Sets the orientation from a chip that computes a quaternion. The rotation is from the axes of the
 * poi to the axes of the world. */
void attitude_set(struct attitude *attitude, struct quaternion turn);

/* Returns the angles. The heading decays to 0 with a time constant of about `ahead_s`. A value of 0
 * disables the decay. */
struct angles attitude_angles(struct attitude *attitude, float ahead_s, float seconds);

/* Returns the rotation that applies `b` first and then `a`. */
struct quaternion attitude_quaternion_product(struct quaternion a, struct quaternion b);

/* Converts angles to a rotation. */
struct quaternion attitude_quaternion_of_angles(struct angles angles);

/* Converts a rotation to angles. */
struct angles attitude_quaternion_angles(struct quaternion q);

#endif
