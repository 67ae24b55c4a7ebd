/* hid_gadget.h -- sends reports from the poi's board to the host over USB, and receives force
 * feedback. The device /dev/hidgN belongs to Linux's USB gadget function for HID (f_hid).
 *
 * No call blocks. If the host does not read, reports are dropped. If the USB function was removed
 * and created again, the device is opened again. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "drivers/hid/poi_report.h"

struct hid_gadget {
    /* Path of the device /dev/hidgN. "-" means that reports are written to standard output and that
     * no force feedback is received. */
    const char *path;
    int fd;           /* File descriptor, or -1 if the device is not open. */
    uint8_t sequence; /* Sequence number of the next report to the host. */
    /* Number of consecutive writes that failed because no host is connected. */
    uint32_t shut_count;
    uint32_t sent_count;
    /* Number of dropped reports. A report is dropped if the host has not fetched the previous
     * report, or if no host is connected. */
    uint32_t skipped_count;
    uint32_t felt_count;
    /* Number of received output reports that were rejected because their format is unknown. */
    uint32_t refused_count;
};

/* Initializes the structure without opening the device. `path` must outlive `gadget`. */
void hid_gadget_init(struct hid_gadget *gadget, const char *path);

/* Opens the device unless it is already open. Returns true if the device is open. Otherwise sets
 * errno and returns false. */
bool hid_gadget_open(struct hid_gadget *gadget);

/* Sends a report and sets its sequence number. Returns true if the report was sent, or false if the
 * report was dropped. */
bool hid_gadget_send(struct hid_gadget *gadget, const struct poi_report *report);

/* Reads the newest force feedback report that arrived since the last call. Returns true and
 * sets `out`, or returns false if no report arrived. */
bool hid_gadget_feel(struct hid_gadget *gadget, struct poi_force *out);

/* Closes the device /dev/hidgN. */
void hid_gadget_close(struct hid_gadget *gadget);
