/* hid_roster.h -- which controllers are plugged in, and which of them play: what a transport tells
 * the operator's desk (hid_desk.h), and is told by it. One thread calls; no call waits. */
#ifndef KINGYO_DRIVERS_HID_ROSTER_H
#define KINGYO_DRIVERS_HID_ROSTER_H

#include "core/input.h"
#include "drivers/hid_port.h"

struct hid_row {
    struct hid_identity identity;
    uint8_t state; /* enum controller_state */
    uint8_t seat;  /* Where it sits, < POI_MAX; POI_MAX: nowhere. */
};

struct hid_roster_ops {
    /* A row keeps its place from the plugging in to the pulling out, and while it is LOST. */
    void (*rows)(void *self, struct hid_row out[CONTROLLER_MAX]);
    /* From now on it plays, also when it comes back: HAL_OK when the order was taken; what comes of
     * it is seen in its row. HAL_ERR_BUSY: POI_MAX play already. HAL_ERR_NONE: no such row, or it
     * is barred. */
    int (*choose)(void *self, uint32_t row);
    int (*release)(void *self, uint32_t row);
    /* One line: how many there are, or what is in the way and what to do about it. */
    const char *(*describe)(void *self);
};

struct hid_roster { const struct hid_roster_ops *ops; void *self; };

#endif
