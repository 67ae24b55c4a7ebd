/* device_table.h -- the rows of the operator's controller menu, and their assignment to
 * controllers. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_USB_DEVICE_TABLE_H
#define KINGYO_DRIVERS_USB_DEVICE_TABLE_H

#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/usb/usb_choice.h"

struct device_table {
    struct hid_row row[CONTROLLER_MAX];
    char text[HAL_TEXT_SIZE]; /* Text that hid_device_list_ops.describe() returns. */
    /* Number of keys in `wanted`. Each key (usb_choice.h) names a controller that is selected to
     * play, whether the controller is present or not. */
    uint32_t wanted_count;
    struct usb_key wanted[USB_REQUEST_MAX];
};

/* Initializes the table with empty rows and no selected controllers. */
void device_table_init(struct device_table *rows);

/* Assigns a row to a new controller, with the state CONTROLLER_FREE, or CONTROLLER_UNSUPPORTED if
 * `is_barred` is 1. `is_barred` means that the kiosk must not use the controller, for example a
 * keyboard. Returns the row, or CONTROLLER_MAX if there is none.
 *
 * The first choice is the row of the same controller if the controller was lost. The next choices
 * are an empty row, a row with CONTROLLER_UNSUPPORTED, and the row of a different lost controller.
 * If `is_barred` is 1, the controller gets an empty row only while more than POI_MAX rows are
 * empty. */
uint32_t device_table_enter(struct device_table *rows, const struct hid_identity *identity,
                            int is_barred);

/* Returns the row of the controller with exactly this identity, whether present or lost, or
 * CONTROLLER_MAX if there is none. */
uint32_t device_table_find(const struct device_table *rows, const struct hid_identity *identity);

/* Empties a row. */
void device_table_clear(struct device_table *rows, uint32_t index);

#endif
