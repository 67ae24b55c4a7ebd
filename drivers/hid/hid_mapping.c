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

struct place {
    hid_usage usage;
    uint32_t bit_offset, bit_size;
};

/* Axes of Kingyo's poi controller in the order of its report. The sequence number before the axes
 * has no HID usage and is not checked. */
static const struct place own_places[] = {
    { USAGE_X, 8, 16 },   { USAGE_Y, 24, 16 },  { USAGE_Z, 40, 16 },
    { USAGE_RX, 56, 16 }, { USAGE_RY, 72, 16 }, { USAGE_RZ, 88, 16 },
};

int hid_mapping_is_own(const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
    if (!descriptor->has_report_ids ||
        descriptor->report_bits[POI_REPORT_ID] != 8u * (POI_REPORT_SIZE - 1u)) {
        return 0;
    }
    for (uint32_t i = 0; i < sizeof own_places / sizeof own_places[0]; i++) {
        const struct place *place = &own_places[i];
        const struct hid_field_location spot =
            hid_mapping_auto_find(descriptor, 0, POI_REPORT_ID, 1, place->usage);
        const struct hid_group *group = spot.group;
        if (!group || group->bit_size != place->bit_size || group->logical_min != -32767 ||
            group->logical_max != 32767 || (group->flags & HID_RELATIVE) ||
            group->bit_offset + spot.index * group->bit_size != place->bit_offset) {
            return 0;
        }
    }
    return 1;
}

static void map_own(struct hid_mapping *map)
{
    static const uint8_t axes[] = { HID_ROLE_X,     HID_ROLE_Y,   HID_ROLE_Z,
                                    HID_ROLE_PITCH, HID_ROLE_YAW, HID_ROLE_ROLL };
    /* The buttons in the order of enum poi_button. */
    static const uint8_t buttons[] = { HID_ROLE_OK, HID_ROLE_START, HID_ROLE_LEFT, HID_ROLE_RIGHT };
    _Static_assert(sizeof axes == sizeof own_places / sizeof own_places[0],
                   "an axis at each place");
    *map = (struct hid_mapping){ .source = HID_MAPPING_OWN, .style = HID_STYLE_POSE, .feels = 1 };
    for (uint32_t i = 0; i < sizeof axes + sizeof buttons; i++) {
        struct hid_binding binding = { .report_id = POI_REPORT_ID };
        if (i < sizeof axes) {
            binding.role = axes[i];
            binding.manner = HID_BINDING_POSITION;
            binding.bit_offset = own_places[i].bit_offset;
            binding.bit_size = (uint8_t)own_places[i].bit_size;
            binding.is_signed = 1;
            binding.rest = -32767;
            binding.full = 32767;
        } else {
            binding.role = buttons[i - sizeof axes];
            binding.manner = HID_BINDING_PRESS;
            binding.bit_offset = 8u * 13u + i - (uint32_t)sizeof axes;
            binding.bit_size = 1;
            binding.full = 1;
        }
        hid_mapping_auto_bits(map, binding);
    }
}

/* ---- Known controllers ----------------------------------------------------------------------- */

/* Mappings of known controllers whose descriptors are incomplete or unusual. The layouts of the
 * reports are those of drivers/hid/hid-playstation.c in the Linux kernel: struct
 * dualshock4_input_report_common and struct dualsense_input_report. */
#define SONY 0x054cu
/* Dead zone of a stick in counts; full deflection is 127 counts. A worn stick stops within the dead
 * zone when it is released. */
#define STICK_DEAD 12

struct known {
    uint16_t vendor, product;
    const struct hid_binding *bindings;
    uint32_t count;
};

/* clang-format off */
#define STICK(role_, bit)                                                                        \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_RATE, .report_id = 1, .bit_offset = bit,              \
        .bit_size = 8, .rest = 128, .full = 255, .dead = STICK_DEAD                               \
    }
#define TURN(role_, bit)                                                                         \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_POSITION, .report_id = 1,                             \
            .bit_offset = bit, \
        .bit_size = 8, .rest = 0, .full = 255, .dead = STICK_DEAD                                 \
    }
#define BUTTON(role_, bit)                                                                       \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_PRESS, .report_id = 1, .bit_offset = bit,             \
        .bit_size = 1, .rest = 0, .full = 1                                                       \
    }
#define TRIGGER(role_, bit)                                                                      \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_PRESS, .report_id = 1, .bit_offset = bit,             \
        .bit_size = 8, .rest = 0, .full = 255                                                     \
    }
#define HAT(bit)                                                                                 \
    {                                                                                             \
        .role = HID_ROLE_HAT, .manner = HID_BINDING_HAT, .report_id = 1, .bit_offset = bit,        \
        .bit_size = 4, .rest = 0, .full = 7                                                       \
    }

/* Bindings of a DualShock 4. The button bits start at 36: square, cross, circle, triangle, L1, R1,
 * L2, R2, share, options. */
