/* usb_sysfs.h -- reads the data that Linux provides about a USB device in /sys, without opening the
 * device.
 *
 * The menu shows the name of the device, and the report descriptor determines the kind of the
 * device. Both are available even while a kernel driver uses the device. `root` is "/sys", or a
 * folder of a test. */
#pragma once

#include <stdint.h>

#include "drivers/hid/hid_port.h"

/* Size of the buffer for the path of the root of sysfs. */
#define USB_SYSFS_PATH_SIZE 1100u

/* Reads the text `name` ("serial", "product" or "manufacturer") of the device at `port`, such as
 * "3-1.4". The result is "" if there is no such text. Bytes that are not printable UTF-8 become
 * '?'. A long text is truncated between two characters. */
void usb_sysfs_text(const char *root, const char *port, const char *name, char out[HID_TEXT_SIZE]);

/* Reads the report descriptor of one interface, at most HID_DESCRIPTOR_MAX bytes. Returns the size
 * of the descriptor, or 0 if no HID driver is bound to the interface. */
uint32_t usb_sysfs_descriptor(const char *root, const char *port, uint8_t configuration,
                              uint8_t interface_number, uint8_t out[HID_DESCRIPTOR_MAX]);

/* Reads the serial number of the USB device that belongs to a node such as "/dev/input/event5" or
 * "/dev/hidraw3". The result is "" if there is no serial number or if the device is not on USB. */
void usb_sysfs_node_serial(const char *root, const char *node, char out[HID_TEXT_SIZE]);

/* Cleans a text of a device in place: removes trailing spaces and newlines, removes an incomplete
 * character at the end, and replaces bytes that are not printable UTF-8. */
void usb_sysfs_clean_text(char text[HID_TEXT_SIZE]);
