/* hid_mapping_auto_build.c -- builds a mapping from the best control surface that a descriptor
 * declares: a puck, a pen, a stick or a mouse. A puck is a 3D mouse with six axes. */
#include <string.h>

#include "drivers/hid/hid_mapping_auto.h"

/* ---- Control surfaces ----------------------------------------------------------------------- */

/* A control surface: a report of one application collection with an X axis or a hat. */
struct surface {
    const struct hid_descriptor *descriptor;
    hid_usage application;
    int report_id;
    int relative;
};

static struct hid_field_location of(const struct surface *surface, hid_usage usage)
{
    return hid_mapping_auto_find(surface->descriptor, surface->application, surface->report_id, 0,
                                 usage);
}

static struct hid_field_location here(const struct surface *surface, hid_usage usage)
{
    return hid_mapping_auto_find(surface->descriptor, surface->application, surface->report_id, 1,
                                 usage);
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
        return of(surface, USAGE_Z).group ? 60u : 0u;
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
        return places ? 20u + (here(surface, USAGE_TIP_PRESSURE).group ? 5u : 0u) : 10u;
    default:
        return 0;
    }
}

/* Returns 1 for a four-switch joystick, which has a hat and no X axis, otherwise 0. */
static int is_switch_stick(const struct surface *surface)
{
    return (surface->application == USAGE_JOYSTICK || surface->application == USAGE_GAMEPAD) &&
           of(surface, USAGE_HAT).group && !of(surface, USAGE_X).group;
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
    const struct hid_field_location y = of(out, USAGE_Y);
    return (has_x && y.group && hid_mapping_auto_is_axis(y.group)) ||
           (has_hat && is_switch_stick(out));
}

/* ---- Mappings of each kind of surface ------------------------------------------------------- */

static struct hid_field_location button(const struct surface *surface, uint32_t number)
{
    return of(surface, USAGE_BUTTON + number);
}

static void press(struct hid_mapping *map, const struct surface *surface, uint32_t number,
                  enum hid_role role)
{
    hid_mapping_auto_bind(map, button(surface, number), role, HID_BINDING_PRESS, 0);
}

/* Maps a puck. The X axis of a puck points right, the Y axis toward the user, and the Z axis
 * downward. RX, RY and RZ are rotations about these axes. Some descriptors declare the axes as
 * relative although the values are deflections. */
static void map_puck(struct hid_mapping *map, const struct surface *surface)
{
    map->style = HID_STYLE_FLY;
    hid_mapping_auto_bind(map, of(surface, USAGE_X), HID_ROLE_X, HID_BINDING_RATE, 0);
    hid_mapping_auto_bind(map, of(surface, USAGE_Y), HID_ROLE_Z, HID_BINDING_RATE, 0);
    hid_mapping_auto_bind(map, of(surface, USAGE_Z), HID_ROLE_Y, HID_BINDING_RATE, 1);
    hid_mapping_auto_bind(map, of(surface, USAGE_RX), HID_ROLE_PITCH, HID_BINDING_POSITION, 0);
    hid_mapping_auto_bind(map, of(surface, USAGE_RY), HID_ROLE_ROLL, HID_BINDING_POSITION, 1);
    hid_mapping_auto_bind(map, of(surface, USAGE_RZ), HID_ROLE_YAW, HID_BINDING_POSITION, 1);
    press(map, surface, 1, HID_ROLE_START);
    press(map, surface, 1, HID_ROLE_OK);
    press(map, surface, 2, HID_ROLE_LEVEL);
    press(map, surface, 2, HID_ROLE_RIGHT);
}

/* Maps the right stick of a game pad; X and Y are the left stick. If Z and RZ both exist, they
 * are the right stick. Otherwise RX and RY are the right stick, because Z then belongs to the
 * triggers. */
static void map_right_stick(struct hid_mapping *map, const struct surface *surface)
{
    const int by_z = of(surface, USAGE_Z).group && of(surface, USAGE_RZ).group;
    const struct hid_field_location across = of(surface, by_z ? USAGE_Z : USAGE_RX);
    const struct hid_field_location along = of(surface, by_z ? USAGE_RZ : USAGE_RY);
    if (across.group && along.group) {
        hid_mapping_auto_bind(map, across, HID_ROLE_ROLL, HID_BINDING_POSITION, 0);
        hid_mapping_auto_bind(map, along, HID_ROLE_PITCH, HID_BINDING_POSITION, 0);
    } else {
        hid_mapping_auto_bind(map, of(surface, USAGE_RZ), HID_ROLE_YAW, HID_BINDING_POSITION, 1);
    }
}

/* Maps the buttons of a game pad, which has one of two numberings. With twelve or more buttons, 1
 * to 4 are face buttons, 5 to 8 are shoulder buttons, and 9 and 10 are in the middle. With fewer
 * buttons, 5 and 6 are shoulder buttons, and 7 and 8 are in the middle. On a joystick, button 1 is
 * the trigger. */
