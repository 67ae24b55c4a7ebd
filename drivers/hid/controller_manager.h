/* controller_manager.h -- the controller manager: selects the controllers that play, and learns the
 * mappings of new controllers. A controller plays while it has a slot and moves a poi.
 *
 * Implements hal_controllers for the operator's menu. The manager uses the device list of a
 * transport (hid_device_list.h), the players' slots and the mapping store. A slot is the place of
 * one of up to POI_MAX controllers. All calls come from one thread, and no call blocks. */
#pragma once

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_learn.h"
#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/poi_hid.h"
#include "platform/hal.h"

struct controller_manager {
    struct hid_device_list device_list;
    struct hid_mapping_store *store; /* Mapping store, owned by the caller. */
    /* Controller of each slot, owned by the caller. An element is null if the transport has fewer
     * slots. */
    struct poi_hid *poi[POI_MAX];
    struct hid_row row[CONTROLLER_MAX]; /* Copy of the device list from the last poll. */
    struct hid_learn learn;
    uint8_t learn_row; /* Row of the controller that is being learned. */
    /* Slot of the controller that is being learned, or POI_MAX if no such controller is
     * attached. */
    uint8_t learn_slot;
    bool learn_waits; /* True while the controller to learn is selected but not attached yet. */
    /* True while the learned mapping must be stored in a later poll, because the store was busy. */
    bool keeps;
    /* True while the mapping of `forget_identity` must be deleted in a later poll, because the
     * store was busy. */
    bool forgets;
    bool writes; /* True while the store writes the learned mapping to its file. */
    /* True if the controller that is being learned was not selected before learning. The controller
     * is then released after learning unless its mapping is kept. */
    bool releases_at_end;
    struct hid_identity learn_identity; /* Identity of the controller that is being learned. */
    struct hid_identity forget_identity;
    char name[HAL_CONTROLLER_TEXT];
};

/* Initializes `manager` and returns its device for the operator's menu. `pois` contains the
 * controller of each slot. The pointers are copied. */
struct hal_controllers controller_manager_init(struct controller_manager *manager,
                                               struct hid_device_list device_list,
                                               struct hid_mapping_store *store,
                                               struct poi_hid *const pois[POI_MAX]);
