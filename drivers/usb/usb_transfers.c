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
    for (uint32_t i = 0; i <= USB_IN_TRANSFER_COUNT; i++) {
        struct usb_transfer_slot *transfer_slot =
            i < USB_IN_TRANSFER_COUNT ? &link->in[i] : &link->out;
        transfer_slot->link = link;
        transfer_slot->transfer = libusb_alloc_transfer(0);
        error = transfer_slot->transfer ? error : -1;
    }
    return error;
}

void usb_transfers_free(struct usb_transfers *link)
{
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE);
    libusb_free_transfer(link->out.transfer);
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        libusb_free_transfer(link->in[i].transfer);
    }
}

/* ---- Transfers of input reports ------------------------------------------------------------- */

/* Records an error of a transfer. If the device was unplugged, only `is_gone` is set, because other
 * transfers and hot-plug events also report the unplugging. */
static void note_error(struct usb_transfers *link, int error)
{
    if (error == LIBUSB_ERROR_NO_DEVICE) {
        link->is_gone = 1;
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

/* Evaluates a returned transfer. Returns 1 if the transfer may be submitted again immediately,
 * otherwise 0. */
static int read_status(struct usb_transfers *link, const struct libusb_transfer *transfer)
{
    switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
        link->error_count = 0;
        usb_slot_report(link->seat, hal_now_ns(link->clock), transfer->buffer,
                        (uint32_t)transfer->actual_length);
        return 1;
    case LIBUSB_TRANSFER_OVERFLOW: /* The device sent more bytes than it declared; the report is
                                      lost. */
        usb_slot_report(link->seat, hal_now_ns(link->clock), transfer->buffer, HID_REPORT_MAX + 1u);
        note_error(link, LIBUSB_ERROR_OVERFLOW);
        return 0;
    case LIBUSB_TRANSFER_NO_DEVICE:
        note_error(link, LIBUSB_ERROR_NO_DEVICE);
        return 0;
    case LIBUSB_TRANSFER_STALL:
        link->has_halted = 1;
        note_error(link, LIBUSB_ERROR_PIPE);
        return 0;
    case LIBUSB_TRANSFER_CANCELLED: /* clear_halt() has cancelled the transfer. */
        return 0;
    default: /* A transmission error, which can also mean that the cable is being unplugged. */
        note_error(link, LIBUSB_ERROR_IO);
        return 0;
    }
}

static void LIBUSB_CALL on_report(struct libusb_transfer *transfer)
{
    CORE_ASSERT(transfer->user_data);
    struct usb_transfer_slot *transfer_slot = transfer->user_data;
    struct usb_transfers *link = transfer_slot->link;
    transfer_slot->is_submitted = 0;
    if (link->state != USB_TRANSFERS_LIVE) {
        /* The report of a transfer that completed while the link was closing is queued. Cancelled
         * transfers contain no report. */
        if (transfer->status == LIBUSB_TRANSFER_COMPLETED && !link->has_left) {
            usb_slot_report(link->seat, hal_now_ns(link->clock), transfer->buffer,
                            (uint32_t)transfer->actual_length);
        }
        return;
    }
    if (read_status(link, transfer) && !link->is_gone) {
        submit(transfer_slot);
    } else {
        transfer_slot->is_due = 1;
    }
}

void usb_transfers_begin(struct usb_transfers *link, libusb_device_handle *handle,
                         const struct usb_pipe *pipe, struct usb_slot *seat)
{
    /* The size of an input transfer is a multiple of the packet size, so that no packet overflows.
     * A transfer holds at most one report, so that no report waits for the next report. */
    const uint32_t packet = pipe->in_packet_size;
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE);
    CORE_ASSERT(packet >= 1 && packet <= USB_TRANSFER_MAX);
    const uint32_t packets =
        pipe->report_size_max ? (pipe->report_size_max + packet - 1u) / packet : 1u;
    const uint32_t size = packets <= USB_TRANSFER_MAX / packet ? packets * packet
                                                               : USB_TRANSFER_MAX / packet * packet;
    link->state = USB_TRANSFERS_LIVE;
    link->is_gone = link->has_halted = link->has_left = 0;
    link->error_count = 0;
    link->retry_ns = 0;
    link->handle = handle;
    link->pipe = *pipe;
    link->seat = seat;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        struct usb_transfer_slot *transfer_slot = &link->in[i];
        libusb_fill_interrupt_transfer(transfer_slot->transfer, handle, pipe->in_endpoint,
                                       transfer_slot->buffer, (int)size, on_report, transfer_slot,
                                       0);
        submit(transfer_slot);
    }
}

/* ---- Closing of a link ---------------------------------------------------------------------- */

/* Cancels a transfer. libusb returns NOT_FOUND if the transfer has just completed, which needs no
 * handling. */
static void cancel(struct usb_transfer_slot *transfer_slot)
{
    transfer_slot->is_due = 0;
    if (transfer_slot->is_submitted) {
        libusb_cancel_transfer(transfer_slot->transfer);
    }
}

