/* hid_mapping_store_text.h -- writes the file name and the text of a mapping store entry, and
 * parses the text. Pure: uses no files. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_STORE_TEXT_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_STORE_TEXT_H

#include "drivers/hid/hid_mapping.h"

#define HID_MAPPING_STORE_TEXT_SIZE (HID_MAPPING_TEXT_SIZE + 256u)

struct hid_mapping_store_entry {
    uint16_t vendor, product;
    /* Serial number of the device. "" means every device of the product that reports no serial
     * number. */
    char serial[HID_TEXT_SIZE];
    struct hid_mapping map;
};

/* Size of a file name with the longest serial number. Each byte of the serial number can become
 * three characters. */
#define HID_MAPPING_STORE_NAME_SIZE 224u

/* Writes the file name, such as "054c-09cc-SERIAL.poi". All characters of the serial number except
 * letters, digits and '_' are written as %XX. */
void hid_mapping_store_name(const struct hid_mapping_store_entry *entry,
                            char name[HID_MAPPING_STORE_NAME_SIZE]);

/* Writes three lines: the format version, vendor:product:serial, and the mapping. Returns 0, or -1
 * if the mapping cannot be written as text. */
int hid_mapping_store_write(const struct hid_mapping_store_entry *entry,
                            char text[HID_MAPPING_STORE_TEXT_SIZE]);

/* Parses a mapping file. Returns 0. On an error, returns the number (1 to 3) of the first invalid
 * line and describes the error in `error`. */
int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE]);

#endif
