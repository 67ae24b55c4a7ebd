/* pointer_poi.h -- turns pointer reports (pixels, buttons, wheel) into a pose of the poi, the paper
 * scoop.
 *
 * Pure: uses no device, clock or library. The mouse, the simulated mouse and the fuzzers share this
 * decoder.
 *
 * A pointer has two axes and a pose has six. Pressing the left button lowers the ring along a
 * smooth stroke, and releasing lifts it. The wheel tilts the ring, and the right button levels it.
 * Fast motion leans the ring into its direction. The center of the ring stays under the pointer at
 * every height. For this purpose the line of sight through the pointer is intersected with the
 * plane at the ring's height.
 *
 * While the pointer moves the fan (pointer_fan.h), the poi stands still, and afterwards glides back
 * under the pointer. The buttons and the wheel still control the poi, so one player can fan and
 * scoop. */
#ifndef KINGYO_DRIVERS_POINTER_POINTER_POI_H
#define KINGYO_DRIVERS_POINTER_POINTER_POI_H

#include <stdint.h>

#include "drivers/pointer/dip_trajectory.h"
#include "platform/hal.h"

enum pointer_button {
    POINTER_DIP = 1u << 0,   /* Left button, which holds the ring under water while pressed. */
    POINTER_LEVEL = 1u << 1, /* Right button, which levels the ring. */
    POINTER_FAN = 1u << 2,   /* Key that lets the pointer move the fan while pressed. */
};

/* The complete state of a pointer at one moment, and the motion of its wheel. */
struct pointer_report {
    uint64_t time_ns;
    float x_px, y_px;             /* Position in pixels from the top left corner of the window; any
                                     finite values are accepted. */
    uint32_t width_px, height_px; /* Size of the window in pixels; 0 means unknown. */
    uint32_t buttons;             /* Pressed buttons, as bits of enum pointer_button. */
    float wheel_notches; /* Wheel motion since the previous report, in notches; positive is away
                            from the user. */
};

#define POINTER_HOVER_M DIP_HOVER_M
#define POINTER_DIP_M DIP_DEPTH_M
#define POINTER_DOWN_S DIP_DOWN_S
#define POINTER_UP_S DIP_UP_S
#define POINTER_TILT_STEP_RAD (7.5f * F_DEG) /* Change of the tilt by one notch of the wheel. */
/* Limit of the tilt: eight notches in each direction. */
#define POINTER_TILT_MAX_RAD (60.0f * F_DEG)

struct pointer_poi {
    struct view view;

    /* Position in the window (-1 to 1, y upward) that the pointer gives to the poi, and aspect
     * ratio of the window. */
    float ndc_x, ndc_y, aspect;
    uint32_t buttons;
    uint64_t time_ns; /* Time of the newest report or sample. */

    /* `lag_x` and `lag_y` are the offset of the poi from the pointer when the poi starts to return
     * to the pointer. `back_s` is the duration of this return above the water. `back_done_s` is the
     * part that has passed, which advances more slowly under water. */
    float lag_x, lag_y;
    float back_s, back_done_s;

    struct dip dip; /* The current stroke of the ring. */
    float tilt_rad, tilt_goal_rad;

    /* `hand_m` is the position of the pointer on the still water at the last sample. `hand_m_s` is
     * the velocity of this position. */
    vec3 hand_m, hand_m_s;
    uint64_t hand_ns; /* Time of `hand_m`; 0 means that there was no sample yet. */
};

/* Initializes the pointer in the middle of the window. The ring is level and hovers. `view` is
 * copied. */
void pointer_poi_init(struct pointer_poi *pointer, const struct view *view);

/* Returns 1 if all numbers of the report are finite and the window has a size, otherwise 0. */
int pointer_report_is_usable(const struct pointer_report *report);

/* Returns the report converted from window coordinates to image coordinates. The image may be
 * rotated or smaller than the window. An unusable report is returned unchanged. */
struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct display_settings *display_settings);

/* Processes one report. If the time of a report is before that of the previous report, the time of
 * the previous report is used. Returns 1, or 0 if the report is not usable; the state is then
 * unchanged. */
int pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report);

/* Returns the pose at `time_ns`, which must not decrease from call to call. All values of the pose
 * are finite. */
struct poi_target pointer_poi_target(struct pointer_poi *pointer, uint64_t time_ns);

#endif
