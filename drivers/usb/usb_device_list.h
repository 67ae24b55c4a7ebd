/* usb_device_list.h -- the list of USB controllers: the rows of the operator's controller menu,
 * their assignment to controllers, and the exchange of the list between the event thread and the
 * frame loop.
 *
 * The event thread publishes rows. The frame loop reads the newest rows and sends commands. Neither
 * thread blocks. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"
#include "drivers/usb/usb_choice.h"

struct usb_device_table {
    struct hid_row row[CONTROLLER_MAX];
    char text[HAL_TEXT_SIZE]; /* Text that hid_device_list_ops.describe() returns. */
    /* Number of keys in `wanted`. Each key (usb_choice.h) names a controller that is selected to
     * play, whether the controller is present or not. */
    uint32_t wanted_count;
    struct usb_key wanted[USB_REQUEST_MAX];
};

/* Initializes the table with empty rows and no selected controllers. */
void usb_device_table_init(struct usb_device_table *rows);

/* Assigns a row to a new controller, with the state CONTROLLER_FREE, or CONTROLLER_UNSUPPORTED if
 * `is_barred` is true. `is_barred` means that the kiosk must not use the controller, for example a
 * keyboard. Returns the row, or CONTROLLER_MAX if there is none.
 *
 * The first choice is the row of the same controller if the controller was lost. The next choices
 * are an empty row, a row with CONTROLLER_UNSUPPORTED, and the row of a different lost controller.
 * If `is_barred` is true, the controller gets an empty row only while more than POI_MAX rows are
 * empty. */
uint32_t usb_device_table_enter(struct usb_device_table *rows, const struct hid_identity *identity,
                                bool is_barred);

/* Returns the row of the controller with exactly this identity, whether present or lost, or
 * CONTROLLER_MAX if there is none. */
uint32_t usb_device_table_find(const struct usb_device_table *rows,
                               const struct hid_identity *identity);

/* Empties a row. */
void usb_device_table_clear(struct usb_device_table *rows, uint32_t index);

/* ---- Exchange between the threads ------------------------------------------------------------ */

/* Capacity of the command queue, which the event thread empties within a frame. */
#define USB_COMMAND_MAX 8u

/* Command of the operator. The identity is copied, because the rows can change before the command
 * is executed. */
struct usb_command {
    bool plays; /* True if the controller is selected to play, false if it is released. */
    struct hid_identity identity;
};

struct usb_device_list {
    struct triple_buffer newest; /* Triple buffer for `rows`. */
    struct usb_device_table rows[TRIPLE_BUFFER_SLOTS];
    /* Number of queued commands and number of executed commands, each since
     * usb_device_list_init(). */
    atomic_uint pushed, taken;
    struct usb_command order[USB_COMMAND_MAX];
    void (*wake)(void *self);
    void *wake_self;
};

/* Initializes an empty list. The callback `wake` wakes the event thread and is called for each
 * command. */
void usb_device_list_init(struct usb_device_list *device_list, void (*wake)(void *self),
                          void *wake_self);

/* Copies and publishes `rows`. Called only by the event thread. */
void usb_device_list_publish(struct usb_device_list *device_list,
                             const struct usb_device_table *rows);
/* Takes the next command. Called only by the event thread. Returns true and fills `out`, or returns
 * false if there is no command. */
bool usb_device_list_take_command(struct usb_device_list *device_list, struct usb_command *out);

/* Copies the keys of the selected controllers and returns their number. Called only by the frame
 * loop. */
uint32_t usb_device_list_wanted(struct usb_device_list *device_list,
                                struct usb_key out[USB_REQUEST_MAX]);
/* Returns the device list interface for the controller manager. Called only by the frame loop. */
struct hid_device_list usb_device_list_device(struct usb_device_list *device_list);
