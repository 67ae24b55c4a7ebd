/* hid_mapping.h -- a mapping from the fields of a controller's reports to roles in the game. Pure
 * data.
 *
 * The sources are a table of known devices (hid_mapping_known.c), the descriptor
 * (hid_mapping_auto.c) and learning (hid_learn.h). A mapping is stored as one line of text for each
 * vendor:product:serial (hid_mapping_text.c), and hid_pose_decoder.h decodes reports with it. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_H

#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_port.h"

#define HID_BINDING_MAX 32u /* Enough for six axes, hat, tip, pressure, sequence and buttons. */

#define HID_VALUE_MAX 4294967295ll /* Largest magnitude of a signed or unsigned 32-bit field. */

/* Largest array that keys may be bound to. Real keyboards report 6 keys at a time, one reports
 * 14. Each element costs time in every report, and a hostile descriptor can declare 65,536. */
#define HID_ARRAY_MAX 16u

/* The quantity that a field controls. */
enum hid_role {
    HID_ROLE_NONE = 0,
    HID_ROLE_X, /* Positive to the player's right and right in the image. */
    HID_ROLE_Y, /* Positive upward. */
    HID_ROLE_Z, /* Positive toward the player and down in the image. */
    HID_ROLE_PITCH,
    HID_ROLE_YAW,
    HID_ROLE_ROLL,
    HID_ROLE_TILT,     /* Slant of the ring from a wheel, for controllers without rotation. */
    HID_ROLE_DIP,      /* Lowers the poi while pressed: button, trigger, pen tip or pressure. */
    HID_ROLE_LEVEL,    /* Button that levels the poi. */
    HID_ROLE_FAN,      /* Button that holds the fan instead of the poi. */
    HID_ROLE_IN_RANGE, /* 0 while a pen is away and its axes are invalid. */
    HID_ROLE_SEQUENCE, /* Report counter; a gap means lost reports. */
    HID_ROLE_START,    /* Cabinet buttons on the controller. */
    HID_ROLE_LEFT,
    HID_ROLE_RIGHT,
    HID_ROLE_OK,
    HID_ROLE_HAT, /* Hat directions as buttons: LEFT, RIGHT, and OK for up and down. */
    HID_ROLE_COUNT,
};

/* How the value of a field is interpreted. */
enum hid_binding_kind {
    HID_BINDING_POSITION = 0, /* Value is a position: tablets, tracked pois. */
    HID_BINDING_RATE,         /* Value is a velocity: sticks, pucks. */
    HID_BINDING_STEP,         /* Value is a displacement since the last report: mice, wheels. */
    HID_BINDING_PRESS,        /* Pressed from halfway between `rest` and `full`. */
    /* Eight directions from `rest`, clockwise from up; values out of range mean released. Bound
     * to X and Z, a hat is a four-switch joystick with full deflection only. */
    HID_BINDING_HAT,
    HID_BINDING_KIND_COUNT,
};

struct hid_binding {
    uint8_t role, manner; /* enum hid_role, enum hid_binding_kind */
    uint8_t report_id;
    uint32_t bit_offset; /* Offset in the payload, behind the report id. */
    uint8_t bit_size;    /* 1 .. 32 */
    uint8_t is_signed;   /* 1 for two's complement; vendor fields may not declare the sign. */
    hid_usage usage;     /* Pressed while an element of the array selects it; 0 if not an array. */
    int64_t rest;        /* Value of a released stick or key, or of the low end of a PLACE. */
    int64_t full;        /* Value at the positive end; below `rest` the axis is reversed. */
    /* Dead zone around the rest position, in counts. `rest`, `full` and `dead` are within
     * +-HID_VALUE_MAX. */
    int64_t dead;
};

/* The kind of control that the bindings make together. */
enum hid_style {
    HID_STYLE_NONE = 0,
    HID_STYLE_POSE,    /* Six absolute axes: our own poi. */
    HID_STYLE_POINTER, /* Two axes in the image, with buttons to dip and tilt: mouse, tablet. */
    HID_STYLE_FLY,     /* Velocity control by sticks or a puck; dip by button or by the Y axis. */
};

enum hid_mapping_source {
    HID_MAPPING_NONE = 0, /* The controller has no usable mapping. */
    HID_MAPPING_OWN,      /* The reports have the layout of our own poi. */
    HID_MAPPING_KNOWN,
    HID_MAPPING_AUTO,
    HID_MAPPING_LEARNED,
};

struct hid_mapping {
    uint8_t source, style; /* enum hid_mapping_source, enum hid_style */
    uint8_t trembles;      /* 1 if the sensor has noise; see struct poi_input. */
    uint8_t feels;         /* 1 if the device accepts our haptic output report. */
    uint32_t count;        /* <= HID_BINDING_MAX */
    struct hid_binding binding[HID_BINDING_MAX];
};

/* Returns 1 if the reports have the layout of our own poi: every axis of drivers/hid/poi_report.h
 * at its position. Unlike poi_descriptor_is(), this function also accepts a device with additional
 * reports, which can play after the operator chose it. */
int hid_mapping_is_own(const struct hid_descriptor *descriptor);

/* Returns 1 if the descriptor declares the keys of a keyboard. Such a device is never used. */
int hid_mapping_has_keyboard(const struct hid_descriptor *descriptor);

/* Finds the best mapping for a controller: our own poi, a known device, or what the descriptor
 * offers. `out->source` names the source. Source HID_MAPPING_NONE means that no mapping is
 * possible, for example for a keyboard or a device without axes. */
void hid_mapping_choose(struct hid_mapping *out, const struct hid_identity *identity,
                        const struct hid_descriptor *descriptor);

/* Returns why hid_mapping_choose() finds no mapping, as part of a sentence in static memory. */
const char *hid_mapping_absence_reason(const struct hid_descriptor *descriptor);

/* Returns a rating of the mapping that hid_mapping_choose() finds, to compare the interfaces of a
 * device; 0 if there is no mapping. */
uint32_t hid_mapping_score(const struct hid_identity *identity,
                           const struct hid_descriptor *descriptor);

/* Returns 1 if `group` is the array that the binding's usage belongs to. An array of more than
 * HID_ARRAY_MAX elements never is. */
int hid_mapping_is_array_of(const struct hid_group *group, const struct hid_binding *binding);

/* Validates a mapping, which can come from a file. Returns 1 if the style has its axes, every
 * binding lies inside its declared report, and every number is in range. */
int hid_mapping_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor);

/* Write a mapping as one line of text without a newline, and parse such a line. Both return 0 or
 * -1; hid_mapping_read() then describes the fault in `error`. hid_mapping_store.h stores the line
 * with its vendor:product:serial. */
#define HID_MAPPING_TEXT_SIZE 3072u /* Fits HID_BINDING_MAX bindings of the longest text. */
int hid_mapping_write(const struct hid_mapping *map, char text[HID_MAPPING_TEXT_SIZE]);
int hid_mapping_read(struct hid_mapping *out, const char *text, char error[HAL_TEXT_SIZE]);

#endif
