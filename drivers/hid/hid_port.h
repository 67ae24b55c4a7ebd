/* hid_port.h -- the source of raw HID reports: the interface between a transport and the
 * decoders.
 *
 * A port is one slot and reports the controller that is currently attached to it. The libusb
 * transport (usb_transport.h) and its simulated twin (hid_port_sim.h) implement this interface, and
 * poi_hid.h decodes its reports. Decoders do not depend on USB, and transports do not depend on
 * the game. No call blocks, and all calls come from one thread. */
#ifndef KINGYO_DRIVERS_HID_HID_PORT_H
#define KINGYO_DRIVERS_HID_HID_PORT_H

#include <stdint.h>

#include "platform/hal.h"

#define HID_REPORT_MAX 256u   /* Bytes; game pads send 64, the largest pen tablets 192. */
#define HID_REPORTS_MAX 1024u /* Capacity of a slot's queue: 1,000 Hz for a stall of one second. */
#define HID_DESCRIPTOR_MAX 4096u /* Bytes; Linux reads no more. */
#define HID_TEXT_SIZE 64u

/* Identity of a controller. Texts are UTF-8, truncated to fit, and "" if the device reports
 * none. */
struct hid_identity {
    uint16_t vendor, product, release;
    uint8_t interface_number;
    char serial[HID_TEXT_SIZE];
    char name[HID_TEXT_SIZE];
    char port[32]; /* USB path: "3-1.4" is bus 3, port 1, port 4 of that hub. */
};

/* Returns how many bytes of a text fit into `max` without splitting a UTF-8 character. */
static inline int hid_text_fit(const char *text, int max)
{
    int length = 0;
    while (length < max && text[length]) {
        length++;
    }
    while (length > 0 && ((uint8_t)text[length] & 0xc0u) == 0x80u) {
        length--;
    }
    return length;
}

/* Identity and report descriptor of an attached device, copied whole so that a decoder can be
 * initialized. */
struct hid_device_info {
    struct hid_identity identity;
    uint32_t descriptor_size;
    uint8_t descriptor[HID_DESCRIPTOR_MAX];
};

/* An input report as received. */
struct hid_raw {
    uint64_t time_ns; /* Arrival on the clock of hal_clock_ops; never decreases. */
    uint32_t size;    /* 1 .. HID_REPORT_MAX; a transfer of length 0 is not a report. */
    uint8_t bytes[HID_REPORT_MAX]; /* Starts with the report id if the device uses report ids. */
};

struct hid_port_ops {
    /* Opens the slot. Returns HAL_OK and fills `out` if a controller is attached, HAL_ERR_GONE
     * if none is attached now, or HAL_ERR_ABSENT if none can ever be. After take() returned
     * HAL_ERR_GONE, open() checks again. */
    int (*open)(void *self, struct hid_device_info *out);
    /* Removes the oldest report. Returns 1 and fills `out`, or 0 if the queue is empty. Returns
     * HAL_ERR_GONE after the controller was unplugged and all earlier reports were taken. When
     * the queue is full, the newest report is always kept, because many controllers report only
     * changes and their last state must arrive. */
    int (*take)(void *self, struct hid_raw *out);
    /* Sends an output report, id first. Returns HAL_ERR_BUSY and drops the report while the
     * previous one is in flight. */
    int (*send)(void *self, const uint8_t *bytes, uint32_t size);
    /* Returns the number of reports since the start that were dropped because the queue was full
     * or the report too long. */
    uint32_t (*lost_count)(void *self);
    const char *(*describe)(void *self);
};

struct hid_port {
    const struct hid_port_ops *ops;
    void *self;
};

#endif