void usb_transfers_drain(struct usb_transfers *link, int is_gone)
{
    if (link->state != USB_TRANSFERS_LIVE) {
        return;
    }
    link->state = USB_TRANSFERS_DRAINING;
    link->is_gone |= is_gone != 0;
    link->leave_ns = hal_now_ns(link->clock) + USB_DETACH_MS * 1000000ull;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        cancel(&link->in[i]);
    }
    cancel(&link->out);
}

void usb_transfers_detach(struct usb_transfers *link)
{
    CORE_ASSERT(link->state <= USB_TRANSFERS_DRAINING);
    if (link->state == USB_TRANSFERS_DRAINING && !link->has_left) {
        link->has_left = 1;
        usb_slot_detach(link->seat);
    }
}

static int is_submitted(const struct usb_transfers *link)
{
    int flying = link->out.is_submitted;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        flying |= link->in[i].is_submitted;
    }
    return flying;
}

/* Clears the halt of the input endpoint. If some input transfers have not returned yet, cancels
 * them and returns 0. Otherwise clears the halt and returns 1. */
static int clear_halt(struct usb_transfers *link)
{
    CORE_ASSERT(link->has_halted);
    CORE_ASSERT(link->state == USB_TRANSFERS_LIVE);
    int flying = 0;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        flying |= link->in[i].is_submitted;
        if (link->in[i].is_submitted) {
            libusb_cancel_transfer(link->in[i].transfer);
        }
    }
    if (flying) {
        return 0;
    }
    link->has_halted = 0;
    if (libusb_clear_halt(link->handle, link->pipe.in_endpoint) == LIBUSB_ERROR_NO_DEVICE) {
        link->is_gone = 1;
    }
    return 1;
}

static int has_due_transfer(const struct usb_transfers *link)
{
    int due = 0;
    for (uint32_t i = 0; i < USB_IN_TRANSFER_COUNT; i++) {
        due |= link->in[i].is_due;
    }
    return due;
}

int usb_transfers_service(struct usb_transfers *link)
{
    CORE_ASSERT(link->state == USB_TRANSFERS_NONE || link->handle);
    if (link->state == USB_TRANSFERS_DRAINING) {
        /* The slot is detached before the device is closed, because closing can take a long
         * time. */
        const int flying = is_submitted(link);
        if (!flying || hal_now_ns(link->clock) >= link->leave_ns) {
            usb_transfers_detach(link);
        }
        if (!flying) {
            /* Releasing the interface attaches the kernel driver again if there is one. */
            libusb_release_interface(link->handle, link->pipe.interface_number);
            libusb_close(link->handle);
            link->handle = NULL;
            link->state = USB_TRANSFERS_NONE;
        }
    }
    if (link->state != USB_TRANSFERS_LIVE) {
        return 0;
    }
    if (link->is_gone || link->error_count >= USB_ERRORS_MAX) {
        return 1;
    }
    if (has_due_transfer(link) && hal_now_ns(link->clock) >= link->retry_ns) {
        const int is_clear = !link->has_halted || clear_halt(link);
        for (uint32_t i = 0; is_clear && i < USB_IN_TRANSFER_COUNT && !link->is_gone; i++) {
            if (link->in[i].is_due) {
                submit(&link->in[i]);
            }
        }
    }
    return 0;
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
    transfer_slot->is_submitted = 0;
    if (transfer->status == LIBUSB_TRANSFER_NO_DEVICE) {
        transfer_slot->link->is_gone = 1;
    }
    /* An output report that could not be sent is not sent again, because the next report is
     * newer. */
    usb_slot_sent(transfer_slot->link->seat);
}

void usb_transfers_send(struct usb_transfers *link)
{
    struct usb_transfer_slot *out = &link->out;
    if (link->state != USB_TRANSFERS_LIVE || link->is_gone || out->is_submitted) {
        return;
    }
    const uint32_t size = usb_slot_outgoing(link->seat);
    if (size == 0u) {
        return;
    }
    if (link->pipe.out_endpoint) {
        memcpy(out->buffer, link->seat->out_bytes, size);
        libusb_fill_interrupt_transfer(out->transfer, link->handle, link->pipe.out_endpoint,
                                       out->buffer, (int)size, on_sent, out, USB_OUT_TIMEOUT_MS);
    } else {
        /* Devices without an output endpoint need a SET_REPORT request. */
        const uint8_t type =
            LIBUSB_ENDPOINT_OUT | LIBUSB_REQUEST_TYPE_CLASS | LIBUSB_RECIPIENT_INTERFACE;
        const uint8_t id = link->pipe.has_report_ids ? link->seat->out_bytes[0] : 0u;
        libusb_fill_control_setup(out->buffer, type, HID_SET_REPORT,
                                  (uint16_t)(HID_OUTPUT_REPORT | id), link->pipe.interface_number,
                                  (uint16_t)size);
        memcpy(out->buffer + LIBUSB_CONTROL_SETUP_SIZE, link->seat->out_bytes, size);
        libusb_fill_control_transfer(out->transfer, link->handle, out->buffer, on_sent, out,
                                     USB_OUT_TIMEOUT_MS);
    }
    out->is_submitted = libusb_submit_transfer(out->transfer) == LIBUSB_SUCCESS;
    if (!out->is_submitted) {
        usb_slot_sent(link->seat);
    }
}
