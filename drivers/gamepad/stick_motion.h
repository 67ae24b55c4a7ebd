/* stick_motion.h -- turns the deflection of sticks or of a 3D mouse (a puck with six axes) into a
 * pose of the poi, the paper scoop.
 *
 * Pure: uses no device, clock or library. A stick sets a velocity: pushing the stick moves the
 * ring, and releasing the stick stops the ring. A puck also moves the ring up and down. A game pad
 * lowers the ring with a button, with the strokes of a mouse (pointer_poi.h).
 *
 * The tilt of the ring follows the angle of the stick or puck and returns to level on release.
 * Holding LEVEL returns a puck's ring to the hover height. The ring is slower under water, so that
 * wet paper survives unless the player also shakes the ring. */
#pragma once

#include <stdint.h>

#include "drivers/pointer/pointer_poi.h"

/* Speed of the ring above the water at full deflection. At this speed the ring crosses the kiosk's
 * tank in 1.5 s. */
#define STICK_MOTION_AIR_M_S 0.55f
/* Speed of the ring under water at full deflection. At 0.4 m/s, wet paper does not tear even if the
 * ring moves broadside. */
#define STICK_MOTION_WATER_M_S 0.26f
/* Vertical speed of the ring at full deflection. The value is a little below the highest speed of a
 * dip (0.35 m/s). */
#define STICK_MOTION_HEIGHT_M_S 0.30f
/* Upper limit of the ring's height, above the rim of the tank. */
#define STICK_MOTION_HIGH_M 0.12f
/* Lower limit of the ring's height: the floor of the kiosk's tank. */
#define STICK_MOTION_LOW_M (-0.11f)
#define STICK_MOTION_TILT_MAX_RAD (60.0f * F_DEG)

/* The complete state of the controls at one moment. */
struct stick_report {
    uint64_t time_ns;
    /* Deflection of the stick or puck. Each component is -1 to 1. Non-finite components count as
     * 0. */
    vec3 push;
    /* Pitch, yaw and roll as fractions (-1 to 1) of STICK_MOTION_TILT_MAX_RAD. Non-finite
     * components count as 0. */
    vec3 twist;
    uint32_t buttons; /* Pressed buttons, as bits of enum pointer_button. */
};

struct stick_motion {
    struct view view;
    /* Smallest (`low_m`) and largest (`high_m`) coordinates at which the camera shows the ring.
     * Element 0 is for the height STICK_MOTION_LOW_M, element 1 for STICK_MOTION_HIGH_M. */
    vec3 low_m[2], high_m[2];
    struct stick_report report;
    struct dip dip;
    vec3 place_m;   /* Position of the ring, not including the vertical motion of a dip. */
    vec3 speed_m_s; /* Smoothed velocity of the ring. */
    vec3 twist_rad; /* Smoothed pitch, yaw and roll of the ring. */
    /* Position over the water to which the player has moved the fan. Only x and z are used. */
    vec3 shade_m;
    /* Progress of the fan's entry: 0 means that the fan is beyond the tank's near edge, 1 means
     * that the fan is at `shade_m`. */
    float swing;
    uint64_t time_ns; /* Time of the newest report or sample. */
};

/* Initializes the poi to hover over the middle of the water. `view` is copied. */
void stick_motion_init(struct stick_motion *fly, const struct view *view);

/* Sets the camera view. The ring stays within the part of the water that the camera shows. */
void stick_motion_set_view(struct stick_motion *fly, const struct view *view);

/* Processes one report. If the time of a report is before that of the previous report, the time of
 * the previous report is used. */
void stick_motion_report(struct stick_motion *fly, const struct stick_report *report);

/* Returns the pose at `time_ns`, which must not decrease from call to call. All values of the pose
 * are finite. */
struct poi_target stick_motion_target(struct stick_motion *fly, uint64_t time_ns);

/* Returns the fan at `time_ns`. While POINTER_FAN is pressed, the sticks move the fan and the poi
 * stands still. */
struct shade_input stick_motion_fan(struct stick_motion *fly, uint64_t time_ns);
