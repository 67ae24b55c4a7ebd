/* hid_rows.c -- prints a descriptor with one row for each field, and a report with one row for each
 * value. */
#include "platform/ctl/devices/hid_rows.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/devices/hid_file.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

#define PAGE_KEYBOARD 0x07u
#define PAGE_BUTTON 0x09u

/* First vendor-defined page. All higher pages are vendor-defined too (HID Usage Tables 1.5, section
 * 3). */
#define PAGE_VENDOR 0xff00u

/* Longest line of a report file in characters. A report of 8 KiB needs 16 KiB of hex text. */
#define LINE_SIZE 65536
#define REPORT_SIZE_MAX 16384u

/* Names of usages in runs of adjacent usages. `first` is the first usage of the run. A null name
 * means that the usage is written in hex. */
static const struct {
    hid_usage first;
    const char *names[10];
} runs[] = {
    /* Usages of the Generic Desktop page (HID Usage Tables 1.5, section 4). */
    { 0x00010001, { "pointer", "mouse", NULL, "joystick", "game pad", "keyboard", "keypad" } },
    { 0x00010008, { "multi-axis controller" } },
    { 0x00010030, { "X", "Y", "Z", "Rx", "Ry", "Rz", "slider", "dial", "wheel", "hat" } },
    { 0x0001003d, { "start", "select", NULL, "Vx", "Vy", "Vz" } },
    { 0x00010080, { "system control", NULL, NULL, NULL, NULL, "system main menu" } },
    { 0x00010090, { "pad up", "pad down", "pad right", "pad left" } },
    /* Usages of the Simulation Controls page (HID Usage Tables 1.5, section 5). */
    { 0x000200ba, { "rudder", "throttle" } },
    { 0x000200c4, { "accelerator", "brake", NULL, NULL, "steering" } },
    /* Usages of the Generic Device Controls page (HID Usage Tables 1.5, section 9) and the Consumer
     * page (section 15). */
    { 0x00060020, { "battery" } },
    { 0x000c0001, { "consumer control" } },
    { 0x000c0224, { "back" } },
    { 0x000c0238, { "pan" } },
    /* Usages of the Digitizers page (HID Usage Tables 1.5, section 16). */
    { 0x000d0001, { "digitizer", "pen", NULL, "touch screen", "touch pad" } },
    { 0x000d0022, { "finger" } },
    { 0x000d0030, { "pressure", NULL, "in range" } },
    { 0x000d003c, { "invert", "X tilt", "Y tilt", NULL, NULL, NULL, "tip", NULL, "barrel" } },
    { 0x000d0045, { "eraser", NULL, "confidence" } },
    { 0x000d0051, { "contact id", NULL, NULL, "contact count", NULL, "scan time" } },
};

const char *hid_usage_name(hid_usage usage, char out[HID_NAME_SIZE])
{
    const uint32_t page = usage >> 16, id = usage & 0xffffu;
    CORE_ASSERT(out);
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++) {
        /* For a usage before the run, the unsigned subtraction wraps around to a large number. */
        const uint32_t at = usage - runs[i].first;
        if (at < sizeof runs[0].names / sizeof runs[0].names[0] && runs[i].names[at]) {
            return runs[i].names[at];
        }
    }
    if (page == PAGE_BUTTON) {
        snprintf(out, HID_NAME_SIZE, "button %u", id);
    } else if (page == PAGE_KEYBOARD) {
        snprintf(out, HID_NAME_SIZE, "key %02x", id);
    } else {
        snprintf(out, HID_NAME_SIZE, "%s%04x:%04x", page >= PAGE_VENDOR ? "vendor's " : "", page,
                 id);
    }
    return out;
}

static void print_usage(hid_usage usage)
{
    printf("%04x:%04x", usage >> 16, usage & 0xffffu);
}

/* ---- Output of `kingyoctl hid describe` ------------------------------------------------------ */

static void describe_field(const struct hid_descriptor *descriptor, const char *id,
                           const struct hid_group *group, uint32_t index)
{
    const bool is_variable = (group->flags & HID_VARIABLE) != 0;
    print_part(stdout, "%s", id);
    putchar('\t');
    print_usage(group->application);
    printf("\t%u\t%u\t%u\t%03x\t%s\t%s\t%s\t%s\t", group->report_id,
           group->bit_offset + index * group->bit_size, group->bit_size, group->flags,
           group->flags & HID_CONSTANT ? "const" : "data", is_variable ? "var" : "array",
           group->flags & HID_RELATIVE ? "rel" : "abs",
           group->flags & HID_NULL_STATE ? "null" : "-");
    if (is_variable) {
        print_usage(hid_usage_at(descriptor, group, index));
    } else {
        for (uint32_t i = 0; i < group->range_count; i++) {
            const struct hid_range *range = &descriptor->range[group->range_first + i];
            fputs(i > 0 ? "," : "", stdout);
            print_usage(range->first);
            if (range->last != range->first) {
                putchar('-');
                print_usage(range->last);
            }
        }
    }
    printf("\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%d\t%08x\n", group->logical_min,
           group->logical_max, group->physical_min, group->physical_max, group->unit_exponent,
           group->unit);
}

