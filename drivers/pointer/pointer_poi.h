/* pointer_poi.h -- turns pointer reports (pixels, buttons, wheel) into a pose of the poi, the paper
 * scoop, and into the position of a fan (uchiwa).
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
 * While the pointer moves the fan the poi stands still, and afterwards glides back under the
 * pointer. The buttons and the wheel still control the poi, so one player can fan and scoop. The
 * fan enters from the player's side and leaves in the same direction along a smooth path, so that
 * it never appears or jumps suddenly.
 *
 * A dip is a stroke between the hover height and the depth under water. The stroke starts from the
 * ring's current height, velocity and acceleration, so that the motion is smooth. */
#ifndef KINGYO_DRIVERS_POINTER_POINTER_POI_H
#define KINGYO_DRIVERS_POINTER_POINTER_POI_H

#include <stdint.h>

#include "core/base/fmath.h"
#include "platform/hal.h"

/* Returns the time from `from_ns` to `to_ns` in seconds, or 0 if `to_ns` is not later. */
static inline float pointer_seconds_between(uint64_t from_ns, uint64_t to_ns)
{
    return to_ns > from_ns ? (float)(to_ns - from_ns) * 1e-9f : 0.0f;
}

/* ---- Dips ------------------------------------------------------------------------------------ */

/* Height of a hovering ring above the still water. The ring is above the ripples and low enough for
 * aiming. */
#define DIP_HOVER_M 0.035f
/* Height of a dipped ring; negative means under water. At this depth the fish swim in a tank that
 * is 10 to 20 cm deep. */
#define DIP_DEPTH_M (-0.050f)
#define DIP_DOWN_S 0.30f
/* Duration of the upward stroke; longer than the downward stroke, because wet paper carries
 * water. */
#define DIP_UP_S 0.46f

#define DIP_SLANT_MAX_RAD (28.0f * F_DEG)
#define DIP_SLANT_AT_M_S 0.40f

/* The current stroke: a quintic polynomial that starts from the ring's state at `start_ns`. */
struct dip {
    uint64_t start_ns;
    float duration_s; /* Duration of the stroke; 0 means that no stroke was started yet. */
    float from_m, from_m_s, from_m_s2, to_m;
};

struct dip_state {
    float height_m, speed_m_s, acceleration_m_s2;
};

/* Initializes a hovering ring. */
void pointer_dip_init(struct dip *dip);

/* Starts a stroke at `time_ns`: downward if `down` is 1, upward if it is 0. */
void pointer_dip_begin(struct dip *dip, uint64_t time_ns, int down);

/* Returns the state of the ring at `time_ns`. If `time_ns` is before the start of the stroke,
 * returns the state at the start. */
struct dip_state pointer_dip_at(const struct dip *dip, uint64_t time_ns);

/* Returns the slant of the ring in radians (0 or more). The slant is proportional to the vertical
 * speed of the ring, up to a limit. The far edge of the ring enters and leaves the water first. The
 * ring also moves away from the player on its way down, so that the slanted paper moves more
 * edge-on and displaces less water. The paper lasts four dips with a flat ring and eight dips with
 * a slanted ring. */
float pointer_dip_slant_rad(float speed_m_s);

/* ---- Poi ------------------------------------------------------------------------------------- */

enum pointer_button {
    POINTER_DIP = 1u << 0,   /* Left button, which holds the ring under water while pressed. */
    POINTER_LEVEL = 1u << 1, /* Right button, which levels the ring while pressed. */
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

/* ---- Fan ------------------------------------------------------------------------------------- */

/* Radius of the fan's shadow. The value is that of the 2013 thesis and equals the size of a small
 * uchiwa (a hand-held fan). */
#define POINTER_FAN_RADIUS_M 0.10f
/* Time in which the fan moves from beyond the tank's near edge to the pointer, or back. */
#define POINTER_FAN_SWING_S 0.40f

struct pointer_fan {
    struct view view;
    float ndc_x, ndc_y, aspect; /* Pointer position (-1 to 1 across the window) and aspect ratio of
                                   the window at the last report that had POINTER_FAN pressed. */
    uint8_t held;
    float swing;      /* Progress of the fan's entry: 0 means that the fan is out of sight, 1 means
                         that it is under the pointer. */
    uint64_t time_ns; /* Time for which `swing` was computed last. */
};

/* Initializes a fan that is out of sight. `view` is copied. */
void pointer_fan_init(struct pointer_fan *fan, const struct view *view);

/* Processes one report. Returns 1, or 0 if pointer_report_is_usable() rejects the report; the state
 * is then unchanged. */
int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report);

/* Returns the fan's shadow on the water at `time_ns`, which must not decrease from call to call.
 * The position is finite. */
struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns);

#endif
