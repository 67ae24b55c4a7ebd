/* gamepad_decoder.c -- implements the game pad decoder. */
#include "drivers/gamepad/gamepad_decoder.h"

#define AXIS_FULL 32767.0f
#define STICK_TWIST (GAMEPAD_TILT_RAD / STICK_MOTION_TILT_MAX_RAD)

void gamepad_decoder_init(struct gamepad_decoder *hand, const struct view *view)
{
    *hand = (struct gamepad_decoder){ 0 };
    stick_motion_init(&hand->fly, view);
}

void gamepad_decoder_set_view(struct gamepad_decoder *hand, const struct view *view)
{
    stick_motion_set_view(&hand->fly, view);
}

/* ---- Sticks and motion sensors --------------------------------------------------------------- */

/* Returns the deflection of a stick beyond its dead zone as a vector. The direction is that of the
 * stick, and the length is 0 to 1. */
static vec3 read_stick(int16_t x_raw, int16_t y_raw)
{
    const float dead = (float)GAMEPAD_DEAD / AXIS_FULL;
    const vec3 stick = v3((float)x_raw / AXIS_FULL, (float)y_raw / AXIS_FULL, 0.0f);
    const float length = v3_length(stick);
    const float way = f_clamp((length - dead) / (1.0f - dead), 0.0f, 1.0f);
    return v3_scale(stick, length > dead ? way / length : 0.0f);
}

static void read_triggers(struct gamepad_decoder *hand)
{
    const int16_t left = hand->now.axis[GAMEPAD_TRIGGER_LEFT];
    const int16_t right = hand->now.axis[GAMEPAD_TRIGGER_RIGHT];
    const int16_t most = left > right ? left : right;
    hand->trigger_down =
        most >= GAMEPAD_TRIGGER_ON || (hand->trigger_down && most > GAMEPAD_TRIGGER_OFF);
}

static void read_motion(struct gamepad_decoder *hand)
{
    if (hand->now.has_turn) {
        gamepad_imu_filter_add_rotation(&hand->tilt, hand->time_ns, hand->now.turn_rad_s);
    }
    if (hand->now.has_weight) {
        gamepad_imu_filter_add_gravity(&hand->tilt, hand->time_ns, hand->now.weight_m_s2);
    }
}

/* Converts the right stick to tilt. Pushing the stick away from the player lifts the far edge of
 * the ring, as the mouse wheel does. Pushing right lowers the right edge. */
static void read_sticks(struct gamepad_decoder *hand)
{
    const int16_t *axis = hand->now.axis;
    const vec3 twist = read_stick(axis[GAMEPAD_TILT_X], axis[GAMEPAD_TILT_Y]);
    hand->stick_twist = v3(-twist.y * STICK_TWIST, 0.0f, twist.x * STICK_TWIST);
}

/* ---- Pose ------------------------------------------------------------------------------------ */

static uint32_t hand_buttons(const struct gamepad_decoder *hand)
{
    const uint32_t buttons = hand->now.buttons;
    return (buttons & GAMEPAD_SOUTH || hand->trigger_down ? (uint32_t)POINTER_DIP : 0u) |
           (buttons & (GAMEPAD_WEST | GAMEPAD_STICK_RIGHT) ? (uint32_t)POINTER_LEVEL : 0u) |
           (buttons & GAMEPAD_SHOULDER_LEFT ? (uint32_t)POINTER_FAN : 0u);
}

/* Passes the deflection, the buttons, and the sum of the tilts from stick and motion sensors to
 * stick_motion. */
static void tell_fly(struct gamepad_decoder *hand)
{
    const uint32_t buttons = hand_buttons(hand);
    const struct angles wrist =
        gamepad_imu_filter_at(&hand->tilt, hand->time_ns, !(buttons & POINTER_DIP));
    const vec3 turned = v3(wrist.pitch_rad, 0.0f, wrist.roll_rad);
    const vec3 push = read_stick(hand->now.axis[GAMEPAD_LEAD_X], hand->now.axis[GAMEPAD_LEAD_Y]);
    const struct stick_report report = {
        .time_ns = hand->time_ns,
        .push = v3(push.x, 0.0f, push.y),
        .twist = v3_muladd(hand->stick_twist, turned, 1.0f / STICK_MOTION_TILT_MAX_RAD),
        .buttons = buttons,
    };
    stick_motion_report(&hand->fly, &report);
}

static void come_to(struct gamepad_decoder *hand, uint64_t time_ns)
{
    hand->time_ns = time_ns > hand->time_ns ? time_ns : hand->time_ns;
}

/* Converts pad buttons to cabinet buttons. Most pad buttons act as OK in the menus. */
static uint32_t cabinet_buttons(uint32_t buttons)
{
    return (buttons & GAMEPAD_START ? (uint32_t)INPUT_START : 0u) |
           (buttons & GAMEPAD_LEFT ? (uint32_t)INPUT_LEFT : 0u) |
           (buttons & GAMEPAD_RIGHT ? (uint32_t)INPUT_RIGHT : 0u) |
           (buttons & GAMEPAD_BACK ? (uint32_t)INPUT_LANGUAGE : 0u) |
           (buttons & (GAMEPAD_UP | GAMEPAD_DOWN | GAMEPAD_EAST | GAMEPAD_NORTH |
                       GAMEPAD_SHOULDER_RIGHT)
                ? (uint32_t)INPUT_OK
                : 0u);
}

void gamepad_decoder_report(struct gamepad_decoder *hand, const struct gamepad_report *report)
{
    const uint32_t before = hand->now.buttons;
    const uint32_t held = cabinet_buttons(report->buttons);
    come_to(hand, report->time_ns);
    hand->now = *report;
    read_triggers(hand);
    read_motion(hand);
    read_sticks(hand);
    if (report->buttons & ~before & (GAMEPAD_WEST | GAMEPAD_STICK_RIGHT)) {
        gamepad_imu_filter_level(&hand->tilt);
    }
    hand->pressed |= held & ~hand->held;
    hand->held = held;
    tell_fly(hand);
}

struct poi_sample gamepad_decoder_sample(struct gamepad_decoder *hand, uint64_t time_ns)
{
    come_to(hand, time_ns);
    tell_fly(hand);
    return (struct poi_sample){
        .time_ns = hand->time_ns,
        .target = stick_motion_target(&hand->fly, hand->time_ns),
    };
}

void gamepad_decoder_buttons(struct gamepad_decoder *hand, struct button_sample *out)
{
    *out = (struct button_sample){ .held = hand->held, .pressed = hand->pressed };
    hand->pressed = 0;
}

struct shade_input gamepad_decoder_fan(struct gamepad_decoder *hand, uint64_t time_ns)
{
    return stick_motion_fan(&hand->fly, time_ns);
}

/* ---- Force feedback -------------------------------------------------------------------------- */

static uint16_t motor(float level)
{
    return (uint16_t)(f_clamp(level, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

/* Returns the levels of the two motors for the forces on the poi (the paper scoop). The slow motor
 * gets the square of the drag. Squaring weakens a small drag most, so that the player barely feels
 * the poi when it glides edge-on through the water. */
struct gamepad_rumble gamepad_decoder_rumble(const struct poi_force *force)
{
    return (struct gamepad_rumble){
        .slow = motor(force->drag * force->drag),
        .fast = motor(f_max(force->slap, force->tear)),
    };
}
