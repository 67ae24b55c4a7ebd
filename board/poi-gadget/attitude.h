/* attitude.h -- computes the orientation of the poi (a paper scoop with sensors) from its inertial
 * sensor, and converts all sensor readings to the report that is sent to the host. The functions
 * are pure.
 *
 * Some inertial chips, for example the BNO055, compute the orientation as a quaternion. For other
 * chips, a complementary filter combines the rotation rate with the acceleration (Mahony, Hamel,
 * Pflimlin 2008). The gyroscope measures fast motion, and gravity corrects pitch and roll. The bias
 * of the gyroscope is measured while the poi is still.
 *
 * No sensor measures the heading. The heading therefore decays to straight ahead, so that the drift
 * of the gyroscope does not accumulate. The decay is not visible on the round ring of the poi, only
 * on its handle.
 *
 * The position is filtered without delaying fast motion. The One Euro filter (Casiez, Roussel,
 * Vogel 2012) is a first-order low-pass filter whose corner frequency increases with the speed. At
 * rest, one step of a 12-bit converter (0.3 mm) must not appear as a hand tremor of 75 mm/s. During
 * a fast dip, the delay of the filter must stay below one tick of the game (1/120 s). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "board/poi-gadget/poi_config.h"
#include "core/base/vec.h"
#include "drivers/hid/poi_report.h"

#define GRAVITY_M_S2 9.80665f

/* Unit quaternion of the rotation from the axes of the poi to the axes of the world. */
struct quaternion {
    float w, x, y, z;
};

struct attitude {
    bool is_valid; /* True after gravity was first measured, so that `turn` is valid. */
    struct quaternion turn;
    vec3 bias_rad_s; /* Bias of the gyroscope in rad/s, in the axes of the poi. */
    float still_s;   /* Time in seconds for which the poi has been still. */
    float ahead_rad; /* Heading in rad that is reported as 0, which means straight ahead. */
    bool has_ahead;  /* True after `ahead_rad` was first set. */
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

/* ---- Pose ------------------------------------------------------------------------------------ */

/* Limit in converter steps. A reading below this limit counts as the end stop of the potentiometer.
 * The limit allows for noise. */
#define BOARD_POSE_STEPS_MIN 8.0f

/* Readings of all sensors at one moment, in the steps of the converter and in the axes of the
 * inertial chip. */
struct readings {
    /* Mean of several samples for each draw wire, in steps of the analog-to-digital converter. */
    float wire[DRAW_WIRE_COUNT];
    /* True if the inertial chip computes a quaternion and `turn` is valid. False if `gyro_rad_s`
     * and `accel_m_s2` are valid instead. */
    bool fuses;
    /* Rotation from the axes of the inertial chip to a world whose +z axis points up. */
    struct quaternion turn;
    vec3 gyro_rad_s, accel_m_s2;
    uint8_t buttons; /* Bit mask of the pressed buttons (enum poi_button). */
};

/* State of the position filter. The constants of the filter are in attitude.c. */
struct steady {
    bool begun; /* True after the filter has received its first position. */
    /* Filtered position, filtered speed, and last unfiltered position. Positions are in metres. */
    vec3 place_m, speed_m_s, raw_m;
};

struct board_pose {
    const struct poi_config *config;
    struct attitude attitude;
    struct steady steady;
    /* Rotation from the axes of the inertial chip to the axes of the poi. */
    struct quaternion mount;
    /* Result of the last computation of the position from the draw wires. */
    enum draw_wires_result wires;
    /* Unfiltered position of the eye, the point at which the draw wires meet, in metres. */
    vec3 eye_m;
};

/* Initializes the state. `config` must outlive `pose`. The caller guarantees that `config` is valid
 * and calibrated. */
void board_pose_init(struct board_pose *pose, const struct poi_config *config);

/* Computes the next report. `seconds` is the time since the previous report and must be above 0. If
 * the wires do not meet in a point, the report has no position. The caller sets the sequence number
 * of the report. */
void board_pose_step(struct board_pose *pose, const struct readings *readings, float seconds,
                     struct poi_report *out);

/* Converts a rotation matrix with the rows `row` to a quaternion. */
struct quaternion board_pose_quaternion_of_rows(const vec3 row[3]);
