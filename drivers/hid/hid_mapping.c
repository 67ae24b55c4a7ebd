/* hid_mapping.c -- selects the mapping of a controller and validates mappings. */
#include "drivers/hid/hid_mapping.h"

#include <string.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_mapping_auto.h"
#include "drivers/hid/poi_report.h"

#define KEYBOARD_PAGE 0x0007u
/* Score of Kingyo's poi controller and of known controllers, above every score of
 * hid_mapping_auto_score(). */
#define WORTH_KNOWN 100u

/* ---- Kingyo's poi controller ---------------------------------------------------------------- */

/* Axes of Kingyo's poi controller in the order of its report. The sequence number before the axes
 * has no HID usage and is not checked. */
static const hid_usage own_axes[] = { USAGE_X, USAGE_Y, USAGE_Z, USAGE_RX, USAGE_RY, USAGE_RZ };

/* Position of the first axis in the report, and size of each axis, in bits. */
#define OWN_AXES_BIT 8u
#define OWN_AXIS_BITS 16u

/* Returns true if the reports have the layout of Kingyo's poi controller. In this layout every axis
 * of poi_report.h is at its position. Unlike poi_descriptor_is(), this function also accepts a
 * device with additional reports. Such a device can play after the operator selected it. */
static bool is_own(const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
    if (!descriptor->has_report_ids ||
        descriptor->report_bits[POI_REPORT_ID] != 8u * (POI_REPORT_SIZE - 1u)) {
        return false;
    }
    for (uint32_t i = 0; i < sizeof own_axes / sizeof own_axes[0]; i++) {
        const struct hid_field_location spot =
            hid_mapping_auto_find(descriptor, 0, POI_REPORT_ID, true, own_axes[i]);
        const struct hid_group *group = spot.group;
        if (!group || group->bit_size != OWN_AXIS_BITS || group->logical_min != -32767 ||
            group->logical_max != 32767 || (group->flags & HID_RELATIVE) ||
            group->bit_offset + spot.index * group->bit_size != OWN_AXES_BIT + i * OWN_AXIS_BITS) {
            return false;
        }
    }
    return true;
}

/* Macros for bindings to fields of the report with the id 1. Kingyo's poi controller and all known
 * controllers send their axes and buttons in this report. Offsets and sizes are in bits. */
_Static_assert(POI_REPORT_ID == 1u, "the poi has the report id of the other controllers");
/* clang-format off */
#define BIND(role_, manner_, bit, size, rest_, full_, dead_)                                       \
    {                                                                                             \
        .role = role_, .manner = manner_, .report_id = 1, .bit_offset = bit, .bit_size = size,     \
        .rest = rest_, .full = full_, .dead = dead_, .is_signed = rest_ < 0                       \
    }
#define STICK(role, bit) BIND(role, HID_BINDING_RATE, bit, 8, 128, 255, STICK_DEAD)
#define TURN(role, bit) BIND(role, HID_BINDING_POSITION, bit, 8, 0, 255, STICK_DEAD)
#define BUTTON(role, bit) BIND(role, HID_BINDING_PRESS, bit, 1, 0, 1, 0)
#define TRIGGER(role, bit) BIND(role, HID_BINDING_PRESS, bit, 8, 0, 255, 0)
#define HAT(bit) BIND(HID_ROLE_HAT, HID_BINDING_HAT, bit, 4, 0, 7, 0)
#define OWN_AXIS(role, index)                                                                      \
    BIND(role, HID_BINDING_POSITION, OWN_AXES_BIT + (index) * OWN_AXIS_BITS, OWN_AXIS_BITS,        \
         -32767, 32767, 0)

static const struct hid_mapping own_mapping = {
    .source = HID_MAPPING_OWN, .style = HID_STYLE_POSE, .feels = true, .count = 10, .binding = {
        OWN_AXIS(HID_ROLE_X, 0),     OWN_AXIS(HID_ROLE_Y, 1),   OWN_AXIS(HID_ROLE_Z, 2),
        OWN_AXIS(HID_ROLE_PITCH, 3), OWN_AXIS(HID_ROLE_YAW, 4), OWN_AXIS(HID_ROLE_ROLL, 5),
        /* The buttons have the order of enum poi_button. */
        BUTTON(HID_ROLE_OK, 104),    BUTTON(HID_ROLE_START, 105),
        BUTTON(HID_ROLE_LEFT, 106),  BUTTON(HID_ROLE_RIGHT, 107),
    },
};
/* clang-format on */

/* ---- Known controllers ----------------------------------------------------------------------- */

