/* hid_source.c -- waits for bytes from a device or a file, and divides the bytes into reports. */
#include "platform/ctl/devices/hid_source.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <linux/input.h>
#include <poll.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/number.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

#define LINE_SIZE 512
/* Time in ms to wait for a process that opens the writing end of a pipe. A shell needs less time to
 * start a process. */
#define WRITER_WAIT_MS 2000
#define WRITER_STEP_MS 20

/* ---- Device nodes ---------------------------------------------------------------------------- */

static void read_node(const char *root, struct hid_node *node)
{
    const struct {
        const char *key;
        char *out;
        size_t size;
    } texts[] = {
        { "HID_NAME=", node->name, sizeof node->name },
        { "HID_PHYS=", node->place, sizeof node->place },
        { "HID_UNIQ=", node->serial, sizeof node->serial },
        { "DRIVER=", node->driver, sizeof node->driver },
    };
    char path[HID_NODE_PATH], line[LINE_SIZE];
    snprintf(path, sizeof path, "%s/sys/class/hidraw/hidraw%u/device/uevent", root, node->number);
    FILE *file = file_open(path, FILE_KERNEL_SIZE_MAX);
    while (file && file_read_line(file, line, sizeof line) != FILE_LINE_END) {
        sscanf(line, "HID_ID=%4hx:%8x:%8x", &node->bus, &node->vendor, &node->product);
        for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
            const size_t length = strlen(texts[i].key);
            if (strncmp(line, texts[i].key, length) == 0) {
                snprintf(texts[i].out, texts[i].size, "%s", line + length);
                printable(texts[i].out);
            }
        }
    }
    if (file) {
        fclose(file);
    }
    snprintf(path, sizeof path, "%s/dev/hidraw%u", root, node->number);
    node->open_errno = access(path, R_OK) == 0 ? 0 : errno;
}

static int by_number(const void *left, const void *right)
{
    const uint32_t a = ((const struct hid_node *)left)->number;
    const uint32_t b = ((const struct hid_node *)right)->number;
    return (a > b) - (a < b);
}

uint32_t hid_nodes_list(const char *root, struct hid_node out[HID_NODES_MAX])
{
    char path[HID_NODE_PATH];
    uint32_t count = 0, number;
    snprintf(path, sizeof path, "%s/sys/class/hidraw", root);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder && count < HID_NODES_MAX && (entry = readdir(folder))) {
        if (strncmp(entry->d_name, "hidraw", 6) == 0 &&
            number_parse(entry->d_name + 6, 0, UINT16_MAX, &number)) {
            out[count] = (struct hid_node){ .number = number };
            read_node(root, &out[count++]);
        }
    }
    if (folder) {
        closedir(folder);
    }
    qsort(out, count, sizeof out[0], by_number);
    return count;
}

const char *hid_node_bus(const struct hid_node *node)
{
    static const char *const names[] = { [BUS_USB] = "USB",
                                         [BUS_BLUETOOTH] = "Bluetooth",
                                         [BUS_VIRTUAL] = "virtual",
                                         [BUS_I2C] = "I2C" };
    const size_t count = sizeof names / sizeof names[0];
    return node->bus < count && names[node->bus] ? names[node->bus] : "other";
}

/* ---- Opening a source and its descriptor ----------------------------------------------------- */

static enum exit_code read_raw(int file, struct hid_descriptor *descriptor, const char *path)
{
    struct hidraw_report_descriptor raw = { .size = 0 };
    if (ioctl(file, HIDIOCGRDESCSIZE, &raw.size) < 0 || ioctl(file, HIDIOCGRDESC, &raw) < 0) {
        return hid_file_print_error(path);
    }
    const enum hid_error error = hid_descriptor_read(descriptor, raw.value, raw.size);
    if (error) {
        return print_fail(EXIT_BAD_DATA, "kingyoctl hid: %s: byte %zu of its report descriptor: %s",
                          path, descriptor->error_offset, hid_error_text(error));
    }
    return EXIT_OK;
}

/* Waits until another process opens the pipe for writing, because a shell starts both processes at
 * about the same time. Also reads the first bytes. Returns true, or false if no process opens the
 * pipe within WRITER_WAIT_MS. */
static bool wait_for_writer(struct hid_source *source)
{
    ssize_t size =
        /* A `size` of 0 means that the pipe has no writer. A negative `size` (EAGAIN) means that a
         * process has opened the pipe but has not written to it yet. */
        0;
    for (int ms = 0; size == 0 && ms < WRITER_WAIT_MS; ms += WRITER_STEP_MS) {
        poll(NULL, 0, ms > 0 ? WRITER_STEP_MS : 0);
        size = read(source->file, source->bytes, sizeof source->bytes);
    }
    source->size = size > 0 ? (size_t)size : 0;
    return size != 0;
}

/* Checks a source that is not a device node. The source must be a file of limited size, or a pipe
 * with a writer. Returns EXIT_OK. After an error, prints one line and returns another exit code. */
static enum exit_code check_type(struct hid_source *source)
{
    struct stat about;
    if (fstat(source->file, &about) != 0) {
        return hid_file_print_error(source->path);
    }
    if (S_ISREG(about.st_mode) && about.st_size > (off_t)HID_REPORTS_SIZE_MAX) {
        return ctl_file_error("kingyoctl hid", source->path, HID_REPORTS_SIZE_MAX, EFBIG);
    }
    if (S_ISFIFO(about.st_mode) && !wait_for_writer(source)) {
        return print_fail(EXIT_IO, "kingyoctl hid: %s: no process writes into this pipe",
                          source->path);
    }
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        return print_fail(EXIT_IO,
                          "kingyoctl hid: %s: is not a HID device, a regular file or a pipe",
                          source->path);
    }
    return EXIT_OK;
}

