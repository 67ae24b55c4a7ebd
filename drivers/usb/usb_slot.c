/* usb_slot.c -- attaches controllers to a slot, and passes reports in both directions. The report
 * queue is a ring buffer with two counters that only increase. */
#include "drivers/usb/usb_slot.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

/* ---- Report queue ---------------------------------------------------------------------------- */

_Static_assert((HID_REPORTS_MAX & (HID_REPORTS_MAX - 1u)) == 0u,
               "the counters wrap at a multiple of the slots");

void usb_ring_init(struct usb_ring *ring)
{
    memset(ring, 0, sizeof *ring);
    triple_buffer_init(&ring->mail);
}

int usb_ring_push(struct usb_ring *ring, uint32_t generation, uint64_t time_ns,
                  const uint8_t *bytes, uint32_t size)
{
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_relaxed);
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_acquire);
    CORE_ASSERT(size >= 1 && size <= HID_REPORT_MAX);
    CORE_ASSERT(pushed - taken <= HID_REPORTS_MAX);
    const int fits = pushed - taken < HID_REPORTS_MAX;
    struct usb_ring_slot *slot =
        fits ? &ring->slot[pushed % HID_REPORTS_MAX] : &ring->late[ring->mail.writing];
    slot->generation = generation;
    slot->number = ring->next_number++;
    slot->raw.time_ns = time_ns;
    slot->raw.size = size;
    memcpy(slot->raw.bytes, bytes, size);
    if (fits) {
        atomic_store_explicit(&ring->pushed, pushed + 1u, memory_order_release);
    } else if (triple_buffer_post(&ring->mail)) {
        usb_ring_lose(ring);
    }
    return fits;
}

void usb_ring_lose(struct usb_ring *ring)
{
    atomic_fetch_add_explicit(&ring->lost, 1u, memory_order_relaxed);
}

/* Returns the older of two reports: the next report in the queue, and the report in the late
 * buffer. The queue is read first, so that a late report that was posted before a push is seen. */
const struct usb_ring_slot *usb_ring_peek(struct usb_ring *ring)
{
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    const uint32_t pushed = atomic_load_explicit(&ring->pushed, memory_order_acquire);
    const struct usb_ring_slot *slot =
        taken == pushed ? NULL : &ring->slot[taken % HID_REPORTS_MAX];
    ring->has_late = ring->has_late || triple_buffer_fetch(&ring->mail);
    const struct usb_ring_slot *late = ring->has_late ? &ring->late[ring->mail.reading] : NULL;
    ring->is_late = late && (!slot || (int32_t)(late->number - slot->number) < 0);
    return ring->is_late ? late : slot;
}

void usb_ring_drop(struct usb_ring *ring)
{
    CORE_ASSERT(!ring->is_late || ring->has_late);
    if (ring->is_late) {
        ring->has_late = 0;
        return;
    }
    const uint32_t taken = atomic_load_explicit(&ring->taken, memory_order_relaxed);
    atomic_store_explicit(&ring->taken, taken + 1u, memory_order_release);
}

uint32_t usb_ring_lost(const struct usb_ring *ring)
{
    return atomic_load_explicit(&ring->lost, memory_order_relaxed);
}

/* ---- Slot ------------------------------------------------------------------------------------ */

void usb_slot_init(struct usb_slot *seat, void (*wake)(void *self), void *wake_self)
{
    CORE_ASSERT(wake);
    memset(seat, 0, sizeof *seat);
    usb_ring_init(&seat->ring);
    triple_buffer_init(&seat->mail);
    seat->wake = wake;
    seat->wake_self = wake_self;
}

/* ---- Functions for the event thread --------------------------------------------------------- */

void usb_slot_attach(struct usb_slot *seat, const struct hid_device_info *face)
{
    CORE_ASSERT(!(atomic_load_explicit(&seat->generation, memory_order_relaxed) & 1u));
    CORE_ASSERT(face->descriptor_size <= HID_DESCRIPTOR_MAX);
    const uint32_t generation = atomic_load_explicit(&seat->generation, memory_order_relaxed) + 1u;
    struct usb_attachment *attachment = &seat->attachment[seat->mail.writing];
    attachment->generation = generation;
    attachment->face = *face;
    triple_buffer_post(&seat->mail);
    atomic_store_explicit(&seat->generation, generation, memory_order_release);
}

void usb_slot_detach(struct usb_slot *seat)
{
    CORE_ASSERT(atomic_load_explicit(&seat->generation, memory_order_relaxed) & 1u);
    atomic_fetch_add_explicit(&seat->generation, 1u, memory_order_release);
}

void usb_slot_report(struct usb_slot *seat, uint64_t now_ns, const uint8_t *bytes, uint32_t size)
{
    CORE_ASSERT(bytes || size == 0);
    if (size == 0u) {
        return; /* An empty packet of a USB gadget is not a report. */
    }
    if (size > HID_REPORT_MAX) {
        usb_ring_lose(&seat->ring);
        return;
    }
    seat->last_ns = now_ns > seat->last_ns ? now_ns : seat->last_ns;
    usb_ring_push(&seat->ring, atomic_load_explicit(&seat->generation, memory_order_relaxed),
                  seat->last_ns, bytes, size);
}

