/* usb_rows.h -- the rows of the operator's menu: who has which, and for how long. Pure. */
#ifndef KINGYO_DRIVERS_USB_ROWS_H
#define KINGYO_DRIVERS_USB_ROWS_H

#include <stdint.h>

#include "drivers/hid_roster.h"
#include "drivers/usb_choice.h"

struct usb_rows {
    struct hid_row row[CONTROLLER_MAX];
    char text[HAL_TEXT_SIZE]; /* What hid_roster_ops.describe() says. */
    uint32_t wanted_count;    /* Who was named to play, whether it is here or not. */
    struct usb_key wanted[USB_WISH_MAX];
};

void usb_rows_init(struct usb_rows *rows);

/* A row for who was plugged in, FREE for now: the one that it was lost from, else an empty one. In
 * a full house it is one of who is barred, then of who is lost; CONTROLLER_MAX: there is none. Who
 * is barred gets one only while POI_MAX others stay empty. */
uint32_t usb_rows_enter(struct usb_rows *rows, const struct hid_identity *identity, int is_barred);

/* The row of exactly this one, whether it is here or lost; CONTROLLER_MAX: it has none. */
uint32_t usb_rows_find(const struct usb_rows *rows, const struct hid_identity *identity);

/* Empties it. */
void usb_rows_clear(struct usb_rows *rows, uint32_t index);

#endif
