/* hid_pose_decoder.h -- the pose decoder: turns raw HID reports into a pose by a mapping.
 *
 * Pure: no device, no clock and no library. Every transport, every simulated twin and the fuzzer
 * use this decoder. Any bytes are accepted as input. A report that is too short, has an
 * undeclared id or is garbage is refused and counted, and the state stays unchanged. The core
 * validates the resulting pose (core/game/control/input_validation.h). */
#ifndef KINGYO_DRIVERS_HID_HID_POSE_DECODER_H
#define KINGYO_DRIVERS_HID_HID_POSE_DECODER_H

#include <stdint.h>

#include "drivers/gamepad/stick_motion.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/hid/poi_fan.h"
#include "drivers/pointer/pointer_fan.h"
#include "drivers/pointer/pointer_poi.h"
#include "platform/hal.h"

/* A pen out of range for longer than this time lies beside its tablet and counts as absent. */
#define HID_PEN_AWAY_NS 3000000000ull

struct hid_pose_decoder {
    struct hid_descriptor descriptor;
    struct hid_mapping map;
    struct pointer_poi pointer; /* State of the pointer, used by HID_STYLE_POINTER. */
    struct pointer_fan fan;
    struct pointer_report report;
    struct stick_motion fly; /* State of the stick motion, used by HID_STYLE_FLY. */
    struct poi_fan pose;     /* Pose of the newest report, used by HID_STYLE_POSE. */
    /* Newest value of each binding. An axis has [-1, 1], a STEP has counts, a press has 0 or 1.
     * A hat has its direction 0 .. 7, or -1 for none. */
    float value[HID_BINDING_MAX];
    uint16_t array[HID_BINDING_MAX]; /* Indexes of the array groups that have bindings. */
    uint32_t array_count;
    /* Bit set of the stick bindings that were near their rest at least once. The value of any
     * other stick is ignored, because such a stick is missing or broken. */
    uint32_t awake;
    uint64_t time_ns;  /* Arrival of the newest report. */
    uint64_t range_ns; /* Last time the pen was in range. */
    uint32_t held;     /* Buttons that are down, enum input_button. */
    uint32_t pressed;  /* Press edges that were not read yet. */
    uint8_t sequence, has_sequence;
    uint8_t present; /* 1 after the first position was decoded. */
    uint32_t report_count, refused_count;
    uint32_t gap_count; /* Reports lost according to the sequence number. */
};

/* Initializes the decoder. `face` is only read; `map` and `view` are copied. Returns 0, or -1 if
 * the descriptor cannot be parsed or if the mapping is not valid for it. */
int hid_pose_decoder_init(struct hid_pose_decoder *hand, const struct hid_device_info *face,
                          const struct hid_mapping *map, const struct view *view);

/* Sets the camera view that pointer motion and stick motion refer to. */
void hid_pose_decoder_set_view(struct hid_pose_decoder *hand, const struct view *view);

/* Decodes one report. Returns 1 if the pose may have changed. Returns 0 if the report was
 * refused or if the mapping uses no field of it. */
int hid_pose_decoder_report(struct hid_pose_decoder *hand, const struct hid_raw *raw);

/* Writes the pose at `time_ns`, which must never decrease. For sticks and dips the pose is
 * extrapolated to `time_ns`; for HID_STYLE_POSE it is the pose of the newest report. Returns 1,
 * or 0 if the controller is absent (no report yet, or a pen put aside). */
int hid_pose_decoder_sample(struct hid_pose_decoder *hand, uint64_t time_ns,
                            struct poi_sample *out);

/* Adds the buttons that are down and the press edges since the last call. */
void hid_pose_decoder_buttons(struct hid_pose_decoder *hand, struct button_sample *out);

/* Returns the fan that a FAN button holds up, or an inactive fan. */
struct shade_input hid_pose_decoder_fan(struct hid_pose_decoder *hand, uint64_t time_ns);

#endif
