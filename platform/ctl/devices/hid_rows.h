/* hid_rows.h -- prints descriptors and decoded reports as tab-separated rows on standard output. */
#pragma once

#include <stdio.h>

#include "drivers/hid/hid_descriptor.h"
#include "platform/config/options.h"

/* Prints a header line and one row for each input field of the descriptor. */
void hid_rows_describe(const struct hid_descriptor *descriptor, const char *id);

/* Header line of hid_rows_values(), without a newline. */
#define HID_VALUE_HEADER "id\tseq\treport_id\tbit_offset\tbit_size\tusage\tvalue\tnote"

/* Prints one row for each value of a report. Prints no row if the report is shorter than the
 * descriptor declares. Constant fields and fields of more than 32 bits are skipped. Every row ends
 * in `tail`, which contains optional further columns and a newline. */
void hid_rows_values(const struct hid_descriptor *descriptor, const char *id, const char *seq,
                     struct hid_report report, const char *tail);

/* Decodes the reports in `file` whose id equals `id`. Prints the header line and one row for each
 * value. The file has a header line and then rows with an id, a number, the report in hex and
 * optional further columns.
 *
 * Returns EXIT_OK. Returns EXIT_NOT_SO if no report has the id, or if every report is shorter than
 * declared. Returns EXIT_BAD_DATA for an invalid line and EXIT_IO for a read error. Each error
 * message contains `path`, and the message for an invalid line also contains the line number. */
enum exit_code hid_rows_decode(const struct hid_descriptor *descriptor, const char *id, FILE *file,
                               const char *path);

/* Size in bytes of a usage name with its terminating zero. */
#define HID_NAME_SIZE 24u

/* Writes the name of a usage, for example "X", "hat", "button 3" or "tip". A usage that is not in
 * the table is written as page:id in hex. Returns `out`. */
const char *hid_usage_name(hid_usage usage, char out[HID_NAME_SIZE]);
