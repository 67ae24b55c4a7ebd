/* usb_roster.h -- the USB device list, shared between the event thread and the frame loop.
 *
 * The event thread publishes rows. The frame loop reads the newest rows and sends commands.
 * Neither blocks. */
#ifndef KINGYO_DRIVERS_USB_ROSTER_H
#define KINGYO_DRIVERS_USB_ROSTER_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_roster.h"
#include "drivers/usb_mail.h"
#include "drivers/usb_rows.h"

#define USB_ORDER_MAX 8u /* Capacity of the command queue, which is emptied within a frame. */

/* A command with a copy of the identity, because rows can change before the command is executed. */
struct usb_order {
    uint8_t plays; /* 1 to choose the controller, 0 to release it. */
    struct hid_identity identity;
};

struct usb_roster {
    struct usb_mail mail;
    struct usb_rows rows[USB_MAIL_SLOTS];
    atomic_uint pushed, taken; /* Counters of the commands. */
    struct usb_order order[USB_ORDER_MAX];
    void (*wake)(void *self);
    void *wake_self;
};

/* Initializes an empty list. `wake` is called for each command. */
void usb_roster_init(struct usb_roster *roster, void (*wake)(void *self), void *wake_self);

/* For the event thread: copies and publishes `rows`; takes the next command. usb_roster_order()
 * returns 1, or 0 if there is no command. */
void usb_roster_post(struct usb_roster *roster, const struct usb_rows *rows);
int usb_roster_order(struct usb_roster *roster, struct usb_order *out);

/* For the frame loop: copies the chosen keys and returns their number; returns the device list
 * interface. */
uint32_t usb_roster_wanted(struct usb_roster *roster, struct usb_key out[USB_WISH_MAX]);
struct hid_roster usb_roster_face(struct usb_roster *roster);

#endif