static void map_pad_buttons(struct hid_mapping *map, const struct surface *surface)
{
    const int is_long = button(surface, 12).group != NULL;
    press(map, surface, 1, HID_ROLE_DIP);
    press(map, surface, 1, HID_ROLE_OK);
    press(map, surface, 2, is_long ? HID_ROLE_DIP : HID_ROLE_LEVEL);
    press(map, surface, 3, is_long ? HID_ROLE_LEVEL : HID_ROLE_FAN);
    press(map, surface, 4, HID_ROLE_FAN);
    press(map, surface, 6, HID_ROLE_DIP);
    press(map, surface, is_long ? 10 : 8, HID_ROLE_START);
    if (is_long) {
        press(map, surface, 8, HID_ROLE_DIP);
    }
}

static void map_pad(struct hid_mapping *map, const struct surface *surface)
{
    const struct hid_field_location hat = of(surface, USAGE_HAT);
    map->style = HID_STYLE_FLY;
    if (is_switch_stick(surface)) {
        hid_mapping_auto_bind(map, hat, HID_ROLE_X, HID_BINDING_HAT, 0);
        hid_mapping_auto_bind(map, hat, HID_ROLE_Z, HID_BINDING_HAT, 0);
    } else {
        hid_mapping_auto_bind(map, of(surface, USAGE_X), HID_ROLE_X, HID_BINDING_RATE, 0);
        hid_mapping_auto_bind(map, of(surface, USAGE_Y), HID_ROLE_Z, HID_BINDING_RATE, 0);
        map_right_stick(map, surface);
        hid_mapping_auto_bind(map, hat, HID_ROLE_HAT, HID_BINDING_HAT, 0);
    }
    hid_mapping_auto_bind(map, of(surface, USAGE_ACCELERATOR), HID_ROLE_DIP, HID_BINDING_PRESS, 0);
    map_pad_buttons(map, surface);
}

static void map_tip(struct hid_mapping *map, const struct surface *surface)
{
    if (!hid_mapping_auto_bind(map, here(surface, USAGE_TIP), HID_ROLE_DIP, HID_BINDING_PRESS, 0) &&
        !hid_mapping_auto_bind(map, here(surface, USAGE_BUTTON + 1u), HID_ROLE_DIP,
                               HID_BINDING_PRESS, 0) &&
        hid_mapping_auto_bind(map, here(surface, USAGE_TIP_PRESSURE), HID_ROLE_DIP,
                              HID_BINDING_PRESS, 0)) {
        struct hid_binding *pressure = &map->binding[map->count - 1u];
        pressure->full = pressure->rest + (pressure->full - pressure->rest) / 8 + 1;
    }
}

static void map_pen(struct hid_mapping *map, const struct surface *surface)
{
    map->style = HID_STYLE_POINTER;
    hid_mapping_auto_bind(map, here(surface, USAGE_X), HID_ROLE_X, HID_BINDING_POSITION, 0);
    hid_mapping_auto_bind(map, here(surface, USAGE_Y), HID_ROLE_Z, HID_BINDING_POSITION, 0);
    map_tip(map, surface);
    hid_mapping_auto_bind(map, here(surface, USAGE_IN_RANGE), HID_ROLE_IN_RANGE, HID_BINDING_PRESS,
                          0);
    hid_mapping_auto_bind(map, here(surface, USAGE_BARREL), HID_ROLE_FAN, HID_BINDING_PRESS, 0);
    hid_mapping_auto_bind(map, here(surface, USAGE_X_TILT), HID_ROLE_ROLL, HID_BINDING_POSITION, 0);
    hid_mapping_auto_bind(map, here(surface, USAGE_Y_TILT), HID_ROLE_PITCH, HID_BINDING_POSITION,
                          0);
}

static void map_mouse(struct hid_mapping *map, const struct surface *surface)
{
    const enum hid_binding_kind manner =
        surface->relative ? HID_BINDING_STEP : HID_BINDING_POSITION;
    map->style = HID_STYLE_POINTER;
    hid_mapping_auto_bind(map, here(surface, USAGE_X), HID_ROLE_X, manner, 0);
    hid_mapping_auto_bind(map, here(surface, USAGE_Y), HID_ROLE_Z, manner, 0);
    map_tip(map, surface);
    hid_mapping_auto_bind(map, of(surface, USAGE_WHEEL), HID_ROLE_TILT, HID_BINDING_STEP, 0);
    press(map, surface, 2, HID_ROLE_LEVEL);
    press(map, surface, 3, HID_ROLE_FAN);
}

static void map_surface(struct hid_mapping *map, const struct surface *surface)
{
    switch (surface->application) {
    case USAGE_MULTI_AXIS:
        map_puck(map, surface);
        break;
    case USAGE_JOYSTICK:
    case USAGE_GAMEPAD:
        map_pad(map, surface);
        break;
    case USAGE_MOUSE:
        map_mouse(map, surface);
        break;
    default:
        map_pen(map, surface);
        break;
    }
}

/* Finds the control surface with the highest score. Returns the score, or 0 if there is no usable
 * surface. */
static uint32_t best_surface(const struct hid_descriptor *descriptor, struct surface *out)
{
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
