/* hid_mapping_infer.c -- finds the recorded fields that moved farthest, and binds them. */
#include "drivers/hid/hid_learn.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "drivers/hid/hid_mapping_auto.h"

/* Largest noise of a usable field at rest, as a fraction of the field's range. */
#define NOISE_MAX 0.20f
/* Smallest travel of a field that can be an axis, as a fraction of the field's range. */
#define WAY_MIN 0.12f
/* Smallest travel of the control that dips the poi, as a fraction of the field's range. */
#define PRESS_MIN 0.30f
/* A learning step counts as clearly demonstrated if a field travels at least this fraction of its
 * range. */
#define CLEAR_WAY 0.4f
/* Weight of the motion of a vendor-defined field. With this weight, a vendor-defined field must
 * move twice as far as a standard field to be selected. */
#define VENDOR_WORTH 0.5f
#define STEP_WAY 100.0f /* Range that is assumed for a relative field, in counts. */
/* Largest distance from the rest value at which a stick counts as returned, as a fraction of the
 * field's range. */
#define MIDDLE_SHARE 0.2f
#define DEAD_SHARE 0.08f
#define PAGE_OF(usage) ((usage) >> 16)
#define PAGE_VENDOR 0xff00u

const struct hid_group *hid_mapping_infer_group(const struct hid_learn *learn,
                                                const struct learn_field *field)
{
    CORE_ASSERT(field->group < learn->descriptor.group_count);
    return &learn->descriptor.group[field->group];
}

bool hid_mapping_infer_is_relative(const struct hid_group *group)
{
    return (group->flags & HID_RELATIVE) && group->application != USAGE_MULTI_AXIS;
}

static float span_of(const struct hid_group *group)
{
    return hid_mapping_infer_is_relative(group)
               ? STEP_WAY
               : (float)(hid_mapping_auto_high(group) - group->logical_min);
}

/* ---- Evaluation of the recording ------------------------------------------------------------ */

static int64_t rest_of(const struct learn_field *field)
{
    CORE_ASSERT(field->rest_low <= field->rest_high);
    return (field->rest_low + field->rest_high) / 2;
}

/* Returns the largest deflection of a field from its rest value in the learning step `step`. The
 * sign is the direction of the deflection. */
static int64_t deflection_in(const struct learn_field *field, enum learn_step step)
{
    CORE_ASSERT(step < LEARN_STEP_COUNT);
    const int64_t down = field->low[step] - rest_of(field);
    const int64_t up = field->high[step] - rest_of(field);
    return up >= -down ? up : down;
}

static float hid_mapping_infer_share_of(const struct hid_learn *learn,
                                        const struct learn_field *field, int64_t way)
{
    const struct hid_group *group = hid_mapping_infer_group(learn, field);
    const float noise = (float)(field->rest_high - field->rest_low) / span_of(group);
    const hid_usage usage = hid_usage_at(&learn->descriptor, group, field->index);
    if (!field->reported || noise > NOISE_MAX) {
        return 0.0f;
    }
    const float share = f_min(f_abs((float)way) / span_of(group), 1.0f);
    return share * (PAGE_OF(usage) >= PAGE_VENDOR ? VENDOR_WORTH : 1.0f);
}

/* `there` is the deflection of a field in one step, and `back` is its deflection in the opposite
 * direction in a second step. Both deflections are 0 if the field did not move in opposite
 * directions. The deflections are measured from the rest value, because the controller can start a
 * step where the previous step ended. */
struct ways {
    int64_t there, back;
};

static struct ways ways_of(const struct learn_field *field, enum learn_step one,
                           enum learn_step other)
{
    CORE_ASSERT(one < LEARN_STEP_COUNT);
    CORE_ASSERT(other < LEARN_STEP_COUNT);
    CORE_ASSERT(one != other);
    const int64_t rest = rest_of(field);
    const struct ways down_up = { field->low[one] - rest, field->high[other] - rest };
    const struct ways up_down = { field->high[one] - rest, field->low[other] - rest };
    const int64_t first = -down_up.there < down_up.back ? -down_up.there : down_up.back;
    const int64_t second = up_down.there < -up_down.back ? up_down.there : -up_down.back;
    return first <= 0 && second <= 0 ? (struct ways){ 0 } : first >= second ? down_up : up_down;
}

