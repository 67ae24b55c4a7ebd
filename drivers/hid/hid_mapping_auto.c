/* hid_mapping_auto.c -- finds fields by their usage, computes the ends and dead zones of bindings,
 * and builds a mapping from the best control surface that a descriptor declares: a puck, a pen, a
 * stick or a mouse. A puck is a 3D mouse with six axes. */
#include "drivers/hid/hid_mapping_auto.h"

#include <string.h>

#include "core/base/panic.h"

/* Smallest logical range with which a field counts as an axis. The limit is above the range of a
 * hat. */
#define AXIS_STEPS_MIN 14
/* Divisor of the dead zone of a stick. The dead zone is half the range of the stick divided by this
 * number. A released stick stops within its dead zone. */
#define DEAD_SHARE_STICK 12
/* The dead zone of a puck is half the range of the puck divided by this number. A puck has stiffer
 * springs than a stick. */
#define DEAD_SHARE_PUCK 50

/* Returns true if the fields of `group` can be an axis. A field of an axis has more possible values
 * than a hat. For example, an "X" field of one bit is a button and not an axis. */
static bool is_axis(const struct hid_group *group)
{
    return (group->flags & HID_VARIABLE) && group->bit_size <= 32u &&
           group->logical_max - group->logical_min >= AXIS_STEPS_MIN;
}

/* Returns the index of the field with the usage `usage` in `group`, or -1 if the group does not
 * have the usage. For an array, returns 0, because one field entry stands for all elements. */
static int32_t place_in(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        hid_usage usage)
{
    CORE_ASSERT((uint32_t)group->range_first + group->range_count <= HID_RANGE_MAX);
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

struct hid_field_location hid_mapping_auto_find(const struct hid_descriptor *descriptor,
                                                hid_usage application, int report_id,
                                                bool report_only, hid_usage usage)
{
    struct hid_field_location elsewhere = { 0 };
    CORE_ASSERT(report_id >= -1 && report_id <= 255);
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        const int32_t index = place_in(descriptor, group, usage);
        if (index < 0 || (group->flags & HID_CONSTANT) || group->bit_size > 32u ||
            (application && group->application != application)) {
            continue;
        }
        const struct hid_field_location found = { group, (uint32_t)index, usage };
        if (report_id < 0 || group->report_id == report_id) {
            return found;
        }
        if (!elsewhere.group && !report_only) {
            elsewhere = found;
        }
    }
    return elsewhere;
}

bool hid_mapping_auto_bits(struct hid_mapping *map, struct hid_binding binding)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    if (map->count == HID_BINDING_MAX) {
        return false;
    }
    map->binding[map->count++] = binding;
    return true;
}

/* Returns true for a one-bit button whose descriptor declares no logical range. */
static bool is_bare_button(const struct hid_group *group)
{
    return group->bit_size == 1 && group->logical_min == 0 && group->logical_max == 0;
}

int64_t hid_mapping_auto_high(const struct hid_group *group)
{
    CORE_ASSERT(group->bit_size >= 1 && group->bit_size <= 32);
    const uint32_t bits = group->bit_size - (group->logical_min < 0);
    const int64_t most = ((int64_t)1 << bits) - 1;
    return group->logical_max < most && !is_bare_button(group) ? group->logical_max : most;
}

/* Adds a binding of the field `spot` to `map`. Returns true, or false if `spot` is empty or
 * unsuitable or if the mapping is full. The binding ranges from the logical minimum of the field to
 * its maximum. A HID_BINDING_RATE binding ranges from the middle of the field to its maximum. If
 * `turned` is true the direction is reversed. */
