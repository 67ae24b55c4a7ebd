/* usb_ring.c -- two counters that only grow, and the slots between them. */
#include "drivers/usb_ring.h"

#include <string.h>

_Static_assert((HID_REPORTS_MAX & (HID_REPORTS_MAX - 1u)) == 0u,
               "the counters wrap at a multiple of the slots");

int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size)
{
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_relaxed);
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_acquire);
    if (pushed - taken == HID_REPORTS_MAX) {
        usb_ring_lose(ring);
        return 0;
    }
    struct usb_ring_slot *slot = &ring->slot[pushed % HID_REPORTS_MAX];
    slot->generation = generation;
    slot->raw.time_ns = time_ns;
    slot->raw.size = size;
    memcpy(slot->raw.bytes, bytes, size);
    atomic_store_explicit(&ring->pushed, pushed + 1u, memory_order_release);
    return 1;
}

void usb_ring_lose(struct usb_ring *ring)
{
    atomic_fetch_add_explicit(&ring->lost, 1u, memory_order_relaxed);
}

const struct usb_ring_slot *usb_ring_peek(const struct usb_ring *ring)
{
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_acquire);
    return taken == pushed ? NULL : &ring->slot[taken % HID_REPORTS_MAX];
}

void usb_ring_drop(struct usb_ring *ring)
{
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    atomic_store_explicit(&ring->taken, taken + 1u, memory_order_release);
}

uint32_t usb_ring_lost(const struct usb_ring *ring)
{
    return atomic_load_explicit(&ring->lost, memory_order_relaxed);
}
