/* hid_file.h -- report descriptors and reports as files hold them: hex text, or the bytes. */
#ifndef KINGYO_PLATFORM_CTL_HID_FILE_H
#define KINGYO_PLATFORM_CTL_HID_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid_descriptor.h"
#include "platform/kiosk/options.h"

#define HID_ID_SIZE 256u /* A file name on Linux has 255 bytes at most. */

/* The bytes of a file that may be a descriptor, or hex of one: four letters for each byte, blanks
 * among them, and one byte more than there may be, so that the reader sees that it is too long. */
#define HID_FILE_SIZE (4u * (HID_DESCRIPTOR_SIZE_MAX + 1u))

#define HID_REPORTS_SIZE_MAX (1u << 30) /* Bytes; 2 h of 64-byte reports at 1 kHz. */

#define HID_NOT_HEX (-1)  /* Something else than hex digits and blanks is among them. */
#define HID_HALF_HEX (-2) /* It is hex, but a byte has one digit. */

/* Hex text with blanks between bytes, to bytes in place: how many, or one of the two above. */
long hid_from_hex(uint8_t *bytes, size_t size);

/* Reads what is in a file: hex text, or the descriptor itself where there is anything else in it.
 * EXIT_OK, or EXIT_BAD_DATA with one line on standard error that names `path` and the byte. `bytes`
 * are used up. */
enum exit_code hid_file_take(struct hid_descriptor *out, uint8_t *bytes, size_t size,
                             const char *path);

/* The same from a file's name; EXIT_IO, told, where it cannot be read. */
enum exit_code hid_file_read(struct hid_descriptor *out, const char *path);

/* The base name up to its last dot: what a descriptor's rows and its reports are known by. */
void hid_file_id(const char *path, char id[HID_ID_SIZE]);

/* Tells `errno` of a path, and EXIT_IO. */
enum exit_code hid_tell_io(const char *path);

#endif
