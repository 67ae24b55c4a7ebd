/* hid_port.c -- attaches controllers to a port, and passes reports in both directions. The report
 * queue is a ring buffer with two counters that only increase. */
#include "drivers/hid/hid_port.h"

#include <string.h>

_Static_assert((HID_REPORTS_MAX & (HID_REPORTS_MAX - 1u)) == 0u,
               "the counters wrap at a multiple of the queue's size");

void hid_port_init(struct hid_port *port, void (*wake)(void *self), void *wake_self)
{
    CORE_ASSERT(wake);
    memset(port, 0, sizeof *port);
    triple_buffer_init(&port->newest);
    triple_buffer_init(&port->overflow);
    port->wake = wake;
    port->wake_self = wake_self;
}

/* ---- Functions for the transport ------------------------------------------------------------- */

void hid_port_attach(struct hid_port *port, const struct hid_device_info *face)
{
    const uint32_t generation = atomic_load_explicit(&port->generation, memory_order_relaxed) + 1u;
    CORE_ASSERT(generation & 1u);
    CORE_ASSERT(face->descriptor_size <= HID_DESCRIPTOR_MAX);
    port->attachment[port->newest.writing] = (struct hid_attachment){ generation, *face };
    triple_buffer_post(&port->newest);
    atomic_store_explicit(&port->generation, generation, memory_order_release);
}

void hid_port_detach(struct hid_port *port)
{
    CORE_ASSERT(atomic_load_explicit(&port->generation, memory_order_relaxed) & 1u);
    atomic_fetch_add_explicit(&port->generation, 1u, memory_order_release);
}

void hid_port_report(struct hid_port *port, uint64_t now_ns, const uint8_t *bytes, uint32_t size)
{
    CORE_ASSERT(bytes || size == 0);
    if (size == 0u) {
        /* An empty packet, which some USB gadgets send, is not a report. */
        return;
    }
    if (size > HID_REPORT_MAX) {
        atomic_fetch_add_explicit(&port->lost, 1u, memory_order_relaxed);
        return;
    }
    const uint32_t pushed = atomic_load_explicit(&port->pushed, memory_order_relaxed);
    const uint32_t taken = atomic_load_explicit(&port->taken, memory_order_acquire);
    CORE_ASSERT(pushed - taken <= HID_REPORTS_MAX);
    const bool fits = pushed - taken < HID_REPORTS_MAX;
    struct hid_port_report *report =
        fits ? &port->queue[pushed % HID_REPORTS_MAX] : &port->late[port->overflow.writing];
    port->last_ns = now_ns > port->last_ns ? now_ns : port->last_ns;
    report->generation = atomic_load_explicit(&port->generation, memory_order_relaxed);
    report->number = port->next_number++;
    report->raw.time_ns = port->last_ns;
    report->raw.size = size;
    memcpy(report->raw.bytes, bytes, size);
    if (fits) {
        atomic_store_explicit(&port->pushed, pushed + 1u, memory_order_release);
    } else if (triple_buffer_post(&port->overflow)) {
        atomic_fetch_add_explicit(&port->lost, 1u, memory_order_relaxed);
    }
}

uint32_t hid_port_outgoing(struct hid_port *port)
{
    if (atomic_load_explicit(&port->outgoing, memory_order_acquire) != HID_PORT_OUT_READY) {
        return 0u;
    }
    if (port->out_generation != atomic_load_explicit(&port->generation, memory_order_relaxed)) {
        hid_port_sent(port); /* The output report was written for a previous controller and is not
                                sent. */
        return 0u;
    }
    atomic_store_explicit(&port->outgoing, HID_PORT_OUT_SUBMITTED, memory_order_relaxed);
    CORE_ASSERT(port->out_size >= 1 && port->out_size <= HID_REPORT_MAX);
    return port->out_size;
}

void hid_port_sent(struct hid_port *port)
{
    CORE_ASSERT(atomic_load_explicit(&port->outgoing, memory_order_relaxed) <=
                HID_PORT_OUT_SUBMITTED);
    atomic_store_explicit(&port->outgoing, HID_PORT_OUT_NONE, memory_order_release);
}

