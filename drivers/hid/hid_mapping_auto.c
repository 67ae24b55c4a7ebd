/* hid_mapping_auto.c -- finds fields by their usage, computes the ends and dead zones of bindings,
 * and builds a mapping from the best control surface that a descriptor declares: a puck, a pen, a
 * stick or a mouse. A puck is a 3D mouse with six axes. */
#include "drivers/hid/hid_mapping_auto.h"

#include <string.h>

#include "core/base/panic.h"

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

static struct hid_field_location find_in(const struct hid_descriptor *descriptor,
                                         hid_usage application, int report_id, hid_usage usage)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
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
    CORE_ASSERT(report_id >= -1 && report_id <= 255);
    const struct hid_field_location here = find_in(descriptor, application, report_id, usage);
    return here.group || report_only ? here : find_in(descriptor, application, -1, usage);
}

int hid_mapping_auto_bits(struct hid_mapping *map, struct hid_binding binding)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
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
    CORE_ASSERT(group->bit_size >= 1 && group->bit_size <= 32);
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

int hid_mapping_auto_bind(struct hid_mapping *map, struct hid_field_location spot,
                          enum hid_role role, enum hid_binding_kind manner, int turned)
{
    const struct hid_group *group = spot.group;
    CORE_ASSERT(role > HID_ROLE_NONE && role < HID_ROLE_COUNT);
    CORE_ASSERT(manner < HID_BINDING_KIND_COUNT);
    CORE_ASSERT(!group || spot.index < group->count);
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
    };
    const int is_turn = role >= HID_ROLE_PITCH && role <= HID_ROLE_ROLL;
    if (manner == HID_BINDING_RATE || (manner == HID_BINDING_POSITION && is_turn)) {
        const int is_puck = group->application == USAGE_MULTI_AXIS;
        binding.dead = (group->logical_max - group->logical_min) / 2 /
                       (is_puck ? DEAD_SHARE_PUCK : DEAD_SHARE_STICK);
    }
    set_ends(&binding, group, turned);
    return hid_mapping_auto_bits(map, binding);
}

/* ---- Control surfaces ----------------------------------------------------------------------- */

/* A control surface: a report of one application collection with an X axis or a hat. */
struct surface {
    const struct hid_descriptor *descriptor;
    hid_usage application;
    int report_id;
    int relative;
};

/* Finds the usage in the surface's application collection. Reports other than the surface's report
 * are searched too unless `report_only` is 1. */
static struct hid_field_location find_on(const struct surface *surface, hid_usage usage,
                                         int report_only)
{
    return hid_mapping_auto_find(surface->descriptor, surface->application, surface->report_id,
                                 report_only, usage);
}

/* Returns the score of a control surface; 0 means that the surface cannot control the poi.
 * Multi-axis controllers and pens have the highest scores, and relative mice and touch pads the
 * lowest. */
static uint32_t worth_of(const struct surface *surface)
{
    /* Score of a touch pad, which is below that of the mouse in the same descriptor. The touch pad
     * sends only mouse reports until the host sets its Input Mode (usage 0d:52, a feature report),
     * which the kiosk never does. */
    enum { TOUCH_PAD_WORTH = 5u };
    const int places = !surface->relative;
    switch (surface->application) {
    case USAGE_MULTI_AXIS:
        return find_on(surface, USAGE_Z, 0).group ? 60u : 0u;
    case USAGE_PEN:
    case USAGE_DIGITIZER:
        return places ? 50u : 0u;
    case USAGE_TOUCH_SCREEN:
        return places ? 35u : 0u;
    case USAGE_TOUCH_PAD:
        return places ? TOUCH_PAD_WORTH : 0u;
    case USAGE_JOYSTICK:
    case USAGE_GAMEPAD:
        return places ? 30u : 0u;
    case USAGE_MOUSE:
        return places ? 20u + (find_on(surface, USAGE_TIP_PRESSURE, 1).group ? 5u : 0u) : 10u;
    default:
        return 0;
    }
}

/* Returns 1 for a four-switch joystick, which has a hat and no X axis, otherwise 0. */
static int is_switch_stick(const struct surface *surface)
{
    return (surface->application == USAGE_JOYSTICK || surface->application == USAGE_GAMEPAD) &&
           find_on(surface, USAGE_HAT, 0).group && !find_on(surface, USAGE_X, 0).group;
}

