/* hid_offer.h -- what a descriptor has to offer a hand; the pieces of which maps are made. Pure. */
#ifndef KINGYO_DRIVERS_HID_OFFER_H
#define KINGYO_DRIVERS_HID_OFFER_H

#include "drivers/hid_map.h"

/* Usage page << 16 | usage, of the HID Usage Tables 1.5. */
enum {
    USAGE_MOUSE = 0x00010002,
    USAGE_JOYSTICK = 0x00010004,
    USAGE_GAMEPAD = 0x00010005,
    USAGE_KEYBOARD = 0x00010006,
    USAGE_MULTI_AXIS = 0x00010008,
    USAGE_X = 0x00010030,
    USAGE_Y = 0x00010031,
    USAGE_Z = 0x00010032,
    USAGE_RX = 0x00010033,
    USAGE_RY = 0x00010034,
    USAGE_RZ = 0x00010035,
    USAGE_WHEEL = 0x00010038,
    USAGE_HAT = 0x00010039,
    USAGE_ACCELERATOR = 0x000200c4,
    USAGE_BRAKE = 0x000200c5,
    USAGE_BUTTON = 0x00090000, /* + its number from 1. */
    USAGE_DIGITIZER = 0x000d0001,
    USAGE_PEN = 0x000d0002,
    USAGE_TOUCH_SCREEN = 0x000d0004,
    USAGE_TOUCH_PAD = 0x000d0005,
    USAGE_TIP_PRESSURE = 0x000d0030,
    USAGE_IN_RANGE = 0x000d0032,
    USAGE_X_TILT = 0x000d003d,
    USAGE_Y_TILT = 0x000d003e,
    USAGE_TIP = 0x000d0042,
    USAGE_BARREL = 0x000d0044,
    USAGE_SECOND_BARREL = 0x000d005a,
};

/* One field of a report. */
struct hid_spot {
    const struct hid_group *group; /* Null: there is none. */
    uint32_t index;                /* < group->count */
    hid_usage usage;
};

/* Whether it says more than a hat does: "X" of one bit is a button with a name. */
int hid_offer_is_axis(const struct hid_group *group);

/* Where in a group such a usage stands; -1: nowhere. In an array the first element stands for all.
 */
int32_t hid_offer_place(const struct hid_descriptor *descriptor, const struct hid_group *group,
                        hid_usage usage);

/* The first field of such a usage in reports of the application `application` (0: any), in report
 * `report_id` if it is there, else (`report_only` 0) in another. Padding and constants do not
 * count; of an array the group's first element stands for all. */
struct hid_spot hid_offer_find(const struct hid_descriptor *descriptor, hid_usage application,
                               int report_id, int report_only, hid_usage usage);

/* Binds a field; 0 when there is none, or no room. An axis goes from its logical minimum to its
 * maximum, or from its middle if it is a RATE; `turned` swaps the ends. */
int hid_offer_bind(struct hid_map *map, struct hid_spot spot, enum hid_role role,
                   enum hid_manner manner, int turned);

/* The same for bits that no usage names. */
int hid_offer_bits(struct hid_map *map, struct hid_binding binding);

/* Fills `out` with the best that a descriptor offers; source HID_MAP_NONE: nothing. */
void hid_offer_map(struct hid_map *out, const struct hid_descriptor *descriptor);

/* How well a hand would be led by that, 0 .. 60; 0: by nothing. */
uint32_t hid_offer_worth(const struct hid_descriptor *descriptor);

/* Adds what a table of known devices says; 0: it knows none, `out` as it was. */
int hid_known_map(struct hid_map *out, const struct hid_identity *identity,
                  const struct hid_descriptor *descriptor);

#endif