static bool bind_field(struct hid_mapping *map, struct hid_field_location spot, enum hid_role role,
                       enum hid_binding_kind manner, bool turned)
{
    const struct hid_group *group = spot.group;
    CORE_ASSERT(role > HID_ROLE_NONE && role < HID_ROLE_COUNT);
    CORE_ASSERT(manner < HID_BINDING_KIND_COUNT);
    CORE_ASSERT(!group || spot.index < group->count);
    const bool is_switch = manner == HID_BINDING_PRESS || manner == HID_BINDING_HAT;
    if (!group || (!is_switch && !is_axis(group)) ||
        (group->logical_min >= group->logical_max && !is_bare_button(group))) {
        return false;
    }
    const bool is_array = !(group->flags & HID_VARIABLE);
    if (is_array && (manner != HID_BINDING_PRESS || group->count > HID_ARRAY_MAX)) {
        return false;
    }
    struct hid_binding binding = {
        .role = (uint8_t)role,
        .manner = (uint8_t)manner,
        .report_id = group->report_id,
        .bit_offset = group->bit_offset + spot.index * group->bit_size,
        .bit_size = (uint8_t)group->bit_size,
        .is_signed = !is_array && group->logical_min < 0,
        .usage = is_array ? spot.usage : 0,
    };
    const bool is_turn = role >= HID_ROLE_PITCH && role <= HID_ROLE_ROLL;
    if (manner == HID_BINDING_RATE || (manner == HID_BINDING_POSITION && is_turn)) {
        const bool is_puck = group->application == USAGE_MULTI_AXIS;
        binding.dead = (group->logical_max - group->logical_min) / 2 /
                       (is_puck ? DEAD_SHARE_PUCK : DEAD_SHARE_STICK);
    }
    const int64_t low = group->logical_min, high = hid_mapping_auto_high(group);
    if (manner == HID_BINDING_STEP) {
        binding.full = turned ? -1 : 1;
    } else {
        const bool is_rate = manner == HID_BINDING_RATE;
        binding.rest = is_rate ? low + (high - low + 1) / 2 : turned ? high : low;
        binding.full = turned ? low : high;
    }
    return hid_mapping_auto_bits(map, binding);
}

/* ---- Control surfaces ----------------------------------------------------------------------- */

/* A control surface: a report of one application collection with an X axis or a hat. */
struct surface {
    const struct hid_descriptor *descriptor;
    hid_usage application;
    int report_id;
    bool relative;
};

/* Finds the usage `usage` in the surface's application collection. Reports other than the surface's
 * report are searched too unless `report_only` is true. */
static struct hid_field_location find_on(const struct surface *on, hid_usage usage,
                                         bool report_only)
{
    return hid_mapping_auto_find(on->descriptor, on->application, on->report_id, report_only,
                                 usage);
}

/* Returns the score of a control surface. 0 means that the surface cannot control the poi.
 * Multi-axis controllers and pens have the highest scores, and relative mice and touch pads the
 * lowest. */
static uint32_t score_of(const struct surface *surface)
{
    /* The score of a touch pad is below that of the mouse in the same descriptor. The touch pad
     * sends only mouse reports until the host sets its Input Mode (usage 0d:52, a feature report),
     * which the kiosk never does. */
    const bool places = !surface->relative;
    switch (surface->application) {
    case USAGE_MULTI_AXIS:
        return find_on(surface, USAGE_Z, false).group ? 60u : 0u;
    case USAGE_PEN:
    case USAGE_DIGITIZER:
        return places ? 50u : 0u;
    case USAGE_TOUCH_SCREEN:
        return places ? 35u : 0u;
    case USAGE_TOUCH_PAD:
        return places ? 5u : 0u;
    case USAGE_JOYSTICK:
    case USAGE_GAMEPAD:
        return places ? 30u : 0u;
    case USAGE_MOUSE:
        return places ? 20u + (find_on(surface, USAGE_TIP_PRESSURE, true).group ? 5u : 0u) : 10u;
    default:
        return 0;
    }
}

/* Returns true for a four-switch joystick, which has a hat and no X axis. */
static bool is_switch_stick(const struct surface *surface)
{
    return (surface->application == USAGE_JOYSTICK || surface->application == USAGE_GAMEPAD) &&
           find_on(surface, USAGE_HAT, false).group && !find_on(surface, USAGE_X, false).group;
}

/* ---- Mappings of each kind of surface ------------------------------------------------------- */

/* Rule for one binding of a control surface. */
struct rule {
    hid_usage usage;
    uint8_t role, manner;
    bool turned; /* True if the direction of the axis is reversed. */
    bool here;   /* True if the field must be in the report of the surface. */
};

#define RATE(usage, role, turned) { usage, role, HID_BINDING_RATE, turned, false }
#define POSITION(usage, role, turned) { usage, role, HID_BINDING_POSITION, turned, false }
#define PRESS(number, role) { USAGE_BUTTON + (number), role, HID_BINDING_PRESS, false, false }
#define HAT(role) { USAGE_HAT, role, HID_BINDING_HAT, false, false }
#define BIND_ALL(map, surface, rules) bind_all(map, surface, rules, sizeof rules / sizeof rules[0])

static void bind_all(struct hid_mapping *map, const struct surface *surface,
                     const struct rule *rules, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct rule *rule = &rules[i];
        CORE_ASSERT(rule->role < HID_ROLE_COUNT);
        bind_field(map, find_on(surface, rule->usage, rule->here), rule->role, rule->manner,
                   rule->turned);
    }
}