static int is_surface(const struct hid_descriptor *descriptor, const struct hid_group *group,
                      struct surface *out)
{
    const int has_x =
        hid_mapping_auto_is_axis(group) && hid_mapping_auto_place(descriptor, group, USAGE_X) >= 0;
    const int has_hat = hid_mapping_auto_place(descriptor, group, USAGE_HAT) >= 0;
    if ((group->flags & HID_CONSTANT) || (!has_x && !has_hat)) {
        return 0;
    }
    *out = (struct surface){
        .descriptor = descriptor,
        .application = group->application,
        .report_id = group->report_id,
        .relative = (group->flags & HID_RELATIVE) != 0,
    };
    const struct hid_field_location y = find_on(out, USAGE_Y, 0);
    return (has_x && y.group && hid_mapping_auto_is_axis(y.group)) ||
           (has_hat && is_switch_stick(out));
}

/* ---- Mappings of each kind of surface ------------------------------------------------------- */

/* Rule for one binding of a control surface. `here` is 1 if the field must be in the report of the
 * surface, otherwise 0. */
struct rule {
    hid_usage usage;
    uint8_t role, manner, turned, here;
};

#define PRESS(number, role) { USAGE_BUTTON + (number), role, HID_BINDING_PRESS, 0, 0 }
#define BIND_ALL(map, surface, rules) bind_all(map, surface, rules, sizeof rules / sizeof rules[0])

static void bind_all(struct hid_mapping *map, const struct surface *surface,
                     const struct rule *rules, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct rule *rule = &rules[i];
        CORE_ASSERT(rule->role < HID_ROLE_COUNT);
        hid_mapping_auto_bind(map, find_on(surface, rule->usage, rule->here), rule->role,
                              rule->manner, rule->turned);
    }
}

/* Rules of a puck. The X axis of a puck points right, the Y axis toward the user, and the Z axis
 * downward. RX, RY and RZ are rotations about these axes. Some descriptors declare the axes as
 * relative although the values are deflections. */
static const struct rule puck_rules[] = {
    { USAGE_X, HID_ROLE_X, HID_BINDING_RATE, 0, 0 },
    { USAGE_Y, HID_ROLE_Z, HID_BINDING_RATE, 0, 0 },
    { USAGE_Z, HID_ROLE_Y, HID_BINDING_RATE, 1, 0 },
    { USAGE_RX, HID_ROLE_PITCH, HID_BINDING_POSITION, 0, 0 },
    { USAGE_RY, HID_ROLE_ROLL, HID_BINDING_POSITION, 1, 0 },
    { USAGE_RZ, HID_ROLE_YAW, HID_BINDING_POSITION, 1, 0 },
    PRESS(1, HID_ROLE_START),
    PRESS(1, HID_ROLE_OK),
    PRESS(2, HID_ROLE_LEVEL),
    PRESS(2, HID_ROLE_RIGHT),
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

/* Maps a game pad or a joystick. X and Y are the left stick. If Z and RZ both exist, they are the
 * right stick. Otherwise RX and RY are the right stick, because Z then belongs to the triggers. */
static void map_pad(struct hid_mapping *map, const struct surface *surface)
{
    CORE_ASSERT(surface->application == USAGE_JOYSTICK || surface->application == USAGE_GAMEPAD);
    const struct hid_field_location hat = find_on(surface, USAGE_HAT, 0),
                                    turn = find_on(surface, USAGE_RZ, 0);
    map->style = HID_STYLE_FLY;
    if (is_switch_stick(surface)) {
        hid_mapping_auto_bind(map, hat, HID_ROLE_X, HID_BINDING_HAT, 0);
        hid_mapping_auto_bind(map, hat, HID_ROLE_Z, HID_BINDING_HAT, 0);
    } else {
        const int by_z = find_on(surface, USAGE_Z, 0).group && turn.group;
        const struct hid_field_location across = find_on(surface, by_z ? USAGE_Z : USAGE_RX, 0);
        const struct hid_field_location along = by_z ? turn : find_on(surface, USAGE_RY, 0);
        hid_mapping_auto_bind(map, find_on(surface, USAGE_X, 0), HID_ROLE_X, HID_BINDING_RATE, 0);
        hid_mapping_auto_bind(map, find_on(surface, USAGE_Y, 0), HID_ROLE_Z, HID_BINDING_RATE, 0);
        if (across.group && along.group) {
            hid_mapping_auto_bind(map, across, HID_ROLE_ROLL, HID_BINDING_POSITION, 0);
            hid_mapping_auto_bind(map, along, HID_ROLE_PITCH, HID_BINDING_POSITION, 0);
        } else {
            hid_mapping_auto_bind(map, turn, HID_ROLE_YAW, HID_BINDING_POSITION, 1);
        }
        hid_mapping_auto_bind(map, hat, HID_ROLE_HAT, HID_BINDING_HAT, 0);
    }
    hid_mapping_auto_bind(map, find_on(surface, USAGE_ACCELERATOR, 0), HID_ROLE_DIP,
                          HID_BINDING_PRESS, 0);
    if (find_on(surface, USAGE_BUTTON + 12u, 0).group) {
        BIND_ALL(map, surface, many_button_rules);
    } else {
        BIND_ALL(map, surface, few_button_rules);
    }
}

static void map_tip(struct hid_mapping *map, const struct surface *surface)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    if (!hid_mapping_auto_bind(map, find_on(surface, USAGE_TIP, 1), HID_ROLE_DIP, HID_BINDING_PRESS,
                               0) &&
        !hid_mapping_auto_bind(map, find_on(surface, USAGE_BUTTON + 1u, 1), HID_ROLE_DIP,
                               HID_BINDING_PRESS, 0) &&
        hid_mapping_auto_bind(map, find_on(surface, USAGE_TIP_PRESSURE, 1), HID_ROLE_DIP,
                              HID_BINDING_PRESS, 0)) {
        struct hid_binding *pressure = &map->binding[map->count - 1u];
        pressure->full = pressure->rest + (pressure->full - pressure->rest) / 8 + 1;
    }
}

