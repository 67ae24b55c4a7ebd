/* poi_hid.h -- any HID controller as a poi: decodes the raw reports of a port by a mapping.
 *
 * Implements the poi, fan and button devices of struct hal for one slot. The port may be USB or
 * simulated. The frame loop is the only caller. */
#ifndef KINGYO_DRIVERS_HID_POI_HID_H
#define KINGYO_DRIVERS_HID_POI_HID_H

#include "drivers/hid/hid_port.h"
#include "drivers/hid/hid_pose_decoder.h"
#include "platform/hal.h"

/* Selects the mapping of a controller, learned mappings first. Writes `out` like
 * hid_mapping_choose(). */
struct hid_mapper {
    void (*choose)(void *self, const struct hid_device_info *face,
                   const struct hid_descriptor *descriptor, struct hid_mapping *out);
    void *self;
};

/* Callback that receives a copy of each report; used by the controller manager while it learns. */
struct hid_watch {
    void (*report)(void *self, const struct hid_raw *raw);
    void *self;
};

struct poi_hid {
    struct hid_port port;
    struct hal_clock clock;
    struct hid_mapper mapper;
    struct hid_watch watch;
    struct view view;
    struct hid_device_info face;
    struct hid_pose_decoder hand;
    uint8_t is_open;
    uint8_t plays; /* 1 if the current mapping can control the poi. */
    uint8_t feel_sequence;
    char text[HAL_TEXT_SIZE];
};

/* Initializes `poi`. If `mapper.choose` is null, hid_mapping_choose() is used. */
void poi_hid_init(struct poi_hid *poi, struct hid_port port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view);

/* Passes each further report to `watch`; `watch.report` null ends that. */
void poi_hid_set_observer(struct poi_hid *poi, struct hid_watch watch);

/* Changes the mapping to `map`, or, if `map` is null, to the mapper's choice. Returns 1 if the
 * controller can play with it. */
int poi_hid_remap(struct poi_hid *poi, const struct hid_mapping *map);

struct hal_poi poi_hid_device(struct poi_hid *poi);
struct hal_fan poi_hid_fan(struct poi_hid *poi);

/* Returns START, LEFT, RIGHT and OK of the controller. Must be polled after the poi. */
struct hal_buttons poi_hid_buttons(struct poi_hid *poi);

#endif
