/* pointer_poi.h -- turns pointer reports (pixels, buttons, wheel) into a pose.
 *
 * Pure: no device, no clock and no library. The mouse, its simulated twin and the fuzzers use
 * this decoder. A pointer has two axes and a pose has six. Holding the left button lowers the
 * ring along a smooth stroke, and releasing lifts it. The wheel tilts the ring and the right
 * button levels it. Fast motion leans the ring into its direction. The center of the ring stays
 * under the pointer at every height. For this purpose the pointer's ray is intersected with the
 * plane at the ring's current height.
 *
 * While the pointer moves the fan (pointer_fan.h), the poi waits in place and then glides back
 * under the pointer. Buttons and wheel still control the poi, so one player can fan and scoop. */
#ifndef KINGYO_DRIVERS_POINTER_POINTER_POI_H
#define KINGYO_DRIVERS_POINTER_POINTER_POI_H

#include <stdint.h>

#include "drivers/pointer/dip_trajectory.h"
#include "platform/hal.h"

enum pointer_button {
    POINTER_DIP = 1u << 0,   /* Left button: the ring is down while held. */
    POINTER_LEVEL = 1u << 1, /* Right button, which levels the ring. */
    POINTER_FAN = 1u << 2,   /* A key: while held, the pointer moves the fan. */
};

/* The complete state of a pointer at one moment, and the wheel's motion. */
struct pointer_report {
    uint64_t time_ns;
    float x_px, y_px;             /* Pixels from the window's top left corner; any finite value. */
    uint32_t width_px, height_px; /* Size of the window; 0: not known. */
    uint32_t buttons;             /* enum pointer_button bits that are down. */
    float wheel_notches; /* Wheel motion since the last report; positive is away from the user. */
};

#define POINTER_HOVER_M DIP_HOVER_M
#define POINTER_DIP_M DIP_DEPTH_M
#define POINTER_DOWN_S DIP_DOWN_S
#define POINTER_UP_S DIP_UP_S
#define POINTER_TILT_STEP_RAD (7.5f * F_DEG) /* Tilt for one notch of the wheel. */
#define POINTER_TILT_MAX_RAD (60.0f * F_DEG) /* Tilt limit, eight notches either way. */

struct pointer_poi {
    struct view view;

    /* Position in the window, -1 .. 1, and the window's aspect ratio. */
    float ndc_x, ndc_y, aspect;
    uint32_t buttons;
    uint64_t time_ns; /* Time of the newest report or sample. */

    /* Return after waiting: offset from the pointer at the start, duration in air, and the time
     * done. Under water the return is much slower. */
    float lag_x, lag_y;
    float back_s, back_done_s;

    struct dip dip; /* The current stroke. */
    float tilt_rad, tilt_goal_rad;

    /* Pointer position on the still water at the last sample; its velocity. */
    vec3 hand_m, hand_m_s;
    uint64_t hand_ns; /* Time of `hand_m`; 0 before the first sample. */
};

/* Initializes the pointer in the middle of the window, with the ring level and hovering. `view`
 * is copied. */
void pointer_poi_init(struct pointer_poi *pointer, const struct view *view);

/* Returns 1 if every number is finite and the window is not empty. */
int pointer_report_is_usable(const struct pointer_report *report);

/* Returns the report converted from the window to the image, which may be rotated or smaller. A
 * report that is not usable is returned unchanged. */
struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct display_settings *display_settings);

/* Processes one report. A report older than the last one is processed as current. Returns 1, or
 * 0 if the report is not usable; nothing then changes. */
int pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report);

/* Returns the pose at `time_ns`, which must never decrease. The pose is always finite. */
struct poi_target pointer_poi_target(struct pointer_poi *pointer, uint64_t time_ns);

#endif
