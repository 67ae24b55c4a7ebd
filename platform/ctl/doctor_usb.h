/* doctor_usb.h -- what /sys says of one device on USB, and of its interface that plays best. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_USB_H
#define KINGYO_PLATFORM_CTL_DOCTOR_USB_H

#include "drivers/hid_map.h"
#include "drivers/usb_choice.h"
#include "platform/ctl/doctor.h"

#define USB_DEVICES "/sys/bus/usb/devices"
#define USB_CLASS_HID 0x03u
#define USB_CLASS_HUB 0x09u
#define USB_PORT_SIZE 32u

struct usb_device {
    char port[USB_PORT_SIZE]; /* "3-1.4" */
    struct hid_identity identity;
    char maker[HID_TEXT_SIZE];
    uint32_t bus, number, class, configuration;
    uint8_t sleeps; /* Autosuspend is on. */
};

struct usb_interface {
    uint32_t number, class, subclass, protocol;
    char driver[48]; /* "": none. */
    struct usb_subject subject;
    enum usb_verdict verdict;
    struct hid_map map;
};

/* Fills what lies behind `device->port`, and the best of its interfaces: the one that plays, else
 * one that may, else any. `device->identity` stays `best->subject`'s. */
void doctor_read_usb(const struct doctor *doctor, const struct usb_choice *choice,
                     struct usb_device *device, struct usb_interface *best);

#endif
