/* hid_mapping_auto.h -- finds fields of a HID descriptor by their usage, and makes bindings and
 * mappings from them. Pure: uses no device and no clock. */
#pragma once

#include "drivers/hid/hid_mapping.h"

/* Usages of the HID Usage Tables 1.5: the usage page in the upper 16 bits, the usage id in the
 * lower. */
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
    /* Usage id that is added to the number of a button (1 or more) to get the button's usage. */
    USAGE_BUTTON = 0x00090000,
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

/* Place of a field in a descriptor. */
struct hid_field_location {
    const struct hid_group *group; /* Group of the field, or null if no field was found. */
    uint32_t index;                /* Index of the field in the group, less than group->count. */
    hid_usage usage;
};

/* Returns the highest possible value of the fields of `group`, which have at most 32 bits. Some
 * descriptors declare a maximum that does not fit into the field, and some declare no maximum for
 * buttons. */
int64_t hid_mapping_auto_high(const struct hid_group *group);

/* Returns the first field with the usage `usage`. Only reports of the application collection
 * `application` are searched. An `application` of 0 means any application. The report `report_id`
 * is searched first. A `report_id` of -1 means any report. All other reports follow unless
 * `report_only` is true. Constant fields are skipped. The first element of an array stands for the
 * whole array. */
struct hid_field_location hid_mapping_auto_find(const struct hid_descriptor *descriptor,
                                                hid_usage application, int report_id,
                                                bool report_only, hid_usage usage);

/* Adds a binding that is given by its bits instead of a usage. Returns true, or false if the
 * mapping is full. */
bool hid_mapping_auto_bits(struct hid_mapping *map, struct hid_binding binding);

/* Fills `out` with the best mapping that the descriptor allows. The source is HID_MAPPING_NONE if
 * there is no such mapping. */
void hid_mapping_auto_build(struct hid_mapping *out, const struct hid_descriptor *descriptor);

/* Returns how well the mapping of hid_mapping_auto_build() controls the poi, 0 to 60. 0 means that
 * there is no mapping. */
uint32_t hid_mapping_auto_score(const struct hid_descriptor *descriptor);
