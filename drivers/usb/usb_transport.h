/* usb_transport.h -- the libusb transport: up to POI_MAX USB controllers, each attached to a port
 * (hid_port.h).
 *
 * An event thread waits for transfers and hot-plug events (usb_event_thread.h). Only Kingyo's poi
 * controller (poi_report.h) and selected controllers are claimed (usb_choice.h). A boot keyboard or
 * a second interface of the same device is never claimed. The frame loop calls all functions. */
#pragma once

#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"
#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

struct usb_event_thread;

/* Configuration of the transport. All members are copied. The objects behind `clock` and the
 * callback must stay valid. */
struct usb_transport_config {
    /* Clock from which the time stamps of reports are read. The event thread calls the clock
     * too. */
    struct hal_clock clock;
    /* Path of the file of rules (usb_choice.h). Null means that rules are not stored. */
    const char *choices;
    /* Keys of the controllers that the option --usb names. Such a controller may play even if the
     * file of rules (usb_choice.h) forbids it. */
    const struct usb_key *listed;
    uint32_t listed_count; /* Number of elements of `listed`. */
    const char *sysfs;     /* Root of sysfs. Null means "/sys". Tests use another folder. */
    /* Callback that receives one line for each controller that should play and cannot be opened.
     * Called from the event thread. If the callback is null, only hid_device_list_ops.describe()
     * reports the fault. */
    void (*report)(void *self, const char *line);
    void *report_self;
};

/* Starts the event thread and returns the transport, which is a static object, because there is
 * only one. `why` receives one line with a problem, or "". If USB is not available, all ports
 * return HAL_ERR_ABSENT. An invalid line of the file of rules is reported in `why`. A file that
 * cannot be read is also reported, and is not overwritten. */
struct usb_event_thread *usb_transport_start(const struct usb_transport_config *config,
                                             char why[HAL_TEXT_SIZE]);

/* Returns the port of slot `index` (0 to POI_MAX - 1). A controller that is plugged in again gets
 * its former slot, which is found by vendor:product:serial or by port. */
struct hid_port *usb_transport_port(struct usb_event_thread *usb_thread, uint32_t index);

/* Returns the list of connected and selected controllers (hid_device_list.h) for the controller
 * manager. */
struct hid_device_list usb_transport_list(struct usb_event_thread *usb_thread);

/* Copies to `out` the keys of all controllers that the file of rules or the option --usb selects,
 * even if they are not plugged in. Other drivers must not open these controllers. Returns the
 * number of keys, or 0 without USB. */
uint32_t usb_transport_wanted(struct usb_event_thread *usb_thread,
                              struct usb_key out[USB_REQUEST_MAX]);

/* Stops the event thread: cancels all transfers, closes all devices and attaches the kernel drivers
 * again. Waits at most two seconds for transfers. */
void usb_transport_stop(struct usb_event_thread *usb_thread);
