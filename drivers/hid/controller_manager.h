/* controller_manager.h -- the controller manager: selects the controllers that play, and learns the
 * mappings of new controllers.
 *
 * Implements hal_controllers for the operator's menu. The manager uses the device list of a
 * transport (hid_device_list.h), the players' slots and the mapping store. A slot is the place of
 * one of up to POI_MAX controllers. All calls come from one thread, and no call blocks. */
#ifndef KINGYO_DRIVERS_HID_CONTROLLER_MANAGER_H
#define KINGYO_DRIVERS_HID_CONTROLLER_MANAGER_H

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_learn.h"
#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/poi_hid.h"
#include "platform/hal.h"

struct controller_manager {
    struct hid_device_list device_list;
    struct hid_mapping_store *book;     /* Mapping store, owned by the caller. */
    struct poi_hid *seat[POI_MAX];      /* Controller of each slot, owned by the caller. An element
                                           is null if the transport has fewer slots. */
    struct hid_row row[CONTROLLER_MAX]; /* Copy of the device list from the last poll. */
    struct hid_learn learn;
    uint8_t learn_row;      /* Row of the controller that is being learned. */
    uint8_t learn_seat;     /* Slot of the controller that is being learned, or POI_MAX if no such
                               controller is attached. */
    uint8_t learn_waits;    /* 1 while the controller to learn is selected but not attached yet,
                               otherwise 0. */
    uint8_t keeps, forgets; /* 1 while the mapping must be stored (`keeps`) or deleted (`forgets`)
                               in a later poll, because the store was busy. */
    uint8_t writes;         /* 1 while the store writes the learned mapping to its file, otherwise
                               0. */
    /* 1 if the controller that is being learned was not selected before learning, otherwise 0. If
     * the field is 1, the controller is released after learning unless its mapping is kept. */
    uint8_t gives_back;
    struct hid_identity learn_identity; /* Identity of the controller that is being learned. */
    struct hid_identity forget_identity;
    char name[HAL_CONTROLLER_TEXT];
};

/* Initializes `manager`. `seats` contains the controller of each slot; the pointers are copied. */
void controller_manager_init(struct controller_manager *manager, struct hid_device_list device_list,
                             struct hid_mapping_store *book, struct poi_hid *const seats[POI_MAX]);

/* Returns the device for the operator's menu. */
struct hal_controllers controller_manager_device(struct controller_manager *manager);

#endif
