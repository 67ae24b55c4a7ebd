/* pad_hand.c -- the manner of playing with a pad. */
#include "drivers/pad_hand.h"

#define LEAD_TAU_S 0.07f    /* A thumb snaps, an arm does not. */
#define TURN_TAU_S 0.06f    /* As a wheel's clicks: a ring has no jerks in it. */
#define STEP_S 0.02f        /* The way in longer steps would cut corners of the perspective. */
#define STEPS_MAX 25u       /* Half a second; who was stalled for longer has not led meanwhile. */
#define SLOPE_NDC 0.01f     /* Near enough for the slope of the picture at a place. */
#define ANGLE_MAX_RAD (80.0f * F_DEG) /* Upright it would hold nothing. */
#define AXIS_FULL 32767.0f

static float seconds_between(uint64_t from_ns, uint64_t to_ns)
{
    return to_ns > from_ns ? (float)(to_ns - from_ns) * 1e-9f : 0.0f;
}

void pad_hand_init(struct pad_hand *hand, const struct view *view)
{
    *hand = (struct pad_hand){ .report = { .width_px = 1280, .height_px = 720 } };
    pointer_poi_init(&hand->pointer, view);
    pointer_fan_init(&hand->fan, view);
}

void pad_hand_look(struct pad_hand *hand, const struct view *view)
{
    hand->pointer.view = hand->fan.view = *view;
}

void pad_hand_window(struct pad_hand *hand, uint32_t width_px, uint32_t height_px)
{
    if (width_px > 0 && height_px > 0) {
        hand->report.width_px = width_px;
        hand->report.height_px = height_px;
    }
}

/* ---- Sticks --------------------------------------------------------------------------------- */

/* A stick's way from its dead middle to its rim, [0, 1], squared: fine near the middle, and still
 * fast at the rim. Its direction stays. */
static void read_stick(int16_t x_raw, int16_t y_raw, float *x, float *y)
{
    const float dead = (float)PAD_DEAD / AXIS_FULL;
    *x = (float)x_raw / AXIS_FULL;
    *y = (float)y_raw / AXIS_FULL;
    const float length = f_sqrt(*x * *x + *y * *y);
    const float way = f_clamp((length - dead) / (1.0f - dead), 0.0f, 1.0f);
    const float scale = length > dead ? way * way / length : 0.0f;
    *x *= scale;
    *y *= scale;
}

/* How far the water under the pointer moves as the pointer does; the inverse of that leads it. 0
 * where the picture knows no water. */
static int slope_at(const struct pad_hand *hand, float aspect, float slope[2][2])
{
    const struct view *view = &hand->pointer.view;
    const float x = hand->ndc_x;
    const float y = hand->ndc_y;
    const vec3 here = view_point_on_plane(view, aspect, x, y, 0.0f);
    const vec3 right = view_point_on_plane(view, aspect, x + SLOPE_NDC, y, 0.0f);
    const vec3 above = view_point_on_plane(view, aspect, x, y + SLOPE_NDC, 0.0f);
    const float a = (right.x - here.x) / SLOPE_NDC;
    const float b = (above.x - here.x) / SLOPE_NDC;
    const float c = (right.z - here.z) / SLOPE_NDC;
    const float d = (above.z - here.z) / SLOPE_NDC;
    const float area = a * d - b * c;
    if (!(f_abs(area) > 1e-4f)) {
        return 0;
    }
    slope[0][0] = d / area;
    slope[0][1] = -b / area;
    slope[1][0] = -c / area;
    slope[1][1] = a / area;
    return 1;
}

static void lead(struct pad_hand *hand, float dt_s)
{
    float x;
    float z;
    float slope[2][2];
    read_stick(hand->now.axis[PAD_LEAD_X], hand->now.axis[PAD_LEAD_Y], &x, &z);
    const float left = f_exp(-dt_s / LEAD_TAU_S);
    hand->speed_x_m_s = f_lerp(x * PAD_LEAD_M_S, hand->speed_x_m_s, left);
    hand->speed_z_m_s = f_lerp(z * PAD_LEAD_M_S, hand->speed_z_m_s, left);
    const float aspect = (float)hand->report.width_px / (float)hand->report.height_px;
    if (slope_at(hand, aspect, slope)) {
        const float dx_m = hand->speed_x_m_s * dt_s;
        const float dz_m = hand->speed_z_m_s * dt_s;
        hand->ndc_x = f_clamp(hand->ndc_x + slope[0][0] * dx_m + slope[0][1] * dz_m, -1.0f, 1.0f);
        hand->ndc_y = f_clamp(hand->ndc_y + slope[1][0] * dx_m + slope[1][1] * dz_m, -1.0f, 1.0f);
    }
}

static uint32_t pointer_buttons(const struct pad_hand *hand)
{
    const uint32_t buttons = hand->now.buttons;
    return (buttons & PAD_SOUTH || hand->trigger_down ? (uint32_t)POINTER_DIP : 0u) |
           (buttons & (PAD_WEST | PAD_STICK_RIGHT) ? (uint32_t)POINTER_LEVEL : 0u) |
           (buttons & PAD_SHOULDER_LEFT ? (uint32_t)POINTER_FAN : 0u);
}

