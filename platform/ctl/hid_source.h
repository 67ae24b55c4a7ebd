/* hid_source.h -- live reports: of a device's node, or of a file or pipe that holds what one sent.
 *
 * A node (/dev/hidraw3) gives one report a read, and its own descriptor. Anything else gives bytes,
 * which the descriptor cuts into reports: as they lie in the file that `cat /dev/hidraw3` made. */
#ifndef KINGYO_PLATFORM_CTL_HID_SOURCE_H
#define KINGYO_PLATFORM_CTL_HID_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid_descriptor.h"
#include "platform/kiosk/options.h"

#define HID_SOURCE_BYTES 16384u /* Twice the longest report that a descriptor may declare. */

struct hid_source {
    const char *path;
    const struct hid_descriptor *descriptor;
    int file;
    uint8_t is_node;
    uint8_t at_end; /* Of a file, or every writer of a pipe has left. */
    size_t size;    /* Bytes that wait in `bytes` to be cut. */
    size_t given;   /* Those of the report that was pulled last. */
    uint64_t taken; /* Bytes that went before them. */
    uint8_t bytes[HID_SOURCE_BYTES];
};

/* Opens `path`. `descriptor` is filled from `descriptor_path`, or by the node itself where that is
 * null. EXIT_OK, else told. */
enum exit_code hid_source_open(struct hid_source *source, const char *path,
                               struct hid_descriptor *descriptor, const char *descriptor_path);

enum hid_pull {
    HID_PULL_NOTHING = 0, /* Within `timeout_ms`. */
    HID_PULL_REPORT,      /* `out` is one; its bytes stay until the next call. */
    HID_PULL_END,         /* There will be no more; `*code` says how it ended, told unless OK. */
};

enum hid_pull hid_source_pull(struct hid_source *source, int timeout_ms, struct hid_report *out,
                              enum exit_code *code);

void hid_source_close(struct hid_source *source);

#endif
