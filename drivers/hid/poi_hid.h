/* poi_hid.h -- turns any HID controller into a poi (the paper scoop): decodes the raw reports of a
 * port by a mapping.
 *
 * Implements the poi, fan and button devices of struct hal for one slot, the place of one of up to
 * four controllers. The port may be USB or simulated. The frame loop is the only caller. */
#ifndef KINGYO_DRIVERS_HID_POI_HID_H
#define KINGYO_DRIVERS_HID_POI_HID_H

#include "drivers/hid/hid_port.h"
#include "drivers/hid/hid_pose_decoder.h"
#include "platform/hal.h"

/* Callback that receives a copy of each report. The controller manager uses it during learning. */
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
    struct hid_device_info face; /* Identity and descriptor of the attached controller. */
    struct hid_pose_decoder hand;
    uint8_t is_open;       /* 1 while a controller is attached, otherwise 0. */
    uint8_t plays;         /* 1 if the current mapping can control the poi, so that the controller
                              can play. Otherwise 0. */
    uint8_t feel_sequence; /* Sequence number of the next force feedback report. */
    char text[HAL_TEXT_SIZE];
};

/* Initializes `poi`. If `mapper.choose` is null, hid_mapping_choose() selects the mapping. */
void poi_hid_init(struct poi_hid *poi, struct hid_port port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view);

/* Passes each further report to the callback `watch`. If `watch.report` is null, no callback is
 * called. */
void poi_hid_set_observer(struct poi_hid *poi, struct hid_watch watch);

/* Changes the mapping to `map`. If `map` is null, the mapper selects the mapping. Returns 1 if the
 * controller can play with the mapping, otherwise 0. */
int poi_hid_remap(struct poi_hid *poi, const struct hid_mapping *map);

/* Returns the poi device of the slot. */
struct hal_poi poi_hid_device(struct poi_hid *poi);
/* Returns the fan device of the slot. */
struct hal_fan poi_hid_fan(struct poi_hid *poi);

/* Returns the device with START, LEFT, RIGHT and OK of the controller. The poi device must be
 * polled before this device. */
struct hal_buttons poi_hid_buttons(struct poi_hid *poi);

#endif
