/* usb_device.h -- one HID device on the bus: who it is, which of its interfaces could be a poi, and
 * how that one is opened. Of the USB thread alone; usb_device_open() waits for the device, at most
 * a few seconds. */
#ifndef KINGYO_DRIVERS_USB_DEVICE_H
#define KINGYO_DRIVERS_USB_DEVICE_H

#include <stdint.h>

#include <libusb.h>

#include "drivers/hid_descriptor.h"
#include "drivers/usb_choice.h"
#include "drivers/usb_link.h"

/* Why one that may play does not. */
enum usb_trouble {
    USB_FINE = 0,
    USB_DENIED, /* We have no right to open it. */
    USB_HELD,   /* Another program has claimed it. */
    USB_BROKEN, /* It does not answer. */
    USB_AWAY,   /* It was pulled out meanwhile. */
};

struct usb_device {
    libusb_device *device;  /* A reference of ours; null: this is none. */
    uint8_t configuration;
    uint8_t serial_index, product_index; /* Of its string descriptors; 0: none. */
    uint8_t is_boot;        /* The interface knows the boot protocol ... */
    uint8_t is_boot_keyboard; /* ... of a keyboard. */
    uint32_t declared_size; /* Of its report descriptor. */
    uint8_t is_read;        /* `face.descriptor` came from the device itself. */
    uint8_t verdict;        /* enum usb_verdict */
    uint8_t kind;           /* enum usb_kind */
    uint8_t worth;          /* hid_map_worth() */
    struct usb_pipe pipe;
    struct hid_face face;   /* descriptor_size 0: not known yet. */
};

/* What judging needs beside the device. */
struct usb_judge {
    const char *sysfs;
    const struct usb_choice *choice;
    struct hid_descriptor *scratch;
};

/* Takes a reference and looks at what the kernel knows: 0, or -1 for what is no HID device. */
int usb_device_meet(struct usb_device *out, libusb_device *device, const struct usb_judge *judge);

/* Looks again: a driver may have bound it, choices may have changed. */
void usb_device_look(struct usb_device *device, const struct usb_judge *judge);

/* Gives it a kind and a verdict by what is known of it. */
void usb_device_judge(struct usb_device *device, const struct usb_judge *judge);

/* Opens and claims it, reads what was not known, and makes it speak in whole reports. The verdict
 * must allow that; it may be another one afterwards, and then `out` is null and USB_FINE said. */
enum usb_trouble usb_device_open(struct usb_device *device, const struct usb_judge *judge,
                                 libusb_device_handle **out);

/* Gives the reference back. */
void usb_device_forget(struct usb_device *device);

#endif
