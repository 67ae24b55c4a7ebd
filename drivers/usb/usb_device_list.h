/* usb_device_list.h -- the USB device list, shared between the event thread and the frame loop.
 *
 * The event thread publishes rows. The frame loop reads the newest rows and sends commands.
 * Neither blocks. */
#ifndef KINGYO_DRIVERS_USB_USB_DEVICE_LIST_H
#define KINGYO_DRIVERS_USB_USB_DEVICE_LIST_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/usb/device_table.h"
#include "drivers/usb/triple_buffer.h"

#define USB_COMMAND_MAX 8u /* Capacity of the command queue, which is emptied within a frame. */

/* A command with a copy of the identity, because rows can change before the command is executed. */
struct usb_command {
    uint8_t plays; /* 1 to choose the controller, 0 to release it. */
    struct hid_identity identity;
};

struct usb_device_list {
    struct triple_buffer mail;
    struct device_table rows[TRIPLE_BUFFER_SLOTS];
    atomic_uint pushed, taken; /* Counters of the commands. */
    struct usb_command order[USB_COMMAND_MAX];
    void (*wake)(void *self);
    void *wake_self;
};

/* Initializes an empty list. `wake` is called for each command. */
void usb_device_list_init(struct usb_device_list *device_list, void (*wake)(void *self),
                          void *wake_self);

/* For the event thread: copies and publishes `rows`; takes the next command.
 * usb_device_list_take_command() returns 1, or 0 if there is no command. */
void usb_device_list_publish(struct usb_device_list *device_list, const struct device_table *rows);
int usb_device_list_take_command(struct usb_device_list *device_list, struct usb_command *out);

/* For the frame loop: copies the chosen keys and returns their number; returns the device list
 * interface. */
uint32_t usb_device_list_wanted(struct usb_device_list *device_list,
                                struct usb_key out[USB_REQUEST_MAX]);
struct hid_device_list usb_device_list_device(struct usb_device_list *device_list);

#endif
