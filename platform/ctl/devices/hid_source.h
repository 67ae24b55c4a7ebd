/* hid_source.h -- reads live reports from a device node, or recorded reports from a file or a pipe.
 *
 * Each read from a device node (for example /dev/hidraw3) returns one report, and the node provides
 * the report descriptor. A file or a pipe contains a stream of bytes, as `cat /dev/hidraw3` writes
 * it. The descriptor then determines where each report ends. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

/* Maximum number of device nodes, equal to HIDRAW_MAX_DEVICES of the Linux kernel. */
#define HID_NODES_MAX 64u
#define HID_NODE_TEXT 128u
#define HID_NODE_PATH 512u

/* A HID device node of Linux, /dev/hidrawN. */
struct hid_node {
    uint32_t number; /* Number N of the node /dev/hidrawN. */
    /* Bus type, a BUS_* constant of linux/input.h: 3 is USB, 5 is Bluetooth, 0x18 is I2C. */
    uint16_t bus;
    uint32_t vendor, product;
    /* 0 if the current user may read the node, otherwise the errno of the attempt to open the node.
     * ENOENT means that /dev has no such node. */
    int open_errno;
    /* Name that the device reports. Unprintable characters are replaced by dots. */
    char name[HID_NODE_TEXT];
    char place[HID_NODE_TEXT]; /* Physical location, for example usb-0000:00:14.0-1/input0. */
    char serial[HID_NODE_TEXT];
    /* Name of the kernel driver, for example hid-generic or logitech-djreceiver. "" means that no
     * driver is bound. */
    char driver[32];
};

/* Lists the device nodes in the order of their numbers. `root` is the prefix of all paths: "" for
 * this machine, or a test folder with the same layout. Returns the number of nodes. Nodes beyond
 * HID_NODES_MAX are dropped. */
uint32_t hid_nodes_list(const char *root, struct hid_node out[HID_NODES_MAX]);

/* Returns the name of the node's bus: "USB", "Bluetooth", "I2C", "virtual" or "other". */
const char *hid_node_bus(const struct hid_node *node);

/* Size of the receive buffer in bytes, twice the longest report that a descriptor may declare. */
#define HID_SOURCE_BYTES 16384u

/* An open source of reports. hid_source_open() initializes the structure. */
struct hid_source {
    const char *path;
    const struct hid_descriptor *descriptor;
    int file;
    bool is_node; /* True for a device node, false for a file or a pipe. */
    /* True after the end of the file, or after every writer of the pipe has closed the pipe. */
    bool at_end;
    size_t size; /* Number of valid bytes in the buffer `bytes`. */
    /* Length in bytes of the report that the last hid_source_pull() returned. The next call removes
     * this report from the buffer. */
    size_t given;
    uint64_t taken; /* Position of the first byte of the buffer in the whole stream. */
    uint8_t bytes[HID_SOURCE_BYTES];
};

/* Opens the source at `path` and fills `descriptor`. The descriptor is read from the file
 * `descriptor_path`, or from the device node if `descriptor_path` is null. Returns EXIT_OK. After
 * an error, prints one line and returns another exit code. `path` and `descriptor` must outlive
 * `source`. */
enum exit_code hid_source_open(struct hid_source *source, const char *path,
                               struct hid_descriptor *descriptor, const char *descriptor_path);

/* Result of hid_source_pull(). */
enum hid_pull {
    HID_PULL_NOTHING = 0, /* No complete report was received within `timeout_ms`. */
    /* A report was received. The bytes of `out` stay valid until the next call. */
    HID_PULL_REPORT,
    /* The source has ended. `*code` is the exit code. An error has already been printed. */
    HID_PULL_END,
};

/* Waits up to `timeout_ms` for the next report. For HID_PULL_REPORT, sets `*out`. For HID_PULL_END,
 * sets `*code`. */
enum hid_pull hid_source_pull(struct hid_source *source, int timeout_ms, struct hid_report *out,
                              enum exit_code *code);

/* Closes the file or the device node of the source. */
void hid_source_close(struct hid_source *source);
