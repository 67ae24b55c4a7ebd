/* usb_sim.h -- a simulated USB bus, which replaces the part of libusb that the drivers call.
 *
 * A test plugs devices in and out while the drivers' thread runs. The bus behaves like libusb
 * 1.0.26 on Linux. It also checks the drivers: each forbidden call is counted as a breach and
 * printed on standard error. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_USB_USB_SIM_H
#define KINGYO_TESTS_UNIT_SUPPORT_USB_USB_SIM_H

#include <stdint.h>

/* Largest number of devices in one test. The stress test needs so many. */
#define USB_SIM_DEVICE_MAX 4096u
#define USB_SIM_INTERFACE_MAX 4u
#define USB_SIM_WIRE_MAX 4096u /* Largest number of reports of a device that wait for a transfer. */

/* Descriptors of one interface of a simulated device. */
struct usb_sim_interface {
    uint8_t class, subclass, protocol;
    uint16_t packet_size; /* Packet size of the interrupt IN endpoint; 0 means that the interface
                             has no such endpoint. */
    uint8_t has_out;
    const uint8_t *descriptor; /* Report descriptor that the device returns on request. */
    uint32_t descriptor_size;
    const uint8_t *mended; /* Report descriptor in /sys, if it differs from `descriptor`. Null means
                              that both are equal. */
    uint32_t mended_size;
};

struct usb_sim_kind {
    uint16_t vendor, product;
    const char *name, *serial; /* Name and serial number of the device; null means that the device
                                  has none. */
    uint8_t is_bound;          /* 1 if a HID driver of the kernel has bound the interfaces, so that
                                  /sys has their report descriptors; otherwise 0. */
    uint32_t interface_count;
    struct usb_sim_interface interface[USB_SIM_INTERFACE_MAX];
};

/* Order of the events that follow when a device is unplugged. */
enum usb_sim_unplug_order {
    /* Every pending transfer returns NO_DEVICE, and the hot-plug event follows. */
    USB_SIM_GONE = 0,
    USB_SIM_IO_FIRST, /* One pending transfer returns ERROR, the others return NO_DEVICE, and the
                         hot-plug event follows. */
    USB_SIM_LATE,     /* Every pending transfer returns NO_DEVICE, and the hot-plug event waits
                         for usb_sim_announce(). */
    USB_SIM_QUIET,    /* The hot-plug event comes first, and pending transfers return only when
                         they are cancelled. */
};

/* Initializes the bus without devices and faults. `sysfs` is the path of a folder for the simulated
 * /sys, or null for no /sys. */
void usb_sim_begin(const char *sysfs);

/* Ends a test. Returns the number of handles, devices, transfers and lists that the drivers did not
 * release; 0 means none. */
uint32_t usb_sim_end(void);

/* Plugs a device into port `port` of bus 3. Port 1 has the name "3-1". Returns the index of the
 * device, counted from 0. */
uint32_t usb_sim_plug(const struct usb_sim_kind *kind, uint8_t port);
/* Unplugs a device. `how` selects the order of the events. */
void usb_sim_unplug(uint32_t device, enum usb_sim_unplug_order how);
/* Sends the hot-plug event of a device that was unplugged with USB_SIM_LATE. */
void usb_sim_announce(uint32_t device);

/* Queues one report of a device. With size 0, the device sends an empty packet (zero length). */
void usb_sim_report(uint32_t device, const uint8_t *bytes, uint32_t size);

/* Makes the next completed transfer of a device return `status`, an enum libusb_transfer_status. */
void usb_sim_fail(uint32_t device, int status);

/* Returns the number of queued reports that no transfer has taken yet. */
uint32_t usb_sim_waiting(uint32_t device);

/* Number of calls that a device has received, by kind, and the newest output report. */
struct usb_sim_seen {
    uint32_t opens, closes, claims, releases;
    uint32_t closes_begun;       /* Calls of libusb_close(), including the one that still runs. */
    uint32_t claimed_interfaces; /* Interfaces that were ever claimed; bit i belongs to interface
                                    i. */
    uint32_t in_flight, in_flight_max;
    uint32_t clear_halts, set_idles, set_protocols, descriptor_reads;
    uint32_t outs, set_reports; /* Number of output reports that arrived by interrupt transfers
                                   (`outs`) and by SET_REPORT requests (`set_reports`). */
    uint32_t out_size;
    /* Bytes of the newest output report. They do not include the setup packet of a control
     * transfer. */
    uint8_t out[64];
    uint16_t set_report_value; /* Field wValue of the newest SET_REPORT request: report type and
                                  report id. */
};
/* Returns the number of calls that a device has received. */
struct usb_sim_seen usb_sim_seen(uint32_t device);

/* Faults that apply to all devices on the bus. */
struct usb_sim_faults {
    int open_error, claim_error; /* Errors that libusb_open() and libusb_claim_interface() return
                                    (enum libusb_error); 0 means no error. */
    uint32_t close_ms;           /* Duration of libusb_close(). */
    uint8_t holds_close;         /* 1 if libusb_close() waits until the fault is cleared, otherwise
                                    0. */
    uint32_t cancel_ms;          /* Delay until a cancelled transfer completes. */
    uint8_t stalls_requests;     /* 1 if devices stall the requests SET_IDLE and SET_PROTOCOL,
                                    otherwise 0. */
    uint8_t hold_outs;           /* 1 if output reports stay on the host until the fault is cleared,
                                    otherwise 0. */
    uint8_t lets_outs_time_out;
    uint8_t is_unconfigured;  /* 1 if the kernel has not chosen a configuration yet, otherwise 0. */
    uint8_t hides_descriptor; /* 1 if the request GET_DESCRIPTOR of the report descriptor fails,
                                 otherwise 0. */
    int init_error;
    uint8_t no_hotplug;
};
/* Replaces the faults of the bus by `faults`. */
void usb_sim_set_faults(const struct usb_sim_faults *faults);

/* Returns the number of breaches since usb_sim_begin(). A breach is one of four kinds of forbidden
 * calls: communication with a device from within a callback, closing a device with a pending
 * transfer, use of a closed object, and a call from a thread other than the drivers' thread. */
uint32_t usb_sim_breaches(void);

/* Returns the number of libusb calls since usb_sim_begin(), without the calls that initialize
 * libusb and shut it down. */
uint32_t usb_sim_calls(void);

#endif
