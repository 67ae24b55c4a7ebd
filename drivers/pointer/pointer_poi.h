/* pointer_poi.h -- turns pointer reports (pixels, buttons, wheel) into a pose of the poi, the paper
 * scoop, and into the position of a fan (uchiwa).
 *
 * Pure: uses no device, clock or library. The mouse, the simulated mouse and the fuzzers share
 * this decoder.
 *
 * A pointer has two axes and a pose has six. A press of the left button lowers the ring, and a
 * release lifts the ring (see Dips below). The wheel tilts the ring, and the right button levels
 * it. Fast motion leans the ring into its direction. The center of the ring is under the pointer
 * at every height, except during a downward stroke. For this purpose the line of sight through
 * the pointer is intersected with the plane at the ring's height.
 *
 * While the pointer moves the fan, the poi stands still. Afterwards the poi returns to the
 * pointer. The buttons and the wheel still control the poi, so one player can fan and scoop. The
 * fan enters from the player's side and leaves in the same direction along a smooth path, so that
 * the fan never appears suddenly and never jumps. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/fmath.h"
#include "platform/hal.h"

/* Returns the time from `from_ns` to `to_ns` in seconds, or 0 if `to_ns` is not later. */
static inline float pointer_seconds_between(uint64_t from_ns, uint64_t to_ns)
{
    return to_ns > from_ns ? (float)(to_ns - from_ns) * 1e-9f : 0.0f;
}

/* ---- Dips ------------------------------------------------------------------------------------ */

/* A dip consists of a downward stroke and an upward stroke between the hover height and the depth
 * under water. Each stroke starts from the ring's current height, velocity and acceleration, so
 * that the motion is smooth. Mice, touch screens and sticks use the same strokes.
 *
 * - Downward: the ring sinks steeply into the water nearer to the player than the pointer, with its
 *   far edge first. Under water the ring glides away from the player until its center is below the
 *   pointer, and becomes level. A fish below the pointer is then above the paper.
 * - A downward stroke is always completed. If the button is released earlier, the upward stroke
 *   starts when the downward stroke ends. A short press therefore scoops as well as a long one.
 * - Upward: the ring rises below the pointer. The far edge leaves the water first, so that the
 *   water runs off the paper.
 *
 * drivers/README.md compares this mapping with two others. */

/* Height of a hovering ring above the still water. The ring is above the ripples and low enough for
 * aiming. */
#define DIP_HOVER_M 0.035f
/* Height of a dipped ring. A negative height is under water. At this depth the fish swim in a tank
 * that is 10 to 20 cm deep. */
#define DIP_DEPTH_M (-0.050f)
/* Duration of the downward stroke. A faster stroke presses harder on the paper, and a slower stroke
 * gives the fish more time to flee. */
#define DIP_DOWN_S 0.45f
/* Duration of the upward stroke. Wet paper carries water, so a faster stroke would tear the
 * paper. */
#define DIP_UP_S 0.46f

/* Largest slant of the ring during a downward stroke, and the vertical speed at which the slant is
 * largest. The ring reaches this speed within the first two frames of the stroke and is faster
 * until shortly before the end of the stroke. With this slant the paper meets the water at 0.23 m/s
 * along its normal. A level ring would meet the water at 0.35 m/s. */
#define DIP_SLANT_DOWN_RAD (57.0f * F_DEG)
#define DIP_SLANT_DOWN_M_S 0.10f
/* Largest slant of the ring during an upward stroke, and the vertical speed at which the slant is
 * largest. The slant is smaller than in a downward stroke, because a fish slides off steep
 * paper. */
#define DIP_SLANT_UP_RAD (28.0f * F_DEG)
#define DIP_SLANT_UP_M_S 0.40f

/* Largest distance by which the ring is nearer to the player than the pointer during a downward
 * stroke from the hover height: about one radius of the ring. A stroke that starts lower has a
 * proportionally smaller distance, and a stroke that starts under water has none. */
