/* hid_device_list.h -- the device list interface between a transport and the controller manager.
 *
 * The list contains the connected controllers and those that play. The controller manager
 * (controller_manager.h) calls it from one thread, and no call blocks. */
#ifndef KINGYO_DRIVERS_HID_HID_DEVICE_LIST_H
#define KINGYO_DRIVERS_HID_HID_DEVICE_LIST_H

#include "core/input.h"
#include "drivers/hid/hid_port.h"

struct hid_row {
    struct hid_identity identity;
    uint8_t state; /* enum controller_state */
    uint8_t seat;  /* Slot of the controller, or POI_MAX if it has none. */
};

struct hid_device_list_ops {
    /* Copies the list. A controller keeps its row from plugging in until unplugging, and while
     * it is LOST. */
    void (*rows)(void *self, struct hid_row out[CONTROLLER_MAX]);
    /* Lets the controller play now and after each reconnection. HAL_OK means that the command
     * was accepted; the row shows the result later. Returns HAL_ERR_BUSY if POI_MAX controllers
     * play already, or HAL_ERR_ABSENT if there is no such row or the controller is barred. */
    int (*choose)(void *self, uint32_t row);
    int (*release)(void *self, uint32_t row);
    /* Returns one line with the number of controllers, or with a problem and its remedy. */
    const char *(*describe)(void *self);
};

struct hid_device_list {
    const struct hid_device_list_ops *ops;
    void *self;
};

#endif
