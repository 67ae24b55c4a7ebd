/* usb_slot.h -- one slot for a USB controller, shared between the event thread and the frame loop,
 * with the lock-free queue of its reports.
 *
 * The event thread attaches a controller, delivers its reports and detaches it. The frame loop uses
 * the slot as a struct hid_port. Each attachment has a generation number, so that a report of one
 * controller is never taken for a report of the next controller. No call blocks. */
#ifndef KINGYO_DRIVERS_USB_USB_SLOT_H
#define KINGYO_DRIVERS_USB_USB_SLOT_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_port.h"
#include "drivers/usb/triple_buffer.h"

/* ---- Report queue ---------------------------------------------------------------------------- */

/* The event thread writes to the queue and the frame loop reads. When the queue is full, the newest
 * report is kept in a separate late buffer. The reader receives the late report after all older
 * reports. Other reports that do not fit are lost and counted. The generation number of a report
 * identifies the connection of the controller that sent it. */

/* Size of a cache line in bytes. Each thread writes to its own cache lines. */
#define USB_RING_LINE_SIZE 64u

struct usb_ring_slot {
    uint32_t generation;
    /* Sequence number of the report. Lost reports are numbered too. The number wraps at 2^32. */
    uint32_t number;
    struct hid_raw raw;
};

struct usb_ring {
    _Alignas(USB_RING_LINE_SIZE)
        atomic_uint pushed; /* `pushed` is the number of reports that were added to the queue.
                               `taken` is the number of reports that were removed. Both counters
                               wrap at 2^32. */
    atomic_uint lost;
    uint32_t next_number; /* Number of the next report; used only by the writer. */
    _Alignas(USB_RING_LINE_SIZE) atomic_uint taken;
    /* `has_late` is 1 if `late` contains an unread report. `is_late` is 1 if usb_ring_peek()
     * returned the report in `late`. Only the reader uses these flags. */
    uint8_t has_late, is_late;
    /* Triple buffer for `late`, which holds the newest report while the queue is full. */
    _Alignas(USB_RING_LINE_SIZE) struct triple_buffer mail;
    struct usb_ring_slot late[TRIPLE_BUFFER_SLOTS];
    _Alignas(USB_RING_LINE_SIZE) struct usb_ring_slot slot[HID_REPORTS_MAX];
};

/* Initializes an empty queue. Must be called before a thread uses the queue. */
void usb_ring_init(struct usb_ring *ring);

/* Copies a report of `size` bytes (1 to HID_REPORT_MAX) into the queue. Called only by the writer.
 * Returns 1 if the report was queued. Returns 0 if the queue is full. The report is then kept in
 * the late buffer until the next report that does not fit replaces it. */
int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size);

/* Increases the number of lost reports by 1. Called only by the writer. */
void usb_ring_lose(struct usb_ring *ring);

/* Returns the oldest report, which stays valid until usb_ring_drop(), or null if there is no
 * report. Called only by the reader. */
const struct usb_ring_slot *usb_ring_peek(struct usb_ring *ring);

/* Removes the report that usb_ring_peek() returned last. Called only by the reader. */
void usb_ring_drop(struct usb_ring *ring);

/* Returns the number of reports lost since usb_ring_init(). The writer and the reader may call
 * this function. */
uint32_t usb_ring_lost(const struct usb_ring *ring);

/* ---- Slot ------------------------------------------------------------------------------------ */

/* State of the slot's output report. */
enum usb_outgoing {
    USB_OUT_NONE = 0,  /* The frame loop may write the next report. */
    USB_OUT_READY,     /* The event thread may send the report. */
    USB_OUT_SUBMITTED, /* The event thread is sending the report. */
};

struct usb_attachment {
    uint32_t generation;
    struct hid_device_info face;
};

struct usb_slot {
    /* The event thread and the frame loop share the fields from `ring` to `out_bytes`. */
    struct usb_ring ring;
    atomic_uint generation; /* Number that increases with each attach and each detach. It is odd
                               while a controller is attached. */
    struct triple_buffer mail;
    struct usb_attachment attachment[TRIPLE_BUFFER_SLOTS];
    /* State of the output report (enum usb_outgoing). The state determines which thread may use
     * `out_size`, `out_generation` and `out_bytes`. */
    atomic_uint outgoing;
    uint32_t out_size, out_generation;
    uint8_t out_bytes[HID_REPORT_MAX];
    /* Only the event thread uses `last_ns`. */
    uint64_t last_ns; /* Time stamp of the newest report. */
    /* Only the frame loop uses the fields from `opened` on. */
    uint32_t opened;  /* Generation number at the last successful open(); 0 means that open() never
                         succeeded. */
    uint8_t is_never; /* 1 if USB is not available at all, otherwise 0. */
    struct hid_identity identity;
    void (*wake)(void *self); /* Callback that wakes the event thread for an output report. The
                                 callback must not block. */
    void *wake_self;
    char text[HAL_TEXT_SIZE];
};

/* Initializes an empty slot. `wake` is called for each output report. */
void usb_slot_init(struct usb_slot *seat, void (*wake)(void *self), void *wake_self);

/* ---- Functions for the event thread --------- */

/* Attaches a controller to an empty slot. `face` is copied. */
void usb_slot_attach(struct usb_slot *seat, const struct hid_device_info *face);

/* Detaches the controller. The queued reports can still be read. */
void usb_slot_detach(struct usb_slot *seat);

/* Queues a report of the attached controller that was received at `now_ns`. A report of size 0 is
 * ignored. A report of more than HID_REPORT_MAX bytes is counted as lost. */
void usb_slot_report(struct usb_slot *seat, uint64_t now_ns, const uint8_t *bytes, uint32_t size);

/* Returns the size of the output report that must be sent now, or 0 if there is none. If the size
 * is not 0, the event thread owns `out_bytes` until usb_slot_sent(). */
uint32_t usb_slot_outgoing(struct usb_slot *seat);

/* Releases the output report, so that the frame loop may write the next one. */
void usb_slot_sent(struct usb_slot *seat);

/* ---- Functions for the frame loop --------------- */

/* Returns the port of the slot for poi_hid.h. */
struct hid_port usb_slot_port(struct usb_slot *seat);

#endif
