/* hid_pose_decoder.c -- turns the values of a controller's bindings into motion of the poi. */
#include "drivers/hid/hid_pose_decoder.h"

#include <string.h>

#include "core/base/panic.h"
#include "drivers/hid/poi_report.h"

/* Width of a virtual window for a relative mouse, in which each count moves one pixel. */
#define WINDOW_WIDTH 1920u
#define WINDOW_HEIGHT 1080u

/* Time in which the poi returns to the controller's position after the FAN button is released. */
#define POI_FAN_BACK_S 0.5f

/* ---- Fan of Kingyo's poi controller ---------------------------------------------------------- */

/* Z coordinate of the idle fan: in front of the player, beyond the near edge of every tank. */
#define LAP_Z_M 0.75f

static void go_to_time(struct poi_fan *fan, uint64_t time_ns)
{
    if (time_ns <= fan->time_ns) {
        return;
    }
    const float dt_s = fan->time_ns > 0 ? (float)(time_ns - fan->time_ns) * 1e-9f : 0.0f;
    const float swing = dt_s / POINTER_FAN_SWING_S;
    fan->swing = f_clamp(fan->swing + (fan->held ? swing : -swing), 0.0f, 1.0f);
    fan->back = fan->held ? fan->back : f_min(1.0f, fan->back + dt_s / POI_FAN_BACK_S);
    fan->time_ns = time_ns;
}

/* Interpolates an angle in the shorter direction. A value that is not finite is returned unchanged,
 * so that the core rejects it. */
static float interpolate_angle(float from_rad, float to_rad, float share)
{
    const float way_rad = to_rad - from_rad;
    return f_is_finite(way_rad) && f_abs(way_rad) < 1000.0f
               ? from_rad + share * f_wrap_angle(way_rad)
               : to_rad;
}

/* Returns the pose of the poi. */
static struct poi_target poi_fan_pose(const struct poi_fan *fan)
{
    CORE_ASSERT(fan->back >= 0.0f && fan->back <= 1.0f);
    const float share = f_smoothstep(0.0f, 1.0f, fan->back);
    const struct poi_target *from = &fan->waits, *to = &fan->hand;
    if (fan->back >= 1.0f) {
        return *to;
    }
    return (struct poi_target){
        .position_m = v3_lerp(from->position_m, to->position_m, share),
        .angles = { .yaw_rad = interpolate_angle(from->angles.yaw_rad, to->angles.yaw_rad, share),
                    .pitch_rad =
                        interpolate_angle(from->angles.pitch_rad, to->angles.pitch_rad, share),
                    .roll_rad =
                        interpolate_angle(from->angles.roll_rad, to->angles.roll_rad, share) },
    };
}

/* Sets the controller's pose `hand` at `time_ns`, which must not decrease. `held` is 1 if the FAN
 * key is pressed. */
static void poi_fan_move(struct poi_fan *fan, const struct poi_target *hand, int held,
                         uint64_t time_ns)
{
    go_to_time(fan, time_ns);
    if (held && !fan->held) {
        fan->waits = poi_fan_pose(fan); /* The pose from before the current report is stored,
                                           because the report may also move the controller. */
        fan->back = 0.0f;
    }
    fan->held = held != 0;
    fan->hand = *hand;
}

/* Returns the shadow of the fan on the water at `time_ns`. */
static struct shade_input poi_fan_shade(struct poi_fan *fan, uint64_t time_ns)
{
    CORE_ASSERT(fan->swing >= 0.0f && fan->swing <= 1.0f);
    go_to_time(fan, time_ns);
    const float share = f_smoothstep(0.0f, 1.0f, fan->swing);
    const vec3 at_m = fan->hand.position_m;
    return (struct shade_input){
        .present = fan->swing > 0.0f,
        .x_m = at_m.x,
        .z_m = f_lerp(f_max(LAP_Z_M, at_m.z), at_m.z, share),
        .radius_m = POINTER_FAN_RADIUS_M,
    };
}

