/* hid_pose_decoder.c -- turns the values of a controller's bindings into motion of the poi. */
#include "drivers/hid/hid_pose_decoder.h"

#include <string.h>

#include "drivers/hid/hid_axis_decoder.h"
#include "drivers/hid/poi_report.h"

/* Width of a virtual window for a relative mouse, in which each count moves one pixel. */
#define WINDOW_WIDTH 1920u
#define WINDOW_HEIGHT 1080u

int hid_pose_decoder_init(struct hid_pose_decoder *hand, const struct hid_device_info *face,
                          const struct hid_mapping *map, const struct view *view)
{
    memset(hand, 0, sizeof *hand);
    const uint32_t size =
        face->descriptor_size < HID_DESCRIPTOR_MAX ? face->descriptor_size : HID_DESCRIPTOR_MAX;
    hid_descriptor_read(&hand->descriptor, face->descriptor, size);
    if (!hid_mapping_is_sound(map, &hand->descriptor)) {
        return -1;
    }
    hand->map = *map;
    hid_axis_decoder_find_arrays(hand);
    hand->report = (struct pointer_report){
        .x_px = 0.5f * WINDOW_WIDTH,
        .y_px = 0.5f * WINDOW_HEIGHT,
        .width_px = WINDOW_WIDTH,
        .height_px = WINDOW_HEIGHT,
    };
    for (uint32_t i = 0; i < map->count; i++) {
        hand->value[i] = map->binding[i].manner == HID_BINDING_HAT ? -1.0f : 0.0f;
    }
    pointer_poi_init(&hand->pointer, view);
    pointer_fan_init(&hand->fan, view);
    stick_motion_init(&hand->fly, view);
    poi_fan_init(&hand->pose);
    return 0;
}

void hid_pose_decoder_set_view(struct hid_pose_decoder *hand, const struct view *view)
{
    hand->pointer.view = hand->fan.view = *view;
    stick_motion_set_view(&hand->fly, view);
}

/* ---- From binding values to motion ---------------------------------------------------------- */

/* Returns the sum of the values of all bindings with the role `role` and the manner `manner`.
 * HID_BINDING_KIND_COUNT means every manner. */
static float sum_of(const struct hid_pose_decoder *hand, enum hid_role role,
                    enum hid_binding_kind manner)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role &&
            (manner == HID_BINDING_KIND_COUNT || binding->manner == manner)) {
            sum += hand->value[i];
        }
    }
    return sum;
}

static int has(const struct hid_pose_decoder *hand, enum hid_role role,
               enum hid_binding_kind manner)
{
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role && binding->manner == manner) {
            return 1;
        }
    }
    return 0;
}

static int is_pressed(const struct hid_pose_decoder *hand, enum hid_role role)
{
    return sum_of(hand, role, HID_BINDING_PRESS) > 0.5f;
}

static uint32_t pointer_buttons(const struct hid_pose_decoder *hand)
{
    return (is_pressed(hand, HID_ROLE_DIP) ? (uint32_t)POINTER_DIP : 0u) |
           (is_pressed(hand, HID_ROLE_LEVEL) ? (uint32_t)POINTER_LEVEL : 0u) |
           (is_pressed(hand, HID_ROLE_FAN) ? (uint32_t)POINTER_FAN : 0u);
}

static int is_in_range(const struct hid_pose_decoder *hand)
{
    return !has(hand, HID_ROLE_IN_RANGE, HID_BINDING_PRESS) || is_pressed(hand, HID_ROLE_IN_RANGE);
}

/* Updates the pointer. While a pen is out of range its axes are invalid, so the last position is
 * kept. */
