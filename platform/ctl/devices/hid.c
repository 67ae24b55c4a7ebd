/* hid.c -- the command `kingyoctl hid`.
 *
 * The command explains a HID report descriptor and decodes reports with that descriptor. */
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/usb/usb_choice.h"
#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/devices/hid_live.h"
#include "platform/ctl/devices/hid_source.h"
#include "platform/ctl/devices/hid_rows.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"

/* Timeout of one wait in ms. The timeout limits the delay after Ctrl-C, and lets the displayed
 * report rate drop when no report arrives. */
#define WAIT_MS 50
#define SECONDS_MAX 86400u /* One day. */
/* Minimum time between two redraws in ns, which gives 20 redraws per second. */
#define PICTURE_NS 50000000ull

/* Terminal escape codes. SCREEN_BEGIN selects the alternate screen and hides the cursor. */
#define SCREEN_BEGIN "\x1b[?1049h\x1b[?25l"
#define SCREEN_HOME "\x1b[H"
#define LINE_REST "\x1b[K"
#define SCREEN_REST "\x1b[J"
#define SCREEN_END "\x1b[?25h\x1b[?1049l"

/* Arguments of a subcommand of `kingyoctl hid`. */
struct request {
    const char *path;   /* First argument: the path of a descriptor or of a device. Null lists all
                           devices. */
    const char *second; /* Second argument: a file of reports, or the ids of a device. */
    /* Path of the descriptor if `path` is a file or a pipe, or null. */
    const char *descriptor_path;
    uint32_t seconds; /* Duration in seconds. 0 means that the command runs until the source ends or
                         the user stops the command. */
};

/* State of `kingyoctl hid watch` for one device. */
struct watch {
    struct hid_source source;
    struct hid_live live;
    char id[HID_ID_SIZE];
    bool on_terminal;
    uint64_t begin_ns, picture_ns;
};

static const char name[] = "hid";
static volatile sig_atomic_t is_stopped;
static struct hid_descriptor descriptor;

/* ---- List of devices ------------------------------------------------------------------------- */

static enum exit_code print_hid_nodes(void)
{
    static struct hid_node nodes[HID_NODES_MAX];
    const uint32_t count = hid_nodes_list("", nodes);
    puts("node\tvendor:product\tbus\tdriver\taccess\tname");
    for (uint32_t i = 0; i < count; i++) {
        const struct hid_node *node = &nodes[i];
        printf("/dev/hidraw%u\t%04x:%04x\t%s\t%s\t%s\t%s\n", node->number, node->vendor,
               node->product, hid_node_bus(node), node->driver[0] ? node->driver : "-",
               node->open_errno ? strerror(node->open_errno) : "ok", node->name);
    }
    if (count == 0 && print_flush(stdout) == 0) { /* main() reports lost output instead. */
        print_error("kingyoctl hid: no HID device is plugged in that has a /dev/hidraw node");
    }
    return EXIT_OK;
}

/* ---- Reports of one device ------------------------------------------------------------------- */

static char *format_hid_picture(const struct watch *watch)
{
    static char text[HID_LIVE_TEXT];
    struct winsize size = { .ws_row = 24, .ws_col = 80 };
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    hid_live_picture(&watch->live, size.ws_col, size.ws_row > 1 ? size.ws_row - 1u : 1u, text);
    return text;
}

