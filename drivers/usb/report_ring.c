/* report_ring.c -- implements the report queue as a ring buffer with two counters that only
 * increase. */
#include "drivers/usb/report_ring.h"

#include <string.h>

_Static_assert((HID_REPORTS_MAX & (HID_REPORTS_MAX - 1u)) == 0u,
               "the counters wrap at a multiple of the slots");

void report_ring_init(struct report_ring *ring)
{
    memset(ring, 0, sizeof *ring);
    triple_buffer_init(&ring->mail);
}

int report_ring_push(struct report_ring *ring, uint32_t generation, uint64_t time_ns,
                     const uint8_t *bytes, uint32_t size)
{
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_relaxed);
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_acquire);
    const int fits = pushed - taken < HID_REPORTS_MAX;
    struct report_ring_slot *slot =
        fits ? &ring->slot[pushed % HID_REPORTS_MAX] : &ring->late[ring->mail.writing];
    slot->generation = generation;
    slot->number = ring->next_number++;
    slot->raw.time_ns = time_ns;
    slot->raw.size = size;
    memcpy(slot->raw.bytes, bytes, size);
    if (fits) {
        atomic_store_explicit(&ring->pushed, pushed + 1u, memory_order_release);
    } else if (triple_buffer_post(&ring->mail)) {
        report_ring_lose(ring);
    }
    return fits;
}

void report_ring_lose(struct report_ring *ring)
{
    atomic_fetch_add_explicit(&ring->lost, 1u, memory_order_relaxed);
}

/* Returns the older of two reports: the next report in the queue, and the report in the late
 * buffer. The queue is read first, so that a late report that was posted before a push is seen. */
const struct report_ring_slot *report_ring_peek(struct report_ring *ring)
{
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_acquire);
    const struct report_ring_slot *slot =
        taken == pushed ? NULL : &ring->slot[taken % HID_REPORTS_MAX];
    ring->has_late = ring->has_late || triple_buffer_fetch(&ring->mail);
    const struct report_ring_slot *late = ring->has_late ? &ring->late[ring->mail.reading] : NULL;
    ring->is_late = late && (!slot || (int32_t)(late->number - slot->number) < 0);
    return ring->is_late ? late : slot;
}

void report_ring_drop(struct report_ring *ring)
{
    if (ring->is_late) {
        ring->has_late = 0;
        return;
    }
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    atomic_store_explicit(&ring->taken, taken + 1u, memory_order_release);
}

uint32_t report_ring_lost(const struct report_ring *ring)
{
    return atomic_load_explicit(&ring->lost, memory_order_relaxed);
}