/* Rules of a puck. The X axis of a puck points right, the Y axis toward the user, and the Z axis
 * downward. RX, RY and RZ are rotations about these axes. Some descriptors declare the axes as
 * relative although the values are deflections. */
static const struct rule puck_rules[] = {
    RATE(USAGE_X, HID_ROLE_X, false),
    RATE(USAGE_Y, HID_ROLE_Z, false),
    RATE(USAGE_Z, HID_ROLE_Y, true),
    POSITION(USAGE_RX, HID_ROLE_PITCH, false),
    POSITION(USAGE_RY, HID_ROLE_ROLL, true),
    POSITION(USAGE_RZ, HID_ROLE_YAW, true),
    PRESS(1, HID_ROLE_START),
    PRESS(1, HID_ROLE_OK),
    PRESS(2, HID_ROLE_LEVEL),
    PRESS(2, HID_ROLE_RIGHT),
};

/* Rules of the sticks and the hat of a game pad or a joystick. X and Y are the left stick. If Z and
 * RZ both exist, these two axes are the right stick. Otherwise RX and RY are the right stick,
 * because Z then belongs to the triggers. Without a right stick, RZ is the twist of a joystick. */
static const struct rule four_switch_rules[] = { HAT(HID_ROLE_X), HAT(HID_ROLE_Z) };
static const struct rule left_stick_rules[] = {
    RATE(USAGE_X, HID_ROLE_X, false),
    RATE(USAGE_Y, HID_ROLE_Z, false),
};
static const struct rule z_stick_rules[] = {
    POSITION(USAGE_Z, HID_ROLE_ROLL, false),
    POSITION(USAGE_RZ, HID_ROLE_PITCH, false),
    HAT(HID_ROLE_HAT),
};
static const struct rule rx_stick_rules[] = {
    POSITION(USAGE_RX, HID_ROLE_ROLL, false),
    POSITION(USAGE_RY, HID_ROLE_PITCH, false),
    HAT(HID_ROLE_HAT),
};
static const struct rule twist_rules[] = {
    POSITION(USAGE_RZ, HID_ROLE_YAW, true),
    HAT(HID_ROLE_HAT),
};

/* Rules of the buttons of a game pad, which has one of two numberings. With twelve or more buttons,
 * 1 to 4 are face buttons, 5 to 8 are shoulder buttons, and 9 and 10 are in the middle. With fewer
 * buttons, 5 and 6 are shoulder buttons, and 7 and 8 are in the middle. On a joystick, button 1 is
 * the trigger. */
/* clang-format off */
static const struct rule few_button_rules[] = {
    PRESS(1, HID_ROLE_DIP), PRESS(1, HID_ROLE_OK), PRESS(2, HID_ROLE_LEVEL), PRESS(3, HID_ROLE_FAN),
    PRESS(4, HID_ROLE_FAN), PRESS(6, HID_ROLE_DIP), PRESS(8, HID_ROLE_START),
};
static const struct rule many_button_rules[] = {
    PRESS(1, HID_ROLE_DIP), PRESS(1, HID_ROLE_OK), PRESS(2, HID_ROLE_DIP), PRESS(3, HID_ROLE_LEVEL),
    PRESS(4, HID_ROLE_FAN), PRESS(6, HID_ROLE_DIP), PRESS(10, HID_ROLE_START),
    PRESS(8, HID_ROLE_DIP),
};
/* clang-format on */

static void map_pad(struct hid_mapping *map, const struct surface *surface)
{
    CORE_ASSERT(surface->application == USAGE_JOYSTICK || surface->application == USAGE_GAMEPAD);
    map->style = HID_STYLE_FLY;
    if (is_switch_stick(surface)) {
        BIND_ALL(map, surface, four_switch_rules);
    } else {
        BIND_ALL(map, surface, left_stick_rules);
        if (find_on(surface, USAGE_Z, false).group && find_on(surface, USAGE_RZ, false).group) {
            BIND_ALL(map, surface, z_stick_rules);
        } else if (find_on(surface, USAGE_RX, false).group &&
                   find_on(surface, USAGE_RY, false).group) {
            BIND_ALL(map, surface, rx_stick_rules);
        } else {
            BIND_ALL(map, surface, twist_rules);
        }
    }
    bind_field(map, find_on(surface, USAGE_ACCELERATOR, false), HID_ROLE_DIP, HID_BINDING_PRESS,
               false);
    if (find_on(surface, USAGE_BUTTON + 12u, false).group) {
        BIND_ALL(map, surface, many_button_rules);
    } else {
        BIND_ALL(map, surface, few_button_rules);
    }
}

