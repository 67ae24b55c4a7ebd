/* board_pose.h -- what a poi's sensors say, into the report that its host gets. Pure. */
#ifndef KINGYO_POI_GADGET_BOARD_POSE_H
#define KINGYO_POI_GADGET_BOARD_POSE_H

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/steady.h"
#include "drivers/poi_report.h"

/* Fewer steps of the converter are the stop of a potentiometer, with its noise. */
#define BOARD_POSE_STEPS_MIN 8.0f

/* All sensors at one moment, in the chips' own steps and axes. */
struct readings {
    float wire[DRAW_WIRE_COUNT]; /* Steps of the converter, a mean of several. */
    uint8_t fuses;               /* `turn` is the chip's; else gyro and accel. */
    struct quaternion turn;      /* From the chip's axes to a world whose +z is up. */
    vec3 gyro_rad_s, accel_m_s2;
    uint8_t buttons;             /* enum poi_button */
};

struct board_pose {
    const struct poi_config *config;
    struct attitude attitude;
    struct steady steady;
    struct quaternion mount;       /* From the chip's axes to the poi's. */
    enum draw_wires_result wires;  /* Of the last step. */
    vec3 eye_m;                    /* Where they met, before anything was smoothed. */
};

/* `config` must outlive it, sound and calibrated. */
void board_pose_init(struct board_pose *pose, const struct poi_config *config);

/* The report `seconds` > 0 after the last; no place where the wires do not meet. The sequence
 * number stays the caller's. */
void board_pose_step(struct board_pose *pose, const struct readings *readings, float seconds,
                     struct poi_report *out);

/* A rotation whose matrix has these rows. */
struct quaternion quaternion_of_rows(const vec3 row[3]);

#endif
