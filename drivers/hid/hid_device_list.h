/* hid_device_list.h -- the device list: the interface between a transport and the controller
 * manager.
 *
 * The list contains all connected controllers, and lost controllers that were selected to play. A
 * controller plays while it has a slot and moves a poi. The controller manager
 * (controller_manager.h) calls the functions from one thread, and no call blocks. */
#pragma once

#include "core/input.h"
#include "drivers/hid/hid_port.h"

struct hid_row {
    struct hid_identity identity;
    uint8_t state; /* State of the controller (enum controller_state). */
    uint8_t slot;  /* Slot of the controller, or POI_MAX if the controller has no slot. */
};

struct hid_device_list_ops {
    /* Copies the list to `out`. A controller keeps its row while it is connected, and while its
     * state is CONTROLLER_LOST after it was unplugged. */
    void (*rows)(void *self, struct hid_row out[CONTROLLER_MAX]);
    /* Selects the controller of `row` to play if `plays` is true, otherwise releases it. A selected
     * controller also plays after each reconnection. Returns HAL_OK if the command was accepted.
     * The result appears later in the row. Returns HAL_ERR_BUSY if POI_MAX other controllers play
     * already. Returns HAL_ERR_ABSENT if the row is empty or the controller may not be used. */
    int (*choose)(void *self, uint32_t row, bool plays);
    /* Returns one line with the number of controllers, or with a problem and the remedy for the
     * problem. */
    const char *(*describe)(void *self);
};

struct hid_device_list {
    const struct hid_device_list_ops *ops;
    void *self;
};
