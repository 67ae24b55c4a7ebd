/* hid.c -- the command `kingyoctl hid`.
 *
 * The command explains a HID report descriptor and decodes reports with that descriptor. */
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

static enum exit_code hid_run(int argc, const char *const *argv)
{
    const int has_option = argc >= 2 && argv[1][0] == '-' && argv[1][1];
    if (has_option && strcmp(argv[0], "watch") != 0) {
        return ctl_usage(name, "%s: there is no option '%s'; a file of that name is ./%s", argv[0],
                         argv[1], argv[1]);
    }
    if (argc == 2 && strcmp(argv[0], "describe") == 0) {
        return describe(argv[1]);
    }
    if (argc == 3 && strcmp(argv[0], "decode") == 0) {
        return decode(argv[1], argv[2]);
    }
    if ((argc == 2 || argc == 3) && strcmp(argv[0], "map") == 0) {
        return map(argv[1], argc == 3 ? argv[2] : NULL);
    }
    if (argc >= 1 && strcmp(argv[0], "watch") == 0) {
        return hid_watch(argc - 1, argv + 1);
    }
    return ctl_usage(name, "describe FILE, decode DESCRIPTOR REPORTS.tsv, map FILE, or "
                           "watch [DEVICE]; --help says more");
}

const struct ctl_command ctl_hid = {
    .name = name,
    .summary = "what a HID report descriptor says, what reports mean, what a device sends",
    .usage =
        "  kingyoctl hid describe FILE                   every input field, one row each\n"
        "  kingyoctl hid decode DESCRIPTOR REPORTS.tsv   the values in recorded reports\n"
        "  kingyoctl hid map FILE [VVVV:PPPP]            as what the kiosk would play such a\n"
        "                                                device; exit 1: as nothing\n"
        "  kingyoctl hid watch                           which devices there are\n"
        "  kingyoctl hid watch DEVICE [OPTION...]        what one sends now: a picture on a\n"
        "                                                terminal, rows as of decode elsewhere\n"
        "      --descriptor FILE   DEVICE is a file or pipe of raw reports, which FILE declares\n"
        "      --seconds N         ends by itself\n\n"
        "A descriptor is hex text, or binary if the file holds anything else. Reports are rows\n"
        "of id, number and hex (report id first, if the device has them) under a header line;\n"
        "those are shown whose id is the descriptor's file name without its extension, and\n"
        "that are as long as declared; exit 1: none is.\n"
        "`cat /dev/hidraw3 >file` records what watch can read; it shows all of that at once.\n"
        "Rows of watch have one more column, milliseconds since it began.\n",
    .run = hid_run,
};
