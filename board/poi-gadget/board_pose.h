/* board_pose.h -- converts a poi's sensor readings to the report for its host. The functions are
 * pure. */
#ifndef KINGYO_BOARD_POI_GADGET_BOARD_POSE_H
#define KINGYO_BOARD_POI_GADGET_BOARD_POSE_H

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/steady.h"
#include "drivers/hid/poi_report.h"

/* Readings below this number of converter steps are the stop of a potentiometer with its noise. */
#define BOARD_POSE_STEPS_MIN 8.0f

/* Readings of all sensors at one moment, in the chips' own steps and axes. */
struct readings {
    float wire[DRAW_WIRE_COUNT]; /* Converter steps of each wire, a mean of several samples. */
    /* 1 if the chip computes `turn`. Otherwise `gyro` and `accel` are valid. */
    uint8_t fuses;
    struct quaternion turn; /* Rotation from the chip's axes to a world with +z up. */
    vec3 gyro_rad_s, accel_m_s2;
    uint8_t buttons; /* Pressed buttons, enum poi_button. */
};

struct board_pose {
    const struct poi_config *config;
    struct attitude attitude;
    struct steady steady;
    struct quaternion mount;      /* Rotation from the chip's axes to the axes of the poi. */
    enum draw_wires_result wires; /* Result of the wires in the last step. */
    vec3 eye_m;                   /* Unfiltered position at which the wires meet. */
};

/* Initializes the state. `config` must outlive `pose`. The caller guarantees a valid and calibrated
 * `config`. */
void board_pose_init(struct board_pose *pose, const struct poi_config *config);

/* Computes the report `seconds` > 0 after the previous report. The report has no position if the
 * wires do not meet. The caller sets the sequence number. */
void board_pose_step(struct board_pose *pose, const struct readings *readings, float seconds,
                     struct poi_report *out);

/* Returns the rotation whose matrix has the given rows. */
struct quaternion board_pose_quaternion_of_rows(const vec3 row[3]);

#endif
