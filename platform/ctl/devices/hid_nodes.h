/* hid_nodes.h -- lists the HID device nodes that Linux provides in /sys and /dev. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_NODES_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_NODES_H

#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"

/* Maximum number of device nodes, equal to HIDRAW_MAX_DEVICES of the Linux kernel. */
#define HID_NODES_MAX 64u
#define HID_NODE_TEXT 128u
#define HID_NODE_PATH 512u

/* A HID device node of Linux, /dev/hidrawN. */
struct hid_node {
    uint32_t number; /* Number N of the node /dev/hidrawN. */
    uint16_t bus;    /* Bus type, a BUS_* constant of linux/input.h: 3 is USB, 5 is Bluetooth, 0x18
                        is I2C. */
    uint16_t vendor, product;
    int open_errno; /* Errno of the attempt to open the node. 0 means that the current user may read
                       the node. ENOENT means that /dev has no such node. */
    char name[HID_NODE_TEXT];  /* Name that the device reports, with unprintable characters
                                  replaced by dots. */
    char place[HID_NODE_TEXT]; /* Physical location, for example usb-0000:00:14.0-1/input0. */
    char serial[HID_NODE_TEXT];
    char driver[32]; /* Name of the kernel driver, for example hid-generic or logitech-djreceiver.
                        "" means that no driver is bound. */
};

/* Lists the device nodes in the order of their numbers. `root` is the prefix of all paths: "" for
 * this machine, or a test folder with the same layout. Returns the number of nodes. Nodes beyond
 * HID_NODES_MAX are dropped. */
uint32_t hid_nodes_list(const char *root, struct hid_node out[HID_NODES_MAX]);

/* Reads the report descriptor of a node from /sys, which every user may read. Returns 1 if the
 * descriptor is valid. Otherwise returns 0 and sets `*said_errno`. A `*said_errno` of 0 means that
 * the descriptor was read but is invalid, and `out->error` is the reason. */
int hid_node_descriptor(const char *root, const struct hid_node *node, struct hid_descriptor *out,
                        int *said_errno);

/* Returns the name of the node's bus: "USB", "Bluetooth", "I2C", "virtual" or "other". */
const char *hid_node_bus(const struct hid_node *node);

#endif
