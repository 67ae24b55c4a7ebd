/* hid_rows.h -- prints descriptors and decoded reports as tab-separated rows on standard output. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_HID_ROWS_H
#define KINGYO_PLATFORM_CTL_DEVICES_HID_ROWS_H

#include <stdio.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

/* Prints the header line and one row per input field. */
void hid_rows_describe(const struct hid_descriptor *descriptor, const char *id);

/* Header line of hid_rows_values(), without a newline. */
#define HID_VALUE_HEADER "id\tseq\treport_id\tbit_offset\tbit_size\tusage\tvalue\tnote"

/* Prints one row per value of a report, or no row if the report is shorter than declared. Constants
 * and fields of more than 32 bits are skipped. Every row ends in `tail`, which is a newline,
 * possibly after further columns. */
void hid_rows_values(const struct hid_descriptor *descriptor, const char *id, const char *seq,
                     struct hid_report report, const char *tail);

/* Decodes the reports in `file` that belong to `id`. Prints the header line and the values. The
 * file has a header line and rows of id, number, report in hex and optional further columns.
 *
 * Returns EXIT_OK, EXIT_NOT_SO if no report has this id or none is as long as declared,
 * EXIT_BAD_DATA or EXIT_IO. Each error is printed with `path`, and with the line number if one line
 * is invalid. */
enum exit_code hid_rows_decode(const struct hid_descriptor *descriptor, const char *id, FILE *file,
                               const char *path);

#endif
