/* hid.c -- `kingyoctl hid`: what a report descriptor says, and what reports then mean. */
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drivers/hid_descriptor.h"
#include "platform/ctl/ctl.h"

#define LINE_SIZE 65536 /* A report of 8 KiB is 16 KiB of hex. */
#define REPORT_SIZE_MAX 16384
#define ID_SIZE 256

static const char name[] = "hid";

/* One byte over the most that a descriptor may have, as hex with blanks. */
static uint8_t file_bytes[4u * (HID_DESCRIPTOR_SIZE_MAX + 1u)];
static struct hid_descriptor descriptor;

/* ---- Files ---------------------------------------------------------------------------------- */

static int hex_digit(int letter)
{
    return isdigit(letter)                  ? letter - '0'
           : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10
           : letter >= 'A' && letter <= 'F' ? letter - 'A' + 10
                                            : -1;
}

/* Hex text, blanks allowed between bytes, to bytes in place. -1: it holds something else. */
static long from_hex(uint8_t *bytes, size_t size)
{
    long count = 0;
    int high = -1;
    for (size_t i = 0; i < size; i++) {
        const int digit = hex_digit(bytes[i]);
        if (digit < 0 && !(isspace(bytes[i]) && high < 0)) {
            return -1;
        }
        if (digit >= 0 && high >= 0) {
            bytes[count++] = (uint8_t)(high << 4 | digit);
            high = -1;
        } else if (digit >= 0) {
            high = digit;
        }
    }
    return high < 0 ? count : -1;
}

static enum exit_code tell_io(const char *path)
{
    fprintf(stderr, "kingyoctl hid: %s: %s\n", path, strerror(errno));
    return EXIT_IO;
}

/* A file of hex digits and blanks is text; any other is the descriptor itself. */
static enum exit_code read_descriptor(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        return tell_io(path);
    }
    size_t size = fread(file_bytes, 1, sizeof file_bytes, file);
    const int failed = ferror(file);
    fclose(file);
    if (failed) {
        return tell_io(path);
    }
    const long count = from_hex(file_bytes, size);
    size = count >= 0 ? (size_t)count : size;
    const enum hid_error error = hid_descriptor_read(&descriptor, file_bytes, size);
    if (error || descriptor.group_count == 0) {
        fprintf(stderr, "kingyoctl hid: %s: byte %zu: %s\n", path,
                error ? descriptor.error_offset : size,
                error ? hid_error_text(error) : "no input field that is used for anything");
        return EXIT_BAD_DATA;
    }
    return EXIT_OK;
}

/* The base name up to its last dot. */
static void id_of(const char *path, char id[ID_SIZE])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    const size_t length = dot && dot != base ? (size_t)(dot - base) : strlen(base);
    snprintf(id, ID_SIZE, "%.*s", (int)(length < ID_SIZE ? length : ID_SIZE - 1), base);
}

static void print_usage(hid_usage usage)
{
    printf("%04x:%04x", usage >> 16, usage & 0xffffu);
}

/* ---- describe ------------------------------------------------------------------------------- */

static void print_ranges(const struct hid_group *group)
{
    for (uint32_t i = 0; i < group->range_count; i++) {
        const struct hid_range *range = &descriptor.range[group->range_first + i];
        fputs(i > 0 ? "," : "", stdout);
        print_usage(range->first);
        if (range->last != range->first) {
            putchar('-');
            print_usage(range->last);
        }
    }
}

static void describe_field(const char *id, const struct hid_group *group, uint32_t index)
{
    const int is_variable = (group->flags & HID_VARIABLE) != 0;
    printf("%s\t", id);
    print_usage(group->application);
    printf("\t%u\t%u\t%u\t%03x\t%s\t%s\t%s\t%s\t", group->report_id,
           group->bit_offset + index * group->bit_size, group->bit_size, group->flags,
           group->flags & HID_CONSTANT ? "const" : "data", is_variable ? "var" : "array",
           group->flags & HID_RELATIVE ? "rel" : "abs",
           group->flags & HID_NULL_STATE ? "null" : "-");
    if (is_variable) {
        print_usage(hid_usage_at(&descriptor, group, index));
    } else {
        print_ranges(group);
    }
    printf("\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%d\t%08x\n", group->logical_min,
           group->logical_max, group->physical_min, group->physical_max, group->unit_exponent,
           group->unit);
}

static enum exit_code describe(const char *path)
{
    char id[ID_SIZE];
    const enum exit_code code = read_descriptor(path);
    if (code != EXIT_OK) {
        return code;
    }
    id_of(path, id);
    puts("id\tapplication\treport_id\tbit_offset\tbit_size\tflags_hex\tdata_const\tvar_array\tabs_"
         "rel"
         "\tnull\tusage\tlogical_min\tlogical_max\tphysical_min\tphysical_max\tunit_exponent\tunit_"
         "hex");
    for (uint32_t i = 0; i < descriptor.group_count; i++) {
        for (uint32_t index = 0; index < descriptor.group[i].count; index++) {
            describe_field(id, &descriptor.group[i], index);
        }
    }
    return EXIT_OK;
}