/* Known controllers whose descriptors are incomplete or unusual. The layouts of the reports are
 * those of drivers/hid/hid-playstation.c in the Linux kernel: struct dualshock4_input_report_common
 * and struct dualsense_input_report. In both, the sticks come first, and the hat is followed by the
 * buttons: square, cross, circle, triangle, L1, R1, L2, R2, share, options. */
#define SONY 0x054cu
/* Dead zone of a stick in counts. Full deflection is 127 counts. A worn stick stops within the dead
 * zone when it is released. */
#define STICK_DEAD 12

static const struct known {
    uint16_t vendor, product;
    /* Bit offsets of the hat and of the right trigger, counted from the end of the report id. */
    uint32_t hat_bit, trigger_bit;
} knowns[] = {
    { SONY, 0x05c4, 32, 64 }, /* DualShock 4 */
    { SONY, 0x09cc, 32, 64 }, /* DualShock 4, second edition */
    { SONY, 0x0ba0, 32, 64 }, /* DualShock 4 wireless adapter */
    { SONY, 0x0ce6, 56, 40 }, /* DualSense */
    { SONY, 0x0df2, 56, 40 }, /* DualSense Edge */
};

static struct hid_mapping mapping_of(const struct known *known)
{
    const uint32_t hat = known->hat_bit;
    /* clang-format off */
    return (struct hid_mapping){
        .source = HID_MAPPING_KNOWN, .style = HID_STYLE_FLY, .count = 12, .binding = {
            STICK(HID_ROLE_X, 0),           STICK(HID_ROLE_Z, 8),
            TURN(HID_ROLE_ROLL, 16),        TURN(HID_ROLE_PITCH, 24),
            HAT(hat),                       BUTTON(HID_ROLE_DIP, hat + 5),
            BUTTON(HID_ROLE_OK, hat + 5),   BUTTON(HID_ROLE_LEVEL, hat + 6),
            BUTTON(HID_ROLE_FAN, hat + 7),  BUTTON(HID_ROLE_DIP, hat + 9),
            TRIGGER(HID_ROLE_DIP, known->trigger_bit), BUTTON(HID_ROLE_START, hat + 13),
        },
    };
    /* clang-format on */
}

/* Fills `out` from the table of known controllers. Returns true. Returns false if the controller is
 * not known. After a failure `out` is unchanged. */
static bool set_known(struct hid_mapping *out, const struct hid_identity *identity,
                      const struct hid_descriptor *descriptor)
{
    for (uint32_t i = 0; i < sizeof knowns / sizeof knowns[0]; i++) {
        if (knowns[i].vendor == identity->vendor && knowns[i].product == identity->product) {
            const struct hid_mapping map = mapping_of(&knowns[i]);
            CORE_ASSERT(map.count <= HID_BINDING_MAX);
            if (hid_mapping_is_sound(&map, descriptor)) {
                *out = map;
                return true;
            }
        }
    }
    return false;
}

/* ---- Selection of a mapping ----------------------------------------------------------------- */

bool hid_mapping_has_keyboard(const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        if (group->application == USAGE_KEYBOARD && !(group->flags & HID_CONSTANT) &&
            descriptor->range[group->range_first].first >> 16 == KEYBOARD_PAGE) {
            return true;
        }
    }
    return false;
}

void hid_mapping_choose(struct hid_mapping *out, const struct hid_identity *identity,
                        const struct hid_descriptor *descriptor)
{
    memset(out, 0, sizeof *out);
    if (descriptor->error != HID_OK || hid_mapping_has_keyboard(descriptor)) {
        return;
    }
    if (is_own(descriptor)) {
        *out = own_mapping;
    } else if (!set_known(out, identity, descriptor)) {
        hid_mapping_auto_build(out, descriptor);
    }
    if (!hid_mapping_is_sound(out, descriptor)) {
        memset(out, 0, sizeof *out);
    }
    CORE_ASSERT(out->count <= HID_BINDING_MAX);
    CORE_ASSERT((out->source == HID_MAPPING_NONE) == (out->style == HID_STYLE_NONE));
}

uint32_t hid_mapping_score(const struct hid_identity *identity,
                           const struct hid_descriptor *descriptor)
{
    struct hid_mapping map;
    hid_mapping_choose(&map, identity, descriptor);
    return map.source == HID_MAPPING_NONE   ? 0
           : map.source == HID_MAPPING_AUTO ? hid_mapping_auto_score(descriptor)
                                            : WORTH_KNOWN;
}

