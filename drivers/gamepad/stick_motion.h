/* stick_motion.h -- turns the deflection of sticks or of a 3D mouse (a puck with six axes) into a
 * pose of the poi, the paper scoop.
 *
 * Pure: uses no device, clock or library. A stick sets a velocity: pushing moves the ring, and
 * releasing stops it. A puck also moves the ring up and down. A game pad lowers the ring with a
 * button, as a mouse does (dip_trajectory.h).
 *
 * The tilt of the ring follows the angle of the control and returns to level on release. Holding
 * LEVEL returns a puck's ring to the hover height. The ring is slower under water, so that wet
 * paper survives unless the player also shakes it. */
#ifndef KINGYO_DRIVERS_GAMEPAD_STICK_MOTION_H
#define KINGYO_DRIVERS_GAMEPAD_STICK_MOTION_H

#include <stdint.h>

#include "drivers/pointer/dip_trajectory.h"
#include "drivers/pointer/pointer_poi.h"

/* Speed above the water at full deflection; the kiosk's tank is crossed in 1.5 s. */
#define STICK_MOTION_AIR_M_S 0.55f
/* Speed under water at full deflection. Wet paper withstands 0.4 m/s broadside. */
#define STICK_MOTION_WATER_M_S 0.26f
/* Vertical speed at full deflection, equal to the fastest part of a dip. */
#define STICK_MOTION_HEIGHT_M_S 0.30f
#define STICK_MOTION_HIGH_M 0.12f   /* Upper limit of the ring, above the rim of the tank. */
#define STICK_MOTION_LOW_M (-0.11f) /* Lower limit of the ring: the floor of the kiosk's tank. */
#define STICK_MOTION_TILT_MAX_RAD (60.0f * F_DEG)

/* The complete state of the controls at one moment. */
struct stick_report {
    uint64_t time_ns;
    vec3 push;  /* Deflection with components of -1 to 1. Non-finite components count as 0. */
    vec3 twist; /* Pitch, yaw and roll as shares of STICK_MOTION_TILT_MAX_RAD, -1 to 1. Non-finite
                   components count as 0. */
    uint32_t buttons; /* Pressed buttons, as bits of enum pointer_button. */
};

struct stick_motion {
    struct view view;
    /* Lower and upper corner of the visible part: [0] at STICK_MOTION_LOW_M, [1] at
     * STICK_MOTION_HIGH_M. */
    vec3 low_m[2], high_m[2];
    struct stick_report report;
    struct dip dip;
    vec3 place_m;     /* Position of the ring without the motion of the dip. */
    vec3 speed_m_s;   /* Velocity of the ring after smoothing. */
    vec3 twist_rad;   /* Pitch, yaw and roll of the ring after smoothing. */
    vec3 shade_m;     /* Last position of the fan; only x and z are used. */
    float swing;      /* Progress of the fan on its way over the water: 0 means beyond the near
                         edge, 1 means in place. */
    uint64_t time_ns; /* Time of the newest report or sample. */
};

/* Initializes the poi to hover over the middle of the water. `view` is copied. */
void stick_motion_init(struct stick_motion *fly, const struct view *view);

/* Sets the camera view. The poi stays within the visible part. */
void stick_motion_set_view(struct stick_motion *fly, const struct view *view);

/* Processes one report. A report with an older time than the previous report is processed at the
 * time of the previous report. */
void stick_motion_report(struct stick_motion *fly, const struct stick_report *report);

/* Returns the pose at `time_ns`, which must not decrease from call to call. All values of the pose
 * are finite. */
struct poi_target stick_motion_target(struct stick_motion *fly, uint64_t time_ns);

/* Returns the fan at `time_ns`. While POINTER_FAN is pressed, the sticks move the fan and the poi
 * stands still. */
struct shade_input stick_motion_fan(struct stick_motion *fly, uint64_t time_ns);

#endif