static enum exit_code hid_watch_loop(struct watch *watch, uint32_t seconds)
{
    char seq[16], tail[40];
    enum exit_code code = EXIT_OK;
    const uint64_t end_ns = seconds ? watch->begin_ns + seconds * 1000000000ull : UINT64_MAX;
    for (;;) {
        struct hid_report report;
        const enum hid_pull pull = hid_source_pull(&watch->source, WAIT_MS, &report, &code);
        if (pull == HID_PULL_REPORT) {
            const uint64_t time_ns = ctl_now_ns();
            if (!watch->on_terminal) {
                snprintf(seq, sizeof seq, "%u",
                         watch->live.report_count + watch->live.refused_count);
                snprintf(tail, sizeof tail, "\t%.3f\n", (double)(time_ns - watch->begin_ns) / 1e6);
                hid_rows_values(&descriptor, watch->id, seq, report, tail);
                fflush(stdout);
            }
            hid_live_report(&watch->live, report, time_ns);
        }
        const uint64_t time_ns = ctl_now_ns();
        hid_live_time(&watch->live, time_ns);
        if (watch->on_terminal && time_ns - watch->picture_ns >= PICTURE_NS) {
            watch->picture_ns = time_ns;
            fputs(SCREEN_HOME, stdout);
            for (char *rest = format_hid_picture(watch), *line;
                 (line = strsep(&rest, "\n")) && rest;) {
                printf("%s" LINE_REST "\n", line);
            }
            fputs(SCREEN_REST, stdout);
            fflush(stdout);
        }
        if (pull == HID_PULL_END || is_stopped || ferror(stdout) || time_ns >= end_ns) {
            return code;
        }
    }
}

static enum exit_code watch_device(const struct request *options)
{
    static struct watch watch;
    ctl_stop_at_signals(&is_stopped);
    const enum exit_code code =
        hid_source_open(&watch.source, options->path, &descriptor, options->descriptor_path);
    if (code != EXIT_OK) {
        return code;
    }
    hid_file_id(options->descriptor_path ? options->descriptor_path : options->path, watch.id);
    hid_live_begin(&watch.live, &descriptor, options->path);
    watch.on_terminal = isatty(STDOUT_FILENO) != 0;
    watch.begin_ns = ctl_now_ns();
    fputs(watch.on_terminal ? SCREEN_BEGIN : HID_VALUE_HEADER "\ttime_ms\n", stdout);
    const enum exit_code end = hid_watch_loop(&watch, options->seconds);
    /* Prints the last view once more on the normal screen, where it stays visible. */
    if (watch.on_terminal) {
        printf(SCREEN_END "%s", format_hid_picture(&watch));
    }
    fflush(stdout);
    hid_source_close(&watch.source);
    return end;
}

/* Prints the fields of the descriptor, or the values in the reports `reports_path` if it is not
 * null. */
static enum exit_code decode(const char *descriptor_path, const char *reports_path)
{
    char id[HID_ID_SIZE];
    FILE *file;
    enum exit_code code = hid_file_read(&descriptor, descriptor_path);
    hid_file_id(descriptor_path, id);
    if (code == EXIT_OK && !reports_path) {
        hid_rows_describe(&descriptor, id);
    } else if (code == EXIT_OK) {
        code = ctl_file_open("kingyoctl hid", reports_path, HID_REPORTS_SIZE_MAX, &file);
        if (code == EXIT_OK) {
            code = hid_rows_decode(&descriptor, id, file, reports_path);
            fclose(file);
        }
    }
    return code;
}

/* Prints the controller mapping that the kiosk would use for the descriptor. `ids` is "VVVV:PPPP",
 * the vendor and product in hex. Null means a device of an unknown vendor. */
static enum exit_code print_hid_mapping(const char *path, const char *ids)
{
    struct usb_key key = { 0 };
    struct hid_mapping chosen;
    char text[HID_MAPPING_TEXT_SIZE];
    if (ids && usb_key_read(&key, ids) != 0) {
        return ctl_usage(name,
                         "map: VVVV:PPPP must be four hexadecimal digits, a colon and four more");
    }
    const enum exit_code code = hid_file_read(&descriptor, path);
    if (code != EXIT_OK) {
        return code;
    }
    const struct hid_identity who = { .vendor = key.vendor, .product = key.product };
    hid_mapping_choose(&chosen, &who, &descriptor);
    if (chosen.source == HID_MAPPING_NONE || hid_mapping_write(&chosen, text) != 0) {
        return print_fail(EXIT_NOT_SO,
                          "kingyoctl hid: %s: the kiosk has no mapping for this device: %s", path,
                          hid_mapping_absence_reason(&descriptor));
    }
    puts(text);
    return EXIT_OK;
}