static const struct hid_binding dualshock4[] = {
    STICK(HID_ROLE_X, 0),         STICK(HID_ROLE_Z, 8),       TURN(HID_ROLE_ROLL, 16),
    TURN(HID_ROLE_PITCH, 24),     HAT(32),                    BUTTON(HID_ROLE_DIP, 37),
    BUTTON(HID_ROLE_OK, 37),      BUTTON(HID_ROLE_LEVEL, 38), BUTTON(HID_ROLE_FAN, 39),
    BUTTON(HID_ROLE_DIP, 41),     TRIGGER(HID_ROLE_DIP, 64),  BUTTON(HID_ROLE_START, 45),
};

/* Bindings of a DualSense. The triggers come before the buttons, whose bits start at 60. */
static const struct hid_binding dualsense[] = {
    STICK(HID_ROLE_X, 0),         STICK(HID_ROLE_Z, 8),       TURN(HID_ROLE_ROLL, 16),
    TURN(HID_ROLE_PITCH, 24),     HAT(56),                    BUTTON(HID_ROLE_DIP, 61),
    BUTTON(HID_ROLE_OK, 61),      BUTTON(HID_ROLE_LEVEL, 62), BUTTON(HID_ROLE_FAN, 63),
    BUTTON(HID_ROLE_DIP, 65),     TRIGGER(HID_ROLE_DIP, 40),  BUTTON(HID_ROLE_START, 69),
};
/* clang-format on */

#define ROW(product, table) { SONY, product, table, sizeof table / sizeof table[0] }

static const struct known knowns[] = {
    ROW(0x05c4, dualshock4), /* DualShock 4 */
    ROW(0x09cc, dualshock4), /* DualShock 4, second edition */
    ROW(0x0ba0, dualshock4), /* DualShock 4 wireless adapter */
    ROW(0x0ce6, dualsense),  /* DualSense */
    ROW(0x0df2, dualsense),  /* DualSense Edge */
};

/* Fills `out` from the table of known controllers. Returns 1, or 0 if the controller is not known;
 * `out` is then unchanged. */
static int hid_mapping_known(struct hid_mapping *out, const struct hid_identity *identity,
                             const struct hid_descriptor *descriptor)
{
    for (uint32_t i = 0; i < sizeof knowns / sizeof knowns[0]; i++) {
        const struct known *known = &knowns[i];
        CORE_ASSERT(known->count <= HID_BINDING_MAX);
        if (known->vendor == identity->vendor && known->product == identity->product) {
            struct hid_mapping map = { .source = HID_MAPPING_KNOWN, .style = HID_STYLE_FLY };
            for (uint32_t j = 0; j < known->count; j++) {
                hid_mapping_auto_bits(&map, known->bindings[j]);
            }
            if (hid_mapping_is_sound(&map, descriptor)) {
                *out = map;
                return 1;
            }
        }
    }
    return 0;
}

/* ---- Selection of a mapping ----------------------------------------------------------------- */

int hid_mapping_has_keyboard(const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
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
    CORE_ASSERT(out->count <= HID_BINDING_MAX);
    CORE_ASSERT((out->source == HID_MAPPING_NONE) == (out->style == HID_STYLE_NONE));
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

static int binding_is_sound(const struct hid_binding *binding,
                            const struct hid_descriptor *descriptor)
{
    CORE_ASSERT(descriptor->error == HID_OK);
    if (binding->rest < -HID_VALUE_MAX || binding->rest > HID_VALUE_MAX ||
        binding->full < -HID_VALUE_MAX || binding->full > HID_VALUE_MAX) {
        return 0;
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
           manner_fits(binding) && binding->bit_size >= 1 && binding->bit_size <= 32 &&
           binding->is_signed <= 1 && end <= descriptor->report_bits[binding->report_id] &&
           span != 0 && binding->dead >= 0 && binding->dead < width &&
           (binding->usage == 0 ||
            (binding->manner == HID_BINDING_PRESS && array < descriptor->group_count));
}

static int has_role_binding(const struct hid_mapping *map, enum hid_role role,
                            enum hid_binding_kind manner)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    for (uint32_t i = 0; i < map->count; i++) {
        if (map->binding[i].role == role && map->binding[i].manner == manner) {
            return 1;
        }
    }
    return 0;
}

static int has_plane(const struct hid_mapping *map, enum hid_binding_kind manner)
{
    return has_role_binding(map, HID_ROLE_X, manner) && has_role_binding(map, HID_ROLE_Z, manner);
}

static int style_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor)
{
    const int dips = has_role_binding(map, HID_ROLE_DIP, HID_BINDING_PRESS);
    switch (map->style) {
    case HID_STYLE_POSE:
        return hid_mapping_is_own(descriptor);
    case HID_STYLE_POINTER:
        return dips && (has_plane(map, HID_BINDING_POSITION) || has_plane(map, HID_BINDING_STEP));
    case HID_STYLE_FLY:
        return (has_plane(map, HID_BINDING_RATE) || has_plane(map, HID_BINDING_HAT)) &&
               (dips || has_role_binding(map, HID_ROLE_Y, HID_BINDING_RATE));
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
