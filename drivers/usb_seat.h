/* usb_seat.h -- one seat at the tank, as the USB thread and the frame loop share it.
 *
 * The thread says who sits down, what it reports and when it is gone; the frame loop takes that as
 * a struct hid_port. Every sitting has a number, so that no report of one is taken for the next's.
 * No call here waits. */
#ifndef KINGYO_DRIVERS_USB_SEAT_H
#define KINGYO_DRIVERS_USB_SEAT_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_port.h"
#include "drivers/usb_mail.h"
#include "drivers/usb_ring.h"

/* What a seat's output report is doing. */
enum usb_outgoing {
    USB_OUT_NONE = 0, /* The frame loop may write the next. */
    USB_OUT_READY,    /* The thread may send it. */
    USB_OUT_FLYING,
};

struct usb_sitting {
    uint32_t generation;
    struct hid_face face;
};

struct usb_seat {
    /* Either thread's. */
    struct usb_ring ring;
    atomic_uint generation; /* Odd: somebody sits here. */
    struct usb_mail mail;
    struct usb_sitting sitting[USB_MAIL_SLOTS];
    atomic_uint outgoing;   /* enum usb_outgoing; whose turn it is with what follows. */
    uint32_t out_size, out_generation;
    uint8_t out_bytes[HID_REPORT_MAX];
    /* The thread's. */
    uint64_t last_ns;       /* Stamp of the newest report. */
    /* The frame loop's. */
    uint32_t opened;        /* Generation that it took a face of; 0: none. */
    uint8_t is_never;       /* There is no USB here: nobody ever will sit. */
    struct hid_identity identity;
    void (*wake)(void *self); /* Tells the thread of an output report; does not wait. */
    void *wake_self;
    char text[HAL_TEXT_SIZE];
};

void usb_seat_init(struct usb_seat *seat, void (*wake)(void *self), void *wake_self);

/* ---- The thread's side ---- */

/* Somebody sits down in an empty seat; `face` is copied. */
void usb_seat_sit(struct usb_seat *seat, const struct hid_face *face);

/* Whoever sat there is gone. All it reported before will still be taken. */
void usb_seat_leave(struct usb_seat *seat);

/* A report of whoever sits there, at `now_ns`: any size; 0 is none, too long ones are lost. */
void usb_seat_report(struct usb_seat *seat, uint64_t now_ns, const uint8_t *bytes, uint32_t size);

/* The output report to send now: its size, or 0. Its bytes are the thread's until
 * usb_seat_sent(). */
uint32_t usb_seat_outgoing(struct usb_seat *seat);
void usb_seat_sent(struct usb_seat *seat);

/* ---- The frame loop's side ---- */

struct hid_port usb_seat_port(struct usb_seat *seat);

#endif
