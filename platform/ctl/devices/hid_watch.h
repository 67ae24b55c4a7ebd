/* hid_watch.h -- the subcommand `kingyoctl hid watch`.
 *
 * The subcommand lists the HID devices, or shows the reports that one device sends. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_WATCH_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_WATCH_H

#include "platform/ctl/lib/ctl.h"

#define HID_WATCH_SECONDS_MAX 86400u /* One day. */

struct hid_watch_options {
    const char *path; /* Path of the device. Null lists all devices. */
    const char
        *descriptor_path; /* Path of the descriptor if `path` is a file or a pipe, or null. */
    uint32_t seconds; /* Duration in seconds. 0 means that the command runs until the source ends or
                         the user stops the command. */
};

/* Runs `kingyoctl hid watch`. Returns the exit code of the program. */
enum exit_code hid_watch(const struct hid_watch_options *options);

#endif
