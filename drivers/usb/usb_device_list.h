/* usb_device_list.h -- the list of USB controllers, shared between the event thread and the frame
 * loop.
 *
 * The event thread publishes rows. The frame loop reads the newest rows and sends commands. Neither
 * thread blocks. */
#ifndef KINGYO_DRIVERS_USB_USB_DEVICE_LIST_H
#define KINGYO_DRIVERS_USB_USB_DEVICE_LIST_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/usb/device_table.h"
#include "drivers/usb/triple_buffer.h"

/* Capacity of the command queue, which the event thread empties within a frame. */
#define USB_COMMAND_MAX 8u

/* Command of the operator. The identity is copied, because the rows can change before the command
 * is executed. */
struct usb_command {
    uint8_t plays; /* 1 if the controller is selected to play, 0 if it is released. */
    struct hid_identity identity;
};

struct usb_device_list {
    struct triple_buffer mail;
    struct device_table rows[TRIPLE_BUFFER_SLOTS];
    atomic_uint pushed, taken; /* Number of queued commands and number of executed commands, each
                                  since usb_device_list_init(). */
    struct usb_command order[USB_COMMAND_MAX];
    void (*wake)(void *self);
    void *wake_self;
};

/* Initializes an empty list. `wake` is called for each command. */
void usb_device_list_init(struct usb_device_list *device_list, void (*wake)(void *self),
                          void *wake_self);

/* Copies and publishes `rows`. Called only by the event thread. */
void usb_device_list_publish(struct usb_device_list *device_list, const struct device_table *rows);
/* Takes the next command. Called only by the event thread. Returns 1 and fills `out`, or returns 0
 * if there is no command. */
int usb_device_list_take_command(struct usb_device_list *device_list, struct usb_command *out);

/* Copies the keys of the selected controllers and returns their number. Called only by the frame
 * loop. */
uint32_t usb_device_list_wanted(struct usb_device_list *device_list,
                                struct usb_key out[USB_REQUEST_MAX]);
/* Returns the device list interface for the controller manager. Called only by the frame loop. */
struct hid_device_list usb_device_list_device(struct usb_device_list *device_list);

#endif
