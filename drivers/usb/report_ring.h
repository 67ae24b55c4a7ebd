/* report_ring.h -- the lock-free report queue from the event thread to the frame loop.
 *
 * The event thread writes and the frame loop reads; neither thread blocks. When the queue is full,
 * the newest report is kept in a separate late buffer. The reader receives the late report after
 * all older reports. Other reports that do not fit are lost and counted. The generation number of a
 * report identifies the connection of the controller that sent it. */
#ifndef KINGYO_DRIVERS_USB_REPORT_RING_H
#define KINGYO_DRIVERS_USB_REPORT_RING_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_port.h"
#include "drivers/usb/triple_buffer.h"

/* Size of a cache line in bytes. Each thread writes to its own cache lines. */
#define REPORT_RING_LINE_SIZE 64u

struct report_ring_slot {
    uint32_t generation;
    /* Sequence number of the report. Lost reports are numbered too. The number wraps at 2^32. */
    uint32_t number;
    struct hid_raw raw;
};

struct report_ring {
    _Alignas(REPORT_RING_LINE_SIZE)
        atomic_uint pushed; /* `pushed` is the number of reports that were added to the queue.
                               `taken` is the number of reports that were removed. Both counters
                               wrap at 2^32. */
    atomic_uint lost;
    uint32_t next_number; /* Number of the next report; used only by the writer. */
    _Alignas(REPORT_RING_LINE_SIZE) atomic_uint taken;
    /* `has_late` is 1 if `late` contains an unread report. `is_late` is 1 if report_ring_peek()
     * returned the report in `late`. Only the reader uses these flags. */
    uint8_t has_late, is_late;
    /* Triple buffer for `late`, which holds the newest report while the queue is full. */
    _Alignas(REPORT_RING_LINE_SIZE) struct triple_buffer mail;
    struct report_ring_slot late[TRIPLE_BUFFER_SLOTS];
    _Alignas(REPORT_RING_LINE_SIZE) struct report_ring_slot slot[HID_REPORTS_MAX];
};

/* Initializes an empty queue. Must be called before a thread uses the queue. */
void report_ring_init(struct report_ring *ring);

/* Copies a report of `size` bytes (1 to HID_REPORT_MAX) into the queue. Called only by the writer.
 * Returns 1 if the report was queued. Returns 0 if the queue is full. The report is then kept in
 * the late buffer until the next report that does not fit replaces it. */
int report_ring_push(struct report_ring *ring, uint32_t generation, uint64_t time_ns,
                     const uint8_t *bytes, uint32_t size);

/* Counts one more lost report. Called only by the writer. */
void report_ring_lose(struct report_ring *ring);

/* Returns the oldest report, which stays valid until report_ring_drop(), or null if there is no
 * report. Called only by the reader. */
const struct report_ring_slot *report_ring_peek(struct report_ring *ring);

/* Removes the report that report_ring_peek() returned last. Called only by the reader. */
void report_ring_drop(struct report_ring *ring);

/* Returns the number of reports lost since report_ring_init(). The writer and the reader may call
 * this function. */
uint32_t report_ring_lost(const struct report_ring *ring);

#endif
