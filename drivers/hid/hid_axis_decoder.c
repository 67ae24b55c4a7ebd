/* hid_axis_decoder.c -- converts the bits of a report to the values of bindings. */
#include "drivers/hid/hid_pose_decoder.h"

#include "core/base/panic.h"

#define PRESS_AT 0.5f /* Fraction of a key's or trigger's travel at which it counts as pressed. */
/* Fraction of the travel at which a pressed key or trigger counts as released; the difference from
 * PRESS_AT is hysteresis. */
#define RELEASE_AT 0.4f
#define AWAKE_WITHIN 0.3f /* Deflection below which a stick counts as released. */
#define HAT_DIRECTIONS 8

/* Returns the deflection of a stick, -1 to 1. `way` is 0 at the `rest` value of the binding and 1
 * at its `full` value. The deflection is 0 within the dead zone, and rises linearly to 1 outside
 * the dead zone. */
static float stick_of(const struct hid_binding *binding, float way)
{
    const int is_rate = binding->manner == HID_BINDING_RATE;
    const float span = (float)(binding->full - binding->rest);
    CORE_ASSERT(span != 0.0f);
    const float dead =
        f_clamp((float)binding->dead / f_abs(is_rate ? span : 0.5f * span), 0.0f, 0.9f);
    const float share = f_clamp(is_rate ? way : 2.0f * way - 1.0f, -1.0f, 1.0f);
    const float size = f_abs(share);
    const float past = size > dead ? f_min((size - dead) / (1.0f - dead), 1.0f) : 0.0f;
    return share < 0.0f ? -past : past;
}

/* Marks every key as released that the arrays of report `report_id` can report. Then reads each
 * bound array once, however many bindings refer to it, and marks the keys that it selects. */
static void read_arrays(struct hid_pose_decoder *hand, uint8_t report_id, struct hid_report report)
{
    const struct hid_descriptor *descriptor = &hand->descriptor;
    CORE_ASSERT(hand->array_count <= HID_BINDING_MAX);
    for (uint32_t i = 0; i < hand->map.count; i++) {
        if (hand->map.binding[i].usage && hand->map.binding[i].report_id == report_id) {
            hand->value[i] = 0.0f;
        }
    }
    for (uint32_t i = 0; i < hand->array_count; i++) {
        const struct hid_group *array = &descriptor->group[hand->array[i]];
        for (uint32_t j = 0; array->report_id == report_id && j < array->count; j++) {
            const hid_usage usage =
                hid_selected(descriptor, array, hid_field_value(descriptor, array, j, report));
            for (uint32_t k = 0; usage && k < hand->map.count; k++) {
                const struct hid_binding *binding = &hand->map.binding[k];
                if (binding->usage == usage && binding->report_id == report_id &&
                    binding->bit_offset == array->bit_offset) {
                    hand->value[k] = 1.0f;
                }
            }
        }
    }
}

void hid_axis_decoder_find_arrays(struct hid_pose_decoder *hand)
{
    const struct hid_mapping *map = &hand->map;
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    hand->array_count = 0;
    for (uint32_t i = 0; i < hand->descriptor.group_count; i++) {
        const struct hid_group *group = &hand->descriptor.group[i];
        uint32_t k = 0;
        while (k < map->count &&
               !(map->binding[k].usage && hid_mapping_is_array_of(group, &map->binding[k]))) {
            k++;
        }
        if (k < map->count && hand->array_count < HID_BINDING_MAX) {
            hand->array[hand->array_count++] = (uint16_t)i;
        }
    }
}

static void read_binding(struct hid_pose_decoder *hand, uint32_t index, struct hid_report report)
{
    const struct hid_binding *binding = &hand->map.binding[index];
    const uint8_t *payload = report.bytes + hand->descriptor.has_report_ids;
    const uint32_t bits = hid_bits_at(payload, binding->bit_offset, binding->bit_size);
    const int64_t raw =
        binding->is_signed ? hid_signed_bits(bits, binding->bit_size) : (int64_t)bits;
    const int64_t from_rest = raw - binding->rest;
    /* `way` is 0 at `rest` and 1 at `full`. Values beyond these ends are not clamped. */
    const float way = (float)from_rest / (float)(binding->full - binding->rest);
    float *value = &hand->value[index];
    CORE_ASSERT(index < HID_BINDING_MAX);
    CORE_ASSERT(binding->bit_size >= 1 && binding->bit_size <= 32);
    switch (binding->manner) {
    case HID_BINDING_STEP:
        *value = binding->full < binding->rest ? -(float)raw : (float)raw;
        break;
    case HID_BINDING_PRESS:
        *value = way >= (*value > 0.5f ? RELEASE_AT : PRESS_AT) ? 1.0f : 0.0f;
        break;
    case HID_BINDING_HAT:
        *value = from_rest >= 0 && from_rest < HAT_DIRECTIONS ? (float)from_rest : -1.0f;
        break;
    default:
        *value = stick_of(binding, way);
        /* A stick that rests at the center is used only after it was at its center once. */
        if (binding->manner == HID_BINDING_RATE || binding->dead > 0) {
            hand->awake |= f_abs(*value) < AWAKE_WITHIN ? 1u << index : 0u;
            *value = hand->awake & 1u << index ? *value : 0.0f;
        }
        break;
    }
}

int hid_axis_decoder_read(struct hid_pose_decoder *hand, uint8_t report_id,
                          struct hid_report report)
{
    int knows = 0;
    CORE_ASSERT(hand->map.count <= HID_BINDING_MAX);
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
