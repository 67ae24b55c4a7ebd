/* hid_mapping_auto.h -- finds fields by usage and makes bindings from them. Pure. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_AUTO_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_AUTO_H

#include "drivers/hid/hid_mapping.h"

/* Values are usage page << 16 | usage id, from the HID Usage Tables 1.5. */
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
    USAGE_BUTTON = 0x00090000, /* Plus the button's number from 1. */
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

/* A field of a report. */
struct hid_field_location {
    const struct hid_group *group; /* Null if no field was found. */
    uint32_t index;                /* < group->count */
    hid_usage usage;
};

/* Returns 1 if a field has more values than a hat and so can be an axis. An "X" of one bit is a
 * button, for example. */
int hid_mapping_auto_is_axis(const struct hid_group *group);

/* Returns the index of a usage in a group, or -1 if the group lacks it. In an array, index 0
 * stands for all elements. */
int32_t hid_mapping_auto_place(const struct hid_descriptor *descriptor,
                               const struct hid_group *group, hid_usage usage);

/* Returns the first field with this usage in reports of `application` (0: any). The report
 * `report_id` (-1: any) is searched first, then, if `report_only` is 0, all others. Constant
 * fields are skipped. In an array, the first element stands for all. */
struct hid_field_location hid_mapping_auto_find(const struct hid_descriptor *descriptor,
                                                hid_usage application, int report_id,
                                                int report_only, hid_usage usage);

/* Adds a binding of the field. Returns 1, or 0 if `spot` is empty or unsuitable or if the
 * mapping is full. An axis ranges from its logical minimum to its maximum, or for a RATE from
 * its middle. `turned` reverses the direction. */
int hid_mapping_auto_bind(struct hid_mapping *map, struct hid_field_location spot,
                          enum hid_role role, enum hid_binding_kind manner, int turned);

/* Adds a binding that refers to bits instead of a usage. Returns 1, or 0 if the mapping is full. */
int hid_mapping_auto_bits(struct hid_mapping *map, struct hid_binding binding);

/* Fills `out` with the best mapping that the descriptor allows. The source is HID_MAPPING_NONE if
 * there is none. */
void hid_mapping_auto_build(struct hid_mapping *out, const struct hid_descriptor *descriptor);

/* Returns how well the mapping of hid_mapping_auto_build() controls the poi: 0 .. 60, where 0 means
 * no mapping. */
uint32_t hid_mapping_auto_score(const struct hid_descriptor *descriptor);

/* Fills `out` from the table of known controllers. Returns 1, or 0 if the controller is not
 * known; `out` is then unchanged. */
int hid_mapping_known(struct hid_mapping *out, const struct hid_identity *identity,
                      const struct hid_descriptor *descriptor);

#endif
