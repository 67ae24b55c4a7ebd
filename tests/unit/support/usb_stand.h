/* usb_stand.h -- a simulated USB bus. It replaces the part of libusb that the drivers call.
 *
 * A test plugs devices in and out while the drivers' thread runs. The bus behaves as libusb 1.0.26
 * on Linux. It also checks its caller: a forbidden call is counted as a breach and printed on
 * standard error. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_USB_STAND_H
#define KINGYO_TESTS_UNIT_SUPPORT_USB_STAND_H

#include <stdint.h>

/* Largest number of devices in one test. A stress test plugs in many devices. */
#define STAND_DEVICE_MAX 4096u
#define STAND_INTERFACE_MAX 4u
#define STAND_WIRE_MAX 4096u /* Largest number of reports that wait for a transfer. */

/* Descriptors of an interface of a device kind. */
struct stand_interface {
    uint8_t class, subclass, protocol;
    uint16_t packet_size; /* Packet size of the interrupt endpoint; 0 means that no such endpoint
                             exists. */
    uint8_t has_out;
    const uint8_t *descriptor; /* Report descriptor. */
    uint32_t descriptor_size;
    const uint8_t *mended; /* Report descriptor in /sys if it differs from `descriptor`; null
                              means the same. */
    uint32_t mended_size;
};

struct stand_kind {
    uint16_t vendor, product;
    const char *name, *serial; /* Name and serial number of the device; null means none. */
    uint8_t is_bound;          /* 1 if a HID driver of the kernel has bound the interface, so that
                                  /sys has its descriptor. */
    uint32_t interface_count;
    struct stand_interface interface[STAND_INTERFACE_MAX];
};

/* Order of the events after a cable was unplugged. */
enum stand_parting {
    STAND_GONE = 0, /* Every transfer returns NO_DEVICE, and the hot-plug event follows. */
    STAND_IO_FIRST, /* One transfer returns ERROR, and the others return NO_DEVICE. */
    STAND_LATE,     /* As STAND_GONE, but the hot-plug event waits for stand_announce(). */
    STAND_QUIET,    /* The hot-plug event comes first, and transfers return only when they are
                       cancelled. */
};

/* Starts with an empty bus and no faults. `sysfs` is a folder of the test, or null. */
void stand_begin(const char *sysfs);

/* Returns 0 if all handles, devices, transfers and lists were released, or the number of resources
 * that were not. */
uint32_t stand_end(void);

/* Plugs in a device at bus 3 and the given port. Port 1 has the name "3-1". Returns the index of
 * the device from 0. */
uint32_t stand_plug(const struct stand_kind *kind, uint8_t port);
/* Unplugs a device. `how` selects the order of the events. */
void stand_unplug(uint32_t device, enum stand_parting how);
/* Sends the hot-plug event of a device that left with STAND_LATE. */
void stand_announce(uint32_t device);

/* Puts one report on the wire, or a short packet of length 0. */
void stand_report(uint32_t device, const uint8_t *bytes, uint32_t size);

/* Makes the next completed transfer return this libusb_transfer_status. */
void stand_fail(uint32_t device, int status);

/* Returns the number of reports that no transfer has taken yet. */
uint32_t stand_waiting(uint32_t device);

/* Counts of the calls that a device received. */
struct stand_seen {
    uint32_t opens, closes, claims, releases;
    uint32_t claimed_interfaces; /* All interfaces that were ever claimed, one bit each. */
    uint32_t in_flight, in_flight_max;
    uint32_t clear_halts, set_idles, set_protocols, descriptor_reads;
    uint32_t outs, set_reports; /* Number of output reports that arrived by interrupt transfers
                                   (`outs`) and by SET_REPORT (`set_reports`). */
    uint32_t out_size;
    uint8_t out[64];           /* Bytes of the newest output report, without the setup packet of
                                  the control pipe. */
    uint16_t set_report_value; /* wValue of the newest SET_REPORT: report type and id. */
};
/* Returns the counts of a device. */
struct stand_seen stand_seen(uint32_t device);

/* Faults that apply to every device. */
struct stand_faults {
    int open_error, claim_error; /* Errors of open and claim, an enum libusb_error each; 0 means
                                    none. */
    uint32_t close_ms;           /* Duration of libusb_close(). */
    uint32_t cancel_ms;          /* Delay of a cancelled transfer. */
    uint8_t stalls_requests;     /* 1 makes the device stall SET_IDLE and SET_PROTOCOL. */
    uint8_t hold_outs;           /* 1 keeps output reports on the host until it is 0 again. */
    uint8_t lets_outs_time_out;
    uint8_t is_unconfigured;  /* 1 means that the kernel has not chosen a configuration yet. */
    uint8_t hides_descriptor; /* 1 makes GET_DESCRIPTOR of the report descriptor fail. */
    int init_error;
    uint8_t no_hotplug;
};
/* Replaces the faults of the bus. */
void stand_set_faults(const struct stand_faults *faults);

/* Returns the number of breaches after stand_begin(). Breaches are: communication with a device
 * from within a callback, close of a device with a pending transfer, use of a closed object, and a
 * call from a thread other than the drivers' thread. */
uint32_t stand_breaches(void);

/* Returns the number of libusb calls so far except those that initialize and shut down. */
uint32_t stand_calls(void);

#endif
