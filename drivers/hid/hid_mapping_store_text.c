/* hid_mapping_store_text.c -- implements the three-line text format of a mapping file. */
#include "drivers/hid/hid_mapping_store_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_LINE "kingyo poi 1"

static int is_plain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Copies letters, digits and '_' to `out`, and writes each other byte as %XX. Truncates the result
 * to fit into `size` bytes. */
static void escape(const char *text, char *out, size_t size)
{
    size_t used = 0;
    for (; *text && used + 4u < size; text++) {
        if (is_plain(*text)) {
            out[used++] = *text;
        } else {
            snprintf(out + used, 4, "%%%02X", (unsigned)(uint8_t)*text);
            used += 3;
        }
    }
    out[used] = '\0';
}

static int hex_value(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Reverses escape(). Returns 1, or 0 if the result is too long for `size` or if `text` is not a
 * valid output of escape(). */
static int unescape(const char *text, char *out, size_t size)
{
    size_t used = 0;
    while (*text) {
        if (used + 1u >= size) {
            return 0;
        }
        if (is_plain(*text)) {
            out[used++] = *text++;
            continue;
        }
        const int high = *text == '%' ? hex_value(text[1]) : -1;
        const int low = high >= 0 ? hex_value(text[2]) : -1;
        if (low < 0 || high * 16 + low == 0) {
            return 0;
        }
        out[used++] = (char)(high * 16 + low);
        text += 3;
    }
    out[used] = '\0';
    return 1;
}

void hid_mapping_store_name(const struct hid_mapping_store_entry *entry,
                            char name[HID_MAPPING_STORE_NAME_SIZE])
{
    char serial[3u * HID_TEXT_SIZE];
    escape(entry->serial, serial, sizeof serial);
    snprintf(name, HID_MAPPING_STORE_NAME_SIZE, "%04x-%04x-%s.poi", entry->vendor, entry->product,
             serial);
}

int hid_mapping_store_write(const struct hid_mapping_store_entry *entry,
                            char text[HID_MAPPING_STORE_TEXT_SIZE])
{
    char serial[3u * HID_TEXT_SIZE], map[HID_MAPPING_TEXT_SIZE];
    if (hid_mapping_write(&entry->map, map) != 0) {
        return -1;
    }
    escape(entry->serial, serial, sizeof serial);
    const int length =
        snprintf(text, HID_MAPPING_STORE_TEXT_SIZE, FIRST_LINE "\n%04x:%04x:%s\n%s\n",
                 entry->vendor, entry->product, serial, map);
    return (size_t)length < HID_MAPPING_STORE_TEXT_SIZE ? 0 : -1;
}

/* Copies the next line into `line` and advances `*text`. Returns 1, or 0 if no complete line is
 * left or if the line does not fit into `size` bytes. */
static int hid_mapping_store_text_next_line(const char **text, char *line, size_t size)
{
    const size_t length = strcspn(*text, "\n");
    if ((*text)[length] != '\n' || length >= size) {
        return 0;
    }
    memcpy(line, *text, length);
    line[length] = '\0';
    *text += length + 1u;
    return 1;
}

static int read_hex4(const char *text, uint16_t *out)
{
    if (strspn(text, "0123456789abcdef") != 4) {
        return 0;
    }
    *out = (uint16_t)strtoul(text, NULL, 16);
    return 1;
}

static int read_key(struct hid_mapping_store_entry *out, const char *line)
{
    return strlen(line) >= 10 && line[4] == ':' && line[9] == ':' &&
           read_hex4(line, &out->vendor) && read_hex4(line + 5, &out->product) &&
           unescape(line + 10, out->serial, sizeof out->serial);
}

int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE])
{
    char line[HID_MAPPING_STORE_TEXT_SIZE];
    memset(out, 0, sizeof *out);
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) ||
        strcmp(line, FIRST_LINE) != 0) {
        snprintf(error, HAL_TEXT_SIZE, "not \"" FIRST_LINE "\"");
        return 1;
    }
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) || !read_key(out, line)) {
        snprintf(error, HAL_TEXT_SIZE, "not vendor:product:serial");
        return 2;
    }
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) || *text) {
        snprintf(error, HAL_TEXT_SIZE, "not one line of a map");
        return 3;
    }
    return hid_mapping_read(&out->map, line, error) == 0 ? 0 : 3;
}
