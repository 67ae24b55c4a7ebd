/* usb_link.h -- one open controller: transfers that are in flight until they are told not to be.
 *
 * Of the USB thread alone. Callbacks of libusb only note what happened and ask again; whatever
 * talks to the device, or closes it, is done by usb_link_tend(), outside of them. A link is closed
 * in this order: cancel, wait for every transfer to come back, release, close. */
#ifndef KINGYO_DRIVERS_USB_LINK_H
#define KINGYO_DRIVERS_USB_LINK_H

#include <stdint.h>

#include <libusb.h>

#include "drivers/usb_seat.h"

#define USB_IN_FLIGHT 4u      /* At 1,000 Hz the thread may sleep 3 ms and lose nothing. */
#define USB_TRANSFER_MAX 1024u /* No packet of an interrupt endpoint is longer, USB 2.0 5.7.3. */
#define USB_ERRORS_MAX 8u     /* In a row, before it is opened anew. */
#define USB_LEAVE_MS 50u      /* So long what is on its way back may still bring a report. */
#define USB_OUT_TIMEOUT_MS 100u /* Who does not take a blow by then shall not feel it. */

/* What an endpoint descriptor says, and the report descriptor. */
struct usb_pipe {
    uint8_t interface_number;
    uint8_t in_endpoint;
    uint8_t has_report_ids;
    uint8_t out_endpoint;     /* 0: output reports go by the control pipe, HID 1.11 7.2.2. */
    uint16_t in_packet_size;
    uint32_t report_size_max; /* Of the longest input report, its id included. */
};

enum usb_link_state {
    USB_LINK_NONE = 0,
    USB_LINK_LIVE,
    USB_LINK_DRAINING, /* Cancelled; transfers are still to come back. */
};

struct usb_link;

struct usb_flight {
    struct usb_link *link;
    struct libusb_transfer *transfer;
    uint8_t is_flying;
    uint8_t is_due; /* To be submitted again: it failed, or its endpoint halted. */
    uint8_t buffer[USB_TRANSFER_MAX];
};

struct usb_link {
    uint8_t state;       /* enum usb_link_state */
    uint8_t is_gone;     /* The device is unplugged: nothing can be asked of it. */
    uint8_t has_halted;  /* The endpoint stalled. */
    uint8_t has_left;    /* Its seat was told that it is gone. */
    uint32_t error_count; /* In a row. */
    uint64_t retry_ns;   /* When what is due may be submitted again. */
    uint64_t leave_ns;   /* When its seat is told, although something still flies. */
    struct hal_clock clock;
    libusb_device_handle *handle;
    struct usb_seat *seat;
    struct usb_pipe pipe;
    struct usb_flight in[USB_IN_FLIGHT];
    struct usb_flight out;
};

/* Takes memory for its transfers, once. 0, or -1 where there is none. */
int usb_link_init(struct usb_link *link, struct hal_clock clock);
void usb_link_free(struct usb_link *link);

/* Begins to read an open device, whose interface is claimed; `handle` is the link's from now on.
 * Who sits in `seat` was told to it before. */
void usb_link_begin(struct usb_link *link, libusb_device_handle *handle,
                    const struct usb_pipe *pipe, struct usb_seat *seat);

/* Sends what the seat wants sent, if the last one is done. */
void usb_link_send(struct usb_link *link);

/* Begins the end of it. `is_gone`: it was unplugged. Its seat is told when all that it reported has
 * arrived, or USB_LEAVE_MS later. */
void usb_link_drain(struct usb_link *link, int is_gone);

/* Tells its seat now, for somebody else wants to sit there. */
void usb_link_leave(struct usb_link *link);

/* Does what callbacks may not: submits again, clears a halt, closes what has drained. 0: it lives;
 * 1: it failed, and usb_link_drain() is right. */
int usb_link_tend(struct usb_link *link);

/* When usb_link_tend() has something to do although nothing happens; UINT64_MAX: never. */
uint64_t usb_link_due_ns(const struct usb_link *link);

#endif