/* What a mouse would have said that was led there. */
static void tell_pointer(struct pad_hand *hand, uint64_t time_ns)
{
    struct pointer_report *report = &hand->report;
    report->time_ns = time_ns;
    report->x_px = 0.5f * (hand->ndc_x + 1.0f) * (float)report->width_px;
    report->y_px = 0.5f * (1.0f - hand->ndc_y) * (float)report->height_px;
    report->buttons = pointer_buttons(hand);
    report->wheel_notches =
        (hand->tilt_goal_rad - hand->pointer.tilt_goal_rad) / POINTER_TILT_STEP_RAD;
    pointer_fan_report(&hand->fan, report);
    pointer_poi_report(&hand->pointer, report);
}

static void lead_to(struct pad_hand *hand, uint64_t time_ns)
{
    float left_s = hand->time_ns > 0 ? seconds_between(hand->time_ns, time_ns) : 0.0f;
    for (uint32_t i = 0; i < STEPS_MAX && left_s > 0.0f; i++) {
        const float dt_s = f_min(left_s, STEP_S);
        lead(hand, dt_s);
        left_s -= dt_s;
    }
    hand->time_ns = time_ns > hand->time_ns ? time_ns : hand->time_ns;
}

/* ---- Reports -------------------------------------------------------------------------------- */

static void read_triggers(struct pad_hand *hand)
{
    const int16_t left = hand->now.axis[PAD_TRIGGER_LEFT];
    const int16_t right = hand->now.axis[PAD_TRIGGER_RIGHT];
    const int16_t most = left > right ? left : right;
    hand->trigger_down = most >= PAD_TRIGGER_ON || (hand->trigger_down && most > PAD_TRIGGER_OFF);
}

/* In menus nearly anything is OK. */
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

static void read_motion(struct pad_hand *hand)
{
    if (hand->now.has_turn) {
        pad_tilt_turns(&hand->tilt, hand->time_ns, hand->now.turn_rad_s);
    }
    if (hand->now.has_weight) {
        pad_tilt_weighs(&hand->tilt, hand->time_ns, hand->now.weight_m_s2);
    }
}

void pad_hand_report(struct pad_hand *hand, const struct pad_report *report)
{
    const uint32_t before = hand->now.buttons;
    float x;
    float y;
    lead_to(hand, report->time_ns);
    hand->now = *report;
    read_triggers(hand);
    read_motion(hand);
    if (report->buttons & ~before & (PAD_WEST | PAD_STICK_RIGHT)) {
        pad_tilt_level(&hand->tilt);
    }
    read_stick(report->axis[PAD_TILT_X], report->axis[PAD_TILT_Y], &x, &y);
    hand->tilt_goal_rad = -y * PAD_TILT_RAD; /* Pushed away the far edge rises, as by the wheel. */
    hand->roll_goal_rad = x * PAD_TILT_RAD;
    const uint32_t held = cabinet_buttons(report->buttons);
    hand->pressed |= held & ~hand->held;
    hand->held = held;
    tell_pointer(hand, hand->time_ns);
}

/* What stick and wrist turn the ring by: LEVEL and a thumb that lets go change it at once, the ring
 * follows. */
static void turn_to(struct pad_hand *hand)
{
    const int hovers = !(hand->report.buttons & POINTER_DIP);
    const struct angles wrist = pad_tilt_at(&hand->tilt, hand->time_ns, hovers);
    const float dt_s = hand->turn_ns > 0 ? seconds_between(hand->turn_ns, hand->time_ns) : 0.0f;
    const float left = f_exp(-f_min(dt_s / TURN_TAU_S, 50.0f));
    hand->turn.pitch_rad = f_lerp(wrist.pitch_rad, hand->turn.pitch_rad, left);
    hand->turn.roll_rad =
        f_lerp(wrist.roll_rad + hand->roll_goal_rad, hand->turn.roll_rad, left);
    hand->turn_ns = hand->time_ns;
}

struct poi_sample pad_hand_sample(struct pad_hand *hand, uint64_t time_ns)
{
    lead_to(hand, time_ns);
    tell_pointer(hand, hand->time_ns);
    turn_to(hand);
    struct poi_target target = pointer_poi_target(&hand->pointer, hand->time_ns);
    struct angles *angles = &target.angles;
    angles->pitch_rad =
        f_clamp(angles->pitch_rad + hand->turn.pitch_rad, -ANGLE_MAX_RAD, ANGLE_MAX_RAD);
    angles->roll_rad =
        f_clamp(angles->roll_rad + hand->turn.roll_rad, -ANGLE_MAX_RAD, ANGLE_MAX_RAD);
    return (struct poi_sample){ .time_ns = hand->time_ns, .target = target };
}

void pad_hand_buttons(struct pad_hand *hand, struct button_sample *out)
{
    *out = (struct button_sample){ .held = hand->held, .pressed = hand->pressed };
    hand->pressed = 0;
}

struct shade_input pad_hand_fan(struct pad_hand *hand, uint64_t time_ns)
{
    return pointer_fan_shade(&hand->fan, time_ns);
}

/* ---- What the hand feels --------------------------------------------------------------------- */

static uint16_t motor(float level)
{
    return (uint16_t)(f_clamp(level, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

/* Squared: a glide along the paper's plane, as it should be, is hardly felt. */
struct pad_rumble pad_rumble_of(const struct poi_force *force)
{
    return (struct pad_rumble){
        .slow = motor(force->drag * force->drag),
        .fast = motor(f_max(force->slap, force->tear)),
    };
}
