/* hid_watch.h -- the subcommand `kingyoctl hid watch`.
 *
 * The subcommand lists the HID devices, or shows the reports that one device sends. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_WATCH_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_WATCH_H

#include "platform/config/options.h"

/* Runs the subcommand. `argv` starts with the first argument after `watch`. Returns the exit code
 * of the program. */
enum exit_code hid_watch(int argc, const char *const *argv);

#endif
