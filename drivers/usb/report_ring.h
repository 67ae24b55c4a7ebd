/* report_ring.h -- the lock-free report queue from the event thread to the frame loop.
 *
 * The event thread writes and the frame loop reads; neither blocks. When the queue is full, the
 * newest report is kept beside it and read in order. Reports in between are lost and counted.
 * The generation of a report identifies the controller that sent it. */
#ifndef KINGYO_DRIVERS_USB_REPORT_RING_H
#define KINGYO_DRIVERS_USB_REPORT_RING_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_port.h"
#include "drivers/usb/triple_buffer.h"

/* Bytes of a cache line; each thread writes to its own lines. */
#define REPORT_RING_LINE_SIZE 64u

struct report_ring_slot {
    uint32_t generation;
    /* Sequence number of all reports since the start, including lost ones; wraps. */
    uint32_t number;
    struct hid_raw raw;
};

struct report_ring {
    _Alignas(REPORT_RING_LINE_SIZE)
        atomic_uint pushed; /* Counts up like `taken`; both wrap at 2^32. */
    atomic_uint lost;
    uint32_t next_number; /* Number of the next report; used only by the writer. */
    _Alignas(REPORT_RING_LINE_SIZE) atomic_uint taken;
    /* Used only by the reader: `late` has a report, and the peeked report is that one. */
    uint8_t has_late, is_late;
    _Alignas(REPORT_RING_LINE_SIZE) struct triple_buffer
        mail; /* Newest report while the queue is full. */
    struct report_ring_slot late[TRIPLE_BUFFER_SLOTS];
    _Alignas(REPORT_RING_LINE_SIZE) struct report_ring_slot slot[HID_REPORTS_MAX];
};

void report_ring_init(struct report_ring *ring);

/* For the writer: copies `size` bytes, 1 .. HID_REPORT_MAX. Returns 1, or 0 if the queue is
 * full. The report is then kept until the next report that does not fit replaces it. */
int report_ring_push(struct report_ring *ring, uint32_t generation, uint64_t time_ns,
                     const uint8_t *bytes, uint32_t size);

/* For the writer: counts one more lost report. */
void report_ring_lose(struct report_ring *ring);

/* For the reader: returns the oldest report, which stays valid until report_ring_drop(), or null.
 */
const struct report_ring_slot *report_ring_peek(struct report_ring *ring);

/* For the reader: removes the report that report_ring_peek() returned last. */
void report_ring_drop(struct report_ring *ring);

/* Returns the number of reports lost since the start. Callable from both threads. */
uint32_t report_ring_lost(const struct report_ring *ring);

#endif
