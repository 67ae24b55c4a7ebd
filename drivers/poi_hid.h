/* poi_hid.h -- any HID controller as a poi: a port's raw reports through a map into a hand.
 *
 * The device of struct hal for one seat. It neither knows nor asks whether the port is USB or
 * memory. */
#ifndef KINGYO_DRIVERS_POI_HID_H
#define KINGYO_DRIVERS_POI_HID_H

#include "drivers/hid_hand.h"
#include "drivers/hid_port.h"
#include "platform/hal.h"

/* Where a controller's map comes from: learned ones first. Writes `out`; see hid_map_choose(). */
struct hid_mapper {
    void (*choose)(void *self, const struct hid_face *face,
                   const struct hid_descriptor *descriptor, struct hid_map *out);
    void *self;
};

/* Who else wants to see what a seat's controller says: the operator's desk, while it learns. */
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
    struct hid_face face;
    struct hid_hand hand;
    uint8_t is_open;
    uint8_t plays;         /* There is a map that the hand can be led by. */
    uint8_t feel_sequence;
    char text[HAL_TEXT_SIZE];
};

/* `mapper.choose` null: hid_map_choose() alone. */
void poi_hid_init(struct poi_hid *poi, struct hid_port port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view);

/* What it says from now on is shown to `watch`, too; `watch.report` null: to nobody. */
void poi_hid_show(struct poi_hid *poi, struct hid_watch watch);

/* From now on it plays by `map`; null: by the mapper's, asked anew. Returns whether it plays. */
int poi_hid_remap(struct poi_hid *poi, const struct hid_map *map);

struct hal_poi poi_hid_device(struct poi_hid *poi);
struct hal_shade poi_hid_fan(struct poi_hid *poi);

/* START, LEFT, RIGHT, OK on the controller itself; to be asked after the poi. */
struct hal_buttons poi_hid_buttons(struct poi_hid *poi);

#endif
