/* usb_transport.h -- the libusb transport: up to POI_MAX USB controllers, each in a slot.
 *
 * A slot is the place of one controller. An event thread waits for transfers and hot-plug events
 * (usb_event_thread.h). Reports reach the frame loop through one fixed-size queue for each slot.
 * Only Kingyo's poi controller (poi_report.h) and selected controllers are claimed
 * (usb_choice.h). A boot keyboard or a second interface of the same device is never claimed. */
#ifndef KINGYO_DRIVERS_USB_USB_TRANSPORT_H
#define KINGYO_DRIVERS_USB_USB_TRANSPORT_H

#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"
#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

struct usb_seats;

/* Configuration of the transport. All members are copied; the objects behind `clock` and the
 * callback must stay valid. */
struct usb_transport_config {
    struct hal_clock clock;       /* Clock from which the time stamps of reports are read. The event
                                     thread calls the clock too. */
    const char *choices;          /* Path of the file of rules (usb_choice.h); null means that rules
                                     are not stored. */
    const struct usb_key *listed; /* Controllers that the option --usb names. These controllers play
                                     regardless of the file of rules. */
    uint32_t listed_count;
    const char *sysfs; /* Root of sysfs; null means "/sys". Tests use another folder. */
    /* Callback that receives one line for each controller that should play and cannot be opened.
     * Called from the event thread. If the callback is null, only hid_device_list_ops.describe()
     * reports the fault. */
    void (*tell)(void *self, const char *line);
    void *tell_self;
};

/* Starts the event thread and returns the transport, which is a static object, because there is
 * only one. `why` receives one line with a problem, or "". If USB is not available, the ports of
 * all slots return HAL_ERR_ABSENT. An invalid line of the file of rules is reported in `why`. A
 * file that cannot be read is also reported, and is not overwritten. */
struct usb_seats *usb_transport_start(const struct usb_transport_config *config,
                                      char why[HAL_TEXT_SIZE]);

/* Returns the port of slot `index` (0 to POI_MAX - 1). A controller that is plugged in again gets
 * its former slot, which is found by vendor:product:serial or by port. */
struct hid_port usb_transport_port(struct usb_seats *seats, uint32_t index);

/* Returns the list of connected and selected controllers (hid_device_list.h) for the controller
 * manager. */
struct hid_device_list usb_transport_roster(struct usb_seats *seats);

/* Copies to `out` the keys of all controllers that the file of rules or the option --usb selects,
 * even if they are not plugged in. Other drivers must not open these controllers. Returns the
 * number of keys, or 0 without USB. */
uint32_t usb_transport_wanted(struct usb_seats *seats, struct usb_key out[USB_REQUEST_MAX]);

/* Cancels all transfers, closes all devices, attaches the kernel drivers again and ends the
 * thread. */
void usb_transport_stop(struct usb_seats *seats);

#endif
