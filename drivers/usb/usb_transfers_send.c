/* usb_transfers_send.c -- sends the output reports of a controller, such as force feedback. */
#include <string.h>

#include "drivers/usb/usb_transfers.h"

#define HID_SET_REPORT 0x09u      /* Code of the request SET_REPORT (HID 1.11, section 7.2.2). */
#define HID_OUTPUT_REPORT 0x0200u /* Report type "output" in the upper byte of wValue. */

static void LIBUSB_CALL on_sent(struct libusb_transfer *transfer)
{
    struct usb_transfer_slot *transfer_slot = transfer->user_data;
    transfer_slot->is_submitted = 0;
    if (transfer->status == LIBUSB_TRANSFER_NO_DEVICE) {
        transfer_slot->link->is_gone = 1;
    }
    /* A lost report is not sent again, because the next report is newer. */
    usb_slot_sent(transfer_slot->link->seat);
}

/* Fills a SET_REPORT request, which devices without an output endpoint need. */
static void fill_set_report(struct usb_transfers *link, uint32_t size)
{
    struct usb_transfer_slot *out = &link->out;
    const uint8_t request_type =
        LIBUSB_ENDPOINT_OUT | LIBUSB_REQUEST_TYPE_CLASS | LIBUSB_RECIPIENT_INTERFACE;
    const uint8_t id = link->pipe.has_report_ids ? link->seat->out_bytes[0] : 0u;
    libusb_fill_control_setup(out->buffer, request_type, HID_SET_REPORT,
                              (uint16_t)(HID_OUTPUT_REPORT | id), link->pipe.interface_number,
                              (uint16_t)size);
    memcpy(out->buffer + LIBUSB_CONTROL_SETUP_SIZE, link->seat->out_bytes, size);
    libusb_fill_control_transfer(out->transfer, link->handle, out->buffer, on_sent, out,
                                 USB_OUT_TIMEOUT_MS);
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
        fill_set_report(link, size);
    }
    out->is_submitted = libusb_submit_transfer(out->transfer) == LIBUSB_SUCCESS;
    if (!out->is_submitted) {
        usb_slot_sent(link->seat);
    }
}
