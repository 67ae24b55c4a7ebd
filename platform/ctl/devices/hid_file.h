/* hid_file.h -- reads report descriptors and reports from files that contain hex text or binary
 * data. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

/* Size of a file's base name in bytes. A file name on Linux has at most 255 bytes, and the
 * terminating zero follows. */
#define HID_ID_SIZE 256u

/* Size in bytes of the read buffer for a descriptor file. For each byte of the descriptor, the file
 * may have four characters: two hex digits and two characters of white space. The buffer holds one
 * byte more than the longest descriptor, so that the parser detects a descriptor that is too
 * long. */
#define HID_FILE_SIZE (4u * (HID_DESCRIPTOR_SIZE_MAX + 1u))

/* Largest size in bytes of a file with recorded reports. 2 h of 64-byte reports at 1 kHz fit. */
#define HID_REPORTS_SIZE_MAX (1u << 30)

/* Error of hid_from_hex(): the text contains a character that is not a hex digit or white space. */
#define HID_NOT_HEX (-1)
/* Error of hid_from_hex(): the text is hex, but one byte has only one of its two digits. */
#define HID_HALF_HEX (-2)

/* Converts hex text to bytes in place. White space separates the bytes. Returns the number of
 * bytes. After an error, sets `*wrong` to the index of the wrong character, or of the digit without
 * a second digit, and returns HID_NOT_HEX or HID_HALF_HEX. `wrong` may be null. */
long hid_from_hex(uint8_t *bytes, size_t size, size_t *wrong);

/* Parses the content `bytes` of the descriptor file `path`. Hex text is first converted to bytes in
 * place, so `bytes` is overwritten. Any other content is parsed as a binary descriptor.
 *
 * Returns EXIT_OK. If the descriptor is invalid, prints one line with `path` and the position of
 * the error to standard error, and returns EXIT_BAD_DATA. */
enum exit_code hid_file_take(struct hid_descriptor *out, uint8_t *bytes, size_t size,
                             const char *path);

/* Reads and parses the descriptor file at `path`. Returns an exit code of hid_file_take(). If the
 * file cannot be read, prints the error and returns EXIT_IO. */
enum exit_code hid_file_read(struct hid_descriptor *out, const char *path);

/* Writes the base name of `path` without its last suffix to `id`. The same id is printed in the
 * rows of a descriptor and in the rows of its reports, so that the two can be matched. */
void hid_file_id(const char *path, char id[HID_ID_SIZE]);

/* Prints a line on standard error with `path` and the meaning of `errno`. Returns EXIT_IO. */
enum exit_code hid_file_print_error(const char *path);
