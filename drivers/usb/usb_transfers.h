/* usb_transfers.h -- a link: the USB transfers of one open controller.
 *
 * Used only by the event thread. The callbacks of libusb only record results and submit transfers
 * again. usb_transfers_service() sends all requests to the device and closes it, outside of the
 * callbacks. Closing has a fixed order: cancel all transfers, wait until each has returned, release
 * the interface, close the handle. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include <libusb.h>

#include "drivers/hid/hid_port.h"

/* Number of input transfers. At 1,000 reports per second the thread may be delayed by 3 ms without
 * loss. */
#define USB_IN_TRANSFER_COUNT 4u
/* Index of the transfer for output reports, after the input transfers. */
#define USB_OUT_TRANSFER USB_IN_TRANSFER_COUNT
#define USB_TRANSFER_COUNT (USB_IN_TRANSFER_COUNT + 1u)
/* Largest packet of an interrupt endpoint in bytes (USB 2.0, section 5.7.3). */
#define USB_TRANSFER_MAX 1024u
/* After this number of consecutive transfer errors, the device is closed and opened again. */
#define USB_ERRORS_MAX 8u
/* Longest time in ms between the cancellation of the transfers and the detachment of the
 * controller. Transfers that return within this time still deliver their reports. */
#define USB_DETACH_MS 50u
/* Timeout of an output report in ms. After a longer time the player would feel the force feedback
 * too late. */
#define USB_OUT_TIMEOUT_MS 100u

/* Endpoints of an interface, and properties of its report descriptor. */
struct usb_pipe {
    uint8_t interface_number;
    uint8_t in_endpoint;
    bool has_report_ids;
    /* Address of the output endpoint. 0 means that there is no output endpoint and output reports
     * use the control pipe (HID 1.11, section 7.2.2). */
    uint8_t out_endpoint;
    uint16_t in_packet_size;
    uint32_t report_size_max; /* Size of the longest input report in bytes, including its id. */
};

enum usb_transfers_state {
    USB_TRANSFERS_NONE = 0,
    USB_TRANSFERS_LIVE, /* The device is open, and its transfers are in use. */
    /* The transfers are cancelled, and some of them have not returned yet. */
    USB_TRANSFERS_DRAINING,
};

struct usb_transfers;

struct usb_transfer_slot {
    struct usb_transfers *link;
    struct libusb_transfer *transfer;
    bool is_submitted;
    bool is_due; /* True if the transfer must be submitted again after an error or a halt. */
    uint8_t buffer[USB_TRANSFER_MAX];
};

struct usb_transfers {
    uint8_t state;        /* State of the link (enum usb_transfers_state). */
    bool is_gone;         /* True if the device was unplugged and accepts no requests. */
    bool has_halted;      /* True if the input endpoint stalled and must be cleared. */
    bool has_left;        /* True if the controller was already detached from its port. */
    uint32_t error_count; /* Number of consecutive transfer errors. */
    uint64_t retry_ns;    /* Earliest time at which transfers are submitted again. */
    /* Time at which the controller is detached from its port even if some transfers have not
     * returned. */
    uint64_t leave_ns;
    struct hal_clock clock;
    libusb_device_handle *handle;
    struct hid_port *port; /* Port of the controller's slot, owned by the event thread. */
    struct usb_pipe pipe;
    struct usb_transfer_slot
        transfer[USB_TRANSFER_COUNT]; /* Input transfers, and the output transfer at
                                         USB_OUT_TRANSFER. */
};

/* Allocates the transfers, which are reused for each device. Returns 0, or -1 if there is no
 * memory. After -1, usb_transfers_free() must still be called. */
int usb_transfers_init(struct usb_transfers *link, struct hal_clock clock);

/* Frees the transfers. All transfers must have returned. */
void usb_transfers_free(struct usb_transfers *link);

/* Starts reading an open device whose interface is claimed. The link owns `handle` from then on.
 * A controller must already be attached to `port` (hid_port_attach()). */
void usb_transfers_begin(struct usb_transfers *link, libusb_device_handle *handle,
                         const struct usb_pipe *pipe, struct hid_port *port);

/* Sends the pending output report of the port, unless the previous output report is still being
 * sent. */
void usb_transfers_send(struct usb_transfers *link);

/* Starts closing the link. `is_gone` is true if the device was unplugged. The controller is
 * detached from its port when all transfers have returned, or USB_DETACH_MS after this call at the
 * latest. */
void usb_transfers_drain(struct usb_transfers *link, bool is_gone);

/* Detaches the controller from its port immediately if the link is closing. Called when another
 * controller needs the port. */
void usb_transfers_detach(struct usb_transfers *link);

/* Performs the actions that are forbidden in callbacks: submits transfers again, clears a halt, and
 * closes a link whose transfers have returned. Returns true if the link failed. After true, the
 * caller must call usb_transfers_drain(). */
bool usb_transfers_service(struct usb_transfers *link);

/* Returns the time at which usb_transfers_service() must be called next. Returns UINT64_MAX if no
 * call is needed before the next event of libusb. */
uint64_t usb_transfers_due_ns(const struct usb_transfers *link);
