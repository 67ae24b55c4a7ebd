/* gamepad_decoder.h -- the game pad decoder: turns sticks, triggers, buttons and motion into a
 * pose.
 *
 * Pure: no device, no clock and no library. SDL's pads (gamepad_poi.h) and their simulated twin
 * (gamepad_sim.h) use this decoder. The left stick moves the ring over the water (stick_motion.h,
 * as for any stick). A or a trigger dips it, the right stick tilts it, X levels it, and the left
 * shoulder button holds the fan. A pad with motion sensors also tilts the ring by its attitude
 * (gamepad_imu_filter.h). */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPAD_DECODER_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPAD_DECODER_H

#include <stdint.h>

#include "drivers/gamepad/gamepad_imu_filter.h"
#include "drivers/gamepad/stick_motion.h"
#include "platform/hal.h"

enum gamepad_axis {
    GAMEPAD_LEAD_X = 0, /* Left stick, positive to the right. */
    GAMEPAD_LEAD_Y,     /* Left stick, positive toward the player. */
    GAMEPAD_TILT_X,
    GAMEPAD_TILT_Y,
    GAMEPAD_TRIGGER_LEFT, /* 0 .. 32,767 */
    GAMEPAD_TRIGGER_RIGHT,
    GAMEPAD_AXIS_COUNT,
};

/* Buttons by position: GAMEPAD_SOUTH is A of an Xbox pad, the cross of a DualShock, and B of a
 * Switch Pro pad. */
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

#define GAMEPAD_DEAD 4915        /* Dead zone, 15 % of an axis, for worn sticks. */
#define GAMEPAD_TRIGGER_ON 16384 /* Press threshold of a trigger, at half travel. */
/* Release threshold of a trigger at 30 %; the hysteresis prevents repeated dips. */
#define GAMEPAD_TRIGGER_OFF 9830
#define GAMEPAD_TILT_RAD (45.0f * F_DEG) /* Tilt at full deflection of the right stick. */

/* The complete state of a pad at one moment. */
struct gamepad_report {
    uint64_t time_ns;
    int16_t axis[GAMEPAD_AXIS_COUNT];
    uint32_t buttons; /* enum gamepad_button bits that are down; other bits are ignored. */
    uint8_t has_turn, has_weight; /* 1 if new motion data follow, in SDL's axes. */
    vec3 turn_rad_s, weight_m_s2;
};

struct gamepad_decoder {
    struct stick_motion fly;
    struct gamepad_imu_filter tilt;
    struct gamepad_report now; /* The newest report. */
    vec3 stick_twist;          /* Pitch, yaw, roll from the right stick, as in stick_report. */
    uint64_t time_ns;          /* Time of the last report or sample. */
    uint8_t trigger_down;
    uint32_t held, pressed; /* Buttons that are down, and press edges, enum input_button. */
};

/* Initializes the decoder with the poi over the middle of the water. `view` is copied. */
void gamepad_decoder_init(struct gamepad_decoder *hand, const struct view *view);

/* Processes one report with any content. A report older than the last one is processed as
 * current. */
void gamepad_decoder_report(struct gamepad_decoder *hand, const struct gamepad_report *report);

/* Returns the pose at `time_ns`, which must never decrease. The pose is always finite. */
struct poi_sample gamepad_decoder_sample(struct gamepad_decoder *hand, uint64_t time_ns);

/* Writes the buttons that are down and the press edges since the last call. */
void gamepad_decoder_buttons(struct gamepad_decoder *hand, struct button_sample *out);

/* Returns the fan, which the left stick moves while GAMEPAD_SHOULDER_LEFT is held. */
struct shade_input gamepad_decoder_fan(struct gamepad_decoder *hand, uint64_t time_ns);

/* Sets the camera view. */
void gamepad_decoder_set_view(struct gamepad_decoder *hand, const struct view *view);

/* Motor levels of a pad, 0 .. 65,535. The slow motor follows the drag of the water. The fast
 * motor follows tail slaps and tearing paper. */
struct gamepad_rumble {
    uint16_t slow, fast;
};
struct gamepad_rumble gamepad_decoder_rumble(const struct poi_force *force);

#endif
