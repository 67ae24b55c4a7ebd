/* hid_watch.h -- `kingyoctl hid watch`: which devices there are, and what one of them sends now. */
#ifndef KINGYO_PLATFORM_CTL_HID_WATCH_H
#define KINGYO_PLATFORM_CTL_HID_WATCH_H

#include "platform/kiosk/options.h"

/* Whatever stands behind the word `watch`. */
enum exit_code hid_watch(int argc, const char *const *argv);

#endif
