/* hid_file.c -- reads descriptor files.
 *
 * A file is hex text only if every character is a hex digit or white space. Any other file is
 * binary. */
#include "platform/ctl/devices/hid_file.h"

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

static int hex_digit(int letter)
{
    return !isxdigit(letter) ? -1 : isdigit(letter) ? letter - '0' : (letter | 0x20) - 'a' + 10;
}

long hid_from_hex(uint8_t *bytes, size_t size, size_t *wrong)
{
    size_t unused, count = 0, high = size;
    wrong = wrong ? wrong : &unused;
    for (*wrong = 0; *wrong < size; ++*wrong) {
        if (!isxdigit(bytes[*wrong]) && !isspace(bytes[*wrong])) {
            return HID_NOT_HEX;
        }
    }
    for (size_t i = 0; i < size; i++) {
        const int digit = hex_digit(bytes[i]);
        if (digit >= 0 && high == size) {
            high = i;
        } else if (digit >= 0) {
            bytes[count++] = (uint8_t)(hex_digit(bytes[high]) << 4 | digit);
            high = size;
        } else if (high < size) {
            break;
        }
    }
    *wrong = high;
    return high == size ? (long)count : HID_HALF_HEX;
}

enum exit_code hid_file_print_error(const char *path)
{
    return print_fail(EXIT_IO, "kingyoctl hid: %s: %s", path, file_error(errno));
}

static bool is_text(const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        if (!isprint(bytes[i]) && !isspace(bytes[i])) {
            return false;
        }
    }
    return true;
}

enum exit_code hid_file_take(struct hid_descriptor *out, uint8_t *bytes, size_t size,
                             const char *path)
{
    CORE_ASSERT(out && bytes && path);
    size_t wrong;
    const long count = hid_from_hex(bytes, size, &wrong);
    if (count == HID_HALF_HEX) {
        return print_fail(EXIT_BAD_DATA,
                          "kingyoctl hid: %s: hex text in which a byte has one digit: letter %zu",
                          path, wrong + 1u);
    }
    const size_t byte_count = count >= 0 ? (size_t)count : size;
    if (byte_count == 0) {
        return print_fail(EXIT_BAD_DATA, "kingyoctl hid: %s: byte 0: empty", path);
    }
    const enum hid_error error = hid_descriptor_read(out, bytes, byte_count);
    if (error || out->group_count == 0) {
        char binary[80] = "";
        if (count < 0 && is_text(bytes, size)) {
            snprintf(binary, sizeof binary,
                     " (read as binary, because letter %zu, '%c', is not hex)", wrong + 1u,
                     bytes[wrong]);
        }
        return print_fail(
            EXIT_BAD_DATA, "kingyoctl hid: %s: byte %zu: %s%s", path,
            error ? out->error_offset : byte_count,
            error ? hid_error_text(error) : "no input field that is used for anything", binary);
    }
    return EXIT_OK;
}

enum exit_code hid_file_read(struct hid_descriptor *out, const char *path)
{
    static uint8_t bytes[HID_FILE_SIZE];
    size_t size;
    const enum exit_code code = ctl_file_read("kingyoctl hid", path, bytes, sizeof bytes, &size);
    return code == EXIT_OK ? hid_file_take(out, bytes, size, path) : code;
}

void hid_file_id(const char *path, char id[HID_ID_SIZE])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    const size_t length = dot && dot != base ? (size_t)(dot - base) : strlen(base);
    snprintf(id, HID_ID_SIZE, "%.*s", (int)(length < HID_ID_SIZE ? length : HID_ID_SIZE - 1), base);
}