#define DIP_NEAR_M 0.045f
/* Fraction of the downward stroke after which the ring is farthest from the pointer (DIP_NEAR_M).
 * The center of the ring is then half way between the surface and the final depth. */
#define DIP_NEAR_AT 0.50f

/* The current stroke: a quintic polynomial that starts from the ring's state at `start_ns`. */
struct dip {
    uint64_t start_ns;
    float duration_s; /* Duration of the stroke. 0 means that no stroke was started yet. */
    float from_m, from_m_s, from_m_s2, to_m;
    bool lifts;  /* True if the button was released during the current downward stroke. */
    bool scoops; /* True if a downward stroke scoops fish, false if it presses on a page. */
    /* Largest distance by which the ring is nearer to the player than the pointer during the
     * current stroke. */
    float near_max_m;
};

struct dip_state {
    float height_m, speed_m_s, acceleration_m_s2;
    /* Distance by which the ring is nearer to the player than the pointer, [0, DIP_NEAR_M]. */
    float near_m;
};

/* Initializes a hovering ring. The strokes scoop fish. */
void pointer_dip_init(struct dip *dip);

/* Processes a press (`down` is true) or a release of the button at `time_ns`. A release during a
 * downward stroke takes effect at the end of this stroke, unless the button is pressed again
 * before. */
void pointer_dip_begin(struct dip *dip, uint64_t time_ns, bool down);

/* Returns the state of the ring at `time_ns`. If `time_ns` is before the start of the stroke,
 * returns the state at the start. */
struct dip_state pointer_dip_at(const struct dip *dip, uint64_t time_ns);

/* Returns the slant of the ring in radians (0 or more) at the vertical speed `speed_m_s`, which is
 * negative in a downward stroke. The slant is proportional to the speed up to the limit for its
 * direction. The far edge of a slanted ring is lower, both while the ring sinks and while the ring
 * rises. */
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
    /* Position in pixels from the top left corner of the window. Any finite values are accepted. */
    float x_px, y_px;
    uint32_t width_px, height_px; /* Size of the window in pixels. 0 means unknown. */
    uint32_t buttons;             /* Pressed buttons, as bits of enum pointer_button. */
    /* Wheel motion since the previous report, in notches. Positive is away from the user. */
    float wheel_notches;
};

#define POINTER_TILT_STEP_RAD (7.5f * F_DEG) /* Change of the tilt by one notch of the wheel. */
/* Limit of the tilt: eight notches in each direction. */
#define POINTER_TILT_MAX_RAD (60.0f * F_DEG)
/* Lean of the ring for each m/s of its speed, because an arm that moves fast cannot hold the ring
 * in its plane. The lean is below 3 degrees at 0.1 m/s. At 1 m/s the lean has its maximum, and the
 * water presses strongly against the leaning paper. */
#define POINTER_LEAN_RAD_PER_M_S (28.0f * F_DEG)
#define POINTER_LEAN_MAX_RAD (20.0f * F_DEG)

/* Progress of a fan's entry. The fan enters while the player holds the fan, and otherwise
 * leaves. */
struct fan_swing {
    bool held; /* True while the player holds the fan over the water. */
    /* Progress of the entry: 0 means that the fan is out of sight, 1 means that the fan has reached
     * its position over the water. */
    float share;
    uint64_t time_ns; /* Time for which `share` was computed last. */
};

struct pointer_poi {
    struct view view;

    /* Position in the window (-1 to 1, y upward) that the pointer gives to the poi, and aspect
     * ratio of the window. */
    float ndc_x, ndc_y, aspect;
    uint32_t buttons;
    uint64_t time_ns; /* Time of the newest report or sample. */

    /* `lag_x` and `lag_y` are the offset of the poi from the pointer when the poi starts to return
     * to the pointer. `back_s` is the duration of this return above the water. `back_done_s` is the
     * part of this duration that has passed. Under water, `back_done_s` advances more slowly. */
    float lag_x, lag_y;
    float back_s, back_done_s;

