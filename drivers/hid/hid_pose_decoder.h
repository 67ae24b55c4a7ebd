/* hid_pose_decoder.h -- the pose decoder: turns raw HID reports into a pose of the poi (the paper
 * scoop) by a mapping.
 *
 * Every transport, the simulated controllers and the fuzzer use this decoder. Any bytes are
 * accepted as input. A report is rejected and counted if it is too short, has an undeclared id or
 * contains invalid values. The state then stays unchanged. The core validates the resulting pose
 * (core/game/control/input_validation.h). Pure: uses no device, clock or library. */
#ifndef KINGYO_DRIVERS_HID_HID_POSE_DECODER_H
#define KINGYO_DRIVERS_HID_HID_POSE_DECODER_H

#include <stdint.h>

#include "drivers/gamepad/stick_motion.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/pointer/pointer_poi.h"
#include "platform/hal.h"

/* Time after which a pen that is out of range counts as absent, because the pen probably lies
 * beside its tablet. */
#define HID_PEN_AWAY_NS 3000000000ull

/* The fan of Kingyo's poi controller. While the FAN key is pressed, the controller moves the fan
 * over the water, and the poi stands still. */
struct poi_fan {
    struct poi_target hand;  /* Newest pose of the controller. */
    struct poi_target waits; /* Pose at which the poi stands still while the fan is used, or from
                                which the poi returns to the controller. */
    uint8_t held;            /* 1 while the FAN key is pressed, otherwise 0. */
    float swing;             /* Progress of the fan's entry: 0 means that the fan is out of sight, 1
                                means that it is at the controller's position. */
    float back;              /* Progress of the poi's return: 0 means that the poi is at `waits`, 1
                                means that it is at the controller's position. */
    uint64_t time_ns;        /* Time for which `swing` and `back` were computed last. */
};

struct hid_pose_decoder {
    struct hid_descriptor descriptor;
    struct hid_mapping map;
    struct pointer_poi pointer; /* Pointer decoder, used by HID_STYLE_POINTER. */
    struct pointer_fan fan;
    struct pointer_report report; /* Last report to the pointer decoder, used by
                                     HID_STYLE_POINTER. */
    struct stick_motion fly;      /* Stick decoder, used by HID_STYLE_FLY. */
    struct poi_fan pose;          /* Pose of the newest report, used by HID_STYLE_POSE. */
    /* Newest value of each binding. An axis is -1 to 1, a displacement is in counts, and a key is 0
     * or 1. A hat has its direction 0 to 7, or -1 if it is released. */
    float value[HID_BINDING_MAX];
    uint16_t array[HID_BINDING_MAX]; /* Indexes in descriptor.group of the array groups that have
                                        bindings. */
    uint32_t array_count;
    /* Stick bindings that were near their rest position at least once, one bit for each binding.
     * The values of all other stick bindings are ignored, because the stick may be missing or
     * broken. */
    uint32_t awake;
    uint64_t time_ns;  /* Time of arrival of the newest report. */
    uint64_t range_ns; /* Last time at which the pen was in range. */
    uint32_t held;     /* Buttons that are pressed, as bits of enum input_button. */
    uint32_t pressed;  /* Buttons that were pressed since the last call of
                          hid_pose_decoder_buttons(), as bits of enum input_button. */
    uint8_t sequence, has_sequence;
    uint8_t present;                      /* 1 after the first position was decoded, otherwise 0. */
    uint32_t report_count, refused_count; /* Number of all reports, and of rejected reports. */
    uint32_t gap_count; /* Number of reports that are missing according to the sequence numbers. */
};

/* Initializes the decoder. `map` and `view` are copied, and `face` is not kept. Returns 0, or -1 if
 * the descriptor cannot be parsed or if the mapping is not valid for the descriptor. */
int hid_pose_decoder_init(struct hid_pose_decoder *hand, const struct hid_device_info *face,
                          const struct hid_mapping *map, const struct view *view);

/* Sets the camera view that pointer motion and stick motion refer to. */
void hid_pose_decoder_set_view(struct hid_pose_decoder *hand, const struct view *view);

/* Decodes one report. Returns 1 if the pose may have changed. Returns 0 if the report was rejected
 * or if the mapping uses no field of the report. */
int hid_pose_decoder_report(struct hid_pose_decoder *hand, const struct hid_raw *raw);

/* Writes the pose at `time_ns`, which must not decrease from call to call. Sticks and dips are
 * extrapolated to `time_ns`. With HID_STYLE_POSE, the pose is that of the newest report. Returns 1.
 * Returns 0 if the controller is absent, because no report has arrived yet or the pen was out of
 * range for HID_PEN_AWAY_NS. */
int hid_pose_decoder_sample(struct hid_pose_decoder *hand, uint64_t time_ns,
                            struct poi_sample *out);

/* Adds to `out` the buttons that are pressed now, and the buttons that were pressed since the last
 * call. */
void hid_pose_decoder_buttons(struct hid_pose_decoder *hand, struct button_sample *out);

/* Returns the fan at `time_ns`. The fan is held over the water while a FAN button is pressed. */
struct shade_input hid_pose_decoder_fan(struct hid_pose_decoder *hand, uint64_t time_ns);

/* ---- Values of bindings (hid_axis_decoder.c), for hid_pose_decoder.c only -------------------- */

/* Finds the array fields that the mapping binds. Must be called once, after hand->map was set. */
void hid_axis_decoder_find_arrays(struct hid_pose_decoder *hand);

/* Decodes a complete report with the id `report_id` into hand->value. Returns 1, or 0 if the
 * mapping uses no field of the report. The value of a HID_BINDING_STEP binding is valid for one
 * report. A report with a different id sets the value to 0. */
int hid_axis_decoder_read(struct hid_pose_decoder *hand, uint8_t report_id,
                          struct hid_report report);

#endif
