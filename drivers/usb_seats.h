/* usb_seats.h -- controllers on USB, through libusb: up to POI_MAX of them play, each in a seat.
 *
 * One thread of its own waits for transfers and hot-plugs (usb_pump.h); reports cross to the frame
 * loop through a ring of a fixed size for each seat. It takes our own poi and what the operator
 * chose (usb_choice.h), and nothing else: never a boot keyboard, never another interface of the
 * same device. */
#ifndef KINGYO_DRIVERS_USB_SEATS_H
#define KINGYO_DRIVERS_USB_SEATS_H

#include <stdint.h>

#include "drivers/hid_port.h"
#include "drivers/hid_roster.h"
#include "drivers/usb_choice.h"
#include "platform/hal.h"

struct usb_seats;

/* All is copied but what the clock points at. */
struct usb_seats_config {
    struct hal_clock clock;       /* Asked by the thread, too. */
    const char *choices;          /* The file of chosen controllers; null: choices are not kept. */
    const struct usb_key *listed; /* These play whatever the file says (--usb). */
    uint32_t listed_count;
    const char *sysfs;            /* Null: "/sys". Tests have their own. */
    /* Gets one line when a controller that should play cannot be had, from the thread; null: nobody
     * is told but who asks hid_roster_ops.describe(). */
    void (*tell)(void *self, const char *line);
    void *tell_self;
};

/* Starts the thread. The one object of it is the file's own: a process has one USB. `why` gets one
 * line where there is no USB at all (the rest then answers HAL_ERR_NONE), or where a line of the
 * file cannot be used, or the file not be read: then it is not written over; else "". */
struct usb_seats *usb_seats_start(const struct usb_seats_config *config, char why[HAL_TEXT_SIZE]);

/* Seat `index` < POI_MAX. Whoever sits there comes back to the same seat after it was pulled out:
 * by vendor:product:serial, else by its port. */
struct hid_port usb_seats_port(struct usb_seats *seats, uint32_t index);

struct hid_roster usb_seats_roster(struct usb_seats *seats);

/* Whom somebody named to play, in the file or by --usb, plugged in or not: from the start on, so
 * that nobody else takes them first. How many; none where there is no USB. */
uint32_t usb_seats_wanted(struct usb_seats *seats, struct usb_key out[USB_WISH_MAX]);

/* Cancels, waits, closes, gives kernel drivers back, ends the thread. */
void usb_seats_stop(struct usb_seats *seats);

#endif