/* ---- decode --------------------------------------------------------------------------------- */

static void print_value(const char *id, const char *seq, const struct hid_group *group,
                        uint32_t index, struct hid_report report)
{
    const int64_t value = hid_field_value(&descriptor, group, index, report);
    const int is_array = !(group->flags & HID_VARIABLE);
    const int out = value < group->logical_min || value > group->logical_max;
    const hid_usage usage = is_array ? hid_selected(&descriptor, group, value)
                                     : hid_usage_at(&descriptor, group, index);
    printf("%s\t%s\t%u\t%u\t%u\t", id, seq, group->report_id,
           group->bit_offset + index * group->bit_size, group->bit_size);
    if (usage) {
        print_usage(usage);
    } else {
        putchar('-');
    }
    printf("\t%" PRId64 "\t%s\n", value,
           is_array ? (out ? "array,out_of_logical_range" : "array")
                    : (out ? "out_of_logical_range" : "-"));
}

static void print_report(const char *id, const char *seq, struct hid_report report)
{
    if (!hid_report_is_whole(&descriptor, report)) {
        return;
    }
    const int report_id = hid_report_id(&descriptor, report);
    for (uint32_t i = 0; i < descriptor.group_count; i++) {
        const struct hid_group *group = &descriptor.group[i];
        const int is_shown = group->report_id == report_id && !(group->flags & HID_CONSTANT) &&
                             group->bit_size <= 32u;
        for (uint32_t index = 0; is_shown && index < group->count; index++) {
            print_value(id, seq, group, index, report);
        }
    }
}

/* One row: id, number, hex. Rows of other ids are no concern of ours. */
static enum exit_code decode_row(const char *path, unsigned row, char *line, const char *id)
{
    char *rest = line;
    const char *row_id = strsep(&rest, "\t\n");
    const char *seq = strsep(&rest, "\t\n");
    char *hex = strsep(&rest, "\t\n");
    if (strcmp(row_id, id) != 0) {
        return EXIT_OK;
    }
    const size_t length = hex ? strlen(hex) : 0;
    const long size = hex && length <= 2u * REPORT_SIZE_MAX ? from_hex((uint8_t *)hex, length) : -1;
    if (size < 0) {
        fprintf(stderr, "kingyoctl hid: %s: line %u: the third column is not a report in hex\n",
                path, row);
        return EXIT_BAD_DATA;
    }
    print_report(id, seq, (struct hid_report){ (const uint8_t *)hex, (size_t)size });
    return EXIT_OK;
}

static enum exit_code decode_rows(const char *path, FILE *file, const char *id)
{
    static char line[LINE_SIZE];
    enum exit_code code = EXIT_OK;
    unsigned row = 0;
    while (code == EXIT_OK && fgets(line, sizeof line, file)) {
        row++;
        if (!strchr(line, '\n') && !feof(file)) {
            fprintf(stderr, "kingyoctl hid: %s: line %u: longer than %d bytes\n", path, row,
                    LINE_SIZE - 2);
            return EXIT_BAD_DATA;
        }
        code = row == 1 ? EXIT_OK : decode_row(path, row, line, id); /* The header comes first. */
    }
    return code;
}

static enum exit_code decode(const char *descriptor_path, const char *reports_path)
{
    char id[ID_SIZE];
    enum exit_code code = read_descriptor(descriptor_path);
    if (code != EXIT_OK) {
        return code;
    }
    FILE *file = fopen(reports_path, "r");
    if (!file) {
        return tell_io(reports_path);
    }
    id_of(descriptor_path, id);
    puts("id\tseq\treport_id\tbit_offset\tbit_size\tusage\tvalue\tnote");
    code = decode_rows(reports_path, file, id);
    fclose(file);
    return code;
}

static enum exit_code run(int argc, const char *const *argv)
{
    if (argc == 2 && strcmp(argv[0], "describe") == 0) {
        return describe(argv[1]);
    }
    if (argc == 3 && strcmp(argv[0], "decode") == 0) {
        return decode(argv[1], argv[2]);
    }
    return ctl_usage(name, "describe FILE, or decode DESCRIPTOR REPORTS.tsv; --help says more");
}

const struct ctl_command ctl_hid = {
    .name = name,
    .summary = "what a HID report descriptor says, and what reports mean",
    .usage =
        "  kingyoctl hid describe FILE                   every input field, one row each\n"
        "  kingyoctl hid decode DESCRIPTOR REPORTS.tsv   the values in recorded reports\n\n"
        "A descriptor is hex text, or binary if the file holds anything else. Reports are rows\n"
        "of id, number and hex (report id first, if the device has them) under a header line;\n"
        "those are shown whose id is the descriptor's file name without its extension, and\n"
        "that are as long as declared.\n",
    .run = run,
};
