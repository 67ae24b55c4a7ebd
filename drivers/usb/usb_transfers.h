/* usb_transfers.h -- the USB transfers of one open controller.
 *
 * Used only by the event thread. libusb callbacks only record results and submit transfers
 * again. All requests to the device, and closing it, happen in usb_transfers_service(), outside of
 * the callbacks. Closing has a fixed order: cancel all transfers, wait until each has returned,
 * release the interface, close the handle. */
#ifndef KINGYO_DRIVERS_USB_USB_TRANSFERS_H
#define KINGYO_DRIVERS_USB_USB_TRANSFERS_H

#include <stdint.h>

#include <libusb.h>

#include "drivers/usb/usb_slot.h"

#define USB_IN_TRANSFER_COUNT 4u /* At 1,000 Hz the thread may be delayed by 3 ms without loss. */
#define USB_TRANSFER_MAX 1024u   /* Largest packet of an interrupt endpoint, USB 2.0 5.7.3. */
#define USB_ERRORS_MAX 8u        /* Consecutive errors before the device is opened again. */
/* Time after cancelling in which returning transfers still deliver reports. */
#define USB_DETACH_MS 50u
/* Timeout of an output report, after which force feedback would be late. */
#define USB_OUT_TIMEOUT_MS 100u

/* Endpoints of an interface and properties of its report descriptor. */
struct usb_pipe {
    uint8_t interface_number;
    uint8_t in_endpoint;
    uint8_t has_report_ids;
    uint8_t out_endpoint; /* 0: output reports use the control pipe, HID 1.11 7.2.2. */
    uint16_t in_packet_size;
    uint32_t report_size_max; /* Bytes of the longest input report, including its id. */
};

enum usb_transfers_state {
    USB_TRANSFERS_NONE = 0,
    USB_TRANSFERS_LIVE,     /* The device is open and its transfers are in use. */
    USB_TRANSFERS_DRAINING, /* The transfers are cancelled and some have not returned yet. */
};

struct usb_transfers;

struct usb_transfer_slot {
    struct usb_transfers *link;
    struct libusb_transfer *transfer;
    uint8_t is_submitted;
    uint8_t is_due; /* To be submitted again after an error or a halt. */
    uint8_t buffer[USB_TRANSFER_MAX];
};

struct usb_transfers {
    uint8_t state;        /* enum usb_transfers_state */
    uint8_t is_gone;      /* 1 if the device was unplugged and accepts no requests. */
    uint8_t has_halted;   /* 1 after the endpoint stalled. */
    uint8_t has_left;     /* 1 after the slot was detached. */
    uint32_t error_count; /* Number of consecutive errors. */
    uint64_t retry_ns;    /* Earliest time to submit transfers again. */
    uint64_t leave_ns;    /* Deadline for detaching the slot, even if transfers are in flight. */
    struct hal_clock clock;
    libusb_device_handle *handle;
    struct usb_slot *seat;
    struct usb_pipe pipe;
    struct usb_transfer_slot in[USB_IN_TRANSFER_COUNT];
    struct usb_transfer_slot out;
};

/* Allocates the transfers once. Returns 0, or -1 if there is no memory; usb_transfers_free() is
 * then still needed. */
int usb_transfers_init(struct usb_transfers *link, struct hal_clock clock);

/* Frees the transfers. No transfer may be in flight. */
void usb_transfers_free(struct usb_transfers *link);

/* Starts reading an open device whose interface is claimed. The link owns `handle` from now on.
 * `seat` must already be attached (usb_slot_attach()). */
void usb_transfers_begin(struct usb_transfers *link, libusb_device_handle *handle,
                         const struct usb_pipe *pipe, struct usb_slot *seat);

/* Sends the pending output report of the slot if the previous one is finished. */
void usb_transfers_send(struct usb_transfers *link);

/* Starts closing. `is_gone` means that the device was unplugged. The slot is detached when all
 * transfers have returned, or after USB_DETACH_MS. */
void usb_transfers_drain(struct usb_transfers *link, int is_gone);

/* Detaches the slot now, because another controller needs it. */
void usb_transfers_detach(struct usb_transfers *link);

/* Performs the actions that callbacks must not: submits again, clears a halt, and closes a
 * drained link. Returns 0, or 1 if the link failed and usb_transfers_drain() must follow. */
int usb_transfers_service(struct usb_transfers *link);

/* Returns when usb_transfers_service() must be called next, or UINT64_MAX if only an event requires
 * it. */
uint64_t usb_transfers_due_ns(const struct usb_transfers *link);

#endif
