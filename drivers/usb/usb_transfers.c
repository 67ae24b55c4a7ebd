/* usb_transfers.c -- submits and completes the transfers of one controller, and sends its output
 * reports, such as force feedback. */
#include "drivers/usb/usb_transfers.h"

#include <string.h>

#include "core/base/panic.h"

/* Delay in ns after an error before transfers are submitted again. The delay is longer than a
 * glitch on the cable. */
#define RETRY_NS 10000000ull

/* ---- Allocation of transfers ---------------------------------------------------------------- */

int usb_transfers_init(struct usb_transfers *link, struct hal_clock clock)
{
    memset(link, 0, sizeof *link);
    link->clock = clock;
    int error = 0;
    for (uint32_t i = 0; i < USB_TRANSFER_COUNT; i++) {
        link->transfer[i].link = link;
        link->transfer[i].transfer = libusb_alloc_transfer(0);
        error = link->transfer[i].transfer ? error : -1;
    }
    return error;
}

void usb_transfers_free(struct usb_transfers *link)
{
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE);
    for (uint32_t i = 0; i < USB_TRANSFER_COUNT; i++) {
        libusb_free_transfer(link->transfer[i].transfer);
    }
}

/* ---- Transfers of input reports ------------------------------------------------------------- */

/* Records an error of a transfer. If the device was unplugged, only `is_gone` is set, because other
 * transfers and hot-plug events also report the unplugging. */
static void note_error(struct usb_transfers *link, int error)
{
    if (error == LIBUSB_ERROR_NO_DEVICE) {
        link->is_gone = true;
        return;
    }
    link->error_count++;
    link->retry_ns = hal_now_ns(link->clock) + RETRY_NS;
}

static void submit(struct usb_transfer_slot *transfer_slot)
{
    CORE_ASSERT(!transfer_slot->is_submitted);
    CORE_ASSERT(transfer_slot->link->state == USB_TRANSFERS_LIVE);
    const int error = libusb_submit_transfer(transfer_slot->transfer);
    transfer_slot->is_submitted = error == LIBUSB_SUCCESS;
    transfer_slot->is_due = error != LIBUSB_SUCCESS;
    if (error) {
        note_error(transfer_slot->link, error);
    }
}

/* Queues the report of a completed transfer. */
static void queue_report(struct usb_transfers *link, const struct libusb_transfer *transfer)
{
    hid_port_report(link->port, hal_now_ns(link->clock), transfer->buffer,
                    (uint32_t)transfer->actual_length);
}

/* Evaluates the status of a returned transfer. Returns true if the transfer may be submitted again
 * immediately. */
static bool read_status(struct usb_transfers *link, const struct libusb_transfer *transfer)
{
    switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
        link->error_count = 0;
        queue_report(link, transfer);
        return true;
    /* The device sent more bytes than its descriptors declare. The report is counted as lost,
     * because it is too long. */
    case LIBUSB_TRANSFER_OVERFLOW:
        hid_port_report(link->port, hal_now_ns(link->clock), transfer->buffer, HID_REPORT_MAX + 1u);
        note_error(link, LIBUSB_ERROR_OVERFLOW);
        return false;
    case LIBUSB_TRANSFER_NO_DEVICE:
        note_error(link, LIBUSB_ERROR_NO_DEVICE);
        return false;
    case LIBUSB_TRANSFER_STALL:
        link->has_halted = true;
        note_error(link, LIBUSB_ERROR_PIPE);
        return false;
    case LIBUSB_TRANSFER_CANCELLED: /* The transfer was cancelled by clear_halt(). */
        return false;
    /* Any other status is a transmission error. The cause may be that the cable is being
     * unplugged. */
    default:
        note_error(link, LIBUSB_ERROR_IO);
        return false;
    }
}

