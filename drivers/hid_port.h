/* hid_port.h -- where raw HID reports come from: the seam between a transport and the decoders.
 *
 * Above it nothing knows of USB (poi_hid.h decodes); below it nothing knows of fish. The libusb
 * transport (usb_seats.h) and its simulated twin (hid_port_sim.h) both end here. A port is one seat
 * at the tank: whatever controller sits there now. No call waits; one thread calls. */
#ifndef KINGYO_DRIVERS_HID_PORT_H
#define KINGYO_DRIVERS_HID_PORT_H

#include <stdint.h>

#include "platform/hal.h"

#define HID_REPORT_MAX 256u      /* Bytes; pads send 64, the largest pen tablets 192. */
#define HID_REPORTS_MAX 1024u    /* That wait to be taken: 1,000 Hz over a stalled second. */
#define HID_DESCRIPTOR_MAX 4096u /* Bytes; what Linux itself reads at most. */
#define HID_TEXT_SIZE 64u

/* Who a controller is. Texts are UTF-8, cut to fit, "" where the device says none. */
struct hid_identity {
    uint16_t vendor, product, release;
    uint8_t interface_number;
    char serial[HID_TEXT_SIZE];
    char name[HID_TEXT_SIZE];
    char port[32]; /* Where it is plugged in: "3-1.4" is bus 3, port 1, port 4 of that hub. */
};

/* How many bytes of a text fit into `max` without cutting a letter of UTF-8 in two. */
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

/* What sits in a seat: copied out whole, so that a decoder can be made for it. */
struct hid_face {
    struct hid_identity identity;
    uint32_t descriptor_size;
    uint8_t descriptor[HID_DESCRIPTOR_MAX];
};

/* One input report, as it came from the wire. */
struct hid_raw {
    uint64_t time_ns; /* Arrival, on the clock of hal_clock_ops; never before the last one's. */
    uint32_t size;    /* 1 .. HID_REPORT_MAX: a transfer of length 0 is no report. */
    uint8_t bytes[HID_REPORT_MAX]; /* With the report id first, if the device uses them. */
};

struct hid_port_ops {
    /* HAL_OK: somebody sits here, `out` says who. HAL_ERR_GONE: nobody now. HAL_ERR_NONE: nobody
     * ever will. After HAL_ERR_GONE from take() this looks again. */
    int (*open)(void *self, struct hid_face *out);
    /* The next report, oldest first: 1 and `out`, or 0; HAL_ERR_GONE once it was pulled out and all
     * that came before was taken. Of what came too fast to be kept the newest is, for many
     * controllers speak only when something changes: their last word must be heard. */
    int (*take)(void *self, struct hid_raw *out);
    /* Sends an output report, id first, or drops it while the last one is still on its way
     * (HAL_ERR_BUSY). */
    int (*send)(void *self, const uint8_t *bytes, uint32_t size);
    /* Reports that came too fast to be kept, or were too long; since the start. */
    uint32_t (*lost_count)(void *self);
    const char *(*describe)(void *self);
};

struct hid_port { const struct hid_port_ops *ops; void *self; };

#endif
