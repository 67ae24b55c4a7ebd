/* stick_motion.h -- turns the deflection of sticks or of a puck into a pose.
 *
 * Pure: no device, no clock and no library. A stick sets a velocity: pushing moves the ring, and
 * releasing stops it. A puck also moves up and down, while a pad lowers the ring with a button
 * as a mouse does (dip_trajectory.h). Tilt follows the angle of the control and returns to level on
 * release. Holding LEVEL returns a puck's ring to the hover height. The ring is slower under
 * water, so that wet paper survives if the player does not also shake it. */
#ifndef KINGYO_DRIVERS_GAMEPAD_STICK_MOTION_H
#define KINGYO_DRIVERS_GAMEPAD_STICK_MOTION_H

#include <stdint.h>

#include "drivers/pointer/dip_trajectory.h"
#include "drivers/pointer/pointer_poi.h"

#define STICK_MOTION_AIR_M_S 0.55f    /* At full deflection: across the kiosk's tank in 1.5 s. */
#define STICK_MOTION_WATER_M_S 0.26f  /* Under water; wet paper bears 0.4 m/s broadside. */
#define STICK_MOTION_HEIGHT_M_S 0.30f /* Vertical velocity, equal to the fastest part of a dip. */
#define STICK_MOTION_HIGH_M 0.12f     /* Upper limit, above the rim of the tank. */
#define STICK_MOTION_LOW_M (-0.11f)   /* Lower limit, the floor of the kiosk's tank. */
#define STICK_MOTION_TILT_MAX_RAD (60.0f * F_DEG)

/* The complete state of the controls at one moment. */
struct stick_report {
    uint64_t time_ns;
    vec3 push;  /* Components in -1 .. 1; non-finite components count as 0. */
    vec3 twist; /* Pitch, yaw, roll as shares of STICK_MOTION_TILT_MAX_RAD; checked likewise. */
    uint32_t buttons; /* enum pointer_button bits that are down. */
};

struct stick_motion {
    struct view view;
    /* Limits of the motion by what the view shows, at STICK_MOTION_LOW_M and at
     * STICK_MOTION_HIGH_M. */
    vec3 low_m[2], high_m[2];
    struct stick_report report;
    struct dip dip;
    vec3 place_m;     /* Position over the still water, before the dip. */
    vec3 speed_m_s;   /* Velocity, smoothed like the motion of an arm. */
    vec3 twist_rad;   /* Pitch, yaw, roll of the ring after smoothing. */
    vec3 shade_m;     /* Last position of the fan; x and z. */
    float swing;      /* [0, 1]: progress of the fan's way in, as in pointer_fan. */
    uint64_t time_ns; /* Time of the newest report or sample. */
};

/* Initializes the poi to hover over the middle of the water. `view` is copied. */
void stick_motion_init(struct stick_motion *fly, const struct view *view);

/* Sets the camera view; the poi stays within the visible part. */
void stick_motion_set_view(struct stick_motion *fly, const struct view *view);

/* Processes one report. A report older than the last one is processed as current. */
void stick_motion_report(struct stick_motion *fly, const struct stick_report *report);

/* Returns the pose at `time_ns`, which must never decrease. The pose is always finite. */
struct poi_target stick_motion_target(struct stick_motion *fly, uint64_t time_ns);

/* Returns the fan. While POINTER_FAN is held the sticks move the fan and the poi waits. */
struct shade_input stick_motion_fan(struct stick_motion *fly, uint64_t time_ns);

#endif
