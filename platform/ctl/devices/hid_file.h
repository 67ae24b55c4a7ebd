/* hid_file.h -- reads report descriptors and reports from files that contain hex text or binary
 * data. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_FILE_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

#define HID_ID_SIZE 256u /* A file name on Linux has at most 255 bytes. */

/* Size in bytes of the read buffer for a descriptor file. The buffer has room for four characters
 * per byte: two hex digits and white space. One extra byte lets the parser detect a descriptor that
 * is too long. */
#define HID_FILE_SIZE (4u * (HID_DESCRIPTOR_SIZE_MAX + 1u))

/* Largest file of reports in bytes. The size holds 2 h of 64-byte reports at 1 kHz. */
#define HID_REPORTS_SIZE_MAX (1u << 30)

#define HID_NOT_HEX (-1)  /* The text contains something other than hex digits and white space. */
#define HID_HALF_HEX (-2) /* The text is hex, but one byte has only one digit. */

/* Converts hex text with white space between the bytes to bytes, in place. Returns the number of
 * bytes, HID_NOT_HEX or HID_HALF_HEX. */
long hid_from_hex(uint8_t *bytes, size_t size);

/* Parses the content of a file as a descriptor. Hex text is converted, and any other content is the
 * binary descriptor. Overwrites `bytes`.
 *
 * Returns EXIT_OK, or EXIT_BAD_DATA after one line on standard error that names `path` and the
 * byte. */
enum exit_code hid_file_take(struct hid_descriptor *out, uint8_t *bytes, size_t size,
                             const char *path);

/* Reads and parses the descriptor file at `path`. Returns the codes of hid_file_take(), or EXIT_IO
 * after printing the error if the file cannot be read. */
enum exit_code hid_file_read(struct hid_descriptor *out, const char *path);

/* Writes the base name of `path` up to its last dot. This id links the rows of a descriptor with
 * the rows of its reports. */
void hid_file_id(const char *path, char id[HID_ID_SIZE]);

/* Prints `errno` as the error of `path`. Returns EXIT_IO. */
enum exit_code hid_file_print_error(const char *path);

#endif