static void point(struct hid_pose_decoder *hand)
{
    struct pointer_report *report = &hand->report;
    const int in_range = is_in_range(hand);
    const float width = (float)WINDOW_WIDTH, height = (float)WINDOW_HEIGHT;
    report->time_ns = hand->time_ns;
    report->wheel_notches = sum_of(hand, HID_ROLE_TILT, HID_BINDING_STEP);
    report->buttons = in_range ? pointer_buttons(hand) : 0u;
    if (has(hand, HID_ROLE_X, HID_BINDING_POSITION) && in_range) {
        report->x_px = 0.5f * width * (1.0f + sum_of(hand, HID_ROLE_X, HID_BINDING_POSITION));
        report->y_px = 0.5f * height * (1.0f + sum_of(hand, HID_ROLE_Z, HID_BINDING_POSITION));
    }
    report->x_px += sum_of(hand, HID_ROLE_X, HID_BINDING_STEP);
    report->y_px += sum_of(hand, HID_ROLE_Z, HID_BINDING_STEP);
    report->x_px = f_clamp(report->x_px, 0.0f, width);
    report->y_px = f_clamp(report->y_px, 0.0f, height);
    pointer_fan_report(&hand->fan, report);
    pointer_poi_report(&hand->pointer, report);
    if (in_range) {
        hand->range_ns = hand->time_ns;
        hand->present = 1;
    }
}

/* Returns the deflection (-1 to 1) of a hat that is bound to an axis, as for a four-switch
 * joystick. */
static float hat_push(const struct hid_pose_decoder *hand, enum hid_role role)
{
    static const int8_t right[] = { 0, 1, 1, 1, 0, -1, -1, -1 };
    static const int8_t near[] = { -1, -1, 0, 1, 1, 1, 0, -1 };
    const int8_t *way = role == HID_ROLE_X ? right : near;
    float push = 0.0f;
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role && binding->manner == HID_BINDING_HAT && hand->value[i] >= 0.0f) {
            push += (float)way[(int)hand->value[i] % 8];
        }
    }
    return push;
}

static float push_of(const struct hid_pose_decoder *hand, enum hid_role role)
{
    return sum_of(hand, role, HID_BINDING_RATE) + hat_push(hand, role);
}

static vec3 twist_of(const struct hid_pose_decoder *hand)
{
    return v3(sum_of(hand, HID_ROLE_PITCH, HID_BINDING_KIND_COUNT),
              sum_of(hand, HID_ROLE_YAW, HID_BINDING_KIND_COUNT),
              sum_of(hand, HID_ROLE_ROLL, HID_BINDING_KIND_COUNT));
}

static void fly(struct hid_pose_decoder *hand)
{
    const struct stick_report report = {
        .time_ns = hand->time_ns,
        .push = v3(push_of(hand, HID_ROLE_X), sum_of(hand, HID_ROLE_Y, HID_BINDING_RATE),
                   push_of(hand, HID_ROLE_Z)),
        .twist = twist_of(hand),
        .buttons = pointer_buttons(hand),
    };
    stick_motion_report(&hand->fly, &report);
    hand->present = 1;
}

static uint32_t hat_buttons(const struct hid_pose_decoder *hand)
{
    uint32_t buttons = 0;
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const int direction = (int)hand->value[i];
        if (hand->map.binding[i].role == HID_ROLE_HAT && direction >= 0) {
            buttons |= direction >= 5 ? INPUT_LEFT : direction % 4 == 0 ? INPUT_OK : INPUT_RIGHT;
        }
    }
    return buttons;
}

static void press(struct hid_pose_decoder *hand)
{
    const uint32_t held = (is_pressed(hand, HID_ROLE_START) ? (uint32_t)INPUT_START : 0u) |
                          (is_pressed(hand, HID_ROLE_LEFT) ? (uint32_t)INPUT_LEFT : 0u) |
                          (is_pressed(hand, HID_ROLE_RIGHT) ? (uint32_t)INPUT_RIGHT : 0u) |
                          (is_pressed(hand, HID_ROLE_OK) ? (uint32_t)INPUT_OK : 0u) |
                          hat_buttons(hand);
    hand->pressed |= held & ~hand->held;
    hand->held = held;
}

/* ---- Decoding of reports -------------------------------------------------------------------- */

static int hid_pose_decoder_error(struct hid_pose_decoder *hand)
{
    hand->refused_count++;
    return 0;
}

/* Decodes a report of Kingyo's poi controller. Returns 1. Returns 0 and rejects the report if it is
 * invalid or repeats a sequence number. Missing sequence numbers are counted in gap_count. */
