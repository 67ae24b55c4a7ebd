/* hid_hand.h -- raw reports into a hand, by a map. Pure: no device, no clock, no library.
 *
 * Every real transport, every simulated twin and the fuzzer meet here. Any bytes may come: a report
 * that is too short, of another id, or garbage is refused and counted; what it cannot know it
 * leaves as it was. The core judges what is left (core/game/trust.h). */
#ifndef KINGYO_DRIVERS_HID_HAND_H
#define KINGYO_DRIVERS_HID_HAND_H

#include <stdint.h>

#include "drivers/fly_poi.h"
#include "drivers/hid_map.h"
#include "drivers/pointer_fan.h"
#include "drivers/pointer_poi.h"
#include "drivers/pose_fan.h"
#include "platform/hal.h"

/* After so long out of range a pen lies beside its tablet, and nobody is there. */
#define HID_PEN_AWAY_NS 3000000000ull

struct hid_hand {
    struct hid_descriptor descriptor;
    struct hid_map map;
    struct pointer_poi pointer; /* Of HID_STYLE_POINTER. */
    struct pointer_fan fan;
    struct pointer_report report;
    struct fly_poi fly;         /* Of HID_STYLE_FLY. */
    struct pose_fan pose;       /* Of HID_STYLE_POSE: the newest report's. */
    /* Newest of each binding: [-1, 1]; of a STEP, steps; of a hat, its direction, -1 for none; of
     * what is pressed, 0 or 1. */
    float value[HID_BINDING_MAX];
    uint16_t array[HID_BINDING_MAX]; /* Groups that are arrays and bound. */
    uint32_t array_count;
    uint32_t awake;             /* Bindings of sticks that were seen near their rest, a bit each:
                                   one that never was is not there, or broken. */
    uint64_t time_ns;           /* Of the newest report. */
    uint64_t range_ns;          /* When the pen was last in range. */
    uint32_t held;              /* enum input_button levels ... */
    uint32_t pressed;           /* ... and edges that nobody took yet. */
    uint8_t sequence, has_sequence;
    uint8_t present;            /* It said where it is. */
    uint32_t report_count, refused_count;
    uint32_t gap_count;         /* Reports that the sequence number says were lost. */
};

/* `face` is read, `map` copied, `view` copied. -1: the descriptor cannot be read, or the map is not
 * sound for it. */
int hid_hand_init(struct hid_hand *hand, const struct hid_face *face, const struct hid_map *map,
                  const struct view *view);

/* The tank is looked at so from now on. */
void hid_hand_look(struct hid_hand *hand, const struct view *view);

/* Takes one report. 1: the hand may have moved; 0: refused, or no report that the map knows. */
int hid_hand_report(struct hid_hand *hand, const struct hid_raw *raw);

/* Where the hand is at `time_ns`, which never goes back: of a RATE or a stroke that is farther on
 * than at the last report; a POSE is that of its report, whenever it is asked for. 0: it is not
 * there (no report yet, a pen that was put aside). */
int hid_hand_sample(struct hid_hand *hand, uint64_t time_ns, struct poi_sample *out);

/* Adds its buttons: levels, and the edges since the last call. */
void hid_hand_buttons(struct hid_hand *hand, struct button_sample *out);

/* The fan that a FAN button holds up, if any. */
struct shade_input hid_hand_fan(struct hid_hand *hand, uint64_t time_ns);

#endif
