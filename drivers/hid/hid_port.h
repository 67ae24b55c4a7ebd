/* hid_port.h -- the source of raw HID reports: the interface between a transport and the decoders.
 *
 * A port belongs to one slot (the place of one of up to four controllers) and reports the
 * controller that is currently attached to the slot. The libusb transport (usb_transport.h) and the
 * simulated transport (hid_port_sim.h) implement the interface, and poi_hid.h decodes the reports.
 * Decoders do not depend on USB, and transports do not depend on the game. No call blocks, and all
 * calls come from one thread. */
#ifndef KINGYO_DRIVERS_HID_HID_PORT_H
#define KINGYO_DRIVERS_HID_HID_PORT_H

#include <stdint.h>

#include "platform/hal.h"

/* Largest report, in bytes. Game pads send 64 bytes, the largest pen tablets 192. */
#define HID_REPORT_MAX 256u
/* Capacity of a slot's queue, enough for 1,000 reports per second during a stall of one second. */
#define HID_REPORTS_MAX 1024u
#define HID_DESCRIPTOR_MAX 4096u /* Largest report descriptor, in bytes. Linux reads no more. */
#define HID_TEXT_SIZE 64u

/* Identity of a controller. The texts are UTF-8 and truncated to fit; "" means that the device does
 * not report the text. */
struct hid_identity {
    uint16_t vendor, product, release;
    uint8_t interface_number;
    char serial[HID_TEXT_SIZE];
    char name[HID_TEXT_SIZE];
    char port[32]; /* USB path of the device. For example, "3-1.4" is bus 3, port 1, and port 4 of
                      the hub at port 1. */
};

/* Identity and report descriptor of an attached device. The struct is a complete copy, from which a
 * decoder can be initialized. */
struct hid_device_info {
    struct hid_identity identity;
    uint32_t descriptor_size;
    uint8_t descriptor[HID_DESCRIPTOR_MAX];
};

/* An input report as received from the device. */
struct hid_raw {
    uint64_t time_ns; /* Time of arrival, read from the HAL clock (hal_clock_ops). The time never
                         decreases from report to report. */
    uint32_t size;    /* Number of bytes, 1 to HID_REPORT_MAX. A transfer of length 0 is not a
                         report. */
    uint8_t bytes[HID_REPORT_MAX]; /* Content of the report, starting with the report id if the
                                      device uses report ids. */
};

struct hid_port_ops {
    /* Opens the slot. Returns HAL_OK and fills `out` if a controller is attached. Returns
     * HAL_ERR_GONE if no controller is attached now, or HAL_ERR_ABSENT if no controller can ever be
     * attached. After take() returned HAL_ERR_GONE, the caller calls open() again until a
     * controller is attached. */
    int (*open)(void *self, struct hid_device_info *out);
    /* Removes the oldest report. Returns 1 and fills `out`, or 0 if the queue is empty. Returns
     * HAL_ERR_GONE if the controller was unplugged and its last report was already removed. When
     * the queue is full, the newest report is always kept, because many controllers report only
     * changes and their last state must arrive. */
    int (*take)(void *self, struct hid_raw *out);
    /* Sends an output report, which starts with its id. Returns HAL_OK, or HAL_ERR_BUSY while the
     * previous report is being sent; the new report is then dropped. */
    int (*send)(void *self, const uint8_t *bytes, uint32_t size);
    /* Returns the number of reports since the program start that were dropped because the queue was
     * full or the report was too long. */
    uint32_t (*lost_count)(void *self);
    const char *(*describe)(void *self);
};

struct hid_port {
    const struct hid_port_ops *ops;
    void *self;
};

#endif
