/* usb_roster.h -- the controllers on USB as the operator's menu sees them, between two threads.
 *
 * The USB thread posts rows; the frame loop reads the newest and sends orders back. None waits. */
#ifndef KINGYO_DRIVERS_USB_ROSTER_H
#define KINGYO_DRIVERS_USB_ROSTER_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_roster.h"
#include "drivers/usb_mail.h"
#include "drivers/usb_rows.h"

#define USB_ORDER_MAX 8u /* Taken within a frame; nobody presses OK eight times in one. */

/* A copy of whom it means, for rows move on meanwhile. */
struct usb_order {
    uint8_t plays; /* 0: it is released. */
    struct hid_identity identity;
};

struct usb_roster {
    struct usb_mail mail;
    struct usb_rows rows[USB_MAIL_SLOTS];
    atomic_uint pushed, taken; /* Orders. */
    struct usb_order order[USB_ORDER_MAX];
    void (*wake)(void *self);
    void *wake_self;
};

void usb_roster_init(struct usb_roster *roster, void (*wake)(void *self), void *wake_self);

/* The thread's side: rows that are copied; the next order, if there is one. */
void usb_roster_post(struct usb_roster *roster, const struct usb_rows *rows);
int usb_roster_order(struct usb_roster *roster, struct usb_order *out);

/* The frame loop's side. */
uint32_t usb_roster_wanted(struct usb_roster *roster, struct usb_key out[USB_WISH_MAX]);
struct hid_roster usb_roster_face(struct usb_roster *roster);

#endif
