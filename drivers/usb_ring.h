/* usb_ring.h -- reports on their way from the USB thread to the frame loop: one writes, one reads.
 *
 * Neither ever waits for the other. What does not fit is lost and counted, and the generation of
 * each report says who sat in the seat when it came. */
#ifndef KINGYO_DRIVERS_USB_RING_H
#define KINGYO_DRIVERS_USB_RING_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid_port.h"

#define USB_LINE_SIZE 64u /* Of a cache: what two threads write lies on two of them. */

struct usb_ring_slot {
    uint32_t generation;
    struct hid_raw raw;
};

/* Zero is an empty ring. */
struct usb_ring {
    _Alignas(USB_LINE_SIZE) atomic_uint pushed; /* Both count for ever, and wrap together. */
    atomic_uint lost;
    _Alignas(USB_LINE_SIZE) atomic_uint taken;
    _Alignas(USB_LINE_SIZE) struct usb_ring_slot slot[HID_REPORTS_MAX];
};

/* The writer's: copies `size` bytes, 1 .. HID_REPORT_MAX. 0: it is full, and the report lost. */
int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size);

/* The writer's: one more that came to nothing. */
void usb_ring_lose(struct usb_ring *ring);

/* The reader's: the oldest, which stays valid until usb_ring_drop(); null: there is none. */
const struct usb_ring_slot *usb_ring_peek(const struct usb_ring *ring);
void usb_ring_drop(struct usb_ring *ring);

/* Either's: how many were lost since the start. */
uint32_t usb_ring_lost(const struct usb_ring *ring);

#endif
