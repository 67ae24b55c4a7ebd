/* pad_hand.c -- decodes a game pad. */
#include "drivers/pad_hand.h"

#define AXIS_FULL 32767.0f
#define STICK_TWIST (PAD_TILT_RAD / FLY_TILT_MAX_RAD)

void pad_hand_init(struct pad_hand *hand, const struct view *view)
{
    *hand = (struct pad_hand){ 0 };
    fly_poi_init(&hand->fly, view);
}

void pad_hand_look(struct pad_hand *hand, const struct view *view)
{
    fly_poi_look(&hand->fly, view);
}

/* ---- Sticks and motion ----------------------------------------------------------------------- */

/* Returns the deflection of a stick outside of its dead zone, with length [0, 1] and unchanged
 * direction. */
static vec3 read_stick(int16_t x_raw, int16_t y_raw)
{
    const float dead = (float)PAD_DEAD / AXIS_FULL;
    const vec3 stick = v3((float)x_raw / AXIS_FULL, (float)y_raw / AXIS_FULL, 0.0f);
    const float length = v3_length(stick);
    const float way = f_clamp((length - dead) / (1.0f - dead), 0.0f, 1.0f);
    return v3_scale(stick, length > dead ? way / length : 0.0f);
}

static void read_triggers(struct pad_hand *hand)
{
    const int16_t left = hand->now.axis[PAD_TRIGGER_LEFT];
    const int16_t right = hand->now.axis[PAD_TRIGGER_RIGHT];
    const int16_t most = left > right ? left : right;
    hand->trigger_down = most >= PAD_TRIGGER_ON || (hand->trigger_down && most > PAD_TRIGGER_OFF);
}

static void read_motion(struct pad_hand *hand)
{
    if (hand->now.has_turn) {
        pad_tilt_turns(&hand->tilt, hand->time_ns, hand->now.turn_rad_s);
    }
    if (hand->now.has_weight) {
        pad_tilt_weighs(&hand->tilt, hand->time_ns, hand->now.weight_m_s2);
    }
}

/* Converts the right stick to tilt: pushing away lifts the far edge, as the wheel does, and
 * pushing right lowers the right edge. */
static void read_sticks(struct pad_hand *hand)
{
    const int16_t *axis = hand->now.axis;
    const vec3 twist = read_stick(axis[PAD_TILT_X], axis[PAD_TILT_Y]);
    hand->stick_twist = v3(-twist.y * STICK_TWIST, 0.0f, twist.x * STICK_TWIST);
}

/* ---- Pose ------------------------------------------------------------------------------------ */

static uint32_t hand_buttons(const struct pad_hand *hand)
{
    const uint32_t buttons = hand->now.buttons;
    return (buttons & PAD_SOUTH || hand->trigger_down ? (uint32_t)POINTER_DIP : 0u) |
           (buttons & (PAD_WEST | PAD_STICK_RIGHT) ? (uint32_t)POINTER_LEVEL : 0u) |
           (buttons & PAD_SHOULDER_LEFT ? (uint32_t)POINTER_FAN : 0u);
}

/* Reports push, buttons and the sum of stick tilt and motion tilt to fly_poi. */
static void tell_fly(struct pad_hand *hand)
{
    const uint32_t buttons = hand_buttons(hand);
    const struct angles wrist = pad_tilt_at(&hand->tilt, hand->time_ns, !(buttons & POINTER_DIP));
    const vec3 turned = v3(wrist.pitch_rad, 0.0f, wrist.roll_rad);
    const vec3 push = read_stick(hand->now.axis[PAD_LEAD_X], hand->now.axis[PAD_LEAD_Y]);
    const struct fly_report report = {
        .time_ns = hand->time_ns,
        .push = v3(push.x, 0.0f, push.y),
        .twist = v3_mad(hand->stick_twist, turned, 1.0f / FLY_TILT_MAX_RAD),
        .buttons = buttons,
    };
    fly_poi_report(&hand->fly, &report);
}

static void come_to(struct pad_hand *hand, uint64_t time_ns)
{
    hand->time_ns = time_ns > hand->time_ns ? time_ns : hand->time_ns;
}

/* Maps pad buttons to cabinet buttons. Most buttons are OK in menus. */
static uint32_t cabinet_buttons(uint32_t buttons)
{
    return (buttons & PAD_START ? (uint32_t)INPUT_START : 0u) |
           (buttons & PAD_LEFT ? (uint32_t)INPUT_LEFT : 0u) |
           (buttons & PAD_RIGHT ? (uint32_t)INPUT_RIGHT : 0u) |
           (buttons & PAD_BACK ? (uint32_t)INPUT_LANGUAGE : 0u) |
           (buttons & (PAD_UP | PAD_DOWN | PAD_EAST | PAD_NORTH | PAD_SHOULDER_RIGHT)
                ? (uint32_t)INPUT_OK
                : 0u);
}

void pad_hand_report(struct pad_hand *hand, const struct pad_report *report)
{
    const uint32_t before = hand->now.buttons;
    const uint32_t held = cabinet_buttons(report->buttons);
    come_to(hand, report->time_ns);
    hand->now = *report;
    read_triggers(hand);
    read_motion(hand);
    read_sticks(hand);
    if (report->buttons & ~before & (PAD_WEST | PAD_STICK_RIGHT)) {
        pad_tilt_level(&hand->tilt);
    }
    hand->pressed |= held & ~hand->held;
    hand->held = held;
    tell_fly(hand);
}

struct poi_sample pad_hand_sample(struct pad_hand *hand, uint64_t time_ns)
{
    come_to(hand, time_ns);
    tell_fly(hand);
    return (struct poi_sample){
        .time_ns = hand->time_ns,
        .target = fly_poi_target(&hand->fly, hand->time_ns),
    };
}

void pad_hand_buttons(struct pad_hand *hand, struct button_sample *out)
{
    *out = (struct button_sample){ .held = hand->held, .pressed = hand->pressed };
    hand->pressed = 0;
}

struct shade_input pad_hand_fan(struct pad_hand *hand, uint64_t time_ns)
{
    return fly_poi_fan(&hand->fly, time_ns);
}

/* ---- Force feedback -------------------------------------------------------------------------- */

static uint16_t motor(float level)
{
    return (uint16_t)(f_clamp(level, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

/* Returns the motor levels. Drag is squared, so that a correct glide along the plane of the
 * paper is barely felt. */
struct pad_rumble pad_rumble_of(const struct poi_force *force)
{
    return (struct pad_rumble){
        .slow = motor(force->drag * force->drag),
        .fast = motor(f_max(force->slap, force->tear)),
    };
}
