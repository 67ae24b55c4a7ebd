/* rows.c -- fuzz target: the commands `kingyoctl hid describe` and `kingyoctl hid decode` with two
 * arbitrary files.
 *
 * Input: a line with the size of the descriptor file in hexadecimal, the descriptor file, and the
 * file of reports. */
#include <stdlib.h>
#include <string.h>

#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/devices/hid_rows.h"
#include "tests/fuzz/trap.h"

/* Largest number of fields that are printed. Printing more fields would only execute the same code
 * again. */
#define FIELDS_SHOWN 4096u

static struct hid_descriptor descriptor;
static uint8_t file_bytes[HID_FILE_SIZE];

static void hold_decode(const uint8_t *bytes, size_t size)
{
    FILE *file = fmemopen((void *)(uintptr_t)bytes, size, "r");
    HOLD(file);
    const enum exit_code code = hid_rows_decode(&descriptor, "d", file, "reports.tsv");
    HOLD(code == EXIT_OK || code == EXIT_NOT_SO || code == EXIT_BAD_DATA);
    fclose(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *rest = NULL;
    char head[8] = "";
    memcpy(head, bytes, size < sizeof head - 1u ? size : sizeof head - 1u);
    const size_t requested = (size_t)strtoul(head, &rest, 16);
    if (*rest != '\n') {
        return 0;
    }
    bytes += rest + 1 - head;
    size -= (size_t)(rest + 1 - head);
    const size_t taken = requested < size ? requested : size;
    memcpy(file_bytes, bytes, taken < sizeof file_bytes ? taken : sizeof file_bytes);
    const enum exit_code code = hid_file_take(&descriptor, file_bytes, taken, "descriptor");
    HOLD(code == EXIT_OK || code == EXIT_BAD_DATA);
    if (code == EXIT_OK && descriptor.field_count <= FIELDS_SHOWN) {
        hid_rows_describe(&descriptor, "d");
        if (taken < size) {
            hold_decode(bytes + taken, size - taken);
        }
    }
    return 0;
}