static void LIBUSB_CALL on_report(struct libusb_transfer *transfer)
{
    CORE_ASSERT(transfer->user_data);
    struct usb_transfer_slot *transfer_slot = transfer->user_data;
    struct usb_transfers *link = transfer_slot->link;
    transfer_slot->is_submitted = false;
    if (link->state != USB_TRANSFERS_LIVE) {
        /* A transfer may have completed while the link was closing. Its report is queued. Cancelled
         * transfers contain no report. */
        if (transfer->status == LIBUSB_TRANSFER_COMPLETED && !link->has_left) {
            queue_report(link, transfer);
        }
        return;
    }
    if (read_status(link, transfer) && !link->is_gone) {
        submit(transfer_slot);
    } else {
        transfer_slot->is_due = true;
    }
}

void usb_transfers_begin(struct usb_transfers *link, libusb_device_handle *handle,
                         const struct usb_pipe *pipe, struct hid_port *port)
{
    /* The size of an input transfer is a multiple of the packet size, so that no packet overflows.
     * A transfer has only the packets of one report, so that each report is delivered as soon as it
     * has arrived. */
    const uint32_t packet = pipe->in_packet_size;
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE);
    CORE_ASSERT(packet >= 1 && packet <= USB_TRANSFER_MAX);
    const uint32_t packets =
        pipe->report_size_max ? (pipe->report_size_max + packet - 1u) / packet : 1u;
    const uint32_t size = packets <= USB_TRANSFER_MAX / packet ? packets * packet
                                                               : USB_TRANSFER_MAX / packet * packet;
    link->state = USB_TRANSFERS_LIVE;
    link->is_gone = link->has_halted = link->has_left = false;
    link->error_count = 0;
    link->retry_ns = 0;
    link->handle = handle;
    link->pipe = *pipe;
    link->port = port;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        struct usb_transfer_slot *transfer_slot = &link->transfer[i];
        libusb_fill_interrupt_transfer(transfer_slot->transfer, handle, pipe->in_endpoint,
                                       transfer_slot->buffer, (int)size, on_report, transfer_slot,
                                       0);
        submit(transfer_slot);
    }
}

/* ---- Closing of a link ---------------------------------------------------------------------- */

/* Cancels the first `count` transfers. libusb returns NOT_FOUND if a transfer has just completed,
 * which needs no handling. Returns true if at least one of the transfers has not returned yet. */
static bool cancel(struct usb_transfers *link, uint32_t count)
{
    bool is_pending = false;
    CORE_ASSERT(count <= USB_TRANSFER_COUNT);
    for (uint32_t i = 0; i < count; i++) {
        if (link->transfer[i].is_submitted) {
            libusb_cancel_transfer(link->transfer[i].transfer);
            is_pending = true;
        }
    }
    return is_pending;
}

void usb_transfers_drain(struct usb_transfers *link, bool is_gone)
{
    if (link->state != USB_TRANSFERS_LIVE) {
        return;
    }
    link->state = USB_TRANSFERS_DRAINING;
    link->is_gone |= is_gone;
    link->leave_ns = hal_now_ns(link->clock) + USB_DETACH_MS * 1000000ull;
    cancel(link, USB_TRANSFER_COUNT);
}

void usb_transfers_detach(struct usb_transfers *link)
{
    CORE_ASSERT(link->state <= USB_TRANSFERS_DRAINING);
    if (link->state == USB_TRANSFERS_DRAINING && !link->has_left) {
        link->has_left = true;
        hid_port_detach(link->port);
    }
}

/* Clears the halt of the input endpoint. If some input transfers have not returned yet, cancels
 * these transfers and returns false. Otherwise clears the halt and returns true. */
static bool clear_halt(struct usb_transfers *link)
{
    CORE_ASSERT(link->has_halted);
    CORE_ASSERT(link->state == USB_TRANSFERS_LIVE);
    if (cancel(link, USB_IN_TRANSFER_COUNT)) {
        return false;
    }
    link->has_halted = false;
    link->is_gone |=
        libusb_clear_halt(link->handle, link->pipe.in_endpoint) == LIBUSB_ERROR_NO_DEVICE;
    return true;
}

static bool has_due_transfer(const struct usb_transfers *link)
{
    bool is_due = false;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        is_due |= link->transfer[i].is_due;
    }
    return is_due;
}

