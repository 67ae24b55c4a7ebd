/* doctor_usb.h -- the state of one USB device in /sys, and of the interface that suits the kiosk
 * best. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_USB_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_USB_H

#include "drivers/hid/hid_mapping.h"
#include "drivers/usb/usb_choice.h"
#include "platform/ctl/doctor/doctor.h"

#define USB_DEVICES "/sys/bus/usb/devices"
#define USB_CLASS_HID 0x03u
#define USB_CLASS_HUB 0x09u
#define USB_PORT_SIZE 32u

/* A USB device as /sys describes it. */
struct usb_device {
    char port[USB_PORT_SIZE]; /* Port of the device, for example "3-1.4". */
    struct hid_identity identity;
    char maker[HID_TEXT_SIZE];
    uint32_t bus, number, class, configuration;
    uint8_t sleeps; /* 1 if autosuspend is enabled. */
};

/* An interface of a USB device, and the kiosk's decision about it. */
struct usb_interface {
    uint32_t number, class, subclass, protocol;
    char driver[48]; /* Name of the kernel driver. "" means no driver. */
    struct usb_candidate subject;
    enum usb_verdict verdict;
    struct hid_mapping map;
};

/* Reads the device at `device->port` and selects the best of its interfaces. An accepted interface
 * is best, then one that may be accepted, then any other. For a HID interface, `best->subject`
 * points to `device->identity`, so `device` must outlive `best`. */
void doctor_read_usb(const struct doctor *doctor, const struct usb_choice *choice,
                     struct usb_device *device, struct usb_interface *best);

#endif