void hid_rows_describe(const struct hid_descriptor *descriptor, const char *id)
{
    puts("id\tapplication\treport_id\tbit_offset\tbit_size\tflags_hex\tdata_const\tvar_array"
         "\tabs_rel\tnull\tusage\tlogical_min\tlogical_max\tphysical_min\tphysical_max"
         "\tunit_exponent\tunit_hex");
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        for (uint32_t index = 0; index < descriptor->group[i].count; index++) {
            describe_field(descriptor, id, &descriptor->group[i], index);
        }
    }
}

/* ---- Output of `kingyoctl hid decode` -------------------------------------------------------- */

void hid_rows_values(const struct hid_descriptor *descriptor, const char *id, const char *seq,
                     struct hid_report report, const char *tail)
{
    if (!hid_report_is_whole(descriptor, report)) {
        return;
    }
    const int report_id = hid_report_id(descriptor, report);
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        const bool is_shown = group->report_id == report_id && !(group->flags & HID_CONSTANT) &&
                              group->bit_size <= 32u;
        for (uint32_t index = 0; is_shown && index < group->count; index++) {
            print_part(stdout, "%s", id);
            putchar('\t');
            print_part(stdout, "%s", seq);
            const int64_t value = hid_field_value(descriptor, group, index, report);
            const bool is_array = !(group->flags & HID_VARIABLE);
            const bool out = value < group->logical_min || value > group->logical_max;
            const hid_usage usage = is_array ? hid_selected(descriptor, group, value)
                                             : hid_usage_at(descriptor, group, index);
            printf("\t%u\t%u\t%u\t", group->report_id, group->bit_offset + index * group->bit_size,
                   group->bit_size);
            if (usage) {
                print_usage(usage);
            } else {
                putchar('-');
            }
            printf("\t%" PRId64 "\t%s", value,
                   is_array ? (out ? "array,out_of_logical_range" : "array")
                            : (out ? "out_of_logical_range" : "-"));
            fputs(tail, stdout);
        }
    }
}

/* ---- Files with recorded reports ------------------------------------------------------------- */

static enum exit_code hid_rows_error(const char *path, unsigned row, const char *what)
{
    return print_fail(EXIT_BAD_DATA, "kingyoctl hid: %s: line %u: %s", path, row, what);
}

/* State of the decoding of a report file. A row of the file starts with an id. Only rows whose id
 * is the id of the descriptor are decoded. */
struct decoded {
    const struct hid_descriptor *descriptor;
    const char *id, *path;
    uint32_t reports, whole; /* `reports` is the number of rows with the descriptor's id. `whole` is
                                the number of these reports that are as long as the descriptor
                                declares. */
};

/* Decodes one row of a report file. A row whose id differs from the descriptor's id is skipped. The
 * header is printed only before the first matching row, so that an unreadable file produces no
 * output. */
static enum exit_code decode_row(struct decoded *of, char *line, unsigned row)
{
    line[strcspn(line, "\r\n")] = '\0';
    char *rest = line;
    const char *row_id = strsep(&rest, "\t");
    const char *seq = strsep(&rest, "\t");
    char *hex = strsep(&rest, "\t");
    const bool is_header = row == 1 && strcmp(row_id, "id") == 0;
    if (is_header || strcmp(row_id, of->id) != 0) {
        return EXIT_OK;
    }
    const size_t length = hex ? strlen(hex) : 0;
    const long size = hex && length <= 2u * REPORT_SIZE_MAX
                          ? hid_from_hex((uint8_t *)hex, length, NULL)
                          : HID_NOT_HEX;
    if (size < 0) {
        return hid_rows_error(of->path, row, "the third column is not a report in hex");
    }
    const struct hid_report report = { (const uint8_t *)hex, (size_t)size };
    if (of->reports++ == 0) {
        puts(HID_VALUE_HEADER);
    }
    of->whole += hid_report_is_whole(of->descriptor, report) ? 1u : 0u;
    hid_rows_values(of->descriptor, of->id, seq, report, "\n");
    return EXIT_OK;
}

enum exit_code hid_rows_decode(const struct hid_descriptor *descriptor, const char *id, FILE *file,
                               const char *path)
{
    static char line[LINE_SIZE];
    struct decoded of = { .descriptor = descriptor, .id = id, .path = path };
    enum exit_code code = EXIT_OK;
    enum file_line result;
    for (unsigned row = 1; code == EXIT_OK &&
                           (result = file_read_line(file, line, sizeof line - 1u)) != FILE_LINE_END;
         row++) {
        code = result == FILE_LINE_READ
                   ? decode_row(&of, line, row)
                   : hid_rows_error(path, row, "longer than 65534 bytes, or no text");
    }
    if (code == EXIT_OK && ferror(file)) {
        return hid_file_print_error(path);
    }
    if (code == EXIT_OK && of.reports == 0) {
        /* The id is the file name of the descriptor. If no report has this id, the report file most
         * likely belongs to another descriptor. */
        puts(HID_VALUE_HEADER);
        return print_fail(
            EXIT_NOT_SO,
            "kingyoctl hid: %s: no report of id '%s', which is the descriptor's file name", path,
            id);
    }
    if (code == EXIT_OK && of.whole == 0) {
        return print_fail(
            EXIT_NOT_SO,
            "kingyoctl hid: %s: reports of id '%s': %u, none as long as the descriptor "
            "declares",
            path, id, of.reports);
    }
    return code;
}
