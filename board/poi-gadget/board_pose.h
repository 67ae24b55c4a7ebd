/* board_pose.h -- converts the sensor readings of a poi (a paper scoop with sensors) to the report
 * that is sent to the host. The functions are pure.
 *
 * The position is filtered without delaying fast motion. The One Euro filter (Casiez, Roussel,
 * Vogel 2012) is a first-order low-pass filter whose corner frequency increases with the speed. At
 * rest, one step of a 12-bit converter (0.3 mm) must not appear as a hand tremor of 75 mm/s. During
 * a fast dip, the delay of the filter must stay below one tick of the game (1/120 s). */
#ifndef KINGYO_BOARD_POI_GADGET_BOARD_POSE_H
#define KINGYO_BOARD_POI_GADGET_BOARD_POSE_H

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/poi_config.h"
#include "drivers/hid/poi_report.h"

/* Limit in converter steps. A reading below this limit counts as the end stop of the potentiometer.
 * The limit allows for noise. */
#define BOARD_POSE_STEPS_MIN 8.0f

/* Readings of all sensors at one moment, in the steps of the converter and in the axes of the
 * inertial chip. */
struct readings {
    float wire[DRAW_WIRE_COUNT]; /* Mean of several samples for each draw wire, in steps of the
                                    analog-to-digital converter. */
    /* 1 if the inertial chip computes a quaternion and `turn` is valid. 0 if `gyro_rad_s` and
     * `accel_m_s2` are valid instead. */
    uint8_t fuses;
    struct quaternion turn; /* Rotation from the axes of the inertial chip to a world whose +z axis
                               points up. */
    vec3 gyro_rad_s, accel_m_s2;
    uint8_t buttons; /* Bit mask of the pressed buttons (enum poi_button). */
};

/* State of the position filter. The constants of the filter are in board_pose.c. */
struct steady {
    uint8_t begun;                  /* 1 after the first position, otherwise 0. */
    vec3 place_m, speed_m_s, raw_m; /* Filtered position, filtered speed, and last unfiltered
                                       position. Positions are in metres. */
};

struct board_pose {
    const struct poi_config *config;
    struct attitude attitude;
    struct steady steady;
    struct quaternion mount;      /* Rotation from the axes of the inertial chip to the axes of the
                                     poi. */
    enum draw_wires_result wires; /* Result of the last computation of the position from the draw
                                     wires. */
    vec3 eye_m;                   /* Unfiltered position of the eye, the point at which the draw
                                     wires meet, in metres. */
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

#endif
