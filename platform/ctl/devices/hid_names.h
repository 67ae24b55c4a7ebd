/* hid_names.h -- short English names for the HID usages of controllers, based on the HID Usage
 * Tables 1.5. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_NAMES_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_NAMES_H

#include "drivers/hid/hid_descriptor.h"

/* Size in bytes of a usage name with its terminating zero. */
#define HID_NAME_SIZE 24u

/* Writes the name of a usage, for example "X", "hat", "button 3" or "tip". A usage that is not in
 * the table is written as page:id in hex. Returns `out`. */
const char *hid_usage_name(hid_usage usage, char out[HID_NAME_SIZE]);

#endif
