/* hid_gadget.h -- the poi's side of the USB cable: /dev/hidgN of Linux's HID function (f_hid).
 *
 * No call blocks. If the host does not read, reports are dropped. A device whose USB function was
 * removed is opened again. */
#ifndef KINGYO_BOARD_POI_GADGET_HID_GADGET_H
#define KINGYO_BOARD_POI_GADGET_HID_GADGET_H

#include <stdint.h>

#include "drivers/hid/poi_report.h"

struct hid_gadget {
    /* Path of the device. The path "-" writes reports to standard output and gives no force
     * feedback. */
    const char *path;
    int fd;              /* File descriptor, or -1 if the device is not open. */
    uint8_t sequence;    /* Sequence number of the next sent report. */
    uint32_t shut_count; /* Number of consecutive writes that found no host. */
    uint32_t sent_count;
    /* Number of reports that were dropped because the host had not fetched the previous report or
     * no host is present. */
    uint32_t skipped_count;
    uint32_t felt_count;
    uint32_t refused_count; /* Number of rejected output reports of an unknown format. */
};

/* Initializes the gadget without opening the device. `path` must outlive `gadget`. */
void hid_gadget_init(struct hid_gadget *gadget, const char *path);

/* Opens the device if it is not open. Returns 1 if the device is open. Returns 0 and sets errno
 * otherwise. */
int hid_gadget_open(struct hid_gadget *gadget);

/* Sends a report with the next sequence number. Returns 1, or 0 if the report was dropped. */
int hid_gadget_send(struct hid_gadget *gadget, const struct poi_report *report);

/* Reads the newest force feedback after the last call. Returns 1 and sets `out`, or returns 0 if
 * there is none. */
int hid_gadget_feel(struct hid_gadget *gadget, struct poi_force *out);

/* Closes the device. */
void hid_gadget_close(struct hid_gadget *gadget);

#endif
