/* hid_nodes.h -- the HID devices that Linux knows, from /sys and /dev. */
#ifndef KINGYO_PLATFORM_CTL_HID_NODES_H
#define KINGYO_PLATFORM_CTL_HID_NODES_H

#include <stdint.h>

#include "drivers/hid_descriptor.h"

#define HID_NODES_MAX 64u /* The kernel's HIDRAW_MAX_DEVICES. */
#define HID_NODE_TEXT 128u
#define HID_NODE_PATH 512u

struct hid_node {
    uint32_t number; /* Of /dev/hidrawNUMBER. */
    uint16_t bus;    /* 3: USB, 5: Bluetooth, 0x18: I2C; linux/input.h's BUS_*. */
    uint16_t vendor, product;
    int open_errno;  /* 0: this user may read it; ENOENT: the node is not in /dev. */
    char name[HID_NODE_TEXT];   /* As the device says it; what is no letter of a line is a dot. */
    char place[HID_NODE_TEXT];  /* usb-0000:00:14.0-1/input0 */
    char serial[HID_NODE_TEXT];
    char driver[32];            /* hid-generic, logitech-djreceiver; "": none. */
};

/* Every node under `root` ("" is this machine; tests have a folder that looks like one), by number.
 * Returns how many; of more than HID_NODES_MAX the last are left out. */
uint32_t hid_nodes_list(const char *root, struct hid_node out[HID_NODES_MAX]);

/* Its descriptor, which anybody may read in /sys: 1, or 0 with `said_errno`, which is 0 where it
 * was read and is none; `out->error` then says why. */
int hid_node_descriptor(const char *root, const struct hid_node *node, struct hid_descriptor *out,
                        int *said_errno);

/* The word for a bus: "USB", "Bluetooth", "I2C", "virtual", or "other". */
const char *hid_node_bus(const struct hid_node *node);

#endif
