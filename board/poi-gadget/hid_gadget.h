/* hid_gadget.h -- the poi's side of the USB cable: /dev/hidgN of Linux's HID function (f_hid).
 *
 * No call waits. A host that does not listen costs reports, never time; a function that was taken
 * away is looked for again. */
#ifndef KINGYO_POI_GADGET_HID_GADGET_H
#define KINGYO_POI_GADGET_HID_GADGET_H

#include <stdint.h>

#include "drivers/poi_report.h"

struct hid_gadget {
    const char *path;       /* "-": reports go to standard output, and nothing is felt. */
    int fd;                 /* -1: not open. */
    uint8_t sequence;       /* Of the next report that leaves. */
    uint32_t shut_count;    /* Writes in a row that found no host. */
    uint32_t sent_count;
    uint32_t skipped_count; /* The host had not fetched the last one, or nobody is there. */
    uint32_t felt_count;
    uint32_t refused_count; /* Output reports that were none of ours. */
};

/* `path` must outlive it. */
void hid_gadget_init(struct hid_gadget *gadget, const char *path);

/* 1: open, or opened now; 0: there is no such device (errno says why). */
int hid_gadget_open(struct hid_gadget *gadget);

/* Sends a report under the next sequence number: 1, or 0 where it was skipped. */
int hid_gadget_send(struct hid_gadget *gadget, const struct poi_report *report);

/* The newest of what the hand is to feel since the last call: 1 and `out`, or 0. */
int hid_gadget_feel(struct hid_gadget *gadget, struct poi_force *out);

void hid_gadget_close(struct hid_gadget *gadget);

#endif
