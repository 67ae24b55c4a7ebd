/* doctor_usb.h -- reads the state of one USB device from /sys, and selects the interface that the
 * kiosk would claim. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_USB_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_USB_H

#include "drivers/hid/hid_mapping.h"
#include "drivers/usb/usb_choice.h"
#include "platform/ctl/doctor/doctor.h"

#define USB_DEVICES "/sys/bus/usb/devices"
#define USB_CLASS_HID 0x03u
#define USB_CLASS_HUB 0x09u
#define USB_PORT_SIZE 32u

/* A USB device as described by the files of /sys. */
struct usb_device {
    char port[USB_PORT_SIZE]; /* USB port of the device, for example "3-1.4" (bus 3, port 1, port 4
                                 of the hub). */
    struct hid_identity identity;
    char maker[HID_TEXT_SIZE];
    uint32_t bus, number, class, configuration;
    uint8_t sleeps; /* 1 if autosuspend is enabled, so that the device may stop responding during a
                       round. Otherwise 0. */
};

/* An interface of a USB device, and the result of the kiosk's rules for accepting the interface. */
struct usb_interface {
    uint32_t number, class, subclass, protocol;
    char driver[48]; /* Name of the kernel driver that is bound to the interface. "" means no
                        driver. */
    struct usb_candidate subject;
    enum usb_verdict verdict;
    struct hid_mapping map;
};

/* Reads the device at `device->port` and selects its best interface for the kiosk
 * (usb_choice_is_better()). An interface that can play is preferred, then an interface whose
 * descriptor must be read, then an interface that must be learned. For a HID interface,
 * `best->subject` points to `device->identity`. `device` must therefore outlive `best`. */
void doctor_read_usb(const struct doctor *doctor, const struct usb_choice *choice,
                     struct usb_device *device, struct usb_interface *best);

/* Writes the advice for a controller to `out`. If the rules list the controller, the advice is to
 * install Kingyo's rules. Otherwise the advice contains the rule that must be added for the
 * controller. */
void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product);

#endif
