/* pointer_poi.h -- turns what a pointer reports (pixels, buttons, wheel) into where a hand is.
 *
 * Pure: no device, no clock, no library. The mouse, its simulated twin and the fuzzers meet
 * here. A pointer has two axes and a hand has six, so the rest is a manner of playing: holding
 * the left button lets the ring down along a smooth stroke, letting go brings it up, the wheel
 * tilts it, the right button levels it, and a hand that hurries leans the ring into its way. The
 * ring's centre stays under the pointer at every height, because the pointer's ray is cut with
 * the plane at the ring's present height.
 *
 * While the pointer leads a fan (pointer_fan.h) the poi waits where it was; then it glides back
 * under the pointer. Its buttons and wheel go on working: one hand fans, the other scoops. */
#ifndef KINGYO_DRIVERS_POINTER_POI_H
#define KINGYO_DRIVERS_POINTER_POI_H

#include <stdint.h>

#include "drivers/dip.h"
#include "platform/hal.h"

enum pointer_button {
    POINTER_DIP = 1u << 0,   /* Left: down while held. */
    POINTER_LEVEL = 1u << 1, /* Right: back to level. */
    POINTER_FAN = 1u << 2,   /* A key: while it is held, the pointer leads the fan instead. */
};

/* Everything a pointer can say at one moment; levels, but for the wheel. */
struct pointer_report {
    uint64_t time_ns;
    float x_px, y_px;                  /* From the window's top left corner; any finite value. */
    uint32_t width_px, height_px;      /* Of the window; 0 means that nothing is known yet. */
    uint32_t buttons;                  /* enum pointer_button levels. */
    float wheel_notches;               /* Since the last report; away from the user is positive. */
};

#define POINTER_HOVER_M DIP_HOVER_M
#define POINTER_DIP_M DIP_DEPTH_M
#define POINTER_DOWN_S DIP_DOWN_S
#define POINTER_UP_S DIP_UP_S
#define POINTER_TILT_STEP_RAD (7.5f * F_DEG) /* One notch of the wheel ... */
#define POINTER_TILT_MAX_RAD (60.0f * F_DEG) /* ... of at most eight either way. */

struct pointer_poi {
    struct view view;

    float ndc_x, ndc_y, aspect; /* Where it is led, in the window, -1 .. 1; its width / height. */
    uint32_t buttons;
    uint64_t time_ns;           /* Of the newest report or sample. */

    /* After it waited: how far from the pointer it sets off, how long its way back takes in the
     * air, and how much of that is done. Under water it hardly goes on. */
    float lag_x, lag_y;
    float back_s, back_done_s;

    struct dip dip;             /* The present stroke. */
    float tilt_rad, tilt_goal_rad;

    vec3 hand_m, hand_m_s;      /* The pointer on the still water at the last sample; its speed. */
    uint64_t hand_ns;           /* 0 before the first. */
};

/* A pointer at the middle of the window, the ring level and hovering. `view` is copied. */
void pointer_poi_init(struct pointer_poi *pointer, const struct view *view);

/* Whether every number of it is one, and the window is not empty. */
int pointer_report_is_usable(const struct pointer_report *report);

/* The same report as it is on the picture, however that lies in the window. One that is not usable
 * is returned as it is. */
struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct showing *showing);

/* Takes one report. One that is older than the last counts as now; one with a non-finite number or
 * an empty window is refused: 0, and nothing changes. */
int pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report);

/* Where the hand is at `time_ns`, which never goes back. Always finite. */
struct poi_target pointer_poi_target(struct pointer_poi *pointer, uint64_t time_ns);

#endif
