/* usb_device.h -- a HID device on the USB bus: reads its identity, selects its best interface, and
 * opens it.
 *
 * Used only by the event thread. usb_device_open() can block on the device for a few seconds. */
#ifndef KINGYO_DRIVERS_USB_USB_DEVICE_H
#define KINGYO_DRIVERS_USB_USB_DEVICE_H

#include <stdint.h>

#include <libusb.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/usb/usb_choice.h"
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
    libusb_device *device; /* Counted reference to the libusb device; null if the table entry is
                              empty. */
    uint8_t configuration;
    uint8_t serial_index, product_index; /* Indexes of the string descriptors; 0 means that the
                                            device has no such string. */
    uint8_t is_boot;                     /* 1 if the interface supports the boot protocol, otherwise
                                            0. */
    uint8_t is_boot_keyboard;            /* 1 if the interface has the boot protocol of a keyboard,
                                            otherwise 0. */
    uint32_t declared_size;              /* Declared size of the report descriptor in bytes. */
    uint8_t is_read; /* 1 if `face.descriptor` was read from the device itself, 0 if it was read
                        from /sys. */
    uint8_t verdict; /* Decision whether the kiosk may claim the interface (enum usb_verdict). */
    uint8_t kind;    /* Kind of the interface (enum usb_kind). */
    uint8_t worth;   /* Score of the mapping, from hid_mapping_score(). */
    struct usb_pipe pipe;
    struct hid_device_info face; /* Identity and report descriptor. A descriptor_size of 0 means
                                    that the descriptor is not known yet. */
};

/* Inputs of the classification in addition to the device: the root of sysfs, the rules of the
 * operator, and scratch memory for a parsed descriptor. */
struct usb_evaluation {
    const char *sysfs;
    const struct usb_choice *choice;
    struct hid_descriptor *scratch;
};

/* Takes a reference to `device` and classifies it by data of the kernel, without opening it.
 * Returns 0, or -1 if the device has no usable HID interface. */
int usb_device_add(struct usb_device *out, libusb_device *device,
                   const struct usb_evaluation *judge);

/* Classifies the device again, because a kernel driver may have bound it or the rules may have
 * changed. */
void usb_device_refresh(struct usb_device *device, const struct usb_evaluation *judge);

/* Sets the kind, the score and the verdict of the device from its current descriptor and the
 * rules. */
void usb_device_evaluate(struct usb_device *device, const struct usb_evaluation *judge);

/* Opens the device, claims the interface, reads its report descriptor and selects the report
 * protocol. The verdict must be USB_ASK or USB_PLAYS. Returns USB_FINE and sets `*out` to the
 * handle, or returns the reason of the failure. If the new verdict is not USB_PLAYS, the result is
 * USB_FINE and `*out` is null. */
enum usb_device_fault usb_device_open(struct usb_device *device, const struct usb_evaluation *judge,
                                      libusb_device_handle **out);

/* Releases the reference to the libusb device. */
void usb_device_remove(struct usb_device *device);

#endif