/* Rules that bind the remaining fields of a pen after the position and the tip were bound. */
static const struct rule pen_rules[] = {
    { USAGE_IN_RANGE, HID_ROLE_IN_RANGE, HID_BINDING_PRESS, false, true },
    { USAGE_BARREL, HID_ROLE_FAN, HID_BINDING_PRESS, false, true },
    { USAGE_X_TILT, HID_ROLE_ROLL, HID_BINDING_POSITION, false, true },
    { USAGE_Y_TILT, HID_ROLE_PITCH, HID_BINDING_POSITION, false, true },
};

/* Rules that bind the remaining fields of a mouse after the position and the buttons that act as
 * the tip were bound. */
static const struct rule mouse_rules[] = {
    { USAGE_WHEEL, HID_ROLE_TILT, HID_BINDING_STEP, false, false },
    PRESS(2, HID_ROLE_LEVEL),
    PRESS(3, HID_ROLE_FAN),
};

static void map_pointer(struct hid_mapping *map, const struct surface *surface)
{
    /* Fields that can dip the poi, best first. Only the first existing field is bound. */
    static const hid_usage tips[] = { USAGE_TIP, USAGE_BUTTON + 1u, USAGE_TIP_PRESSURE };
    const bool is_mouse = surface->application == USAGE_MOUSE;
    const enum hid_binding_kind manner =
        is_mouse && surface->relative ? HID_BINDING_STEP : HID_BINDING_POSITION;
    CORE_ASSERT(map->count == 0);
    map->style = HID_STYLE_POINTER;
    bind_field(map, find_on(surface, USAGE_X, true), HID_ROLE_X, manner, false);
    bind_field(map, find_on(surface, USAGE_Y, true), HID_ROLE_Z, manner, false);
    uint32_t i = 0;
    while (i < 3u && !bind_field(map, find_on(surface, tips[i], true), HID_ROLE_DIP,
                                 HID_BINDING_PRESS, false)) {
        i++;
    }
    if (i < 3u && tips[i] == USAGE_TIP_PRESSURE) {
        struct hid_binding *pressure = &map->binding[map->count - 1u];
        pressure->full = pressure->rest + (pressure->full - pressure->rest) / 8 + 1;
    }
    if (is_mouse) {
        BIND_ALL(map, surface, mouse_rules);
    } else {
        BIND_ALL(map, surface, pen_rules);
    }
}

/* Finds the control surface with the highest score. Returns the score, or 0 if there is no usable
 * surface. */
static uint32_t best_surface(const struct hid_descriptor *descriptor, struct surface *out)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
    uint32_t best_worth = 0;
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        const bool has_x = is_axis(group) && place_in(descriptor, group, USAGE_X) >= 0;
        const bool has_hat = place_in(descriptor, group, USAGE_HAT) >= 0;
        if ((group->flags & HID_CONSTANT) || (!has_x && !has_hat)) {
            continue;
        }
        const struct surface surface = {
            .descriptor = descriptor,
            .application = group->application,
            .report_id = group->report_id,
            .relative = (group->flags & HID_RELATIVE) != 0,
        };
        const struct hid_field_location y = find_on(&surface, USAGE_Y, false);
        const bool is_plane = has_x && y.group && is_axis(y.group);
        const bool is_usable = is_plane || (has_hat && is_switch_stick(&surface));
        const uint32_t worth = is_usable ? score_of(&surface) : 0;
        if (worth > best_worth) {
            *out = surface;
            best_worth = worth;
        }
    }
    return best_worth;
}

void hid_mapping_auto_build(struct hid_mapping *out, const struct hid_descriptor *descriptor)
{
    struct surface best = { 0 };
    memset(out, 0, sizeof *out);
    if (best_surface(descriptor, &best) > 0) {
        out->source = HID_MAPPING_AUTO;
        switch (best.application) {
        case USAGE_MULTI_AXIS:
            out->style = HID_STYLE_FLY;
            BIND_ALL(out, &best, puck_rules);
            break;
        case USAGE_JOYSTICK:
        case USAGE_GAMEPAD:
            map_pad(out, &best);
            break;
        default:
            map_pointer(out, &best);
        }
    }
}

uint32_t hid_mapping_auto_score(const struct hid_descriptor *descriptor)
{
    struct surface best = { 0 };
    return best_surface(descriptor, &best);
}
