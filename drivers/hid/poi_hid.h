/* poi_hid.h -- turns any HID controller into a poi (the paper scoop): takes the raw reports of a
 * port and decodes them by a mapping.
 *
 * The pose decoder is pure: it uses no device, clock or library. Every transport, the simulated
 * controllers and the fuzzer use it. The decoder accepts any bytes. A report is rejected and
 * counted if it is too short, has an undeclared id or contains invalid values. The state then stays
 * unchanged. The core validates the resulting pose (core/game/control/input_pose.h).
 *
 * The device implements the poi, fan and button devices of struct hal for one port. The port may be
 * USB or simulated. The frame loop is the only caller. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "drivers/gamepad/stick_motion.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/hid/hid_port.h"
#include "drivers/pointer/pointer_poi.h"
#include "platform/hal.h"

/* ---- Pose decoder ---------------------------------------------------------------------------- */

/* Timeout of a pen that is out of range. After this time the pen counts as absent, because the pen
 * probably lies beside its tablet. */
#define HID_PEN_AWAY_NS 3000000000ull

/* The pose and the fan of Kingyo's poi controller. While the FAN key is pressed, the controller
 * moves the fan over the water, and the poi stands still. */
struct own_pose {
    struct poi_target pose; /* Newest pose of the controller. */
    /* Pose at which the poi stands still while the fan is used. After the fan is released, the poi
     * returns from this pose to the controller's position. */
    struct poi_target waits;
    /* Progress of the poi's return: 0 means that the poi is still at the pose `waits`, 1 means that
     * the poi has reached the controller's position. */
    float back;
    struct fan_swing swing; /* Movement of the fan to the controller's position. */
    uint8_t sequence;       /* Sequence number of the newest report. */
    bool has_sequence;      /* True after the first report was decoded. */
};

struct hid_pose_decoder {
    struct hid_descriptor descriptor;
    struct hid_mapping map;
    struct pointer_poi pointer; /* Pointer decoder, used by HID_STYLE_POINTER. */
    /* Last report to the pointer decoder, used by HID_STYLE_POINTER. */
    struct pointer_report report;
    struct stick_motion fly; /* Stick decoder, used by HID_STYLE_FLY. */
    struct own_pose own;     /* Pose of the newest report, used by HID_STYLE_POSE. */
    /* Newest value of each binding. An axis is -1 to 1, a displacement is in counts, and a key is 0
     * or 1. A hat has its direction 0 to 7, or -1 if it is released. */
    float value[HID_BINDING_MAX];
    /* Indexes in descriptor.group of the array groups that have bindings. */
    uint16_t array[HID_BINDING_MAX];
    uint32_t array_count; /* Number of elements of `array`. */
    /* Stick bindings that were near their rest position at least once, one bit for each binding.
     * The value of a stick that was never near its rest position is ignored, because such a stick
     * may be missing or broken. */
    uint32_t awake;
    uint64_t time_ns;  /* Time of arrival of the newest report. */
    uint64_t range_ns; /* Last time at which the pen was in range. */
    uint32_t held;     /* Buttons that are pressed, as bits of enum input_button. */
    /* Buttons that were pressed since the last call of hid_pose_decoder_buttons(), as bits of enum
     * input_button. */
    uint32_t pressed;
    bool present;           /* True after the first position was decoded. */
    uint32_t refused_count; /* Number of rejected reports. */
    uint32_t gap_count; /* Number of reports that are missing according to the sequence numbers. */
};

/* Initializes the decoder. `map` and `view` are copied, and `face` is not kept. Returns 0, or -1 if
 * the descriptor cannot be parsed or if the mapping is not valid for the descriptor. */
int hid_pose_decoder_init(struct hid_pose_decoder *decoder, const struct hid_device_info *face,
                          const struct hid_mapping *map, const struct view *view);

/* Sets the camera view that pointer motion and stick motion refer to. */
void hid_pose_decoder_set_view(struct hid_pose_decoder *decoder, const struct view *view);

/* Decodes one report. Returns true if the pose may have changed. Returns false if the report was
 * rejected or if the mapping uses no field of the report. */
bool hid_pose_decoder_report(struct hid_pose_decoder *decoder, const struct hid_raw *raw);

/* Writes the pose at `time_ns`, which must not decrease from call to call. Sticks and dips are
 * extrapolated to `time_ns`. With HID_STYLE_POSE, the pose is that of the newest report. Returns
 * true. Returns false if the controller is absent, because no report has arrived yet or the pen was
 * out of range for HID_PEN_AWAY_NS. */
bool hid_pose_decoder_sample(struct hid_pose_decoder *decoder, uint64_t time_ns,
                             struct poi_sample *out);

/* Adds to `out` the buttons that are pressed now, and the buttons that were pressed since the last
 * call. */
void hid_pose_decoder_buttons(struct hid_pose_decoder *decoder, struct button_sample *out);

/* Returns the fan at `time_ns`. The fan is held over the water while a FAN button is pressed. */
struct shade_input hid_pose_decoder_fan(struct hid_pose_decoder *decoder, uint64_t time_ns);

/* Finds the array fields that the mapping binds. Only hid_pose_decoder_init() calls this function,
 * after decoder->map was set. Defined in hid_axis_decoder.c. */
void hid_axis_decoder_find_arrays(struct hid_pose_decoder *decoder);

/* Decodes a complete report into decoder->value. Returns true, or false if the mapping uses no
 * field of the report. The value of a HID_BINDING_STEP binding is valid for one report. A report
 * with a different id sets the value to 0. Only hid_pose_decoder_report() calls this function.
 * Defined in hid_axis_decoder.c. */
bool hid_axis_decoder_read(struct hid_pose_decoder *decoder, struct hid_report report);

/* ---- Device ---------------------------------------------------------------------------------- */

/* Callback that receives a copy of each report. The controller manager uses the callback during
 * learning. */
struct hid_watch {
    void (*report)(void *self, const struct hid_raw *raw);
    void *self;
};

struct poi_hid {
    struct hid_port *port;
    struct hal_clock clock;
    struct hid_mapper mapper;
    /* Callback that receives a copy of each report from now on. If `watch.report` is null, no
     * callback is called. The owner may change this field between two polls. */
    struct hid_watch watch;
    struct view view;
    struct hid_device_info face; /* Identity and descriptor of the attached controller. */
    struct hid_pose_decoder decoder;
    bool is_open;          /* True while a controller is attached. */
    bool plays;            /* True if the current mapping can control the poi. */
    uint8_t feel_sequence; /* Sequence number of the next force feedback report. */
    char text[HAL_TEXT_SIZE];
};

/* Initializes `poi`. If `mapper.choose` is null, hid_mapping_choose() selects the mapping. */
void poi_hid_init(struct poi_hid *poi, struct hid_port *port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view);

/* Changes the mapping to `map`. If `map` is null, the mapper selects the mapping. Returns true if
 * the controller can play with the mapping. */
bool poi_hid_remap(struct poi_hid *poi, const struct hid_mapping *map);

/* Returns the devices of the port. The buttons are START, LEFT, RIGHT and OK of the controller. The
 * poi must be polled before the fan and the buttons. */
struct hal_controller_devices poi_hid_devices(struct poi_hid *poi_hid);