/* ---- Start ----------------------------------------------------------------------------------- */

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
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    CORE_ASSERT(map->style == HID_STYLE_POSE || map->style == HID_STYLE_POINTER ||
                map->style == HID_STYLE_FLY);
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
    hand->pose = (struct poi_fan){ .back = 1.0f };
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
    CORE_ASSERT(role < HID_ROLE_COUNT);
    CORE_ASSERT(manner <= HID_BINDING_KIND_COUNT);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role &&
            (manner == HID_BINDING_KIND_COUNT || binding->manner == manner)) {
            sum += hand->value[i];
        }
    }
    return sum;
}

static int is_role_mapped(const struct hid_pose_decoder *hand, enum hid_role role,
                          enum hid_binding_kind manner)
{
    CORE_ASSERT(role < HID_ROLE_COUNT);
    CORE_ASSERT(manner < HID_BINDING_KIND_COUNT);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role && binding->manner == manner) {
            return 1;
        }
    }
    return 0;
}

static int is_role_pressed(const struct hid_pose_decoder *hand, enum hid_role role)
{
    return sum_of(hand, role, HID_BINDING_PRESS) > 0.5f;
}

static uint32_t pointer_buttons(const struct hid_pose_decoder *hand)
{
    return (is_role_pressed(hand, HID_ROLE_DIP) ? (uint32_t)POINTER_DIP : 0u) |
           (is_role_pressed(hand, HID_ROLE_LEVEL) ? (uint32_t)POINTER_LEVEL : 0u) |
           (is_role_pressed(hand, HID_ROLE_FAN) ? (uint32_t)POINTER_FAN : 0u);
}

static int is_in_range(const struct hid_pose_decoder *hand)
{
    return !is_role_mapped(hand, HID_ROLE_IN_RANGE, HID_BINDING_PRESS) ||
           is_role_pressed(hand, HID_ROLE_IN_RANGE);
}

/* Updates the pointer. While a pen is out of range its axes are invalid, so the last position is
 * kept. */
static void update_pointer(struct hid_pose_decoder *hand)
{
    struct pointer_report *report = &hand->report;
    CORE_ASSERT(hand->map.style == HID_STYLE_POINTER);
    const int in_range = is_in_range(hand);
    const float width = (float)WINDOW_WIDTH, height = (float)WINDOW_HEIGHT;
    report->time_ns = hand->time_ns;
    report->wheel_notches = sum_of(hand, HID_ROLE_TILT, HID_BINDING_STEP);
    report->buttons = in_range ? pointer_buttons(hand) : 0u;
    if (is_role_mapped(hand, HID_ROLE_X, HID_BINDING_POSITION) && in_range) {
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

/* Returns the sum of the deflections (-1 to 1) of the sticks and hats that are bound to an axis. A
 * hat is bound to an axis if the controller is a four-switch joystick. */
static float push_of(const struct hid_pose_decoder *hand, enum hid_role role)
{
    static const int8_t right[] = { 0, 1, 1, 1, 0, -1, -1, -1 };
    static const int8_t near[] = { -1, -1, 0, 1, 1, 1, 0, -1 };
    const int8_t *way = role == HID_ROLE_X ? right : near;
    float push = 0.0f;
    CORE_ASSERT(role == HID_ROLE_X || role == HID_ROLE_Z);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->role == role && binding->manner == HID_BINDING_HAT && hand->value[i] >= 0.0f) {
            push += (float)way[(int)hand->value[i] % 8];
        }
    }
    return sum_of(hand, role, HID_BINDING_RATE) + push;
}

static vec3 twist_of(const struct hid_pose_decoder *hand)
{
    return v3(sum_of(hand, HID_ROLE_PITCH, HID_BINDING_KIND_COUNT),
              sum_of(hand, HID_ROLE_YAW, HID_BINDING_KIND_COUNT),
              sum_of(hand, HID_ROLE_ROLL, HID_BINDING_KIND_COUNT));
}