static int pose(struct hid_pose_decoder *hand, const struct hid_raw *raw)
{
    struct poi_report report;
    if (!poi_report_decode(raw->bytes, raw->size, &report)) {
        return hid_pose_decoder_error(hand);
    }
    const uint8_t step = (uint8_t)(report.sequence - hand->sequence);
    if (hand->has_sequence && step == 0) {
        return hid_pose_decoder_error(hand);
    }
    hand->gap_count += hand->has_sequence ? step - 1u : 0u;
    hand->sequence = report.sequence;
    hand->has_sequence = 1;
    poi_fan_move(&hand->pose, &report.target, report.buttons & POI_BUTTON_FAN, hand->time_ns);
    hand->present = 1;
    return 1;
}

static int lead(struct hid_pose_decoder *hand, const struct hid_raw *raw, struct hid_report report)
{
    const uint8_t id = (uint8_t)hid_report_id(&hand->descriptor, report);
    if (hand->map.style == HID_STYLE_POSE && !pose(hand, raw)) {
        return 0;
    }
    if (!hid_axis_decoder_read(hand, id, report)) {
        return 0; /* The mapping binds no field of the report. For example, the report has only the
                     state of a battery. */
    }
    if (hand->map.style == HID_STYLE_POINTER) {
        point(hand);
    } else if (hand->map.style == HID_STYLE_FLY) {
        fly(hand);
    }
    press(hand);
    return 1;
}

int hid_pose_decoder_report(struct hid_pose_decoder *hand, const struct hid_raw *raw)
{
    const uint32_t size = raw->size < HID_REPORT_MAX ? raw->size : HID_REPORT_MAX;
    const struct hid_report report = { .bytes = raw->bytes, .size = size };
    hand->report_count++;
    if (raw->time_ns > hand->time_ns) {
        hand->time_ns = raw->time_ns;
    }
    if (raw->size == 0 || raw->size > HID_REPORT_MAX ||
        !hid_report_is_whole(&hand->descriptor, report)) {
        return hid_pose_decoder_error(hand);
    }
    return lead(hand, raw, report);
}

/* ---- Output of the pose and the buttons ----------------------------------------------------- */

static struct poi_target pointed(struct hid_pose_decoder *hand, uint64_t time_ns)
{
    struct poi_target target = pointer_poi_target(&hand->pointer, time_ns);
    /* The rotation of a pen is added to the tilt. The rotation is zero for a mouse. */
    const vec3 twist = v3_scale(twist_of(hand), STICK_MOTION_TILT_MAX_RAD);
    target.angles.pitch_rad += twist.x;
    target.angles.yaw_rad += twist.y;
    target.angles.roll_rad += twist.z;
    return target;
}

static int is_put_aside(const struct hid_pose_decoder *hand, uint64_t time_ns)
{
    return !is_in_range(hand) && time_ns > hand->range_ns &&
           time_ns - hand->range_ns > HID_PEN_AWAY_NS;
}

int hid_pose_decoder_sample(struct hid_pose_decoder *hand, uint64_t time_ns, struct poi_sample *out)
{
    const int is_pose = hand->map.style == HID_STYLE_POSE;
    if (!hand->present || is_put_aside(hand, time_ns)) {
        return 0;
    }
    *out = (struct poi_sample){
        .time_ns = is_pose ? hand->time_ns : time_ns,
        .has_wrist = (uint8_t)is_pose,
        .trembles = hand->map.trembles,
        .target = is_pose                                ? poi_fan_pose(&hand->pose)
                  : hand->map.style == HID_STYLE_POINTER ? pointed(hand, time_ns)
                                                         : stick_motion_target(&hand->fly, time_ns),
    };
    return 1;
}

void hid_pose_decoder_buttons(struct hid_pose_decoder *hand, struct button_sample *out)
{
    out->held |= hand->held;
    out->pressed |= hand->pressed;
    hand->pressed = 0;
}

struct shade_input hid_pose_decoder_fan(struct hid_pose_decoder *hand, uint64_t time_ns)
{
    switch (hand->map.style) {
    case HID_STYLE_POINTER:
        return pointer_fan_shade(&hand->fan, time_ns);
    case HID_STYLE_FLY:
        return stick_motion_fan(&hand->fly, time_ns);
    case HID_STYLE_POSE:
        return poi_fan_shade(&hand->pose, time_ns);
    default:
        return (struct shade_input){ 0 };
    }
}
