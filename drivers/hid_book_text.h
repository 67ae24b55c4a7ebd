/* hid_book_text.h -- an entry of the book as a file's name and as its text, and back. Pure. */
#ifndef KINGYO_DRIVERS_HID_BOOK_TEXT_H
#define KINGYO_DRIVERS_HID_BOOK_TEXT_H

#include "drivers/hid_map.h"

#define HID_BOOK_TEXT_SIZE (HID_MAP_TEXT_SIZE + 256u)

struct hid_book_entry {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": all of this product that say none. */
    struct hid_map map;
};

#define HID_BOOK_NAME_SIZE 224u /* Three letters for each byte of the longest serial number. */

/* "054c-09cc-SERIAL.poi"; what could lead elsewhere in a path is written as %XX. */
void hid_book_name(const struct hid_book_entry *entry, char name[HID_BOOK_NAME_SIZE]);

/* Three lines: what the file is, vendor:product:serial, the map. -1: a map that none can write. */
int hid_book_write(const struct hid_book_entry *entry, char text[HID_BOOK_TEXT_SIZE]);

/* 0, or the number of the line (from 1) that is none of ours, and what is wrong in `error`. */
int hid_book_read(struct hid_book_entry *out, const char *text, char error[HAL_TEXT_SIZE]);

#endif
