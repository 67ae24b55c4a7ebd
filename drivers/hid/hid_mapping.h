/* hid_mapping.h -- a mapping: which field of a controller's reports has which role in the game.
 *
 * A mapping comes from a table of known controllers (hid_mapping.c), from the HID descriptor
 * (hid_mapping_auto.c) or from learning (hid_learn.h). poi_hid.h decodes reports with a
 * mapping. A mapping is stored as one line of text for each vendor:product:serial
 * (hid_mapping_text.c). A poi is a paper scoop, and also the controller that moves it. This project
 * defines its own poi controller (poi_report.h), which the comments name Kingyo's poi controller.
 * Pure: uses no device and no clock. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_port.h"

/* Largest number of bindings: enough for six axes, a hat, a pen tip, pressure, a sequence number
 * and buttons. */
#define HID_BINDING_MAX 32u

/* Largest absolute value of a signed or unsigned 32-bit field. */
#define HID_VALUE_MAX 4294967295ll

/* Largest number of elements of an array whose keys can be bound. Most keyboards report 6 keys at a
 * time, and one known keyboard reports 14. Each element costs time in every report, and a malicious
 * descriptor can declare 65,536 elements. */
#define HID_ARRAY_MAX 16u

/* Role of a field: the quantity that the field controls. */
enum hid_role {
    HID_ROLE_NONE = 0,
    /* Position along X, positive to the player's right and to the right in the image. */
    HID_ROLE_X,
    HID_ROLE_Y, /* Position along Y, positive upward. */
    HID_ROLE_Z, /* Position along Z, positive toward the player and downward in the image. */
    HID_ROLE_PITCH,
    HID_ROLE_YAW,
    HID_ROLE_ROLL,
    HID_ROLE_TILT, /* Tilt of the ring by a wheel, for controllers without rotation axes. */
    /* Button, trigger, pen tip or pressure that lowers the poi while the player presses. */
    HID_ROLE_DIP,
    HID_ROLE_LEVEL, /* Button that levels the poi. */
    /* Button that holds the fan over the water while it is pressed. The controller then moves the
     * fan, and the poi stands still. */
    HID_ROLE_FAN,
    /* Flag that is 1 while a pen is near its tablet. While the flag is 0, the axes of the pen are
     * invalid. */
    HID_ROLE_IN_RANGE,
    /* Counter of the reports. A gap in the sequence means that reports were lost. */
    HID_ROLE_SEQUENCE,
    /* START button on the controller. LEFT, RIGHT and OK are further cabinet buttons on the
     * controller. */
    HID_ROLE_START,
    HID_ROLE_LEFT,
    HID_ROLE_RIGHT,
    HID_ROLE_OK,
    HID_ROLE_HAT, /* Hat whose directions are buttons: LEFT, RIGHT, and OK for up and down. */
    HID_ROLE_COUNT,
};

/* Meaning of a field's value. */
enum hid_binding_kind {
    /* The value is an absolute position, as from a tablet or a tracked poi controller. */
    HID_BINDING_POSITION = 0,
    HID_BINDING_RATE, /* The value is a velocity, as from a stick or a 3D mouse (puck). */
    /* The value is a displacement since the previous report, as from a mouse or a wheel. */
    HID_BINDING_STEP,
    /* The value is the travel of a key. The key counts as pressed from halfway between `rest` and
     * `full`. */
    HID_BINDING_PRESS,
    /* The value is one of the eight directions of a hat. The value `rest` means up, and the
     * following values continue clockwise. Any other value means that the hat is released. A hat
     * that is bound to X and Z is a four-switch joystick, which has only full deflection. */
    HID_BINDING_HAT,
    HID_BINDING_KIND_COUNT,
};

struct hid_binding {
    /* `role` is the role of the field in the game (enum hid_role). `manner` is the meaning of the
     * field's value (enum hid_binding_kind). */
    uint8_t role, manner;
    uint8_t report_id;
    uint32_t bit_offset; /* Bit offset in the payload, counted from the end of the report id. */
    uint8_t bit_size;    /* Number of bits, 1 to 32. */
    /* True if the value is two's complement. Stored here because vendor-defined fields may not
     * declare the sign. */
    bool is_signed;
    /* Usage of a key in an array. The key is pressed while an element selects this usage. 0 means
     * that the field is no array. */
    hid_usage usage;
    /* Value of a released stick or key. For HID_BINDING_POSITION, the value at the low end of the
     * axis. */
    int64_t rest;
    /* Value of the field at the positive end of the axis. If `full` is below `rest`, the axis is
     * reversed. */
    int64_t full;
    /* Dead zone around the rest position, in units of the field's value. `rest`, `full` and `dead`
     * are within +-HID_VALUE_MAX. */
    int64_t dead;
};

/* Kind of control that a mapping provides. */
enum hid_style {
    HID_STYLE_NONE = 0,
    HID_STYLE_POSE, /* Six absolute axes, as of Kingyo's poi controller. */
    /* Two axes in the image, with buttons to dip and tilt, as of a mouse or a tablet. */
    HID_STYLE_POINTER,
    /* Velocity control by sticks or a puck. A button or the Y axis dips the poi. */
    HID_STYLE_FLY,
};