uint32_t usb_slot_outgoing(struct usb_slot *seat)
{
    if (atomic_load_explicit(&seat->outgoing, memory_order_acquire) != USB_OUT_READY) {
        return 0u;
    }
    if (seat->out_generation != atomic_load_explicit(&seat->generation, memory_order_relaxed)) {
        usb_slot_sent(seat); /* The output report was written for a previous controller and is not
                                sent. */
        return 0u;
    }
    atomic_store_explicit(&seat->outgoing, USB_OUT_SUBMITTED, memory_order_relaxed);
    CORE_ASSERT(seat->out_size >= 1 && seat->out_size <= HID_REPORT_MAX);
    return seat->out_size;
}

void usb_slot_sent(struct usb_slot *seat)
{
    CORE_ASSERT(atomic_load_explicit(&seat->outgoing, memory_order_relaxed) <= USB_OUT_SUBMITTED);
    atomic_store_explicit(&seat->outgoing, USB_OUT_NONE, memory_order_release);
}

/* ---- Functions for the frame loop ----------------------------------------------------------- */

static uint32_t generation_now(struct usb_slot *seat)
{
    return atomic_load_explicit(&seat->generation, memory_order_acquire);
}

static int port_open(void *self, struct hid_device_info *out)
{
    struct usb_slot *seat = self;
    if (seat->is_never) {
        return HAL_ERR_ABSENT;
    }
    const uint32_t generation = generation_now(seat);
    triple_buffer_fetch(&seat->mail);
    const struct usb_attachment *attachment = &seat->attachment[seat->mail.reading];
    if (!(generation & 1u) || attachment->generation != generation) {
        return HAL_ERR_GONE; /* No controller is attached, or the attached controller changed during
                                the call. */
    }
    *out = attachment->face;
    seat->opened = generation;
    seat->identity = attachment->face.identity;
    return HAL_OK;
}

static int port_take(void *self, struct hid_raw *out)
{
    struct usb_slot *seat = self;
    if (seat->is_never) {
        return HAL_ERR_ABSENT;
    }
    /* The generation is read before the queue. If the opened controller was detached, all of its
     * reports are then already in the queue. */
    const uint32_t generation = generation_now(seat);
    const struct usb_ring_slot *slot = usb_ring_peek(&seat->ring);
    while (slot && slot->generation < seat->opened) { /* A report of an earlier controller is
                                                         removed. */
        usb_ring_drop(&seat->ring);
        slot = usb_ring_peek(&seat->ring);
    }
    if (slot && slot->generation == seat->opened) {
        out->time_ns = slot->raw.time_ns;
        out->size = slot->raw.size;
        memcpy(out->bytes, slot->raw.bytes, slot->raw.size);
        usb_ring_drop(&seat->ring);
        return 1;
    }
    return seat->opened != 0u && generation == seat->opened ? 0 : HAL_ERR_GONE;
}

static int port_send(void *self, const uint8_t *bytes, uint32_t size)
{
    struct usb_slot *seat = self;
    if (seat->opened == 0u || generation_now(seat) != seat->opened) {
        return HAL_ERR_GONE;
    }
    if (size == 0u || size > HID_REPORT_MAX) {
        return HAL_ERR_IO;
    }
    if (atomic_load_explicit(&seat->outgoing, memory_order_acquire) != USB_OUT_NONE) {
        return HAL_ERR_BUSY;
    }
    memcpy(seat->out_bytes, bytes, size);
    seat->out_size = size;
    seat->out_generation = seat->opened;
    atomic_store_explicit(&seat->outgoing, USB_OUT_READY, memory_order_release);
    seat->wake(seat->wake_self);
    return HAL_OK;
}

static uint32_t port_lost_count(void *self)
{
    return usb_ring_lost(&((struct usb_slot *)self)->ring);
}

static const char *port_describe(void *self)
{
    struct usb_slot *seat = self;
    const struct hid_identity *who = &seat->identity;
    if (seat->opened == 0u || generation_now(seat) != seat->opened) {
        snprintf(seat->text, sizeof seat->text, "no controller on USB yet");
    } else {
        snprintf(seat->text, sizeof seat->text, "%04x:%04x %.60s (USB port %s)", who->vendor,
                 who->product, who->name, who->port);
    }
    return seat->text;
}

struct hid_port usb_slot_port(struct usb_slot *seat)
{
    static const struct hid_port_ops ops = {
        .open = port_open,
        .take = port_take,
        .send = port_send,
        .lost_count = port_lost_count,
        .describe = port_describe,
    };
    return (struct hid_port){ .ops = &ops, .self = seat };
}