static const struct learn_field *best_axis(const struct hid_learn *learn, enum learn_step one,
                                           enum learn_step other,
                                           const struct learn_field *not_this)
{
    CORE_ASSERT(learn->field_count <= LEARN_FIELD_MAX);
    const struct learn_field *best = NULL;
    float best_share = WAY_MIN;
    for (uint32_t i = 0; i < learn->field_count; i++) {
        const struct learn_field *field = &learn->field[i];
        const struct ways ways = ways_of(field, one, other);
        const bool is_wide = hid_mapping_infer_group(learn, field)->bit_size >= 4;
        const float share = is_wide ? f_min(hid_mapping_infer_share_of(learn, field, ways.there),
                                            hid_mapping_infer_share_of(learn, field, ways.back))
                                    : 0.0f;
        if (field != not_this && share > best_share) {
            best = field;
            best_share = share;
        }
    }
    return best;
}

static const struct learn_field *
best_press(const struct hid_learn *learn, const struct learn_field *x, const struct learn_field *z)
{
    const struct learn_field *best = NULL;
    float best_share = PRESS_MIN;
    for (uint32_t i = 0; i < learn->field_count; i++) {
        const struct learn_field *field = &learn->field[i];
        const bool is_relative =
            hid_mapping_infer_is_relative(hid_mapping_infer_group(learn, field));
        const float share =
            hid_mapping_infer_share_of(learn, field, deflection_in(field, LEARN_DIP));
        if (field != x && field != z && !is_relative && share > best_share) {
            best = field;
            best_share = share;
        }
    }
    return best;
}

static const struct learn_key *best_key(const struct hid_learn *learn)
{
    CORE_ASSERT(learn->key_count <= LEARN_KEY_MAX);
    for (uint32_t i = 0; i < learn->key_count; i++) {
        if (!learn->key[i].rested) {
            return &learn->key[i];
        }
    }
    return NULL;
}

float hid_mapping_infer_clarity(const struct hid_learn *learn)
{
    CORE_ASSERT(learn->step < LEARN_STEP_COUNT);
    float best = 0.0f;
    for (uint32_t i = 0; i < learn->field_count; i++) {
        const struct learn_field *field = &learn->field[i];
        const enum learn_step step = (enum learn_step)learn->step;
        const bool counts =
            step == LEARN_DIP || hid_mapping_infer_group(learn, field)->bit_size >= 4;
        best = counts ? f_max(best,
                              hid_mapping_infer_share_of(learn, field, deflection_in(field, step)))
                      : best;
    }
    return best_key(learn) ? 1.0f : f_min(1.0f, best / CLEAR_WAY);
}

/* ---- Construction of the mapping ------------------------------------------------------------ */

static struct hid_binding binding_of(const struct hid_learn *learn, const struct learn_field *field,
                                     enum hid_role role)
{
    CORE_ASSERT(role > HID_ROLE_NONE && role < HID_ROLE_COUNT);
    CORE_ASSERT(field->index < hid_mapping_infer_group(learn, field)->count);
    const struct hid_group *group = hid_mapping_infer_group(learn, field);
    return (struct hid_binding){
        .role = (uint8_t)role,
        .report_id = group->report_id,
        .bit_offset = group->bit_offset + field->index * group->bit_size,
        .bit_size = (uint8_t)group->bit_size,
        .is_signed = group->logical_min < 0,
    };
}

/* Returns true if the field belongs to a stick. A stick returns to its center when it is released,
 * and a pen does not. The declared application takes precedence over the recorded motion. */
static bool is_stick(const struct hid_learn *learn, const struct learn_field *field,
                     enum learn_step one, enum learn_step other)
{
    const struct hid_group *group = hid_mapping_infer_group(learn, field);
    const float near = MIDDLE_SHARE * span_of(group);
    switch (group->application) {
    case USAGE_JOYSTICK:
    case USAGE_GAMEPAD:
    case USAGE_MULTI_AXIS:
        return true;
    case USAGE_MOUSE:
    case USAGE_DIGITIZER:
    case USAGE_PEN:
    case USAGE_TOUCH_SCREEN:
    case USAGE_TOUCH_PAD:
        return false;
    default:
        return f_abs((float)(field->end[one] - rest_of(field))) < near &&
               f_abs((float)(field->end[other] - rest_of(field))) < near;
    }
}

static void bind_axis(struct hid_learn *learn, const struct learn_field *field, enum hid_role role,
                      enum learn_step one, enum learn_step other)
{
    const struct hid_group *group = hid_mapping_infer_group(learn, field);
    const struct ways ways = ways_of(field, one, other);
    struct hid_binding binding = binding_of(learn, field, role);
    if (hid_mapping_infer_is_relative(group)) {
        binding.manner = HID_BINDING_STEP;
        binding.full = ways.back > 0 ? 1 : -1;
    } else if (is_stick(learn, field, one, other)) {
        binding.manner = HID_BINDING_RATE;
        binding.rest = rest_of(field);
        binding.full = rest_of(field) + ways.back;
        binding.dead =
            (int64_t)(DEAD_SHARE * f_abs((float)ways.back)) + (field->rest_high - field->rest_low);
    } else {
        binding.manner = HID_BINDING_POSITION;
        binding.rest = rest_of(field) + ways.there;
        binding.full = rest_of(field) + ways.back;
    }
    hid_mapping_auto_bits(&learn->map, binding);
}

