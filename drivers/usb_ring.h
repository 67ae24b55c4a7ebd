/* usb_ring.h -- reports on their way from the USB thread to the frame loop: one writes, one reads.
 *
 * Neither ever waits for the other. Of what does not fit the newest is kept, beside the ring, and
 * comes out in its turn; those between are lost and counted. The generation of each report says who
 * sat in the seat when it came. */
#ifndef KINGYO_DRIVERS_USB_RING_H
#define KINGYO_DRIVERS_USB_RING_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_port.h"
#include "drivers/usb_mail.h"

#define USB_LINE_SIZE 64u /* Of a cache: what two threads write lies on two of them. */

struct usb_ring_slot {
    uint32_t generation;
    uint32_t number; /* Of the reports since the start, kept or not; wraps. */
    struct hid_raw raw;
};

struct usb_ring {
    _Alignas(USB_LINE_SIZE) atomic_uint pushed; /* Both count for ever, and wrap together. */
    atomic_uint lost;
    uint32_t next_number; /* The writer's. */
    _Alignas(USB_LINE_SIZE) atomic_uint taken;
    uint8_t has_late, is_late; /* The reader's: one of `late` waits; it is the one to drop. */
    _Alignas(USB_LINE_SIZE) struct usb_mail mail; /* What came while the ring was full. */
    struct usb_ring_slot late[USB_MAIL_SLOTS];
    _Alignas(USB_LINE_SIZE) struct usb_ring_slot slot[HID_REPORTS_MAX];
};

void usb_ring_init(struct usb_ring *ring);

/* The writer's: copies `size` bytes, 1 .. HID_REPORT_MAX. 0: the ring is full, and this one is kept
 * only until the next that does not fit either. */
int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size);

/* The writer's: one more that came to nothing. */
void usb_ring_lose(struct usb_ring *ring);

/* The reader's: the oldest, which stays valid until usb_ring_drop(); null: there is none. */
const struct usb_ring_slot *usb_ring_peek(struct usb_ring *ring);

/* The reader's: the one that was peeked at last is done with. */
void usb_ring_drop(struct usb_ring *ring);

/* Either's: how many were lost since the start. */
uint32_t usb_ring_lost(const struct usb_ring *ring);

#endif
