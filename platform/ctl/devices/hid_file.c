/* hid_file.c -- reads descriptor files.
 *
 * A file is hex text only if every character is a hex digit or white space. Any other file is
 * binary. */
#include "platform/ctl/devices/hid_file.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

static int hex_digit(int letter)
{
    return isdigit(letter)                  ? letter - '0'
           : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10
           : letter >= 'A' && letter <= 'F' ? letter - 'A' + 10
                                            : -1;
}

/* Returns the index of the first hex digit without a second digit, or `size` if every byte has two
 * digits. */
static size_t lone_digit(const uint8_t *text, size_t size)
{
    size_t high = size;
    for (size_t i = 0; i < size && (high == size || hex_digit(text[i]) >= 0); i++) {
        high = hex_digit(text[i]) < 0 || high < size ? size : i;
    }
    return high;
}

long hid_from_hex(uint8_t *bytes, size_t size)
{
    long count = 0;
    int high = -1;
    for (size_t i = 0; i < size; i++) {
        if (hex_digit(bytes[i]) < 0 && !isspace(bytes[i])) {
            return HID_NOT_HEX;
        }
    }
    for (size_t i = 0; i < size; i++) {
        const int digit = hex_digit(bytes[i]);
        if (digit < 0 && high >= 0) {
            return HID_HALF_HEX;
        }
        if (high >= 0) {
            bytes[count++] = (uint8_t)(high << 4 | digit);
        }
        high = high < 0 ? digit : -1;
    }
    return high < 0 ? count : HID_HALF_HEX;
}

enum exit_code hid_file_print_error(const char *path)
{
    print_error("kingyoctl hid: %s: %s", path, file_error(errno));
    return EXIT_IO;
}

/* Returns the index of the first character that is neither a hex digit nor white space. Returns
 * `size` if every character is valid, or if the bytes are not text. */
static size_t first_odd_letter(const uint8_t *bytes, size_t size)
{
    size_t odd = size;
    for (size_t i = size; i-- > 0;) {
        if (!isprint(bytes[i]) && !isspace(bytes[i])) {
            return size;
        }
        odd = hex_digit(bytes[i]) < 0 && !isspace(bytes[i]) ? i : odd;
    }
    return odd;
}

enum exit_code hid_file_take(struct hid_descriptor *out, uint8_t *bytes, size_t size,
                             const char *path)
{
    CORE_ASSERT(out && bytes && path);
    const size_t lone = lone_digit(bytes, size); /* The unpaired digit is searched before the
                                                    conversion, because hid_from_hex() overwrites
                                                    the text. */
    const long count = hid_from_hex(bytes, size);
    if (count == HID_HALF_HEX) {
        print_error("kingyoctl hid: %s: hex text in which a byte has one digit: letter %zu", path,
                    lone + 1u);
        return EXIT_BAD_DATA;
    }
    const size_t byte_count = count >= 0 ? (size_t)count : size;
    if (byte_count == 0) {
        print_error("kingyoctl hid: %s: byte 0: empty", path);
        return EXIT_BAD_DATA;
    }
    const enum hid_error error = hid_descriptor_read(out, bytes, byte_count);
    if (error || out->group_count == 0) {
        const size_t letter = count >= 0 ? size : first_odd_letter(bytes, size);
        char binary[80] = "";
        if (letter < size) {
            snprintf(binary, sizeof binary,
                     " (read as binary, for its letter %zu, '%c', is no hex)", letter + 1u,
                     bytes[letter]);
        }
        print_error(
            "kingyoctl hid: %s: byte %zu: %s%s", path, error ? out->error_offset : byte_count,
            error ? hid_error_text(error) : "no input field that is used for anything", binary);
        return EXIT_BAD_DATA;
    }
    return EXIT_OK;
}

enum exit_code hid_file_read(struct hid_descriptor *out, const char *path)
{
    static uint8_t bytes[HID_FILE_SIZE];
    FILE *file;
    enum exit_code code = ctl_file_open("kingyoctl hid", path, sizeof bytes, &file);
    if (code != EXIT_OK) {
        return code;
    }
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    code = ferror(file) ? hid_file_print_error(path) : EXIT_OK;
    fclose(file);
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
