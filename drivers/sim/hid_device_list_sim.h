/* hid_device_list_sim.h -- the simulated twin of a transport's device list.
 *
 * A test plugs controllers in and pulls them out. A chosen controller is attached to a simulated
 * slot. */
#ifndef KINGYO_DRIVERS_SIM_HID_DEVICE_LIST_SIM_H
#define KINGYO_DRIVERS_SIM_HID_DEVICE_LIST_SIM_H

#include "drivers/hid/hid_device_list.h"
#include "drivers/sim/hid_port_sim.h"

struct hid_device_list_sim {
    struct hid_port_sim *seat[POI_MAX]; /* Owned by the caller; null if there are fewer slots. */
    /* Connected device, owned by the caller; null for an empty row. */
    const struct hid_device_info *face[CONTROLLER_MAX];
    uint8_t chosen[CONTROLLER_MAX];
    uint8_t barred[CONTROLLER_MAX]; /* 1 if the device may not play, such as a keyboard. */
    /* Last device of each row, which names a LOST controller. */
    struct hid_identity who[CONTROLLER_MAX];
    uint8_t denied[CONTROLLER_MAX]; /* 1 if opening fails for lack of permission. */
    uint8_t taken[CONTROLLER_MAX];  /* Slot + 1, or 0 if not attached. */
    uint32_t choose_count, release_count;
};

/* Initializes the list with empty rows. `seats` are POI_MAX pointers, which are copied. */
void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const seats[POI_MAX]);

/* Plugs a controller into an empty row, or unplugs it if `face` is null. A chosen controller is
 * attached again when it returns. */
void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face);

struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim);

#endif
