/* controller_manager.h -- the controller manager: selects the controllers that play, and learns new
 * ones.
 *
 * Implements hal_controllers for the operator's menu. The manager uses the device list of a
 * transport, the slots of the frame loop and the mapping store. All calls come from one thread,
 * and no call blocks. */
#ifndef KINGYO_DRIVERS_HID_CONTROLLER_MANAGER_H
#define KINGYO_DRIVERS_HID_CONTROLLER_MANAGER_H

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_learn.h"
#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/poi_hid.h"
#include "platform/hal.h"

struct controller_manager {
    struct hid_device_list device_list;
    struct hid_mapping_store *book; /* Mapping store, owned by the caller. */
    struct poi_hid *seat[POI_MAX]; /* Owned by the caller; null if the transport has fewer slots. */
    struct hid_row row[CONTROLLER_MAX]; /* Device list at the last poll. */
    struct hid_learn learn;
    uint8_t learn_row;
    uint8_t learn_seat;     /* Slot of the attached controller, otherwise POI_MAX. */
    uint8_t learn_waits;    /* 1 while the chosen controller is not attached yet. */
    uint8_t keeps, forgets; /* 1 while a busy store makes the next poll retry. */
    uint8_t writes;         /* 1 while the learned mapping is being written. */
    /* 1 if the controller was free before learning. Such a controller is released afterwards
     * unless its mapping is kept. */
    uint8_t gives_back;
    struct hid_identity learn_identity; /* The controller that is being learned. */
    struct hid_identity forget_identity;
    char name[HAL_CONTROLLER_TEXT];
};

/* Initializes `manager`. `seats` are POI_MAX pointers, which are copied. */
void controller_manager_init(struct controller_manager *manager, struct hid_device_list device_list,
                             struct hid_mapping_store *book, struct poi_hid *const seats[POI_MAX]);

struct hal_controllers controller_manager_device(struct controller_manager *manager);

#endif
