/* hid.c -- the command `kingyoctl hid`.
 *
 * The command explains a HID report descriptor and decodes reports with that descriptor. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/usb/usb_choice.h"
#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/devices/hid_rows.h"
#include "platform/ctl/devices/hid_watch.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/lib/user_file.h"
#include "platform/os/print.h"

static const char name[] = "hid";
static struct hid_descriptor descriptor;

static enum exit_code describe(const char *path)
{
    char id[HID_ID_SIZE];
    const enum exit_code code = hid_file_read(&descriptor, path);
    if (code != EXIT_OK) {
        return code;
    }
    hid_file_id(path, id);
    hid_rows_describe(&descriptor, id);
    return EXIT_OK;
}

static enum exit_code decode(const char *descriptor_path, const char *reports_path)
{
    char id[HID_ID_SIZE];
    enum exit_code code = hid_file_read(&descriptor, descriptor_path);
    if (code != EXIT_OK) {
        return code;
    }
    FILE *file;
    code = user_file_open("kingyoctl hid", reports_path, HID_REPORTS_SIZE_MAX, &file);
    if (code != EXIT_OK) {
        return code;
    }
    hid_file_id(descriptor_path, id);
    code = hid_rows_decode(&descriptor, id, file, reports_path);
    fclose(file);
    return code;
}

/* Prints the controller mapping that the kiosk would use for the descriptor. `ids` is "VVVV:PPPP",
 * the vendor and product in hex. Null means a device of an unknown vendor. */
static enum exit_code map(const char *path, const char *ids)
{
    struct hid_identity who = { 0 };
    struct usb_key key = { 0 };
    struct hid_mapping chosen;
    char text[HID_MAPPING_TEXT_SIZE];
    if (ids && usb_key_read(&key, ids) != 0) {
        return ctl_usage(name, "map FILE [VVVV:PPPP]");
    }
    const enum exit_code code = hid_file_read(&descriptor, path);
    if (code != EXIT_OK) {
        return code;
    }
    who.vendor = key.vendor;
    who.product = key.product;
    hid_mapping_choose(&chosen, &who, &descriptor);
    if (chosen.source == HID_MAPPING_NONE || hid_mapping_write(&chosen, text) != 0) {
        print_error("kingyoctl hid: %s: cannot be a poi as it is: %s", path,
                    hid_mapping_absence_reason(&descriptor));
        return EXIT_NOT_SO;
    }
    puts(text);
    return EXIT_OK;
}

/* ---- Command line ---------------------------------------------------------------------------- */

struct request {
    struct hid_watch_options watch; /* watch.path is the first argument of every subcommand. */
    const char *second; /* Second argument: a file of reports, or the ids of a device. */
};

enum group { GROUP_DESCRIBE = 1, GROUP_DECODE = 2, GROUP_MAP = 4, GROUP_WATCH = 8 };

#define AT(member) .offset = offsetof(struct request, member)

static const struct option options[] = {
    { NULL, "FILE", "descriptor, or device to watch", OPTION_ARGUMENT, AT(watch.path) },
    { NULL, "SECOND", "reports, or the ids of a device", OPTION_ARGUMENT, AT(second),
      .groups = GROUP_DECODE | GROUP_MAP },
    { "descriptor", "FILE", "descriptor of the device", OPTION_TEXT, AT(watch.descriptor_path),
      .groups = GROUP_WATCH },
    { "seconds", "N", "duration", OPTION_WHOLE, AT(watch.seconds), 1, HID_WATCH_SECONDS_MAX,
      .groups = GROUP_WATCH },
};

static const struct option_table table = { options, sizeof options / sizeof options[0], NULL };

static enum exit_code hid_run(int argc, const char *const *argv)
{
    static const char *const subcommands[] = { "describe", "decode", "map", "watch" };
    struct request request = { .second = NULL };
    uint32_t group = GROUP_DESCRIBE;
    for (size_t i = 0; argc > 0 && i < 4 && strcmp(argv[0], subcommands[i]) != 0; i++) {
        group <<= 1;
    }
    if (argc > 0 && group <= GROUP_WATCH) {
        const enum exit_code code = ctl_options(name, &table, group, &request, argc - 1, argv + 1);
        if (code != EXIT_OK || group == GROUP_WATCH) {
            return code != EXIT_OK ? code : hid_watch(&request.watch);
        }
        if (request.watch.path && (request.second || group != GROUP_DECODE)) {
            return group == GROUP_DESCRIBE ? describe(request.watch.path)
                   : group == GROUP_DECODE ? decode(request.watch.path, request.second)
                                           : map(request.watch.path, request.second);
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
