/* usb_device.h -- a HID device on the USB bus: reads its identity, selects its best interface, and
 * opens it.
 *
 * Used only by the event thread. usb_device_open() can block on the device for a few seconds. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include <libusb.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_sysfs.h"
#include "drivers/usb/usb_transfers.h"

/* Fault that keeps a selected controller from playing. */
enum usb_device_fault {
    USB_FINE = 0,
    USB_DENIED, /* The kiosk has no permission to open the device. */
    USB_HELD,   /* Another program has claimed the interface. */
    USB_BROKEN, /* The device does not respond. */
    USB_AWAY,   /* The device was unplugged before it could be opened. */
};

struct usb_device {
    /* Counted reference to the libusb device. Null means that the table entry is empty. */
    libusb_device *device;
    uint8_t configuration;
    /* Indexes of the string descriptors. 0 means that the device has no such string. */
    uint8_t serial_index, product_index;
    bool is_boot; /* True if the interface supports the boot protocol. */
    /* True if the interface has the boot protocol of a keyboard. */
    bool is_boot_keyboard;
    uint32_t declared_size; /* Declared size of the report descriptor in bytes. */
    /* True if `face.descriptor` was read from the device, false if it was read from /sys. */
    bool is_read;
    uint8_t verdict; /* Decision whether the kiosk may claim the interface (enum usb_verdict). */
    uint8_t kind;    /* Kind of the interface (enum usb_kind). */
    uint8_t worth;   /* Score of the mapping, from hid_mapping_score(). */
    struct usb_pipe pipe;
    /* Identity and report descriptor. A descriptor_size of 0 means that the descriptor is not known
     * yet. */
    struct hid_device_info face;
};

/* Inputs of the classification in addition to the device. */
struct usb_evaluation {
    char sysfs[USB_SYSFS_PATH_SIZE]; /* Root of sysfs, usually "/sys". */
    struct usb_choice choice;        /* Rules of the operator. */
    struct hid_descriptor scratch;   /* Scratch memory for a parsed descriptor. */
};

/* Takes a reference to `device` and classifies it by data of the kernel, without opening it.
 * Returns 0, or -1 if the device has no usable HID interface. */
int usb_device_add(struct usb_device *out, libusb_device *device,
                   struct usb_evaluation *evaluation);

/* Classifies the device again, because a kernel driver may have bound the device or the rules may
 * have changed. */
void usb_device_refresh(struct usb_device *device, struct usb_evaluation *evaluation);

/* Opens the device, claims the interface, reads its report descriptor and selects the report
 * protocol. The verdict must be USB_ASK or USB_PLAYS. Returns USB_FINE and sets `*out` to the
 * handle, or returns the reason of the failure. If the new verdict is not USB_PLAYS, the result is
 * USB_FINE and `*out` is null. */
enum usb_device_fault usb_device_open(struct usb_device *device, struct usb_evaluation *evaluation,
                                      libusb_device_handle **out);

/* Releases the reference to the libusb device that usb_device_add() took. */
void usb_device_remove(struct usb_device *device);
