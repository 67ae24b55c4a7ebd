/* hid_mapping_auto.c -- finds fields by their usage, and computes the ends and dead zones of
 * bindings. */
#include "drivers/hid/hid_mapping_auto.h"

/* Smallest logical range of an axis, which is larger than that of a hat. An "X" field of one bit is
 * a button. */
#define AXIS_STEPS_MIN 14
/* Divisor for the dead zone of a stick, which is half the range of the stick divided by this
 * number. A released stick stops within its dead zone. */
#define DEAD_SHARE_STICK 12
/* Divisor for the dead zone of a puck, which is half the range of the puck divided by this number.
 * A puck has stiffer springs than a stick. */
#define DEAD_SHARE_PUCK 50

int hid_mapping_auto_is_axis(const struct hid_group *group)
{
    return (group->flags & HID_VARIABLE) && group->bit_size <= 32u &&
           group->logical_max - group->logical_min >= AXIS_STEPS_MIN;
}

int32_t hid_mapping_auto_place(const struct hid_descriptor *descriptor,
                               const struct hid_group *group, hid_usage usage)
{
    uint32_t first = 0;
    for (uint32_t i = 0; i < group->range_count; i++) {
        const struct hid_range *range = &descriptor->range[group->range_first + i];
        if (usage >= range->first && usage <= range->last) {
            const uint32_t index = first + (usage - range->first);
            return !(group->flags & HID_VARIABLE) ? 0 : index < group->count ? (int32_t)index : -1;
        }
        first += range->last - range->first + 1u;
    }
    return -1;
}

static struct hid_field_location find_in(const struct hid_descriptor *descriptor,
                                         hid_usage application, int report_id, hid_usage usage)
{
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        if ((group->flags & HID_CONSTANT) || group->bit_size > 32u ||
            (application && group->application != application) ||
            (report_id >= 0 && group->report_id != report_id)) {
            continue;
        }
        const int32_t index = hid_mapping_auto_place(descriptor, group, usage);
        if (index >= 0) {
            return (struct hid_field_location){ group, (uint32_t)index, usage };
        }
    }
    return (struct hid_field_location){ 0 };
}

struct hid_field_location hid_mapping_auto_find(const struct hid_descriptor *descriptor,
                                                hid_usage application, int report_id,
                                                int report_only, hid_usage usage)
{
    const struct hid_field_location here = find_in(descriptor, application, report_id, usage);
    return here.group || report_only ? here : find_in(descriptor, application, -1, usage);
}

int hid_mapping_auto_bits(struct hid_mapping *map, struct hid_binding binding)
{
    if (map->count == HID_BINDING_MAX) {
        return 0;
    }
    map->binding[map->count++] = binding;
    return 1;
}

/* Returns 1 for a one-bit button whose descriptor declares no logical range, otherwise 0. */
static int is_bare_button(const struct hid_group *group)
{
    return group->bit_size == 1 && group->logical_min == 0 && group->logical_max == 0;
}

static void set_ends(struct hid_binding *binding, const struct hid_group *group, int turned)
{
    const uint32_t bits = group->bit_size - (group->logical_min < 0);
    /* Largest value that fits into the field. Some descriptors declare a larger logical maximum. */
    const int64_t most = ((int64_t)1 << bits) - 1;
    const int64_t low = group->logical_min;
    const int64_t high =
        group->logical_max < most && !is_bare_button(group) ? group->logical_max : most;
    const int64_t middle = low + (high - low + 1) / 2;
    switch (binding->manner) {
    case HID_BINDING_RATE:
        binding->rest = middle;
        binding->full = turned ? low : high;
        break;
    case HID_BINDING_STEP:
        binding->rest = 0;
        binding->full = turned ? -1 : 1;
        break;
    default:
        binding->rest = turned ? high : low;
        binding->full = turned ? low : high;
        break;
    }
}

static int64_t dead_of(const struct hid_group *group, uint8_t role, uint8_t manner)
{
    const int64_t half = (group->logical_max - group->logical_min) / 2;
    const int is_turn = role >= HID_ROLE_PITCH && role <= HID_ROLE_ROLL;
    if (manner == HID_BINDING_RATE || (manner == HID_BINDING_POSITION && is_turn)) {
        const int is_puck = group->application == USAGE_MULTI_AXIS;
        return half / (is_puck ? DEAD_SHARE_PUCK : DEAD_SHARE_STICK);
    }
    return 0;
}

int hid_mapping_auto_bind(struct hid_mapping *map, struct hid_field_location spot,
                          enum hid_role role, enum hid_binding_kind manner, int turned)
{
    const struct hid_group *group = spot.group;
    const int is_switch = manner == HID_BINDING_PRESS || manner == HID_BINDING_HAT;
    if (!group || (!is_switch && !hid_mapping_auto_is_axis(group)) ||
        (group->logical_min >= group->logical_max && !is_bare_button(group))) {
        return 0;
    }
    const int is_array = !(group->flags & HID_VARIABLE);
    if (is_array && (manner != HID_BINDING_PRESS || group->count > HID_ARRAY_MAX)) {
        return 0;
    }
    struct hid_binding binding = {
        .role = (uint8_t)role,
        .manner = (uint8_t)manner,
        .report_id = group->report_id,
        .bit_offset = group->bit_offset + spot.index * group->bit_size,
        .bit_size = (uint8_t)group->bit_size,
        .is_signed = !is_array && group->logical_min < 0,
        .usage = is_array ? spot.usage : 0,
        .dead = dead_of(group, (uint8_t)role, (uint8_t)manner),
    };
    set_ends(&binding, group, turned);
    return hid_mapping_auto_bits(map, binding);
}
