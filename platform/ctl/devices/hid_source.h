/* hid_source.h -- a source of live reports: a device node, or a file or pipe with recorded reports.
 *
 * Each read from a node (/dev/hidraw3) returns one report, and the node provides its own
 * descriptor. Any other source is a stream of bytes, as `cat /dev/hidraw3` writes it. The
 * descriptor divides the stream into reports. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_SOURCE_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

/* Buffer size in bytes: twice the longest report that a descriptor may declare. */
#define HID_SOURCE_BYTES 16384u

/* An open source of reports. hid_source_open() fills it. */
struct hid_source {
    const char *path;
    const struct hid_descriptor *descriptor;
    int file;
    uint8_t is_node;
    uint8_t at_end; /* 1 at the end of a file, or after every writer of a pipe has closed it. */
    size_t size;    /* Number of valid bytes in `bytes`. */
    size_t given;   /* Length of the report that was returned last. The next call removes these
                       bytes. */
    uint64_t taken; /* Number of bytes of the stream that precede `bytes`. */
    uint8_t bytes[HID_SOURCE_BYTES];
};

/* Opens the source at `path`. Fills `descriptor` from the file `descriptor_path`, or from the node
 * if `descriptor_path` is null. Returns EXIT_OK, or another exit code after printing the error.
 * `path` and `descriptor` must outlive `source`. */
enum exit_code hid_source_open(struct hid_source *source, const char *path,
                               struct hid_descriptor *descriptor, const char *descriptor_path);

/* Result of hid_source_pull(). */
enum hid_pull {
    HID_PULL_NOTHING = 0, /* No report arrived within `timeout_ms`. */
    HID_PULL_REPORT,      /* `out` is a report. The bytes stay valid until the next call. */
    HID_PULL_END,         /* The source has ended. `*code` is the exit code, and every error was
                             printed. */
};

/* Waits up to `timeout_ms` for the next report. Sets `out` for HID_PULL_REPORT, and `*code` for
 * HID_PULL_END. */
enum hid_pull hid_source_pull(struct hid_source *source, int timeout_ms, struct hid_report *out,
                              enum exit_code *code);

/* Closes the source. */
void hid_source_close(struct hid_source *source);

#endif
