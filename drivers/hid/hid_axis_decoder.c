/* hid_axis_decoder.c -- converts the bits of a report to the values of bindings. */
#include "drivers/hid/poi_hid.h"

#include "core/base/panic.h"

#define PRESS_AT 0.5f /* Fraction of the travel at which a key or trigger counts as pressed. */
/* Fraction of the travel at which a pressed key or trigger counts as released. The difference from
 * PRESS_AT is hysteresis. */
#define RELEASE_AT 0.4f
#define AWAKE_WITHIN 0.3f /* Deflection below which a stick counts as released. */
#define HAT_DIRECTIONS 8

/* Returns the deflection of a stick, -1 to 1. `way` is the position of the stick: 0 at the `rest`
 * value of the binding and 1 at its `full` value. The deflection is 0 within the dead zone, and
 * rises linearly to 1 outside the dead zone. */
static float stick_of(const struct hid_binding *binding, float way)
{
    const bool is_rate = binding->manner == HID_BINDING_RATE;
    const float span = (float)(binding->full - binding->rest);
    CORE_ASSERT(span != 0.0f);
    const float dead =
        f_clamp((float)binding->dead / f_abs(is_rate ? span : 0.5f * span), 0.0f, 0.9f);
    const float share = f_clamp(is_rate ? way : 2.0f * way - 1.0f, -1.0f, 1.0f);
    const float size = f_abs(share);
    const float past = size > dead ? f_min((size - dead) / (1.0f - dead), 1.0f) : 0.0f;
    return share < 0.0f ? -past : past;
}

/* Marks as released all keys that the arrays of report `report_id` can report. Then reads each
 * bound array once, however many bindings refer to it, and marks the keys that the array selects as
 * pressed. */
static void read_arrays(struct hid_pose_decoder *decoder, uint8_t report_id,
                        struct hid_report report)
{
    const struct hid_descriptor *descriptor = &decoder->descriptor;
    CORE_ASSERT(decoder->array_count <= HID_BINDING_MAX);
    for (uint32_t i = 0; i < decoder->map.count; i++) {
        if (decoder->map.binding[i].usage && decoder->map.binding[i].report_id == report_id) {
            decoder->value[i] = 0.0f;
        }
    }
    for (uint32_t i = 0; i < decoder->array_count; i++) {
        const struct hid_group *array = &descriptor->group[decoder->array[i]];
        for (uint32_t j = 0; array->report_id == report_id && j < array->count; j++) {
            const hid_usage usage =
                hid_selected(descriptor, array, hid_field_value(descriptor, array, j, report));
            for (uint32_t k = 0; usage && k < decoder->map.count; k++) {
                const struct hid_binding *binding = &decoder->map.binding[k];
                if (binding->usage == usage && binding->report_id == report_id &&
                    binding->bit_offset == array->bit_offset) {
                    decoder->value[k] = 1.0f;
                }
            }
        }
    }
}

void hid_axis_decoder_find_arrays(struct hid_pose_decoder *decoder)
{
    const struct hid_mapping *map = &decoder->map;
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    decoder->array_count = 0;
    for (uint32_t i = 0; i < decoder->descriptor.group_count; i++) {
        const struct hid_group *group = &decoder->descriptor.group[i];
        uint32_t k = 0;
        while (k < map->count &&
               !(map->binding[k].usage && hid_mapping_is_array_of(group, &map->binding[k]))) {
            k++;
        }
        if (k < map->count && decoder->array_count < HID_BINDING_MAX) {
            decoder->array[decoder->array_count++] = (uint16_t)i;
        }
    }
}

static void read_binding(struct hid_pose_decoder *decoder, uint32_t index, struct hid_report report)
{
    const struct hid_binding *binding = &decoder->map.binding[index];
    const uint8_t *payload = report.bytes + decoder->descriptor.has_report_ids;
    const uint32_t bits = hid_bits_at(payload, binding->bit_offset, binding->bit_size);
    const int64_t raw =
        binding->is_signed ? hid_signed_bits(bits, binding->bit_size) : (int64_t)bits;
    const int64_t from_rest = raw - binding->rest;
    /* `way` is 0 at `rest` and 1 at `full`. Values beyond these ends are not clamped. */
    const float way = (float)from_rest / (float)(binding->full - binding->rest);
    float *value = &decoder->value[index];
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
        /* Ignores a stick with a center position until the stick has been at its center once. */
        if (binding->manner == HID_BINDING_RATE || binding->dead > 0) {
            decoder->awake |= f_abs(*value) < AWAKE_WITHIN ? 1u << index : 0u;
            *value = decoder->awake & 1u << index ? *value : 0.0f;
        }
        break;
    }
}

bool hid_axis_decoder_read(struct hid_pose_decoder *decoder, struct hid_report report)
{
    const int report_id = hid_report_id(&decoder->descriptor, report);
    bool is_bound = false;
    CORE_ASSERT(decoder->map.count <= HID_BINDING_MAX);
    CORE_ASSERT(report_id >= 0);
    read_arrays(decoder, (uint8_t)report_id, report);
    for (uint32_t i = 0; i < decoder->map.count; i++) {
        const struct hid_binding *binding = &decoder->map.binding[i];
        if (binding->report_id == report_id) {
            is_bound = true;
            if (!binding->usage) {
                read_binding(decoder, i, report);
            }
        } else if (binding->manner == HID_BINDING_STEP) {
            decoder->value[i] = 0.0f;
        }
    }
    return is_bound;
}