/* Rules of a pen after its position and its tip. */
static const struct rule pen_rules[] = {
    { USAGE_IN_RANGE, HID_ROLE_IN_RANGE, HID_BINDING_PRESS, 0, 1 },
    { USAGE_BARREL, HID_ROLE_FAN, HID_BINDING_PRESS, 0, 1 },
    { USAGE_X_TILT, HID_ROLE_ROLL, HID_BINDING_POSITION, 0, 1 },
    { USAGE_Y_TILT, HID_ROLE_PITCH, HID_BINDING_POSITION, 0, 1 },
};

/* Rules of a mouse after its position and its buttons for the tip. */
static const struct rule mouse_rules[] = {
    { USAGE_WHEEL, HID_ROLE_TILT, HID_BINDING_STEP, 0, 0 },
    PRESS(2, HID_ROLE_LEVEL),
    PRESS(3, HID_ROLE_FAN),
};

static void map_surface(struct hid_mapping *map, const struct surface *surface)
{
    CORE_ASSERT(map->count == 0);
    const int is_mouse = surface->application == USAGE_MOUSE;
    const enum hid_binding_kind manner =
        is_mouse && surface->relative ? HID_BINDING_STEP : HID_BINDING_POSITION;
    switch (surface->application) {
    case USAGE_MULTI_AXIS:
        map->style = HID_STYLE_FLY;
        BIND_ALL(map, surface, puck_rules);
        break;
    case USAGE_JOYSTICK:
    case USAGE_GAMEPAD:
        map_pad(map, surface);
        break;
    default:
        map->style = HID_STYLE_POINTER;
        hid_mapping_auto_bind(map, find_on(surface, USAGE_X, 1), HID_ROLE_X, manner, 0);
        hid_mapping_auto_bind(map, find_on(surface, USAGE_Y, 1), HID_ROLE_Z, manner, 0);
        map_tip(map, surface);
        if (is_mouse) {
            BIND_ALL(map, surface, mouse_rules);
        } else {
            BIND_ALL(map, surface, pen_rules);
        }
        break;
    }
}

/* Finds the control surface with the highest score. Returns the score, or 0 if there is no usable
 * surface. */
static uint32_t best_surface(const struct hid_descriptor *descriptor, struct surface *out)
{
    CORE_ASSERT(descriptor->group_count <= HID_GROUP_MAX);
    uint32_t best_worth = 0;
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        struct surface surface;
        if (is_surface(descriptor, &descriptor->group[i], &surface)) {
            const uint32_t worth = worth_of(&surface);
            *out = worth > best_worth ? surface : *out;
            best_worth = worth > best_worth ? worth : best_worth;
        }
    }
    return best_worth;
}

void hid_mapping_auto_build(struct hid_mapping *out, const struct hid_descriptor *descriptor)
{
    struct surface best = { 0 };
    memset(out, 0, sizeof *out);
    if (best_surface(descriptor, &best) > 0) {
        map_surface(out, &best);
        out->source = HID_MAPPING_AUTO;
    }
}

uint32_t hid_mapping_auto_score(const struct hid_descriptor *descriptor)
{
    struct surface best = { 0 };
    return best_surface(descriptor, &best);
}
