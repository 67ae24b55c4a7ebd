/* hid_device_list_sim.h -- a simulated device list of a transport.
 *
 * A test plugs controllers in and unplugs them. A selected controller is attached to a simulated
 * slot, the place of one of up to four controllers. */
#ifndef KINGYO_DRIVERS_SIM_HID_DEVICE_LIST_SIM_H
#define KINGYO_DRIVERS_SIM_HID_DEVICE_LIST_SIM_H

#include "drivers/hid/hid_device_list.h"
#include "drivers/sim/hid_port_sim.h"

struct hid_device_list_sim {
    struct hid_port_sim *seat[POI_MAX]; /* Port of each slot, owned by the caller; null means that
                                           the slot does not exist. */
    /* Connected device of each row of the device list, owned by the caller; null means that the row
     * has no connected device. */
    const struct hid_device_info *face[CONTROLLER_MAX];
    uint8_t chosen[CONTROLLER_MAX];
    uint8_t barred[CONTROLLER_MAX]; /* 1 if the kiosk must not use the device of the row, for
                                       example a keyboard; otherwise 0. */
    /* Identity of the last device of each row. For a lost controller (CONTROLLER_LOST) the list
     * returns this identity. */
    struct hid_identity who[CONTROLLER_MAX];
    uint8_t denied[CONTROLLER_MAX]; /* 1 if opening the device fails because of missing permission,
                                       otherwise 0. */
    uint8_t taken[CONTROLLER_MAX];  /* Slot of the row's device plus 1; 0 means that the device has
                                       no slot. */
    uint32_t choose_count, release_count;
};

/* Initializes the list with empty rows. `seats` has the ports of the POI_MAX slots; the pointers
 * are copied. */
void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const seats[POI_MAX]);

/* Plugs a controller into an empty row, or unplugs the row's controller if `face` is null. A
 * selected controller is attached to its slot again when it returns. */
void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face);

/* Returns the simulated device list. */
struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim);

#endif
