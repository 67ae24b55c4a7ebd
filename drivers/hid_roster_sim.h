/* hid_roster_sim.h -- the simulated twin of a transport's roster: controllers that a test plugs in,
 * seats of memory at which they sit down when they are chosen. */
#ifndef KINGYO_DRIVERS_HID_ROSTER_SIM_H
#define KINGYO_DRIVERS_HID_ROSTER_SIM_H

#include "drivers/hid_port_sim.h"
#include "drivers/hid_roster.h"

struct hid_roster_sim {
    struct hid_port_sim *seat[POI_MAX];       /* The caller's; null: fewer seats. */
    const struct hid_face *face[CONTROLLER_MAX]; /* Plugged in, the caller's; null: an empty row. */
    uint8_t chosen[CONTROLLER_MAX];
    uint8_t barred[CONTROLLER_MAX];           /* A keyboard, say. */
    struct hid_identity who[CONTROLLER_MAX];  /* Who was there last: one that is LOST has a name. */
    uint8_t denied[CONTROLLER_MAX];           /* We may not open it. */
    uint8_t taken[CONTROLLER_MAX];            /* Seat + 1; 0: it sits nowhere. */
    uint32_t choose_count, release_count;
};

/* `seats` are POI_MAX pointers, copied; all rows are empty. */
void hid_roster_sim_init(struct hid_roster_sim *sim, struct hid_port_sim *const seats[POI_MAX]);

/* Plugs a controller into an empty row, or pulls out (`face` null) who is there. One that was
 * chosen sits down again when it comes back. */
void hid_roster_sim_plug(struct hid_roster_sim *sim, uint32_t row, const struct hid_face *face);

struct hid_roster hid_roster_sim_device(struct hid_roster_sim *sim);

#endif