/* ---- Functions for the frame loop ------------------------------------------------------------ */

int hid_port_open(struct hid_port *port, struct hid_device_info *out)
{
    if (port->is_unusable) {
        return HAL_ERR_ABSENT;
    }
    const uint32_t generation = atomic_load_explicit(&port->generation, memory_order_acquire);
    triple_buffer_fetch(&port->newest);
    const struct hid_attachment *attachment = &port->attachment[port->newest.reading];
    if (!(generation & 1u) || attachment->generation != generation) {
        /* Opening fails, because no controller is attached, or because another controller was
         * attached during the call. */
        return HAL_ERR_GONE;
    }
    *out = attachment->face;
    port->opened = generation;
    return HAL_OK;
}

/* Returns the oldest report, or null if there is no report. The oldest report is either the first
 * report in the queue or the report in `late`. The queue is read before `late`. A report in `late`
 * that is older than the first queued report is then always found. After a new late report was
 * fetched, the queue is read again, because all reports that are older than the late report are in
 * the queue by then. */
static const struct hid_port_report *oldest_report(struct hid_port *port)
{
    const uint32_t taken = atomic_load_explicit(&port->taken, memory_order_relaxed);
    uint32_t pushed = atomic_load_explicit(&port->pushed, memory_order_acquire);
    if (!port->has_late && triple_buffer_fetch(&port->overflow)) {
        port->has_late = true;
        pushed = atomic_load_explicit(&port->pushed, memory_order_acquire);
    }
    const struct hid_port_report *first =
        taken == pushed ? NULL : &port->queue[taken % HID_REPORTS_MAX];
    const struct hid_port_report *late =
        port->has_late ? &port->late[port->overflow.reading] : NULL;
    port->is_late = late && (!first || (int32_t)(late->number - first->number) < 0);
    return port->is_late ? late : first;
}

int hid_port_take(struct hid_port *port, struct hid_raw *out)
{
    if (port->is_unusable) {
        return HAL_ERR_ABSENT;
    }
    /* The generation is read before the queue. If the opened controller was detached, all of its
     * reports are then already in the queue. */
    const uint32_t generation = atomic_load_explicit(&port->generation, memory_order_acquire);
    const struct hid_port_report *report;
    /* Removes the queued reports up to the generation of the opened controller. Reports of earlier
     * controllers are discarded. Reports of a later controller stay in the queue until the port is
     * opened again. */
    while ((report = oldest_report(port)) != NULL && report->generation <= port->opened) {
        const bool is_current = report->generation == port->opened;
        if (is_current) {
            out->time_ns = report->raw.time_ns;
            out->size = report->raw.size;
            memcpy(out->bytes, report->raw.bytes, report->raw.size);
        }
        if (port->is_late) {
            port->has_late = false;
        } else {
            const uint32_t taken = atomic_load_explicit(&port->taken, memory_order_relaxed);
            atomic_store_explicit(&port->taken, taken + 1u, memory_order_release);
        }
        if (is_current) {
            return 1;
        }
    }
    return port->opened != 0u && generation == port->opened ? 0 : HAL_ERR_GONE;
}

int hid_port_send(struct hid_port *port, const uint8_t *bytes, uint32_t size)
{
    const uint32_t generation = atomic_load_explicit(&port->generation, memory_order_acquire);
    if (port->opened == 0u || generation != port->opened) {
        return HAL_ERR_GONE;
    }
    if (size == 0u || size > HID_REPORT_MAX) {
        return HAL_ERR_IO;
    }
    if (atomic_load_explicit(&port->outgoing, memory_order_acquire) != HID_PORT_OUT_NONE) {
        return HAL_ERR_BUSY;
    }
    memcpy(port->out_bytes, bytes, size);
    port->out_size = size;
    port->out_generation = port->opened;
    atomic_store_explicit(&port->outgoing, HID_PORT_OUT_READY, memory_order_release);
    port->wake(port->wake_self);
    return HAL_OK;
}
