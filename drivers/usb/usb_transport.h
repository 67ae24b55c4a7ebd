/* usb_transport.h -- the libusb transport: up to POI_MAX USB controllers, each in a slot.
 *
 * An event thread waits for transfers and hot-plug events (usb_event_thread.h). Reports reach the
 * frame loop through one fixed-size queue for each slot. Only our own poi and chosen controllers
 * are claimed (usb_choice.h). A boot keyboard or a second interface of the same device is never
 * claimed. */
#ifndef KINGYO_DRIVERS_USB_USB_TRANSPORT_H
#define KINGYO_DRIVERS_USB_USB_TRANSPORT_H

#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"
#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

struct usb_seats;

/* Configuration; everything is copied except the objects behind `clock` and the callback. */
struct usb_transport_config {
    struct hal_clock clock;       /* Clock, which the event thread uses too. */
    const char *choices;          /* File of chosen controllers; null: choices are not stored. */
    const struct usb_key *listed; /* Controllers that play regardless of the file (--usb). */
    uint32_t listed_count;
    const char *sysfs; /* Null: "/sys". Tests use a folder of their own. */
    /* Reports in one line that a controller which should play cannot be opened. Called from the
     * event thread. If null, only hid_device_list_ops.describe() reports it. */
    void (*tell)(void *self, const char *line);
    void *tell_self;
};

/* Starts the event thread and returns the only instance, which is a static object. `why` is ""
 * or gets one line. Without USB the slots return HAL_ERR_ABSENT. An invalid line of the choices
 * file is reported too, and a file that cannot be read is reported and not overwritten. */
struct usb_seats *usb_transport_start(const struct usb_transport_config *config,
                                      char why[HAL_TEXT_SIZE]);

/* Returns slot `index` < POI_MAX. A controller gets the same slot after it was unplugged, by
 * vendor:product:serial or else by port. */
struct hid_port usb_transport_port(struct usb_seats *seats, uint32_t index);

/* Returns the device list for the controller manager. */
struct hid_device_list usb_transport_roster(struct usb_seats *seats);

/* Copies the keys chosen by the file or --usb, whether plugged in or not, so that no other
 * driver opens these controllers first. Returns their number, or 0 without USB. */
uint32_t usb_transport_wanted(struct usb_seats *seats, struct usb_key out[USB_REQUEST_MAX]);

/* Cancels all transfers, closes all devices, reattaches kernel drivers and ends the thread. */
void usb_transport_stop(struct usb_seats *seats);

#endif
