/* device_table.h -- the rows of the operator's controller menu and their allocation. Pure. */
#ifndef KINGYO_DRIVERS_USB_DEVICE_TABLE_H
#define KINGYO_DRIVERS_USB_DEVICE_TABLE_H

#include <stdint.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/usb/usb_choice.h"

struct device_table {
    struct hid_row row[CONTROLLER_MAX];
    char text[HAL_TEXT_SIZE]; /* Result of hid_device_list_ops.describe(). */
    uint32_t wanted_count;    /* Keys chosen to play, whether present or not. */
    struct usb_key wanted[USB_REQUEST_MAX];
};

void device_table_init(struct device_table *rows);

/* Returns a row for a new controller, marked FREE or BARRED, or CONTROLLER_MAX if there is none.
 * The controller's own LOST row comes first, then an empty row, then a BARRED row, then another
 * LOST row. A barred controller gets an empty row only while more than POI_MAX rows are empty. */
uint32_t device_table_enter(struct device_table *rows, const struct hid_identity *identity,
                            int is_barred);

/* Returns the row of exactly this controller, present or lost, or CONTROLLER_MAX. */
uint32_t device_table_find(const struct device_table *rows, const struct hid_identity *identity);

/* Empties a row. */
void device_table_clear(struct device_table *rows, uint32_t index);

#endif
