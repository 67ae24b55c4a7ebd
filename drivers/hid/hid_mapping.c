/* hid_mapping.c -- selects the mapping of a controller and validates mappings. */
#include "drivers/hid/hid_mapping.h"

#include <string.h>

#include "drivers/hid/hid_mapping_auto.h"
#include "drivers/hid/poi_report.h"

#define KEYBOARD_PAGE 0x0007u
/* Score of Kingyo's poi controller and of known controllers, above every score of
 * hid_mapping_auto_score(). */
#define WORTH_KNOWN 100u

/* ---- Kingyo's poi controller ---------------------------------------------------------------- */

struct place {
    hid_usage usage;
    uint32_t bit_offset, bit_size;
};

/* Axes of Kingyo's poi controller. The sequence number before the axes has no HID usage and is not
 * checked. */
static const struct place own_places[] = {
    { USAGE_X, 8, 16 },   { USAGE_Y, 24, 16 },  { USAGE_Z, 40, 16 },
    { USAGE_RX, 56, 16 }, { USAGE_RY, 72, 16 }, { USAGE_RZ, 88, 16 },
};

static int is_at(const struct hid_field_location *spot, const struct place *place)
{
    const struct hid_group *group = spot->group;
    return group && group->bit_size == place->bit_size && group->logical_min == -32767 &&
           group->logical_max == 32767 && !(group->flags & HID_RELATIVE) &&
           group->bit_offset + spot->index * group->bit_size == place->bit_offset;
}

int hid_mapping_is_own(const struct hid_descriptor *descriptor)
{
    if (!descriptor->has_report_ids ||
        descriptor->report_bits[POI_REPORT_ID] != 8u * (POI_REPORT_SIZE - 1u)) {
        return 0;
    }
    for (uint32_t i = 0; i < sizeof own_places / sizeof own_places[0]; i++) {
        const struct hid_field_location spot =
            hid_mapping_auto_find(descriptor, 0, POI_REPORT_ID, 1, own_places[i].usage);
        if (!is_at(&spot, &own_places[i])) {
            return 0;
        }
    }
    return 1;
}

/* Binds the buttons in the order of enum poi_button. */
static void bind_own_buttons(struct hid_mapping *map)
{
    static const uint8_t roles[] = { HID_ROLE_OK, HID_ROLE_START, HID_ROLE_LEFT, HID_ROLE_RIGHT };
    for (uint32_t i = 0; i < sizeof roles; i++) {
        hid_mapping_auto_bits(map, (struct hid_binding){
                                       .role = roles[i],
                                       .manner = HID_BINDING_PRESS,
                                       .report_id = POI_REPORT_ID,
                                       .bit_offset = 8u * 13u + i,
                                       .bit_size = 1,
                                       .full = 1,
                                   });
    }
}

static void map_own(struct hid_mapping *map)
{
    static const uint8_t roles[] = { HID_ROLE_X,     HID_ROLE_Y,   HID_ROLE_Z,
                                     HID_ROLE_PITCH, HID_ROLE_YAW, HID_ROLE_ROLL };
    *map = (struct hid_mapping){ .source = HID_MAPPING_OWN, .style = HID_STYLE_POSE, .feels = 1 };
    for (uint32_t i = 0; i < sizeof roles; i++) {
        hid_mapping_auto_bits(map, (struct hid_binding){
                                       .role = roles[i],
                                       .manner = HID_BINDING_POSITION,
                                       .report_id = POI_REPORT_ID,
                                       .bit_offset = own_places[i].bit_offset,
                                       .bit_size = (uint8_t)own_places[i].bit_size,
                                       .is_signed = 1,
                                       .rest = -32767,
                                       .full = 32767,
                                   });
    }
    bind_own_buttons(map);
}

/* ---- Selection of a mapping ----------------------------------------------------------------- */

int hid_mapping_has_keyboard(const struct hid_descriptor *descriptor)
{
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        if (group->application == USAGE_KEYBOARD && !(group->flags & HID_CONSTANT) &&
            descriptor->range[group->range_first].first >> 16 == KEYBOARD_PAGE) {
            return 1;
        }
    }
    return 0;
}

void hid_mapping_choose(struct hid_mapping *out, const struct hid_identity *identity,
                        const struct hid_descriptor *descriptor)
{
    memset(out, 0, sizeof *out);
    if (descriptor->error != HID_OK || hid_mapping_has_keyboard(descriptor)) {
        return;
    }
    if (hid_mapping_is_own(descriptor)) {
        map_own(out);
    } else if (!hid_mapping_known(out, identity, descriptor)) {
        hid_mapping_auto_build(out, descriptor);
    }
    if (!hid_mapping_is_sound(out, descriptor)) {
        memset(out, 0, sizeof *out);
    }
}

uint32_t hid_mapping_score(const struct hid_identity *identity,
                           const struct hid_descriptor *descriptor)
{
    struct hid_mapping map;
    hid_mapping_choose(&map, identity, descriptor);
    switch (map.source) {
    case HID_MAPPING_NONE:
        return 0;
    case HID_MAPPING_AUTO:
        return hid_mapping_auto_score(descriptor);
    default:
        return WORTH_KNOWN;
    }
}

