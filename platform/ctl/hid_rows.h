/* hid_rows.h -- what a descriptor says and what reports mean, as rows of tab-separated columns on
 * standard output. */
#ifndef KINGYO_PLATFORM_CTL_HID_ROWS_H
#define KINGYO_PLATFORM_CTL_HID_ROWS_H

#include <stdio.h>

#include "drivers/hid_descriptor.h"
#include "platform/kiosk/options.h"

/* The header line and a row for each input field. */
void hid_rows_describe(const struct hid_descriptor *descriptor, const char *id);

/* The columns of hid_rows_values(), without a newline. */
#define HID_VALUE_HEADER "id\tseq\treport_id\tbit_offset\tbit_size\tusage\tvalue\tnote"

/* A row for each value in a report, none if it is shorter than declared. Constants and fields over
 * 32 bits are left out. Every row ends in `tail`: a newline, and more columns before it if any. */
void hid_rows_values(const struct hid_descriptor *descriptor, const char *id, const char *seq,
                     struct hid_report report, const char *tail);

/* The header line, and the values of those reports in `file` that belong to `id`. Its rows are id,
 * number, report in hex and whatever else, below a header line. EXIT_OK; EXIT_NOT_SO where no
 * report is of this id, or none as long as declared; EXIT_BAD_DATA or EXIT_IO. What is not OK is
 * told with `path`, and with the line if it is one. */
enum exit_code hid_rows_decode(const struct hid_descriptor *descriptor, const char *id, FILE *file,
                               const char *path);

#endif
