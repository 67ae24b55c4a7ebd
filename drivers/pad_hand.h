/* pad_hand.h -- turns what a game pad says (sticks, triggers, buttons, motion) into a hand.
 *
 * Pure: no device, no clock, no library. SDL's pads (poi_pad.h) and their simulated twin
 * (pad_sim.h) meet here. The left stick flies the ring over the water (fly_poi.h, as any stick
 * does), A or a trigger dips it, the right stick tilts and turns it, X levels it, the left shoulder
 * holds the fan. A pad with a gyroscope is a wrist besides (pad_tilt.h). */
#ifndef KINGYO_DRIVERS_PAD_HAND_H
#define KINGYO_DRIVERS_PAD_HAND_H

#include <stdint.h>

#include "drivers/fly_poi.h"
#include "drivers/pad_tilt.h"
#include "platform/hal.h"

enum pad_axis {
    PAD_LEAD_X = 0, /* + right */
    PAD_LEAD_Y,     /* + toward the player */
    PAD_TILT_X,
    PAD_TILT_Y,
    PAD_TRIGGER_LEFT,  /* 0 .. 32,767 */
    PAD_TRIGGER_RIGHT,
    PAD_AXIS_COUNT,
};

/* By place: PAD_SOUTH is A of an Xbox pad, the cross of a DualShock, B of a Switch Pro. */
enum pad_button {
    PAD_SOUTH = 1u << 0,
    PAD_EAST = 1u << 1,
    PAD_WEST = 1u << 2,
    PAD_NORTH = 1u << 3,
    PAD_BACK = 1u << 4,
    PAD_START = 1u << 6,
    PAD_STICK_RIGHT = 1u << 8,
    PAD_SHOULDER_LEFT = 1u << 9,
    PAD_SHOULDER_RIGHT = 1u << 10,
    PAD_UP = 1u << 11,
    PAD_DOWN = 1u << 12,
    PAD_LEFT = 1u << 13,
    PAD_RIGHT = 1u << 14,
};

#define PAD_DEAD 4915          /* 15 % of an axis: worn sticks rest there. */
#define PAD_TRIGGER_ON 16384   /* Half way: down; ... */
#define PAD_TRIGGER_OFF 9830   /* ... and 30 %: up again, so that a trembling finger dips once. */
#define PAD_TILT_RAD (45.0f * F_DEG) /* Full right stick. */

/* Everything a pad can say at one moment; levels. */
struct pad_report {
    uint64_t time_ns;
    int16_t axis[PAD_AXIS_COUNT];
    uint32_t buttons;        /* enum pad_button levels; other bits are no matter. */
    uint8_t has_turn, has_weight; /* Since the last report, in SDL's axes: */
    vec3 turn_rad_s, weight_m_s2;
};

struct pad_hand {
    struct fly_poi fly;
    struct pad_tilt tilt;
    struct pad_report now;  /* The newest. */
    vec3 stick_twist;       /* Pitch, yaw, roll by the right stick, as fly_report's. */
    uint64_t time_ns;       /* As far as it has come. */
    uint8_t trigger_down;
    uint32_t held, pressed; /* enum input_button */
};

/* A hand over the middle of the water. `view` is copied. */
void pad_hand_init(struct pad_hand *hand, const struct view *view);

/* Takes one report, any bits; one that is older than the last counts as now. */
void pad_hand_report(struct pad_hand *hand, const struct pad_report *report);

/* Where the hand is at `time_ns`, which never goes back. Always finite. */
struct poi_sample pad_hand_sample(struct pad_hand *hand, uint64_t time_ns);

/* Its levels, and the edges since the last call. */
void pad_hand_buttons(struct pad_hand *hand, struct button_sample *out);

struct shade_input pad_hand_fan(struct pad_hand *hand, uint64_t time_ns);

void pad_hand_look(struct pad_hand *hand, const struct view *view);

/* How hard the two motors of a pad hum, 0 .. 65,535: the slow one with the water's push, the fast
 * one with a tail's blow and with paper that tears. */
struct pad_rumble {
    uint16_t slow, fast;
};
struct pad_rumble pad_rumble_of(const struct poi_force *force);

#endif