    struct dip dip; /* The current stroke of the ring. */
    float tilt_rad, tilt_goal_rad;

    /* `water_m` is the position of the pointer on the still water at the last sample. `water_m_s`
     * is the velocity of this position. */
    vec3 water_m, water_m_s;
    uint64_t water_ns; /* Time of `water_m`. 0 means that there was no sample yet. */

    /* Position in the window and aspect ratio at the last report that had POINTER_FAN pressed. */
    float fan_ndc_x, fan_ndc_y, fan_aspect;
    struct fan_swing fan_swing; /* Movement of the fan to the pointer. */
};

/* Initializes the pointer in the middle of the window. The ring is level and hovers, and the fan is
 * out of sight. `view` is copied. */
void pointer_poi_init(struct pointer_poi *pointer, const struct view *view);

/* Returns the report converted from window coordinates to image coordinates. The image may be
 * rotated or smaller than the window. An unusable report is returned unchanged. */
struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct display_settings *display_settings);

/* Processes one report. If the time of a report is before that of the previous report, the time of
 * the previous report is used. Returns true, or false if the report is not usable. After a failure
 * the state is unchanged. */
bool pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report);

/* Returns the pose at `time_ns`, which must not decrease from call to call. All values of the pose
 * are finite. */
struct poi_target pointer_poi_target(struct pointer_poi *pointer, uint64_t time_ns);

/* ---- Aid ------------------------------------------------------------------------------------- */

/* Smallest value of `reach_percent` other than 0, in per cent of the height of the picture. */
#define POINTER_REACH_MIN_PERCENT 40u

/* Adapts pointer reports to players who cannot hold a button, or who cannot reach the upper part of
 * the screen. */
struct pointer_aid {
    /* True if one press of the dip button lowers the ring, and the next press lifts it. */
    bool clicks;
    /* Height of the lower part of the picture that stands for the whole picture, in per cent of
     * the picture's height. 0 means 100. */
    uint32_t reach_percent;
    bool is_pressed; /* True if the dip button was pressed in the last report. */
    bool is_down;    /* True if the ring is lowered because of a press. */
};

/* Adapts `report`, which has image coordinates (pointer_report_on()). `scoops` is true in a round
 * and false on a page with buttons. On a page, a press acts as long as it lasts. A ring that is
 * still lowered is then raised. */
void pointer_aid_apply(struct pointer_aid *aid, bool scoops, struct pointer_report *report);

/* Raises the ring until the dip button is pressed again. Must be called when a page with buttons
 * opens or closes. Otherwise a press on a button of the page would also lower the ring in the
 * round. */
void pointer_aid_raise(struct pointer_aid *aid);

/* ---- Fan ------------------------------------------------------------------------------------- */

/* Radius of the fan's shadow. The value is that of the 2013 thesis and equals the size of a small
 * uchiwa (a hand-held fan). */
#define POINTER_FAN_RADIUS_M 0.10f
/* Time in which the fan moves from its place outside the tank's near edge to the pointer, or back.
 * The fan moves when the player presses or releases FAN. */
#define POINTER_FAN_SWING_S 0.40f

/* Advances `swing` to `time_ns`. Returns the time that has passed in seconds, or 0 if `time_ns` is
 * not later than the previous time. */
float pointer_fan_swing(struct fan_swing *swing, uint64_t time_ns);

/* Returns the shadow of a fan that has covered the fraction `share` (0 to 1) of its way from
 * `rest_m` to `there_m`. The heights of the two positions are not used. */
struct shade_input pointer_fan_between(float share, vec3 rest_m, vec3 there_m);

/* Returns the fan's shadow on the water at `time_ns`, which must not decrease from call to call.
 * The position is finite. */
struct shade_input pointer_fan_shade(struct pointer_poi *pointer, uint64_t time_ns);
