/* hid_mapping_store_text.h -- the file name and the text of a mapping store entry, and their
 * parser.
 *
 * All functions are pure. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_STORE_TEXT_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_STORE_TEXT_H

#include "drivers/hid/hid_mapping.h"

#define HID_MAPPING_STORE_TEXT_SIZE (HID_MAPPING_TEXT_SIZE + 256u)

struct hid_mapping_store_entry {
    uint16_t vendor, product;
    /* "": every device of this product that reports no serial number. */
    char serial[HID_TEXT_SIZE];
    struct hid_mapping map;
};

/* Fits the longest serial number with three characters for each byte. */
#define HID_MAPPING_STORE_NAME_SIZE 224u

/* Writes the file name "054c-09cc-SERIAL.poi". Characters with a meaning in paths are written as
 * %XX. */
void hid_mapping_store_name(const struct hid_mapping_store_entry *entry,
                            char name[HID_MAPPING_STORE_NAME_SIZE]);

/* Writes three lines: the format version, vendor:product:serial, and the mapping. Returns 0, or
 * -1 if the mapping cannot be written as text. */
int hid_mapping_store_write(const struct hid_mapping_store_entry *entry,
                            char text[HID_MAPPING_STORE_TEXT_SIZE]);

/* Parses a mapping file. Returns 0, or the number (from 1) of the first invalid line and its
 * fault in `error`. */
int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE]);

#endif
