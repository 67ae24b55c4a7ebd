/* gamepad_decoder.h -- the game pad decoder: turns sticks, triggers, buttons and motion sensors
 * into a pose of the poi.
 *
 * Pure: uses no device, clock or library. SDL's game pads (gamepads.h) and the simulated game pad
 * (gamepad_sim.h) share this decoder. The poi is the paper scoop, a ring with paper.
 *
 * The left stick moves the ring over the water by the rules of stick_motion.h. Button A or a
 * trigger dips the ring, the right stick tilts it, and button X levels it. While the left shoulder
 * button is pressed, the left stick moves the fan (stick_motion_fan()). A game pad with motion
 * sensors also tilts the ring by its own attitude. The filter of the motion sensors estimates the
 * tilt from the gyroscope and the accelerometer. The gyroscope measures rotation without delay but
 * drifts. The accelerometer measures the direction of gravity without drift, but slowly, and
 * shaking disturbs it. The two sensors together determine pitch and roll. Players do not hold a
 * game pad level, so the result is the tilt relative to a rest attitude. gamepad_imu_filter_level()
 * sets the rest attitude, which also follows slowly while the poi hovers.
 *
 * A stick sets a velocity, so the poi moves between reports too. The queue of reports samples the
 * motion once for each tick (1/120 s), however rarely the kiosk polls. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"
#include "drivers/gamepad/stick_motion.h"
#include "platform/hal.h"

/* ---- Filter of the motion sensors ------------------------------------------------------------ */

/* Largest pitch and largest roll that the filter returns. */
#define GAMEPAD_IMU_FILTER_MAX_RAD (45.0f * F_DEG)

/* State of the filter. The axes are SDL's: +x points to the right, +y upward out of the surface
 * with the buttons, and +z toward the player. */
struct gamepad_imu_filter {
    vec3 up;       /* Upward direction in the axes of the pad, a unit vector. */
    bool has_up;   /* True after the first valid acceleration was processed. */
    bool has_rest; /* True after the rest attitude `rest` was set. */
    /* Rest attitude: the attitude of the pad for which the ring is level. The yaw is 0. */
    struct angles rest;
    /* Time up to which the rotations of the pad are included in `up`. */
    uint64_t turn_ns;
    uint64_t weigh_ns; /* Time of the newest acceleration. */
    uint64_t rest_ns;  /* Time of the last update of the rest attitude. */
    vec3 rate_rad_s;   /* Rotation rate from the newest measurement. */
};

/* Sets the rotation rate of the pad for all times after `time_ns`. Returns 0, or -1 if a component
 * is not finite. After a failure the state is unchanged. */
int gamepad_imu_filter_add_rotation(struct gamepad_imu_filter *tilt, uint64_t time_ns,
                                    vec3 rate_rad_s);

/* Processes an acceleration that includes gravity: a pad at rest measures 9.8 m/s2 upward. Returns
 * 0, or -1 if a component is not finite. After a failure the state is unchanged. */
int gamepad_imu_filter_add_gravity(struct gamepad_imu_filter *tilt, uint64_t time_ns, vec3 up_m_s2);

/* Makes the pad's current attitude the rest attitude (the attitude for which the ring is level). */
void gamepad_imu_filter_level(struct gamepad_imu_filter *tilt);

/* Returns the poi's pitch and roll at `time_ns`, each within +-GAMEPAD_IMU_FILTER_MAX_RAD. The
 * angles are the pad's tilt relative to its rest attitude (the attitude for which the ring is
 * level). Both angles are 0 before the first acceleration. While `hovers` is true, the rest
 * attitude slowly follows the pad's current attitude. */
struct angles gamepad_imu_filter_at(struct gamepad_imu_filter *tilt, uint64_t time_ns, bool hovers);

/* ---- Decoder --------------------------------------------------------------------------------- */

enum gamepad_axis {
    /* Horizontal deflection of the left stick. Positive values point to the right. */
    GAMEPAD_LEAD_X = 0,
    /* Vertical deflection of the left stick. Positive values point toward the player. */
    GAMEPAD_LEAD_Y,
    GAMEPAD_TILT_X,
    GAMEPAD_TILT_Y,
    GAMEPAD_TRIGGER_LEFT, /* Travel of the left trigger, 0 to 32,767. */
    GAMEPAD_TRIGGER_RIGHT,
    GAMEPAD_AXIS_COUNT,
};

/* Buttons, named by their position. GAMEPAD_SOUTH is A on an Xbox pad, the cross on a DualShock,
 * and B on a Switch Pro pad. */
enum gamepad_button {
    GAMEPAD_SOUTH = 1u << 0,
    GAMEPAD_EAST = 1u << 1,
    GAMEPAD_WEST = 1u << 2,
    GAMEPAD_NORTH = 1u << 3,
    GAMEPAD_BACK = 1u << 4,
    GAMEPAD_START = 1u << 6,
    GAMEPAD_STICK_RIGHT = 1u << 8,
    GAMEPAD_SHOULDER_LEFT = 1u << 9,
    GAMEPAD_SHOULDER_RIGHT = 1u << 10,
    GAMEPAD_UP = 1u << 11,
    GAMEPAD_DOWN = 1u << 12,
    GAMEPAD_LEFT = 1u << 13,
    GAMEPAD_RIGHT = 1u << 14,
};