enum hid_mapping_source {
    HID_MAPPING_NONE = 0, /* The controller has no usable mapping. */
    HID_MAPPING_OWN,      /* The reports have the layout of Kingyo's poi controller. */
    HID_MAPPING_KNOWN,
    HID_MAPPING_AUTO,
    HID_MAPPING_LEARNED,
};

struct hid_mapping {
    /* `source` is the origin of the mapping (enum hid_mapping_source). `style` is the kind of
     * control (enum hid_style). */
    uint8_t source, style;
    bool trembles; /* True if the position sensor is noisy (see struct poi_input). */
    /* True if the device accepts the force feedback report that poi_report.h defines. */
    bool feels;
    uint32_t count; /* Number of bindings, at most HID_BINDING_MAX. */
    struct hid_binding binding[HID_BINDING_MAX];
};

/* Returns true if the descriptor declares keyboard keys. A keyboard is never used as a
 * controller. */
bool hid_mapping_has_keyboard(const struct hid_descriptor *descriptor);

/* Finds the best mapping for a controller. Kingyo's poi controller is preferred, then a known
 * controller, then a mapping from the descriptor. `out->source` is the origin of the mapping.
 * HID_MAPPING_NONE means that no mapping is possible, for example for a keyboard or a device
 * without axes. */
void hid_mapping_choose(struct hid_mapping *out, const struct hid_identity *identity,
                        const struct hid_descriptor *descriptor);

/* Returns the reason why hid_mapping_choose() finds no mapping, as part of a sentence in static
 * memory. */
const char *hid_mapping_absence_reason(const struct hid_descriptor *descriptor);

/* Function that selects the mapping of a controller and writes the mapping to `out` as
 * hid_mapping_choose() does. A learned mapping is preferred to all others. */
struct hid_mapper {
    void (*choose)(void *self, const struct hid_device_info *face,
                   const struct hid_descriptor *descriptor, struct hid_mapping *out);
    void *self;
};

/* Returns a score for the mapping that hid_mapping_choose() finds, by which the interfaces of one
 * USB device are compared. A higher score is better, and 0 means that there is no mapping. */
uint32_t hid_mapping_score(const struct hid_identity *identity,
                           const struct hid_descriptor *descriptor);

/* Returns true if `group` is the array that the binding's usage belongs to. Always returns false
 * for an array of more than HID_ARRAY_MAX elements. */
bool hid_mapping_is_array_of(const struct hid_group *group, const struct hid_binding *binding);

/* Returns true if at least one binding has the role `role` and the kind `manner`. */
bool hid_mapping_has_role(const struct hid_mapping *map, enum hid_role role,
                          enum hid_binding_kind manner);

/* Validates a mapping, which can come from a file. Returns true if the style has its axes, every
 * binding lies inside its declared report, and every number is in range. */
bool hid_mapping_is_sound(const struct hid_mapping *map, const struct hid_descriptor *descriptor);

/* Size of the buffer for hid_mapping_write(), enough for HID_BINDING_MAX bindings of the longest
 * text. */
#define HID_MAPPING_TEXT_SIZE 3072u
/* Writes a mapping as one line of text without a newline. Returns 0, or -1 if the mapping cannot be
 * written. hid_mapping_store.h stores the line with its vendor:product:serial. */
int hid_mapping_write(const struct hid_mapping *map, char text[HID_MAPPING_TEXT_SIZE]);
/* Parses a line of hid_mapping_write(). Returns 0, or -1 with a description of the error in
 * `error`. */
int hid_mapping_read(struct hid_mapping *out, const char *text, char error[HAL_TEXT_SIZE]);

/* ---- Files of mappings ----------------------------------------------------------------------- */

#define HID_MAPPING_STORE_TEXT_SIZE (HID_MAPPING_TEXT_SIZE + 256u)

struct hid_mapping_store_entry {
    uint16_t vendor, product;
    /* Serial number of the device. "" means every device of the product that reports no serial
     * number. */
    char serial[HID_TEXT_SIZE];
    struct hid_mapping map;
};

/* Size of a file name with the longest serial number. Each byte of the serial number can become
 * three characters. */
#define HID_MAPPING_STORE_NAME_SIZE 224u

/* Writes the file name, such as "054c-09cc-SERIAL.poi". All characters of the serial number except
 * letters, digits and '_' are written as %XX. */
void hid_mapping_store_name(const struct hid_mapping_store_entry *entry,
                            char name[HID_MAPPING_STORE_NAME_SIZE]);

/* Writes three lines: the format version, vendor:product:serial, and the mapping. Returns 0, or -1
 * if the mapping cannot be written as text. */
int hid_mapping_store_write(const struct hid_mapping_store_entry *entry,
                            char text[HID_MAPPING_STORE_TEXT_SIZE]);

/* Parses a mapping file. Returns 0. On an error, returns the number (1 to 3) of the first invalid
 * line and describes the error in `error`. */
int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE]);