/* Returns true if the in-range bit of a pen was not set while the pen moved an axis. Some pens
 * never set this bit or set it inverted. The in-range bit of such a pen must not be used. */
static bool is_range_unreported(const struct hid_learn *learn, const struct hid_binding *binding)
{
    CORE_ASSERT(binding->role == HID_ROLE_IN_RANGE);
    for (uint32_t i = 0; i < learn->field_count; i++) {
        const struct learn_field *field = &learn->field[i];
        const struct hid_binding own = binding_of(learn, field, HID_ROLE_IN_RANGE);
        if (own.report_id == binding->report_id && own.bit_offset == binding->bit_offset) {
            return field->end[LEARN_LEFT] != binding->full ||
                   field->end[LEARN_NEAR] != binding->full;
        }
    }
    return true;
}

/* Adds bindings of controls that were not demonstrated, such as menu buttons and the rotations of a
 * second stick. The bindings are copied from learn->offered. */
static void keep_offered(struct hid_learn *learn)
{
    CORE_ASSERT(learn->offered.count <= HID_BINDING_MAX);
    for (uint32_t i = 0; i < learn->offered.count; i++) {
        const struct hid_binding *binding = &learn->offered.binding[i];
        const bool was_shown = binding->role == HID_ROLE_X || binding->role == HID_ROLE_Y ||
                               binding->role == HID_ROLE_Z || binding->role == HID_ROLE_DIP;
        const bool is_false =
            binding->role == HID_ROLE_IN_RANGE && is_range_unreported(learn, binding);
        uint32_t k = 0;
        while (k < learn->map.count && !(learn->map.binding[k].report_id == binding->report_id &&
                                         learn->map.binding[k].bit_offset == binding->bit_offset &&
                                         learn->map.binding[k].usage == binding->usage)) {
            k++;
        }
        if (!was_shown && !is_false && k == learn->map.count) {
            hid_mapping_auto_bits(&learn->map, *binding);
        }
    }
}

bool hid_mapping_infer_map(struct hid_learn *learn)
{
    CORE_ASSERT(learn->step == LEARN_DIP);
    const struct learn_field *x = best_axis(learn, LEARN_LEFT, LEARN_RIGHT, NULL);
    const struct learn_field *z = best_axis(learn, LEARN_FAR, LEARN_NEAR, x);
    const struct learn_field *press = best_press(learn, x, z);
    const struct learn_key *key = press ? NULL : best_key(learn);
    if (!x || !z || (!press && !key)) {
        return false;
    }
    CORE_ASSERT(x != z);
    CORE_ASSERT(press != x && press != z);
    learn->map = (struct hid_mapping){ .source = HID_MAPPING_LEARNED };
    bind_axis(learn, x, HID_ROLE_X, LEARN_LEFT, LEARN_RIGHT);
    bind_axis(learn, z, HID_ROLE_Z, LEARN_FAR, LEARN_NEAR);
    learn->map.style =
        learn->map.binding[0].manner == HID_BINDING_RATE ? HID_STYLE_FLY : HID_STYLE_POINTER;
    if (press) {
        struct hid_binding binding = binding_of(learn, press, HID_ROLE_DIP);
        binding.manner = HID_BINDING_PRESS;
        binding.rest = rest_of(press);
        binding.full = rest_of(press) + deflection_in(press, LEARN_DIP);
        hid_mapping_auto_bits(&learn->map, binding);
    } else {
        const struct hid_group *group = &learn->descriptor.group[key->group];
        hid_mapping_auto_bits(&learn->map, (struct hid_binding){
                                               .role = HID_ROLE_DIP,
                                               .manner = HID_BINDING_PRESS,
                                               .report_id = group->report_id,
                                               .bit_offset = group->bit_offset,
                                               .bit_size = (uint8_t)group->bit_size,
                                               .usage = key->usage,
                                               .full = 1,
                                           });
    }
    keep_offered(learn);
    CORE_ASSERT(learn->map.count <= HID_BINDING_MAX);
    return hid_mapping_is_sound(&learn->map, &learn->descriptor);
}
