/* hid_source.c -- waits for bytes from a device or a file, and divides the bytes into reports. */
#include "platform/ctl/devices/hid_source.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/lib/user_file.h"
#include "platform/os/print.h"

/* Timeout in ms for a process that opens the writing end of a pipe. A shell starts the process in
 * less time. */
#define WRITER_WAIT_MS 2000
#define WRITER_STEP_MS 20

static enum exit_code tell_open(const char *path)
{
    if (errno == EACCES || errno == EPERM) {
        print_error("kingyoctl hid: %s: %s; a udev rule as board/udev's gives it to your group, "
                    "'kingyoctl doctor' says which",
                    path, strerror(errno));
        return EXIT_IO;
    }
    return hid_file_print_error(path);
}

/* ---- Opening a source and its descriptor ----------------------------------------------------- */

static enum exit_code ask_node(int file, struct hid_descriptor *descriptor, const char *path)
{
    struct hidraw_report_descriptor said = { .size = 0 };
    int size = 0;
    if (ioctl(file, HIDIOCGRDESCSIZE, &size) < 0) {
        return hid_file_print_error(path);
    }
    said.size = (uint32_t)size;
    if (ioctl(file, HIDIOCGRDESC, &said) < 0) {
        return hid_file_print_error(path);
    }
    const enum hid_error error = hid_descriptor_read(descriptor, said.value, said.size);
    if (error) {
        print_error("kingyoctl hid: %s: byte %zu of its descriptor: %s", path,
                    descriptor->error_offset, hid_error_text(error));
        return EXIT_BAD_DATA;
    }
    return EXIT_OK;
}

static enum exit_code get_descriptor(struct hid_source *source, struct hid_descriptor *descriptor,
                                     const char *descriptor_path)
{
    if (descriptor_path) {
        return hid_file_read(descriptor, descriptor_path);
    }
    if (!source->is_node) {
        print_error("kingyoctl hid: %s: no device's node; --descriptor FILE says what it is",
                    source->path);
        return EXIT_USAGE;
    }
    return ask_node(source->file, descriptor, source->path);
}

/* Waits until another process opens the pipe for writing, because a shell starts both processes at
 * about the same time. Also reads the first bytes. Returns 1, or 0 if no process opens the pipe
 * within WRITER_WAIT_MS. */
static int wait_for_writer(struct hid_source *source)
{
    const ssize_t none = 0;
    ssize_t size = none;
    for (int ms = 0; size == none && ms < WRITER_WAIT_MS; ms += WRITER_STEP_MS) {
        poll(NULL, 0, ms > 0 ? WRITER_STEP_MS : 0);
        size = read(source->file, source->bytes, sizeof source->bytes);
    }
    source->size = size > 0 ? (size_t)size : 0;
    return size == none ? 0 : 1; /* A negative size (EAGAIN) means that a process has opened the
                                    pipe but has not written to it yet. */
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
        return user_file_error("kingyoctl hid", source->path, HID_REPORTS_SIZE_MAX, EFBIG);
    }
    if (S_ISFIFO(about.st_mode) && !wait_for_writer(source)) {
        print_error("kingyoctl hid: %s: no process writes into this pipe", source->path);
        return EXIT_IO;
    }
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        print_error("kingyoctl hid: %s: is no HID device, regular file or pipe", source->path);
        return EXIT_IO;
    }
    return EXIT_OK;
}

enum exit_code hid_source_open(struct hid_source *source, const char *path,
                               struct hid_descriptor *descriptor, const char *descriptor_path)
{
    source->path = path;
    source->descriptor = descriptor;
    source->at_end = 0;
    source->size = 0;
    source->given = 0;
    source->taken = 0;
    source->file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (source->file < 0) {
        return tell_open(path);
    }
    int size = 0;
    source->is_node = ioctl(source->file, HIDIOCGRDESCSIZE, &size) == 0;
    enum exit_code code = get_descriptor(source, descriptor, descriptor_path);
    code = code == EXIT_OK && !source->is_node ? check_type(source) : code;
    if (code != EXIT_OK) {
        hid_source_close(source);
    }
    return code;
}

void hid_source_close(struct hid_source *source)
{
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
static enum hid_pull cut(struct hid_source *source, struct hid_report *out, enum exit_code *code)
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
    source->given = whole;
    *out = (struct hid_report){ source->bytes, whole };
    return HID_PULL_REPORT;
}

static void hid_source_discard(struct hid_source *source, size_t size)
{
    source->size -= size;
    source->taken += size;
    memmove(source->bytes, source->bytes + size, source->size);
}

/* Waits for bytes and appends them to the buffer. At the end of the source, sets `at_end`. Returns
 * HID_PULL_END after printing a read error, otherwise HID_PULL_NOTHING. */
static enum hid_pull hid_source_wait_bytes(struct hid_source *source, int timeout_ms,
                                           enum exit_code *code)
{
    struct pollfd wait = { .fd = source->file, .events = POLLIN };
    if (poll(&wait, 1, timeout_ms) <= 0) {
        return HID_PULL_NOTHING; /* A timeout occurred, or a signal that the caller handles. */
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

static enum hid_pull pull_from_node(struct hid_source *source, int timeout_ms,
                                    struct hid_report *out, enum exit_code *code)
{
    source->size = 0;
    const enum hid_pull pull = hid_source_wait_bytes(source, timeout_ms, code);
    if (pull == HID_PULL_END || source->size == 0) {
        return source->at_end ? end_with(code, EXIT_OK) : pull;
    }
    *out = (struct hid_report){ source->bytes, source->size };
    return HID_PULL_REPORT;
}

enum hid_pull hid_source_pull(struct hid_source *source, int timeout_ms, struct hid_report *out,
                              enum exit_code *code)
{
    if (source->is_node) {
        return pull_from_node(source, timeout_ms, out, code);
    }
    hid_source_discard(source, source->given);
    source->given = 0;
    enum hid_pull pull = cut(source, out, code);
    if (pull == HID_PULL_NOTHING && !source->at_end) {
        pull = hid_source_wait_bytes(source, timeout_ms, code);
        return pull == HID_PULL_NOTHING ? cut(source, out, code) : pull;
    }
    if (pull == HID_PULL_NOTHING) {
        return source->size > 0 ? hid_source_error(source, "ends within a report", code)
                                : end_with(code, EXIT_OK);
    }
    return pull;
}
