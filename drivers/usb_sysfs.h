/* usb_sysfs.h -- what Linux knows of a USB device already: read from /sys, the device not touched.
 *
 * So that a row can have a name, and a controller be judged by its report descriptor, while another
 * driver still has it. `root` is "/sys"; tests have their own. */
#ifndef KINGYO_DRIVERS_USB_SYSFS_H
#define KINGYO_DRIVERS_USB_SYSFS_H

#include <stdint.h>

#include "drivers/hid_port.h"

/* A text of the device at `port` ("3-1.4"): "serial", "product", "manufacturer". "" where it has
 * none. What is no printable UTF-8 becomes '?'; cut to fit between two characters. */
void usb_sysfs_text(const char *root, const char *port, const char *name,
                    char out[HID_TEXT_SIZE]);

/* The report descriptor of one interface; 0 where no HID driver has it bound, or it is too long. */
uint32_t usb_sysfs_descriptor(const char *root, const char *port, uint8_t configuration,
                              uint8_t interface_number, uint8_t out[HID_DESCRIPTOR_MAX]);

/* The serial number of the USB device behind "/dev/input/event5" or "/dev/hidraw3"; "" where it has
 * none, or is not on USB. */
void usb_sysfs_node_serial(const char *root, const char *node, char out[HID_TEXT_SIZE]);

/* Trims the text of a device in place, drops a character that was cut in two at the end, and passes
 * the rest through printable(). */
void usb_clean_text(char text[HID_TEXT_SIZE]);

#endif