/* Dead zone of a stick as an axis value: 15 % of the largest value, because worn sticks do not
 * return exactly to the center. */
#define GAMEPAD_DEAD 4915
/* Axis value at which a trigger counts as pressed: half of the trigger's travel. */
#define GAMEPAD_TRIGGER_ON 16384
/* Axis value at which a pressed trigger counts as released: 30 % of the trigger's travel. The
 * difference from GAMEPAD_TRIGGER_ON (hysteresis) prevents repeated dips. */
#define GAMEPAD_TRIGGER_OFF 9830
/* Tilt of the ring at full deflection of the right stick. */
#define GAMEPAD_TILT_RAD (45.0f * F_DEG)

/* The complete state of a game pad at one moment. */
struct gamepad_report {
    uint64_t time_ns;
    int16_t axis[GAMEPAD_AXIS_COUNT];
    uint32_t buttons; /* Pressed buttons, as bits of enum gamepad_button. Other bits are ignored. */
    bool has_turn;    /* True if `turn_rad_s` is new in this report. */
    bool has_weight;  /* True if `weight_m_s2` is new in this report. */
    /* Rotation rate and acceleration in the axes of SDL's sensors. */
    vec3 turn_rad_s, weight_m_s2;
};

struct gamepad_decoder {
    /* Decoder state that converts the deflection of the sticks to the motion of the ring. */
    struct stick_motion fly;
    /* Filter that computes the tilt of the ring from the motion sensors. */
    struct gamepad_imu_filter tilt;
    struct gamepad_report now; /* The newest report. */
    /* Pitch, yaw and roll from the right stick, as fractions of STICK_MOTION_TILT_MAX_RAD. */
    vec3 stick_twist;
    uint64_t time_ns;  /* Time of the newest report or sample. */
    bool trigger_down; /* True while a trigger of the game pad is pressed. */
    /* Bits of enum input_button. `held` contains the buttons that are pressed now. `pressed`
     * contains the buttons that were pressed after the last call of gamepad_decoder_buttons(). */
    uint32_t held, pressed;
};

/* Initializes the decoder with the poi over the middle of the water. `view` is copied. */
void gamepad_decoder_init(struct gamepad_decoder *decoder, const struct view *view);

/* Processes one report. Any content is accepted. If the time of a report is before that of the
 * previous report, the time of the previous report is used. */
void gamepad_decoder_report(struct gamepad_decoder *decoder, const struct gamepad_report *report);

/* Returns the pose at `time_ns`, which must not decrease from call to call. All values of the pose
 * are finite. */
struct poi_sample gamepad_decoder_sample(struct gamepad_decoder *decoder, uint64_t time_ns);

/* Writes to `out` the buttons that are pressed now, and the buttons that were pressed since the
 * last call. */
void gamepad_decoder_buttons(struct gamepad_decoder *decoder, struct button_sample *out);

/* Motor levels of a game pad, 0 to 65,535. The level of the slow motor follows the drag of the
 * water. The level of the fast motor follows slaps of a fish's tail and the tearing of the
 * paper. */
struct gamepad_rumble {
    uint16_t slow, fast;
};
/* Returns the motor levels for the force feedback `force`. */
struct gamepad_rumble gamepad_decoder_rumble(const struct poi_force *force);

/* ---- Queue of reports ------------------------------------------------------------------------ */

#define GAMEPAD_REPORTS_MAX 64u /* Capacity of the queue, equal to HAL_POI_SAMPLES_MAX. */

struct gamepad_queue {
    /* Decoder that has already processed all reports before the first report in `report`. */
    struct gamepad_decoder decoder;
    /* Reports that are not decoded yet, oldest first. */
    struct gamepad_report report[GAMEPAD_REPORTS_MAX];
    uint32_t report_count;
    uint64_t sampled_ns; /* Time of the newest sample. */
};

/* Initializes `track` with the poi over the middle of the water at `time_ns`. */
void gamepad_queue_init(struct gamepad_queue *track, const struct view *view, uint64_t time_ns);

/* Appends a report. If the queue is full, the oldest report is decoded immediately. The buttons of
 * the oldest report still count, but the motion up to its time is not sampled. */
void gamepad_queue_push(struct gamepad_queue *track, const struct gamepad_report *report);

/* Samples the motion from the previous call to `now_ns`. Writes at most `max` samples, the last of
 * which is at `now_ns`. Returns the number of samples. */
uint32_t gamepad_queue_pop(struct gamepad_queue *track, uint64_t now_ns, struct poi_sample *out,
                           uint32_t max);

/* Decodes all pending reports and writes the pressed buttons to `out`. */
void gamepad_queue_buttons(struct gamepad_queue *track, struct button_sample *out);