const char *hid_mapping_absence_reason(const struct hid_descriptor *of)
{
    const int has_x = hid_mapping_auto_find(of, 0, -1, 0, USAGE_X).group != NULL;
    const int has_y = hid_mapping_auto_find(of, 0, -1, 0, USAGE_Y).group != NULL;
    if (hid_mapping_has_keyboard(of)) {
        return "it has the keys of a keyboard, which is left alone";
    }
    return !has_x && !has_y ? "no axis of it is called X or Y; it may be learned in the menu"
           : !has_x || !has_y
               ? "it has an X or an Y, and not both"
               : "its X and Y are no pair of axes with a button beside them; it may be learned";
}

/* ---- Validation ----------------------------------------------------------------------------- */

static int is_axis_role(uint8_t role)
{
    return role >= HID_ROLE_X && role <= HID_ROLE_TILT;
}

static int manner_fits(const struct hid_binding *binding)
{
    switch (binding->manner) {
    case HID_BINDING_POSITION:
    case HID_BINDING_RATE:
        return is_axis_role(binding->role) ||
               (binding->role == HID_ROLE_SEQUENCE && binding->manner == HID_BINDING_POSITION);
    case HID_BINDING_STEP:
        return is_axis_role(binding->role);
    case HID_BINDING_PRESS:
        return !is_axis_role(binding->role) && binding->role != HID_ROLE_HAT &&
               binding->role != HID_ROLE_SEQUENCE;
    case HID_BINDING_HAT:
        return binding->role == HID_ROLE_HAT || binding->role == HID_ROLE_X ||
               binding->role == HID_ROLE_Z;
    default:
        return 0;
    }
}

int hid_mapping_is_array_of(const struct hid_group *group, const struct hid_binding *binding)
{
    return !(group->flags & HID_VARIABLE) && group->count <= HID_ARRAY_MAX &&
           group->report_id == binding->report_id && group->bit_offset == binding->bit_offset &&
           group->bit_size == binding->bit_size;
}

static int is_array_at(const struct hid_descriptor *descriptor, const struct hid_binding *binding)
{
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        if (hid_mapping_is_array_of(&descriptor->group[i], binding)) {
            return 1;
        }
    }
    return 0;
}

static int is_value(int64_t value)
{
    return value >= -HID_VALUE_MAX && value <= HID_VALUE_MAX;
}

static int binding_is_sound(const struct hid_binding *binding,
                            const struct hid_descriptor *descriptor)
{
    if (!is_value(binding->rest) || !is_value(binding->full)) {
        return 0;
    }
    const uint64_t end = (uint64_t)binding->bit_offset + binding->bit_size;
    const int64_t span = binding->full - binding->rest;
    const int64_t width = span < 0 ? -span : span;
    return binding->role > HID_ROLE_NONE && binding->role < HID_ROLE_COUNT &&
           manner_fits(binding) && binding->bit_size >= 1 && binding->bit_size <= 32 &&
           binding->is_signed <= 1 && end <= descriptor->report_bits[binding->report_id] &&
           span != 0 && binding->dead >= 0 && binding->dead < width &&
           (binding->usage == 0 ||
            (binding->manner == HID_BINDING_PRESS && is_array_at(descriptor, binding)));
}

static int has(const struct hid_mapping *map, enum hid_role role, enum hid_binding_kind manner)
{
    for (uint32_t i = 0; i < map->count; i++) {
        if (map->binding[i].role == role && map->binding[i].manner == manner) {
            return 1;
        }
    }
    return 0;
}

static int has_plane(const struct hid_mapping *map, enum hid_binding_kind manner)
{
    return has(map, HID_ROLE_X, manner) && has(map, HID_ROLE_Z, manner);
}

static int style_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor)
{
    const int dips = has(map, HID_ROLE_DIP, HID_BINDING_PRESS);
    switch (map->style) {
    case HID_STYLE_POSE:
        return hid_mapping_is_own(descriptor);
    case HID_STYLE_POINTER:
        return dips && (has_plane(map, HID_BINDING_POSITION) || has_plane(map, HID_BINDING_STEP));
    case HID_STYLE_FLY:
        return (has_plane(map, HID_BINDING_RATE) || has_plane(map, HID_BINDING_HAT)) &&
               (dips || has(map, HID_ROLE_Y, HID_BINDING_RATE));
    default:
        return 0;
    }
}

int hid_mapping_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor)
{
    if (descriptor->error != HID_OK || map->source == HID_MAPPING_NONE ||
        map->source > HID_MAPPING_LEARNED || map->count > HID_BINDING_MAX || map->trembles > 1 ||
        map->feels > 1) {
        return 0;
    }
    for (uint32_t i = 0; i < map->count; i++) {
        if (!binding_is_sound(&map->binding[i], descriptor)) {
            return 0;
        }
    }
    return style_is_sound(map, descriptor);
}