static void update_fly_pose(struct hid_pose_decoder *hand)
{
    CORE_ASSERT(hand->map.style == HID_STYLE_FLY);
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

/* Updates the cabinet buttons of the controller. */
static void update_cabinet_buttons(struct hid_pose_decoder *hand)
{
    CORE_ASSERT(hand->map.count <= HID_BINDING_MAX);
    uint32_t held = (is_role_pressed(hand, HID_ROLE_START) ? (uint32_t)INPUT_START : 0u) |
                    (is_role_pressed(hand, HID_ROLE_LEFT) ? (uint32_t)INPUT_LEFT : 0u) |
                    (is_role_pressed(hand, HID_ROLE_RIGHT) ? (uint32_t)INPUT_RIGHT : 0u) |
                    (is_role_pressed(hand, HID_ROLE_OK) ? (uint32_t)INPUT_OK : 0u);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const int direction = (int)hand->value[i];
        if (hand->map.binding[i].role == HID_ROLE_HAT && direction >= 0) {
            held |= direction >= 5 ? INPUT_LEFT : direction % 4 == 0 ? INPUT_OK : INPUT_RIGHT;
        }
    }
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
static int decode_pose_report(struct hid_pose_decoder *hand, const struct hid_raw *raw)
{
    CORE_ASSERT(hand->map.style == HID_STYLE_POSE);
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

int hid_pose_decoder_report(struct hid_pose_decoder *hand, const struct hid_raw *raw)
{
    const uint32_t size = raw->size < HID_REPORT_MAX ? raw->size : HID_REPORT_MAX;
    const struct hid_report report = { .bytes = raw->bytes, .size = size };
    CORE_ASSERT(hand->refused_count <= hand->report_count);
    hand->report_count++;
    if (raw->time_ns > hand->time_ns) {
        hand->time_ns = raw->time_ns;
    }
    if (raw->size == 0 || raw->size > HID_REPORT_MAX ||
        !hid_report_is_whole(&hand->descriptor, report)) {
        return hid_pose_decoder_error(hand);
    }
    if (hand->map.style == HID_STYLE_POSE && !decode_pose_report(hand, raw)) {
        return 0;
    }
    if (!hid_axis_decoder_read(hand, (uint8_t)hid_report_id(&hand->descriptor, report), report)) {
        return 0; /* The mapping binds no field of the report. For example, the report has only the
                     state of a battery. */
    }
    if (hand->map.style == HID_STYLE_POINTER) {
        update_pointer(hand);
    } else if (hand->map.style == HID_STYLE_FLY) {
        update_fly_pose(hand);
    }
    update_cabinet_buttons(hand);
    return 1;
}

/* ---- Output of the pose and the buttons ----------------------------------------------------- */

int hid_pose_decoder_sample(struct hid_pose_decoder *hand, uint64_t time_ns, struct poi_sample *out)
{
    CORE_ASSERT(hand->map.style > HID_STYLE_NONE && hand->map.style <= HID_STYLE_FLY);
    const int is_pose = hand->map.style == HID_STYLE_POSE;
    const int is_put_aside = !is_in_range(hand) && time_ns > hand->range_ns &&
                             time_ns - hand->range_ns > HID_PEN_AWAY_NS;
    if (!hand->present || is_put_aside) {
        return 0;
    }
    *out = (struct poi_sample){
        .time_ns = is_pose ? hand->time_ns : time_ns,
        .has_wrist = (uint8_t)is_pose,
        .trembles = hand->map.trembles,
    };
    if (is_pose) {
        out->target = poi_fan_pose(&hand->pose);
    } else if (hand->map.style == HID_STYLE_FLY) {
        out->target = stick_motion_target(&hand->fly, time_ns);
    } else {
        /* The rotation of a pen is added to the tilt. The rotation is zero for a mouse. */
        const vec3 twist = v3_scale(twist_of(hand), STICK_MOTION_TILT_MAX_RAD);
        out->target = pointer_poi_target(&hand->pointer, time_ns);
        out->target.angles.pitch_rad += twist.x;
        out->target.angles.yaw_rad += twist.y;
        out->target.angles.roll_rad += twist.z;
    }
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