const char *hid_mapping_absence_reason(const struct hid_descriptor *of)
{
    const bool has_x = hid_mapping_auto_find(of, 0, -1, false, USAGE_X).group != NULL;
    const bool has_y = hid_mapping_auto_find(of, 0, -1, false, USAGE_Y).group != NULL;
    if (hid_mapping_has_keyboard(of)) {
        return "it has the keys of a keyboard, and the kiosk never uses a keyboard";
    }
    return !has_x && !has_y ? "it declares no X axis and no Y axis; learn it in the operator's menu"
           : !has_x || !has_y
               ? "it declares only one of the axes X and Y"
               : "its X and Y are no pair of axes with a button; learn it in the menu";
}

/* ---- Validation ----------------------------------------------------------------------------- */

static bool is_axis_role(uint8_t role)
{
    return role >= HID_ROLE_X && role <= HID_ROLE_TILT;
}

static bool is_allowed_manner(const struct hid_binding *binding)
{
    switch (binding->manner) {
    case HID_BINDING_POSITION:
        return is_axis_role(binding->role) || binding->role == HID_ROLE_SEQUENCE;
    case HID_BINDING_RATE:
    case HID_BINDING_STEP:
        return is_axis_role(binding->role);
    case HID_BINDING_PRESS:
        return !is_axis_role(binding->role) && binding->role != HID_ROLE_HAT &&
               binding->role != HID_ROLE_SEQUENCE;
    case HID_BINDING_HAT:
        return binding->role == HID_ROLE_HAT || binding->role == HID_ROLE_X ||
               binding->role == HID_ROLE_Z;
    default:
        return false;
    }
}

bool hid_mapping_is_array_of(const struct hid_group *group, const struct hid_binding *binding)
{
    return !(group->flags & HID_VARIABLE) && group->count <= HID_ARRAY_MAX &&
           group->report_id == binding->report_id && group->bit_offset == binding->bit_offset &&
           group->bit_size == binding->bit_size;
}

static bool binding_is_sound(const struct hid_binding *binding,
                             const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->error == HID_OK);
    if (binding->rest < -HID_VALUE_MAX || binding->rest > HID_VALUE_MAX ||
        binding->full < -HID_VALUE_MAX || binding->full > HID_VALUE_MAX) {
        return false;
    }
    const uint64_t end = (uint64_t)binding->bit_offset + binding->bit_size;
    const int64_t span = binding->full - binding->rest;
    const int64_t width = span < 0 ? -span : span;
    uint32_t array = 0;
    while (array < descriptor->group_count &&
           !hid_mapping_is_array_of(&descriptor->group[array], binding)) {
        array++;
    }
    return binding->role > HID_ROLE_NONE && binding->role < HID_ROLE_COUNT &&
           is_allowed_manner(binding) && binding->bit_size >= 1 && binding->bit_size <= 32 &&
           end <= descriptor->report_bits[binding->report_id] && span != 0 && binding->dead >= 0 &&
           binding->dead < width &&
           (binding->usage == 0 ||
            (binding->manner == HID_BINDING_PRESS && array < descriptor->group_count));
}

bool hid_mapping_has_role(const struct hid_mapping *map, enum hid_role role,
                          enum hid_binding_kind manner)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    for (uint32_t i = 0; i < map->count; i++) {
        if (map->binding[i].role == role && map->binding[i].manner == manner) {
            return true;
        }
    }
    return false;
}

static bool has_plane(const struct hid_mapping *map, enum hid_binding_kind manner)
{
    return hid_mapping_has_role(map, HID_ROLE_X, manner) &&
           hid_mapping_has_role(map, HID_ROLE_Z, manner);
}

static bool style_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor)
{
    const bool dips = hid_mapping_has_role(map, HID_ROLE_DIP, HID_BINDING_PRESS);
    switch (map->style) {
    case HID_STYLE_POSE:
        return is_own(descriptor);
    case HID_STYLE_POINTER:
        return dips && (has_plane(map, HID_BINDING_POSITION) || has_plane(map, HID_BINDING_STEP));
    case HID_STYLE_FLY:
        return (has_plane(map, HID_BINDING_RATE) || has_plane(map, HID_BINDING_HAT)) &&
               (dips || hid_mapping_has_role(map, HID_ROLE_Y, HID_BINDING_RATE));
    default:
        return false;
    }
}

bool hid_mapping_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor)
{
    if (descriptor->error != HID_OK || map->source == HID_MAPPING_NONE ||
        map->source > HID_MAPPING_LEARNED || map->count > HID_BINDING_MAX) {
        return false;
    }
    for (uint32_t i = 0; i < map->count; i++) {
        if (!binding_is_sound(&map->binding[i], descriptor)) {
            return false;
        }
    }
    return style_is_sound(map, descriptor);
}
