/* usb_sysfs.h -- reads what Linux has stored about a USB device in /sys, without opening it.
 *
 * A row gets its name, and a controller is classified by its report descriptor, while another
 * driver is bound. `root` is "/sys", or a folder of a test. */
#ifndef KINGYO_DRIVERS_USB_USB_SYSFS_H
#define KINGYO_DRIVERS_USB_USB_SYSFS_H

#include <stdint.h>

#include "drivers/hid/hid_port.h"

/* Reads a text of the device at `port` ("3-1.4"): "serial", "product" or "manufacturer". The
 * result is "" if there is none. Bytes that are not printable UTF-8 become '?', and the text is
 * truncated between two characters. */
void usb_sysfs_text(const char *root, const char *port, const char *name, char out[HID_TEXT_SIZE]);

/* Reads the report descriptor of one interface. Returns its size, or 0 if no HID driver is
 * bound. At most HID_DESCRIPTOR_MAX bytes are read. */
uint32_t usb_sysfs_descriptor(const char *root, const char *port, uint8_t configuration,
                              uint8_t interface_number, uint8_t out[HID_DESCRIPTOR_MAX]);

/* Reads the serial number of the USB device of a node such as "/dev/input/event5" or
 * "/dev/hidraw3". The result is "" if there is no serial number or if the device is not on USB. */
void usb_sysfs_node_serial(const char *root, const char *node, char out[HID_TEXT_SIZE]);

/* Trims a device's text in place, drops a truncated character at the end, and applies
 * printable(). */
void usb_sysfs_clean_text(char text[HID_TEXT_SIZE]);

#endif
