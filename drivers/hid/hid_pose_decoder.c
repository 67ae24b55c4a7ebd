/* hid_pose_decoder.c -- turns the reports of a controller into motion of the poi. A report of
 * Kingyo's poi controller is decoded directly. Other reports are decoded by the bindings of a
 * mapping (hid_axis_decoder.c). */
#include "drivers/hid/poi_hid.h"

#include <string.h>

#include "core/base/panic.h"
#include "drivers/hid/poi_report.h"

/* Width of a virtual window for a relative mouse, in which each count moves one pixel. */
#define WINDOW_WIDTH 1920.0f
#define WINDOW_HEIGHT 1080.0f

/* ---- Pose and fan of Kingyo's poi controller ------------------------------------------------- */

/* Time in seconds in which the poi returns to the controller's position after the FAN button is
 * released. */
#define RETURN_S 0.5f
/* Z coordinate of the idle fan: in front of the player, beyond the near edge of every tank. */
#define FAN_REST_Z_M 0.75f

static void go_to_time(struct own_pose *own, uint64_t time_ns)
{
    const float dt_s = pointer_fan_swing(&own->swing, time_ns);
    own->back = own->swing.held ? own->back : f_min(1.0f, own->back + dt_s / RETURN_S);
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

/* Returns the pose of the poi. The poi stands still at `own->waits` while the fan is used, and
 * returns to the controller's pose afterwards. */
static struct poi_target pose_of(const struct own_pose *own)
{
    CORE_ASSERT(own->back >= 0.0f && own->back <= 1.0f);
    const float share = f_smoothstep(0.0f, 1.0f, own->back);
    const struct poi_target *from = &own->waits, *to = &own->pose;
    if (own->back >= 1.0f) {
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

/* Decodes a report of Kingyo's poi controller and writes the pressed cabinet buttons to `held`.
 * Returns false if the report is invalid or repeats a sequence number. */
static bool decode_own_report(struct hid_pose_decoder *decoder, const struct hid_raw *raw,
                              uint32_t *held)
{
    static const uint32_t buttons[][2] = {
        { POI_BUTTON_START, INPUT_START },
        { POI_BUTTON_LEFT, INPUT_LEFT },
        { POI_BUTTON_RIGHT, INPUT_RIGHT },
        { POI_BUTTON_OK, INPUT_OK },
    };
    struct own_pose *own = &decoder->own;
    struct poi_report report;
    CORE_ASSERT(decoder->map.style == HID_STYLE_POSE);
    if (!poi_report_decode(raw->bytes, raw->size, &report)) {
        return false;
    }
    const uint8_t step = (uint8_t)(report.sequence - own->sequence);
    if (own->has_sequence && step == 0) {
        return false;
    }
    decoder->gap_count += own->has_sequence ? step - 1u : 0u;
    own->sequence = report.sequence;
    own->has_sequence = true;
    go_to_time(own, decoder->time_ns);
    const bool is_fan_held = (report.buttons & POI_BUTTON_FAN) != 0;
    if (is_fan_held && !own->swing.held) {
        /* Store the pose from before the current report as the pose at which the poi stands still,
         * because the report may also move the controller. */
        own->waits = pose_of(own);
        own->back = 0.0f;
    }
    own->swing.held = is_fan_held;
    own->pose = report.target;
    *held = 0;
    for (uint32_t i = 0; i < sizeof buttons / sizeof buttons[0]; i++) {
        *held |= report.buttons & buttons[i][0] ? buttons[i][1] : 0u;
    }
    return true;
}

/* ---- Initialization -------------------------------------------------------------------------- */

int hid_pose_decoder_init(struct hid_pose_decoder *decoder, const struct hid_device_info *face,
                          const struct hid_mapping *map, const struct view *view)
{
    CORE_ASSERT(face->descriptor_size <= HID_DESCRIPTOR_MAX);
    memset(decoder, 0, sizeof *decoder);
    hid_descriptor_read(&decoder->descriptor, face->descriptor, face->descriptor_size);
    if (!hid_mapping_is_sound(map, &decoder->descriptor)) {
        return -1;
    }
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    CORE_ASSERT(map->style > HID_STYLE_NONE && map->style <= HID_STYLE_FLY);
    decoder->map = *map;
    hid_axis_decoder_find_arrays(decoder);
    decoder->report = (struct pointer_report){
        .x_px = 0.5f * WINDOW_WIDTH,
        .y_px = 0.5f * WINDOW_HEIGHT,
        .width_px = (uint32_t)WINDOW_WIDTH,
        .height_px = (uint32_t)WINDOW_HEIGHT,
    };
    for (uint32_t i = 0; i < map->count; i++) {
        decoder->value[i] = map->binding[i].manner == HID_BINDING_HAT ? -1.0f : 0.0f;
    }
    pointer_poi_init(&decoder->pointer, view);
    stick_motion_init(&decoder->fly, view);
    decoder->own.back = 1.0f;
    return 0;
}

void hid_pose_decoder_set_view(struct hid_pose_decoder *decoder, const struct view *view)
{
    decoder->pointer.view = *view;
    stick_motion_set_view(&decoder->fly, view);
}

/* ---- From binding values to motion ---------------------------------------------------------- */

/* Returns the sum of the values of all bindings that have the role `role` and the kind `manner`
 * (enum hid_binding_kind). HID_BINDING_KIND_COUNT means every kind. */
static float sum_of(const struct hid_pose_decoder *decoder, enum hid_role role,
                    enum hid_binding_kind manner)
{
    float sum = 0.0f;
    CORE_ASSERT(role < HID_ROLE_COUNT);
    CORE_ASSERT(manner <= HID_BINDING_KIND_COUNT);
    for (uint32_t i = 0; i < decoder->map.count; i++) {
        const struct hid_binding *binding = &decoder->map.binding[i];
        if (binding->role == role &&
            (manner == HID_BINDING_KIND_COUNT || binding->manner == manner)) {
            sum += decoder->value[i];
        }
    }
    return sum;
}

/* Returns the bits of all pressed buttons. Element i of `roles` is the role of the button whose bit
 * is element i of `bits`. */
static uint32_t pressed_bits(const struct hid_pose_decoder *decoder, const uint8_t *roles,
                             const uint32_t *bits, uint32_t count)
{
    uint32_t pressed = 0;
    for (uint32_t i = 0; i < count; i++) {
        pressed |= sum_of(decoder, roles[i], HID_BINDING_PRESS) > 0.5f ? bits[i] : 0u;
    }
    return pressed;
}

static uint32_t pointer_buttons(const struct hid_pose_decoder *decoder)
{
    static const uint8_t roles[] = { HID_ROLE_DIP, HID_ROLE_LEVEL, HID_ROLE_FAN };
    static const uint32_t bits[] = { POINTER_DIP, POINTER_LEVEL, POINTER_FAN };
    return pressed_bits(decoder, roles, bits, sizeof roles);
}

/* Returns true unless the controller is a pen that is not near its tablet. */
static bool is_in_range(const struct hid_pose_decoder *decoder)
{
    return !hid_mapping_has_role(&decoder->map, HID_ROLE_IN_RANGE, HID_BINDING_PRESS) ||
           sum_of(decoder, HID_ROLE_IN_RANGE, HID_BINDING_PRESS) > 0.5f;
}

/* Updates the pointer. While a pen is out of range its axes are invalid, so the last position is
 * kept. */
static void update_pointer(struct hid_pose_decoder *decoder)
{
    struct pointer_report *report = &decoder->report;
    CORE_ASSERT(decoder->map.style == HID_STYLE_POINTER);
    const bool in_range = is_in_range(decoder);
    report->time_ns = decoder->time_ns;
    report->wheel_notches = sum_of(decoder, HID_ROLE_TILT, HID_BINDING_STEP);
    report->buttons = in_range ? pointer_buttons(decoder) : 0u;
    if (in_range && hid_mapping_has_role(&decoder->map, HID_ROLE_X, HID_BINDING_POSITION)) {
        const float x = sum_of(decoder, HID_ROLE_X, HID_BINDING_POSITION);
        const float y = sum_of(decoder, HID_ROLE_Z, HID_BINDING_POSITION);
        report->x_px = 0.5f * WINDOW_WIDTH * (1.0f + x);
        report->y_px = 0.5f * WINDOW_HEIGHT * (1.0f + y);
    }
    report->x_px += sum_of(decoder, HID_ROLE_X, HID_BINDING_STEP);
    report->y_px += sum_of(decoder, HID_ROLE_Z, HID_BINDING_STEP);
    report->x_px = f_clamp(report->x_px, 0.0f, WINDOW_WIDTH);
    report->y_px = f_clamp(report->y_px, 0.0f, WINDOW_HEIGHT);
    pointer_poi_report(&decoder->pointer, report);
    if (in_range) {
        decoder->range_ns = decoder->time_ns;
        decoder->present = true;
    }
}

/* Returns the sum of the deflections (-1 to 1) of the sticks and hats that are bound to an axis. A
 * hat is bound to an axis if the controller is a four-switch joystick. */
static float push_of(const struct hid_pose_decoder *decoder, enum hid_role role)
{
    static const int8_t right[] = { 0, 1, 1, 1, 0, -1, -1, -1 };
    static const int8_t near[] = { -1, -1, 0, 1, 1, 1, 0, -1 };
    const int8_t *way = role == HID_ROLE_X ? right : near;
    float push = 0.0f;
    CORE_ASSERT(role == HID_ROLE_X || role == HID_ROLE_Z);
    for (uint32_t i = 0; i < decoder->map.count; i++) {
        const struct hid_binding *binding = &decoder->map.binding[i];
        if (binding->role == role && binding->manner == HID_BINDING_HAT &&
            decoder->value[i] >= 0.0f) {
            push += (float)way[(int)decoder->value[i] % 8];
        }
    }
    return sum_of(decoder, role, HID_BINDING_RATE) + push;
}

static vec3 twist_of(const struct hid_pose_decoder *decoder)
{
    return v3(sum_of(decoder, HID_ROLE_PITCH, HID_BINDING_KIND_COUNT),
              sum_of(decoder, HID_ROLE_YAW, HID_BINDING_KIND_COUNT),
              sum_of(decoder, HID_ROLE_ROLL, HID_BINDING_KIND_COUNT));
}

/* Returns the cabinet buttons that the bindings of START, LEFT, RIGHT and OK and a hat report. */
static uint32_t cabinet_buttons(const struct hid_pose_decoder *decoder)
{
    static const uint8_t roles[] = { HID_ROLE_START, HID_ROLE_LEFT, HID_ROLE_RIGHT, HID_ROLE_OK };
    static const uint32_t bits[] = { INPUT_START, INPUT_LEFT, INPUT_RIGHT, INPUT_OK };
    CORE_ASSERT(decoder->map.count <= HID_BINDING_MAX);
    uint32_t held = pressed_bits(decoder, roles, bits, sizeof roles);
    for (uint32_t i = 0; i < decoder->map.count; i++) {
        const int direction = (int)decoder->value[i];
        if (decoder->map.binding[i].role == HID_ROLE_HAT && direction >= 0) {
            held |= direction >= 5       ? INPUT_LEFT
                    : direction % 4 != 0 ? INPUT_RIGHT
                    : direction == 0     ? INPUT_OK | INPUT_UP
                                         : INPUT_OK | INPUT_DOWN;
        }
    }
    return held;
}

/* ---- Decoding of reports -------------------------------------------------------------------- */

bool hid_pose_decoder_report(struct hid_pose_decoder *decoder, const struct hid_raw *raw)
{
    const bool is_own = decoder->map.style == HID_STYLE_POSE;
    const struct hid_report report = { .bytes = raw->bytes, .size = raw->size };
    uint32_t held;
    decoder->time_ns = raw->time_ns > decoder->time_ns ? raw->time_ns : decoder->time_ns;
    if (raw->size == 0 || raw->size > HID_REPORT_MAX ||
        (is_own ? !decode_own_report(decoder, raw, &held)
                : !hid_report_is_whole(&decoder->descriptor, report))) {
        decoder->refused_count++;
        return false;
    }
    if (is_own) {
        decoder->present = true;
    } else {
        if (!hid_axis_decoder_read(decoder, report)) {
            return false; /* The mapping binds no field of the report. For example, the report has
                             only the state of a battery. */
        }
        if (decoder->map.style == HID_STYLE_POINTER) {
            update_pointer(decoder);
        } else {
            const struct stick_report sticks = {
                .time_ns = decoder->time_ns,
                .push =
                    v3(push_of(decoder, HID_ROLE_X), sum_of(decoder, HID_ROLE_Y, HID_BINDING_RATE),
                       push_of(decoder, HID_ROLE_Z)),
                .twist = twist_of(decoder),
                .buttons = pointer_buttons(decoder),
            };
            stick_motion_report(&decoder->fly, &sticks);
            decoder->present = true;
        }
        held = cabinet_buttons(decoder);
    }
    decoder->pressed |= held & ~decoder->held;
    decoder->held = held;
    return true;
}

/* ---- Output of the pose and the buttons ----------------------------------------------------- */

bool hid_pose_decoder_sample(struct hid_pose_decoder *decoder, uint64_t time_ns,
                             struct poi_sample *out)
{
    const bool is_own = decoder->map.style == HID_STYLE_POSE;
    CORE_ASSERT(decoder->map.style > HID_STYLE_NONE && decoder->map.style <= HID_STYLE_FLY);
    const bool is_put_aside = !is_in_range(decoder) && time_ns > decoder->range_ns &&
                              time_ns - decoder->range_ns > HID_PEN_AWAY_NS;
    if (!decoder->present || is_put_aside) {
        return false;
    }
    *out = (struct poi_sample){
        .time_ns = is_own ? decoder->time_ns : time_ns,
        .has_wrist = is_own,
        .trembles = decoder->map.trembles,
    };
    if (is_own) {
        out->target = pose_of(&decoder->own);
    } else if (decoder->map.style == HID_STYLE_FLY) {
        out->target = stick_motion_target(&decoder->fly, time_ns);
    } else {
        /* The rotation of a pen is added to the tilt. The rotation is zero for a mouse. */
        const vec3 twist = v3_scale(twist_of(decoder), STICK_MOTION_TILT_MAX_RAD);
        out->target = pointer_poi_target(&decoder->pointer, time_ns);
        out->target.angles.pitch_rad += twist.x;
        out->target.angles.yaw_rad += twist.y;
        out->target.angles.roll_rad += twist.z;
    }
    return true;
}

void hid_pose_decoder_buttons(struct hid_pose_decoder *decoder, struct button_sample *out)
{
    out->held |= decoder->held;
    out->pressed |= decoder->pressed;
    decoder->pressed = 0;
}

struct shade_input hid_pose_decoder_fan(struct hid_pose_decoder *decoder, uint64_t time_ns)
{
    struct own_pose *own = &decoder->own;
    vec3 rest_m = own->pose.position_m;
    switch (decoder->map.style) {
    case HID_STYLE_POINTER:
        return pointer_fan_shade(&decoder->pointer, time_ns);
    case HID_STYLE_FLY:
        return stick_motion_fan(&decoder->fly, time_ns);
    case HID_STYLE_POSE:
        go_to_time(own, time_ns);
        rest_m.z = f_max(FAN_REST_Z_M, rest_m.z);
        return pointer_fan_between(own->swing.share, rest_m, own->pose.position_m);
    default:
        return (struct shade_input){ 0 };
    }
}
