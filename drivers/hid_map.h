/* hid_map.h -- which field of a controller's reports is which motion of a hand. Pure data.
 *
 * Made by a table of known devices (hid_map_known.c), else from what the descriptor offers
 * (hid_offer.c), else by being shown (hid_learn.h); kept as a line of text for each
 * vendor:product:serial (hid_map_text.c). hid_hand.h plays with it. */
#ifndef KINGYO_DRIVERS_HID_MAP_H
#define KINGYO_DRIVERS_HID_MAP_H

#include <stdint.h>

#include "drivers/hid_descriptor.h"
#include "drivers/hid_port.h"

#define HID_BINDING_MAX 32u /* Six axes, hat, tip, pressure, sequence, and buttons enough. */

#define HID_VALUE_MAX 4294967295ll /* Of a field of 32 bits, whichever sign it has. */

/* Elements of an array that keys may be bound to: a person has ten fingers, and real keyboards
 * name six keys at a time, one of them fourteen. Each costs time in every report, and whoever
 * writes a descriptor can ask for 65,536. */
#define HID_ARRAY_MAX 16u

/* What a field moves. */
enum hid_role {
    HID_ROLE_NONE = 0,
    HID_ROLE_X,        /* + is the player's right, also of a picture. */
    HID_ROLE_Y,        /* + is up. */
    HID_ROLE_Z,        /* + is toward the player: down in a picture. */
    HID_ROLE_PITCH,
    HID_ROLE_YAW,
    HID_ROLE_ROLL,
    HID_ROLE_TILT,     /* Of a hand without a wrist: the slant of the ring, as a wheel gives it. */
    HID_ROLE_DIP,      /* A button, a trigger, a pen's tip or its pressure: down while pressed. */
    HID_ROLE_LEVEL,    /* A button: back to level. */
    HID_ROLE_FAN,      /* A button: hold the fan instead. */
    HID_ROLE_IN_RANGE, /* 0: the pen is away, its axes say nothing. */
    HID_ROLE_SEQUENCE, /* One more with each report; a gap is reports that were lost. */
    HID_ROLE_START,    /* Buttons of the cabinet that sit on the controller. */
    HID_ROLE_LEFT,
    HID_ROLE_RIGHT,
    HID_ROLE_OK,
    HID_ROLE_HAT,      /* Of a hat: its directions are LEFT, RIGHT, and OK for up and down. */
    HID_ROLE_COUNT,
};

/* How a field moves it. */
enum hid_manner {
    HID_MANNER_PLACE = 0, /* The value is the place: tablets, tracked pois. */
    HID_MANNER_RATE,      /* The value is a speed: sticks, pucks. */
    HID_MANNER_STEP,      /* The value is a way since the last report: mice, wheels. */
    HID_MANNER_PRESS,     /* Pressed from half way between `rest` and `full` on. */
    HID_MANNER_HAT,       /* Eight directions from `rest`, clockwise from up; out of range: none. Of
                             X and Z: a stick of four switches, which pushes fully or not at all. */
    HID_MANNER_COUNT,
};

struct hid_binding {
    uint8_t role, manner;   /* enum hid_role, enum hid_manner */
    uint8_t report_id;
    uint32_t bit_offset;    /* Of the payload, behind the report id. */
    uint8_t bit_size;       /* 1 .. 32 */
    uint8_t is_signed;      /* Two's complement; makers hide such numbers in vendors' bytes. */
    hid_usage usage;        /* Of an array: pressed while some element selects it; else 0. */
    int64_t rest;           /* Value of a stick let go, a key not pressed, an axis' low end. */
    int64_t full;           /* Value at the positive end; below `rest` turns the axis round. */
    int64_t dead;           /* Around `rest` a RATE says nothing, in the field's steps. All three
                               within +-HID_VALUE_MAX. */
};

/* How the hand as a whole is led. */
enum hid_style {
    HID_STYLE_NONE = 0,
    HID_STYLE_POSE,    /* Six true axes; our own poi. */
    HID_STYLE_POINTER, /* Two axes of a picture, dip and tilt by buttons: mouse, tablet. */
    HID_STYLE_FLY,     /* Sticks or a puck push it about; dip by button or by the axis of height. */
};

enum hid_map_source {
    HID_MAP_NONE = 0, /* It cannot be a poi as it is. */
    HID_MAP_OWN,      /* It reports as our own poi does. */
    HID_MAP_KNOWN,
    HID_MAP_OFFERED,
    HID_MAP_LEARNED,
};

struct hid_map {
    uint8_t source, style; /* enum hid_map_source, enum hid_style */
    uint8_t trembles;      /* As struct poi_input's. */
    uint8_t feels;         /* It takes our haptic output report. */
    uint32_t count;        /* <= HID_BINDING_MAX */
    struct hid_binding binding[HID_BINDING_MAX];
};

/* Whether it reports as our own poi does: every axis of drivers/poi_report.h in its place. Wider
 * than poi_descriptor_is(): a maker who adds a report of his own is played as ours once he was
 * chosen. */
int hid_map_is_own(const struct hid_descriptor *descriptor);

/* Whether keys that a person types with are in it: it is left alone then, whatever else is. */
int hid_map_has_keyboard(const struct hid_descriptor *descriptor);

/* The best map for a controller: our own poi, a known device, what it offers. `out->source` says
 * which; HID_MAP_NONE when it can be none of them. A keyboard, a boot device's keys and what has
 * no axes give NONE. */
void hid_map_choose(struct hid_map *out, const struct hid_identity *identity,
                    const struct hid_descriptor *descriptor);

/* Why hid_map_choose() finds none for it: part of a sentence; static. */
const char *hid_map_why_none(const struct hid_descriptor *descriptor);

/* How well a hand is led by the map that hid_map_choose() finds, to compare interfaces of a device;
 * 0: it finds none. */
uint32_t hid_map_worth(const struct hid_identity *identity,
                       const struct hid_descriptor *descriptor);

/* Whether a group is the array that such a binding's usage is an element of; one of more than
 * HID_ARRAY_MAX elements is nobody's. */
int hid_map_is_array_of(const struct hid_group *group, const struct hid_binding *binding);

/* Whether it can be played with: style and axes go together, every binding lies in the
 * descriptor's report of its id, no number is out of range. What was read from a file is asked. */
int hid_map_is_sound(const struct hid_map *map, const struct hid_descriptor *descriptor);

/* One line of text without a newline, and back; -1 and one sentence in `error` where it is none.
 * The key is written as vendor:product:serial by hid_book.h. */
#define HID_MAP_TEXT_SIZE 3072u /* HID_BINDING_MAX of the longest. */
int hid_map_write(const struct hid_map *map, char text[HID_MAP_TEXT_SIZE]);
int hid_map_read(struct hid_map *out, const char *text, char error[HAL_TEXT_SIZE]);

#endif
