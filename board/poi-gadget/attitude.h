/* attitude.h -- how the poi is turned, by what its inertial sensor says. Pure.
 *
 * Either the chip fuses by itself and gives a quaternion (BNO055), or it gives turning and gravity
 * and they are fused here: the gyroscope leads, gravity pulls pitch and roll back to the truth by a
 * complementary filter (Mahony, Hamel, Pflimlin 2008), and a gyroscope at rest tells its own bias.
 * Neither knows which way the player looks: the heading leaks to straight ahead, so that a hand
 * that plays for minutes is not slowly turned round. The ring is round; its handle alone shows. */
#ifndef KINGYO_POI_GADGET_ATTITUDE_H
#define KINGYO_POI_GADGET_ATTITUDE_H

#include <stdint.h>

#include "core/base/vec.h"

#define GRAVITY_M_S2 9.80665f

struct quaternion { /* From the poi's axes to the world's; of length 1. */
    float w, x, y, z;
};

struct attitude {
    uint8_t knows;         /* Gravity was felt. */
    struct quaternion turn;
    vec3 bias_rad_s;       /* Of the gyroscope, in the poi's axes. */
    float still_s;         /* How long it has lain still. */
    float ahead_rad;       /* The heading that counts as straight ahead. */
    uint8_t has_ahead;
};

/* What turned and pulled at it in the last `seconds`, in the poi's own axes. */
void attitude_feel(struct attitude *attitude, vec3 gyro_rad_s, vec3 accel_m_s2, float seconds);

/* What a chip that fuses by itself says, already of the poi's axes in the world's. */
void attitude_know(struct attitude *attitude, struct quaternion turn);

/* The angles; the heading leaks to 0 within about `ahead_s`, 0: not at all. */
struct angles attitude_angles(struct attitude *attitude, float ahead_s, float seconds);

struct quaternion quaternion_product(struct quaternion a, struct quaternion b);
struct quaternion quaternion_of(struct angles angles);
struct angles quaternion_angles(struct quaternion q);

#endif