enum exit_code hid_source_open(struct hid_source *source, const char *path,
                               struct hid_descriptor *descriptor, const char *descriptor_path)
{
    CORE_ASSERT(path && descriptor);
    *source = (struct hid_source){ .path = path, .descriptor = descriptor };
    source->file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (source->file < 0 && (errno == EACCES || errno == EPERM)) {
        return print_fail(
            EXIT_IO,
            "kingyoctl hid: %s: %s; a udev rule as in board/udev gives your group access, and "
            "'kingyoctl doctor' prints the rule",
            path, strerror(errno));
    }
    if (source->file < 0) {
        return hid_file_print_error(path);
    }
    int size = 0;
    source->is_node = ioctl(source->file, HIDIOCGRDESCSIZE, &size) == 0;
    enum exit_code code = EXIT_USAGE;
    if (descriptor_path) {
        code = hid_file_read(descriptor, descriptor_path);
    } else if (source->is_node) {
        code = read_raw(source->file, descriptor, path);
    } else {
        print_error(
            "kingyoctl hid: %s: is not a device node; name its descriptor with --descriptor", path);
    }
    code = code == EXIT_OK && !source->is_node ? check_type(source) : code;
    if (code != EXIT_OK) {
        hid_source_close(source);
    }
    return code;
}

void hid_source_close(struct hid_source *source)
{
    CORE_ASSERT(source->file >= 0);
    close(source->file);
    source->file = -1;
}

/* ---- Dividing bytes into reports ------------------------------------------------------------- */

static enum hid_pull end_with(enum exit_code *code, enum exit_code how)
{
    *code = how;
    return HID_PULL_END;
}

static enum hid_pull hid_source_error(const struct hid_source *source, const char *what,
                                      enum exit_code *code)
{
    print_error("kingyoctl hid: %s: byte %llu: %s", source->path, (unsigned long long)source->taken,
                what);
    return end_with(code, EXIT_BAD_DATA);
}

/* Returns the next report from the buffered bytes. The descriptor declares the length of the
 * report. */
static enum hid_pull cut_next_report(struct hid_source *source, struct hid_report *out,
                                     enum exit_code *code)
{
    const struct hid_descriptor *descriptor = source->descriptor;
    const int id = hid_report_id(descriptor, (struct hid_report){ source->bytes, source->size });
    const uint32_t bits = source->size > 0 ? descriptor->report_bits[id] : 0;
    if (source->size > 0 && bits == 0) {
        return hid_source_error(source, "no report of this descriptor begins here", code);
    }
    const size_t whole = (bits + 7u) / 8u + descriptor->has_report_ids;
    if (source->size == 0 || source->size < whole) {
        return HID_PULL_NOTHING;
    }
    CORE_ASSERT(whole <= sizeof source->bytes);
    source->given = whole;
    *out = (struct hid_report){ source->bytes, whole };
    return HID_PULL_REPORT;
}

/* Waits for bytes and appends them to the buffer. At the end of the source, sets `at_end`. Returns
 * HID_PULL_END after printing a read error, otherwise HID_PULL_NOTHING. */
static enum hid_pull hid_source_wait_bytes(struct hid_source *source, int timeout_ms,
                                           enum exit_code *code)
{
    struct pollfd wait = { .fd = source->file, .events = POLLIN };
    if (poll(&wait, 1, timeout_ms) <= 0) {
        /* The wait ended by its timeout, or by a signal that the caller handles. */
        return HID_PULL_NOTHING;
    }
    const ssize_t size =
        read(source->file, source->bytes + source->size, sizeof source->bytes - source->size);
    if (size < 0 && (errno == ENODEV || errno == EIO) && source->is_node) {
        print_error("kingyoctl hid: %s: was pulled out", source->path);
        return end_with(code, EXIT_IO);
    }
    if (size < 0 && errno != EINTR && errno != EAGAIN) {
        return end_with(code, hid_file_print_error(source->path));
    }
    source->at_end = size == 0;
    source->size += size > 0 ? (size_t)size : 0;
    return HID_PULL_NOTHING;
}

enum hid_pull hid_source_pull(struct hid_source *source, int timeout_ms, struct hid_report *out,
                              enum exit_code *code)
{
    CORE_ASSERT(source->file >= 0 && source->given <= source->size);
    if (source->is_node) { /* Each read from a node returns one report. */
        source->size = 0;
        const enum hid_pull read = hid_source_wait_bytes(source, timeout_ms, code);
        if (read == HID_PULL_END || source->size == 0) {
            return source->at_end ? end_with(code, EXIT_OK) : read;
        }
        *out = (struct hid_report){ source->bytes, source->size };
        return HID_PULL_REPORT;
    }
    source->size -= source->given;
    source->taken += source->given;
    memmove(source->bytes, source->bytes + source->given, source->size);
    source->given = 0;
    enum hid_pull pull = cut_next_report(source, out, code);
    if (pull == HID_PULL_NOTHING && source->at_end) {
        return source->size > 0 ? hid_source_error(source, "ends within a report", code)
                                : end_with(code, EXIT_OK);
    }
    if (pull == HID_PULL_NOTHING) {
        pull = hid_source_wait_bytes(source, timeout_ms, code);
    }
    return pull == HID_PULL_NOTHING ? cut_next_report(source, out, code) : pull;
}
