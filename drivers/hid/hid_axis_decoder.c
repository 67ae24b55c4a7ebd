/* hid_axis_decoder.c -- converts the bits of a report to the values of bindings. */
#include "drivers/hid/hid_axis_decoder.h"

#include "drivers/hid/hid_bits.h"

#define PRESS_AT 0.5f /* Fraction of a key's or trigger's travel at which it counts as pressed. */
/* Fraction of the travel at which a pressed key or trigger counts as released; the difference from
 * PRESS_AT is hysteresis. */
#define RELEASE_AT 0.4f
#define AWAKE_WITHIN 0.3f /* Deflection below which a stick counts as released. */
#define HAT_DIRECTIONS 8.0f

static int64_t raw_of(const struct hid_binding *binding, const uint8_t *payload)
{
    const uint32_t bits = hid_bits_at(payload, binding->bit_offset, binding->bit_size);
    return binding->is_signed ? hid_signed_bits(bits, binding->bit_size) : (int64_t)bits;
}

/* Returns the position of `raw` between the ends of the binding: 0 at `rest` and 1 at `full`.
 * Values beyond the ends are not clamped. */
static float way_of(const struct hid_binding *binding, int64_t raw)
{
    const int64_t span = binding->full - binding->rest;
    return (float)(raw - binding->rest) / (float)span;
}

/* Applies a dead zone. Returns 0 if the size of `share` is at most `dead`. Above `dead` the size of
 * the result rises linearly to 1 at full deflection, and the sign is kept. */
static float past_dead(float share, float dead)
{
    const float size = f_abs(share);
    const float rest = size > dead ? f_min((size - dead) / (1.0f - dead), 1.0f) : 0.0f;
    return share < 0.0f ? -rest : rest;
}

static float dead_share(const struct hid_binding *binding, float steps)
{
    return f_clamp((float)binding->dead / f_abs(steps), 0.0f, 0.9f);
}

static float stick_of(const struct hid_binding *binding, int64_t raw)
{
    const float span = (float)(binding->full - binding->rest);
    return binding->manner == HID_BINDING_RATE
               ? past_dead(f_clamp(way_of(binding, raw), -1.0f, 1.0f), dead_share(binding, span))
               : past_dead(f_clamp(2.0f * way_of(binding, raw) - 1.0f, -1.0f, 1.0f),
                           dead_share(binding, 0.5f * span));
}

static float pressed_of(float way, float before)
{
    return way >= (before > 0.5f ? RELEASE_AT : PRESS_AT) ? 1.0f : 0.0f;
}

static float hat_of(const struct hid_binding *binding, int64_t raw)
{
    const int64_t direction = raw - binding->rest;
    return direction >= 0 && (float)direction < HAT_DIRECTIONS ? (float)direction : -1.0f;
}

/* Marks every key as released that the arrays of report `report_id` can report. */
static void let_keys_go(struct hid_pose_decoder *hand, uint8_t report_id)
{
    for (uint32_t i = 0; i < hand->map.count; i++) {
        if (hand->map.binding[i].usage && hand->map.binding[i].report_id == report_id) {
            hand->value[i] = 0.0f;
        }
    }
}

static void press_key(struct hid_pose_decoder *hand, const struct hid_group *array, hid_usage usage)
{
    for (uint32_t i = 0; i < hand->map.count; i++) {
        const struct hid_binding *binding = &hand->map.binding[i];
        if (binding->usage == usage && binding->report_id == array->report_id &&
            binding->bit_offset == array->bit_offset) {
            hand->value[i] = 1.0f;
        }
    }
}

/* Reads each bound array once, however many bindings refer to it. */
static void read_arrays(struct hid_pose_decoder *hand, uint8_t report_id, struct hid_report report)
{
    const struct hid_descriptor *descriptor = &hand->descriptor;
    let_keys_go(hand, report_id);
    for (uint32_t i = 0; i < hand->array_count; i++) {
        const struct hid_group *array = &descriptor->group[hand->array[i]];
        for (uint32_t j = 0; array->report_id == report_id && j < array->count; j++) {
            const hid_usage usage =
                hid_selected(descriptor, array, hid_field_value(descriptor, array, j, report));
            if (usage) {
                press_key(hand, array, usage);
            }
        }
    }
}

static int is_bound(const struct hid_mapping *map, const struct hid_group *array)
{
    for (uint32_t i = 0; i < map->count; i++) {
        if (map->binding[i].usage && hid_mapping_is_array_of(array, &map->binding[i])) {
            return 1;
        }
    }
    return 0;
}

void hid_axis_decoder_find_arrays(struct hid_pose_decoder *hand)
{
    hand->array_count = 0;
    for (uint32_t i = 0; i < hand->descriptor.group_count; i++) {
        if (hand->array_count < HID_BINDING_MAX &&
            is_bound(&hand->map, &hand->descriptor.group[i])) {
            hand->array[hand->array_count++] = (uint16_t)i;
        }
    }
}

/* Returns 1 for bindings of sticks that rest at the center, otherwise 0. The value of a stick is
 * used only after the stick was at its center once. */
static int has_rest(const struct hid_binding *binding)
{
    return binding->manner == HID_BINDING_RATE ||
           (binding->manner == HID_BINDING_POSITION && binding->dead > 0);
}

static float stick_if_awake(struct hid_pose_decoder *hand, uint32_t index, int64_t raw)
{
    const float share = stick_of(&hand->map.binding[index], raw);
    if (!has_rest(&hand->map.binding[index])) {
        return share;
    }
    if (f_abs(share) < AWAKE_WITHIN) {
        hand->awake |= 1u << index;
    }
    return hand->awake & 1u << index ? share : 0.0f;
}

static void read_binding(struct hid_pose_decoder *hand, uint32_t index, struct hid_report report)
{
    const struct hid_binding *binding = &hand->map.binding[index];
    const int64_t raw = raw_of(binding, report.bytes + hand->descriptor.has_report_ids);
    float *value = &hand->value[index];
    switch (binding->manner) {
    case HID_BINDING_STEP:
        *value = binding->full < binding->rest ? -(float)raw : (float)raw;
        break;
    case HID_BINDING_PRESS:
        *value = pressed_of(way_of(binding, raw), *value);
        break;
    case HID_BINDING_HAT:
        *value = hat_of(binding, raw);
        break;
    default:
        *value = stick_if_awake(hand, index, raw);
        break;
    }
}

int hid_axis_decoder_read(struct hid_pose_decoder *hand, uint8_t report_id,
                          struct hid_report report)
{
    int knows = 0;
    read_arrays(hand, report_id, report);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        if (hand->map.binding[i].report_id == report_id) {
            if (!hand->map.binding[i].usage) {
                read_binding(hand, i, report);
            }
            knows = 1;
        } else if (hand->map.binding[i].manner == HID_BINDING_STEP) {
            hand->value[i] = 0.0f;
        }
    }
    return knows;
}
