/* hid_desk.h -- the operator's desk: which controllers play, and learning one. hal_controllers over
 * a transport's roster, the seats that are played at, and the book of what was learned. */
#ifndef KINGYO_DRIVERS_HID_DESK_H
#define KINGYO_DRIVERS_HID_DESK_H

#include "drivers/hid_book.h"
#include "drivers/hid_learn.h"
#include "drivers/hid_roster.h"
#include "drivers/poi_hid.h"
#include "platform/hal.h"

struct hid_desk {
    struct hid_roster roster;
    struct hid_book *book;             /* The caller's. */
    struct poi_hid *seat[POI_MAX];     /* The caller's; null: the transport has fewer. */
    struct hid_row row[CONTROLLER_MAX]; /* As of the last poll. */
    struct hid_learn learn;
    uint8_t learn_row;
    uint8_t learn_seat;                /* < POI_MAX once the controller sits there. */
    uint8_t learn_waits;               /* It was chosen and has not sat down yet. */
    uint8_t keeps, forgets;            /* The book was busy: asked again at the next poll. */
    uint8_t writes;                    /* What was learned is being written. */
    uint8_t gives_back;                /* It was free before: unless it is kept it is so again. */
    struct hid_identity learn_identity; /* Who is learned, ... */
    struct hid_identity forget_identity;
    char name[HAL_CONTROLLER_TEXT];
};

/* `seats` are POI_MAX pointers, copied. */
void hid_desk_init(struct hid_desk *desk, struct hid_roster roster, struct hid_book *book,
                   struct poi_hid *const seats[POI_MAX]);

struct hal_controllers hid_desk_device(struct hid_desk *desk);

#endif