/* ---- Command line ---------------------------------------------------------------------------- */

enum group { GROUP_DESCRIBE = 1, GROUP_DECODE = 2, GROUP_MAP = 4, GROUP_WATCH = 8 };

#define AT(member) .offset = offsetof(struct request, member)

static const struct option options[] = {
    { NULL, "FILE", "descriptor, or device to watch", OPTION_ARGUMENT, AT(path) },
    { NULL, "SECOND", "reports, or the ids of a device", OPTION_ARGUMENT, AT(second),
      .groups = GROUP_DECODE | GROUP_MAP },
    { "descriptor", "FILE", "descriptor of the device", OPTION_TEXT, AT(descriptor_path),
      .groups = GROUP_WATCH },
    { "seconds", "N", "duration", OPTION_WHOLE, AT(seconds), 1, SECONDS_MAX,
      .groups = GROUP_WATCH },
};

static const struct option_table table = OPTION_TABLE(options, NULL);

static enum exit_code hid_run(int argc, const char *const *argv)
{
    static const char *const subcommands[] = { "describe", "decode", "map", "watch" };
    struct request request = { .path = NULL };
    uint32_t group = GROUP_DESCRIBE;
    for (size_t i = 0; argc > 0 && i < 4 && strcmp(argv[0], subcommands[i]) != 0; i++) {
        group <<= 1;
    }
    if (argc > 0 && group <= GROUP_WATCH) {
        const enum exit_code code = ctl_options(name, &table, group, &request, argc - 1, argv + 1);
        if (code != EXIT_OK || (group == GROUP_WATCH && request.path)) {
            return code != EXIT_OK ? code : watch_device(&request);
        }
        if (group == GROUP_WATCH) {
            return request.descriptor_path || request.seconds
                       ? ctl_usage(name, "watch: a DEVICE is missing; watch without options lists "
                                         "the devices")
                       : print_hid_nodes();
        }
        if (request.path && (request.second || group != GROUP_DECODE)) {
            return (group == GROUP_MAP ? print_hid_mapping : decode)(request.path, request.second);
        }
    }
    return ctl_usage(name, "expected describe FILE, decode DESCRIPTOR REPORTS.tsv, map FILE, or "
                           "watch [DEVICE]; --help explains them");
}

const struct ctl_command ctl_hid = {
    .name = name,
    .summary = "explains HID report descriptors, decodes reports, and shows what a device sends",
    .usage =
        "  kingyoctl hid describe FILE                   prints each input field in one row\n"
        "  kingyoctl hid decode DESCRIPTOR REPORTS.tsv   prints the values in recorded reports\n"
        "  kingyoctl hid map FILE [VVVV:PPPP]            prints the controller mapping that the\n"
        "                                                kiosk would use; exit code 1: none\n"
        "  kingyoctl hid watch                           lists the devices\n"
        "  kingyoctl hid watch DEVICE [OPTION...]        shows what a device sends: a view on a\n"
        "                                                terminal, otherwise rows as of decode\n"
        "      --descriptor FILE   FILE describes the raw reports of DEVICE, a file or a pipe\n"
        "      --seconds N         ends after N seconds, 1 to 86400\n\n"
        "A descriptor is hex text, or binary if the file contains anything else. Reports are\n"
        "rows of id, number and hex (report id first, if the device has report ids) below a\n"
        "header line. Reports are decoded if their id is the descriptor's file name without its\n"
        "extension, and if they are as long as declared; exit code 1: there are none.\n"
        "`cat /dev/hidraw3 >file` records what watch can read; watch shows all of it at once.\n"
        "Rows of watch have one more column, the milliseconds from its start.\n",
    .run = hid_run,
};
