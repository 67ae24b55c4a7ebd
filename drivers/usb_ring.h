/* usb_ring.h -- the lock-free report queue from the event thread to the frame loop.
 *
 * The event thread writes and the frame loop reads; neither blocks. When the queue is full, the
 * newest report is kept beside it and read in order. Reports in between are lost and counted.
 * The generation of a report identifies the controller that sent it. */
#ifndef KINGYO_DRIVERS_USB_RING_H
#define KINGYO_DRIVERS_USB_RING_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_port.h"
#include "drivers/usb_mail.h"

#define USB_LINE_SIZE 64u /* Bytes of a cache line; each thread writes to its own lines. */

struct usb_ring_slot {
    uint32_t generation;
    /* Sequence number of all reports since the start, including lost ones; wraps. */
    uint32_t number;
    struct hid_raw raw;
};

struct usb_ring {
    _Alignas(USB_LINE_SIZE) atomic_uint pushed; /* Counts up like `taken`; both wrap at 2^32. */
    atomic_uint lost;
    uint32_t next_number; /* Number of the next report; used only by the writer. */
    _Alignas(USB_LINE_SIZE) atomic_uint taken;
    /* Used only by the reader: `late` has a report, and the peeked report is that one. */
    uint8_t has_late, is_late;
    _Alignas(USB_LINE_SIZE) struct usb_mail mail; /* Newest report while the queue is full. */
    struct usb_ring_slot late[USB_MAIL_SLOTS];
    _Alignas(USB_LINE_SIZE) struct usb_ring_slot slot[HID_REPORTS_MAX];
};

void usb_ring_init(struct usb_ring *ring);

/* For the writer: copies `size` bytes, 1 .. HID_REPORT_MAX. Returns 1, or 0 if the queue is
 * full. The report is then kept until the next report that does not fit replaces it. */
int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size);

/* For the writer: counts one more lost report. */
void usb_ring_lose(struct usb_ring *ring);

/* For the reader: returns the oldest report, which stays valid until usb_ring_drop(), or null. */
const struct usb_ring_slot *usb_ring_peek(struct usb_ring *ring);

/* For the reader: removes the report that usb_ring_peek() returned last. */
void usb_ring_drop(struct usb_ring *ring);

/* Returns the number of reports lost since the start. Callable from both threads. */
uint32_t usb_ring_lost(const struct usb_ring *ring);

#endif
