/* hid_names.h -- usages as people call them: those of controllers, from HID Usage Tables 1.4. */
#ifndef KINGYO_PLATFORM_CTL_HID_NAMES_H
#define KINGYO_PLATFORM_CTL_HID_NAMES_H

#include "drivers/hid_descriptor.h"

#define HID_NAME_SIZE 24u

/* "X", "hat", "button 3", "tip"; page:id in hex where we know no word. Returns `out`. */
const char *hid_usage_name(hid_usage usage, char out[HID_NAME_SIZE]);

#endif
