/* usb_device.h -- a HID device on the bus: reads its identity, selects its best interface, opens
 * it.
 *
 * Used only by the event thread. usb_device_open() blocks on the device for at most a few
 * seconds. */
#ifndef KINGYO_DRIVERS_USB_USB_DEVICE_H
#define KINGYO_DRIVERS_USB_USB_DEVICE_H

#include <stdint.h>

#include <libusb.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_transfers.h"

/* Reason why a controller that may play does not. */
enum usb_device_fault {
    USB_FINE = 0,
    USB_DENIED, /* The kiosk has no permission to open the device. */
    USB_HELD,   /* Another program has claimed the interface. */
    USB_BROKEN, /* The device does not respond. */
    USB_AWAY,   /* The device was unplugged meanwhile. */
};

struct usb_device {
    libusb_device *device; /* A counted reference; null if the entry is empty. */
    uint8_t configuration;
    uint8_t serial_index, product_index; /* Indexes of string descriptors; 0: none. */
    uint8_t is_boot;                     /* 1 if the interface supports the boot protocol. */
    uint8_t is_boot_keyboard;            /* 1 for the boot protocol of a keyboard. */
    uint32_t declared_size;              /* Declared size of the report descriptor in bytes. */
    uint8_t is_read; /* 1 if `face.descriptor` was read from the device itself. */
    uint8_t verdict; /* enum usb_verdict */
    uint8_t kind;    /* enum usb_kind */
    uint8_t worth;   /* Rating by hid_mapping_score(). */
    struct usb_pipe pipe;
    struct hid_device_info face; /* Identity and descriptor; descriptor_size 0: not known yet. */
};

/* Inputs to the classification other than the device. */
struct usb_evaluation {
    const char *sysfs;
    const struct usb_choice *choice;
    struct hid_descriptor *scratch;
};

/* Takes a reference and classifies the device by kernel data, without opening it. Returns 0, or
 * -1 if the device has no usable HID interface. */
int usb_device_add(struct usb_device *out, libusb_device *device,
                   const struct usb_evaluation *judge);

/* Classifies the device again, because a driver may have bound it or the choices may have
 * changed. */
void usb_device_refresh(struct usb_device *device, const struct usb_evaluation *judge);

/* Sets the kind, worth and verdict from what is known. */
void usb_device_evaluate(struct usb_device *device, const struct usb_evaluation *judge);

/* Opens and claims the interface, reads its report descriptor and switches it to the report
 * protocol. The verdict must be USB_ASK or USB_PLAYS. Returns USB_FINE and sets `out`, or
 * returns the reason. If the new verdict is not USB_PLAYS, the result is USB_FINE and `out` is
 * null. */
enum usb_device_fault usb_device_open(struct usb_device *device, const struct usb_evaluation *judge,
                                      libusb_device_handle **out);

/* Releases the reference to the libusb device. */
void usb_device_remove(struct usb_device *device);

#endif
