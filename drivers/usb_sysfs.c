/* usb_sysfs.c -- two kinds of small files under /sys/bus/usb/devices. */
#include "drivers/usb_sysfs.h"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PATH_SIZE 512u

/* At most `size` bytes of a file; how many, or 0 where it cannot be read. */
static uint32_t read_file(const char *path, void *out, uint32_t size)
{
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return 0u;
    }
    uint32_t count = 0;
    while (count < size) {
        const ssize_t got = read(fd, (uint8_t *)out + count, size - count);
        if (got <= 0) {
            break;
        }
        count += (uint32_t)got;
    }
    close(fd);
    return count;
}

/* How many bytes of a character of UTF-8 begin at `text`; 0: it is none that we print. */
static uint32_t character_size(const unsigned char *text)
{
    const unsigned char c = text[0];
    const uint32_t size = c < 0x80u                  ? 1u
                          : c >= 0xc2u && c < 0xe0u ? 2u
                          : c >= 0xe0u && c < 0xf0u ? 3u
                          : c >= 0xf0u && c < 0xf5u ? 4u
                                                     : 0u;
    if (size == 1u) {
        return c >= 0x20u && c != 0x7fu;
    }
    for (uint32_t i = 1; i < size; i++) {
        if ((text[i] & 0xc0u) != 0x80u) {
            return 0u;
        }
    }
    if (c == 0xc2u && text[1] < 0xa0u) {
        return 0u; /* U+0080 .. U+009F: control characters, too. */
    }
    return size;
}

void usb_clean_text(char text[HID_TEXT_SIZE])
{
    unsigned char *c = (unsigned char *)text;
    size_t length = strnlen(text, HID_TEXT_SIZE - 1u);
    text[length] = '\0';
    while (length > 0 && (text[length - 1u] == ' ' || text[length - 1u] == '\n')) {
        text[--length] = '\0';
    }
    while (*c) {
        const uint32_t size = character_size(c);
        const size_t left = length - (size_t)(c - (unsigned char *)text);
        if (size == 0u && *c >= 0xc2u && left < 4u) {
            *c = '\0'; /* The last one was cut in two. */
            return;
        }
        if (size == 0u) {
            *c = '?';
        }
        c += size ? size : 1u;
    }
}

void usb_sysfs_text(const char *root, const char *port, const char *name,
                    char out[HID_TEXT_SIZE])
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/bus/usb/devices/%s/%s", root, port, name);
    const uint32_t size = read_file(path, out, HID_TEXT_SIZE - 1u);
    out[size] = '\0';
    usb_clean_text(out);
}

/* Cuts the last name off a path; 0: there is none left. */
static int climb(char *path)
{
    char *slash = strrchr(path, '/');
    if (!slash || slash == path) {
        return 0;
    }
    *slash = '\0';
    return 1;
}

/* A node's folder lies below that of its device, which is the first that has an idVendor. */
void usb_sysfs_node_serial(const char *root, const char *node, char out[HID_TEXT_SIZE])
{
    char link[PATH_SIZE], folder[PATH_MAX], path[PATH_MAX + 16u];
    const char *slash = strrchr(node, '/');
    const char *name = slash ? slash + 1 : node;
    const char *class = strncmp(name, "hidraw", 6u) == 0 ? "hidraw" : "input";
    out[0] = '\0';
    snprintf(link, sizeof link, "%s/class/%s/%.64s", root, class, name);
    if (!name[0] || !realpath(link, folder)) {
        return;
    }
    while (climb(folder)) {
        snprintf(path, sizeof path, "%s/idVendor", folder);
        if (access(path, F_OK) == 0) {
            snprintf(path, sizeof path, "%s/serial", folder);
            out[read_file(path, out, HID_TEXT_SIZE - 1u)] = '\0';
            usb_clean_text(out);
            return;
        }
    }
}

/* The HID driver's folder under an interface is called BUS:VENDOR:PRODUCT.NUMBER, bus 3 being
 * USB. */
static int is_hid_folder(const char *name)
{
    return strlen(name) == 19u && strncmp(name, "0003:", 5u) == 0 && name[9] == ':' &&
           name[14] == '.';
}

uint32_t usb_sysfs_descriptor(const char *root, const char *port, uint8_t configuration,
                              uint8_t interface_number, uint8_t out[HID_DESCRIPTOR_MAX])
{
    char folder[PATH_SIZE], path[PATH_SIZE + 64u];
    const struct dirent *entry;
    uint32_t size = 0;
    snprintf(folder, sizeof folder, "%s/bus/usb/devices/%s:%u.%u", root, port, configuration,
             interface_number);
    DIR *dir = opendir(folder);
    while (dir && size == 0u && (entry = readdir(dir))) {
        if (is_hid_folder(entry->d_name)) {
            snprintf(path, sizeof path, "%s/%.32s/report_descriptor", folder, entry->d_name);
            size = read_file(path, out, HID_DESCRIPTOR_MAX);
        }
    }
    if (dir) {
        closedir(dir);
    }
    return size;
}