bool usb_transfers_service(struct usb_transfers *link)
{
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE || link->handle);
    if (link->state == USB_TRANSFERS_DRAINING) {
        /* The controller is detached from its port before the device is closed, because closing can
         * take a long time. */
        bool is_pending = false;
        for (uint32_t i = 0; i < USB_TRANSFER_COUNT; i++) {
            is_pending |= link->transfer[i].is_submitted;
        }
        if (!is_pending || hal_now_ns(link->clock) >= link->leave_ns) {
            usb_transfers_detach(link);
        }
        if (!is_pending) {
            /* Releasing the interface attaches the kernel driver again if there is one. */
            libusb_release_interface(link->handle, link->pipe.interface_number);
            libusb_close(link->handle);
            link->handle = NULL;
            link->state = USB_TRANSFERS_NONE;
        }
    }
    if (link->state != USB_TRANSFERS_LIVE) {
        return false;
    }
    if (link->is_gone || link->error_count >= USB_ERRORS_MAX) {
        return true;
    }
    if (has_due_transfer(link) && hal_now_ns(link->clock) >= link->retry_ns) {
        const bool is_clear = !link->has_halted || clear_halt(link);
        for (uint32_t i = 0; is_clear && i < USB_IN_TRANSFER_COUNT && !link->is_gone; i++) {
            if (link->transfer[i].is_due) {
                submit(&link->transfer[i]);
            }
        }
    }
    return false;
}

uint64_t usb_transfers_due_ns(const struct usb_transfers *link)
{
    if (link->state == USB_TRANSFERS_DRAINING && !link->has_left) {
        return link->leave_ns;
    }
    return link->state == USB_TRANSFERS_LIVE && has_due_transfer(link) ? link->retry_ns
                                                                       : UINT64_MAX;
}

/* ---- Output reports -------------------------------------------------------------------------- */

#define HID_SET_REPORT 0x09u      /* Code of the request SET_REPORT (HID 1.11, section 7.2.2). */
#define HID_OUTPUT_REPORT 0x0200u /* Report type "output" in the upper byte of wValue. */

static void LIBUSB_CALL on_sent(struct libusb_transfer *transfer)
{
    CORE_ASSERT(transfer->user_data);
    struct usb_transfer_slot *transfer_slot = transfer->user_data;
    transfer_slot->is_submitted = false;
    transfer_slot->link->is_gone |= transfer->status == LIBUSB_TRANSFER_NO_DEVICE;
    /* A failed output report is not sent again, because the next report will have newer content. */
    hid_port_sent(transfer_slot->link->port);
}

void usb_transfers_send(struct usb_transfers *link)
{
    struct usb_transfer_slot *out = &link->transfer[USB_OUT_TRANSFER];
    if (link->state != USB_TRANSFERS_LIVE || link->is_gone || out->is_submitted) {
        return;
    }
    const uint32_t size = hid_port_outgoing(link->port);
    if (size == 0u) {
        return;
    }
    if (link->pipe.out_endpoint) {
        memcpy(out->buffer, link->port->out_bytes, size);
        libusb_fill_interrupt_transfer(out->transfer, link->handle, link->pipe.out_endpoint,
                                       out->buffer, (int)size, on_sent, out, USB_OUT_TIMEOUT_MS);
    } else {
        /* Devices without an output endpoint need a SET_REPORT request. */
        const uint8_t type =
            LIBUSB_ENDPOINT_OUT | LIBUSB_REQUEST_TYPE_CLASS | LIBUSB_RECIPIENT_INTERFACE;
        const uint8_t id = link->pipe.has_report_ids ? link->port->out_bytes[0] : 0u;
        libusb_fill_control_setup(out->buffer, type, HID_SET_REPORT,
                                  (uint16_t)(HID_OUTPUT_REPORT | id), link->pipe.interface_number,
                                  (uint16_t)size);
        memcpy(out->buffer + LIBUSB_CONTROL_SETUP_SIZE, link->port->out_bytes, size);
        libusb_fill_control_transfer(out->transfer, link->handle, out->buffer, on_sent, out,
                                     USB_OUT_TIMEOUT_MS);
    }
    out->is_submitted = libusb_submit_transfer(out->transfer) == LIBUSB_SUCCESS;
    if (!out->is_submitted) {
        hid_port_sent(link->port);
    }
}
