/* usb_sysfs.c -- reads small files below /sys/bus/usb/devices. */
#include "drivers/usb/usb_sysfs.h"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

#define PATH_SIZE 512u

/* Reads at most `size` bytes of a file. Returns the number of bytes, or 0 if the file cannot be
 * read. */
static uint32_t usb_sysfs_read_file(const char *path, void *out, uint32_t size)
{
    CORE_ASSERT(size > 0);
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

void usb_sysfs_clean_text(char text[HID_TEXT_SIZE])
{
    size_t length = strnlen(text, HID_TEXT_SIZE - 1u);
    text[length] = '\0';
    while (length > 0 && (text[length - 1u] == ' ' || text[length - 1u] == '\n')) {
        text[--length] = '\0';
    }
    /* The text may have been truncated within a UTF-8 character. Such an incomplete last character
     * is removed. */
    const uint32_t last = length > 0 ? printable_fit(text, (uint32_t)length - 1u) : 0u;
    if ((unsigned char)text[last] >= 0xc2u && printable_utf8_size(text + last) == 0u) {
        text[last] = '\0';
    }
    printable(text);
}

void usb_sysfs_text(const char *root, const char *port, const char *name, char out[HID_TEXT_SIZE])
{
    CORE_ASSERT(root && port && name);
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/bus/usb/devices/%s/%s", root, port, name);
    const uint32_t size = usb_sysfs_read_file(path, out, HID_TEXT_SIZE - 1u);
    out[size] = '\0';
    usb_sysfs_clean_text(out);
}

/* Finds the folder of the USB device: the first folder above the node that contains a file
 * idVendor. */
void usb_sysfs_node_serial(const char *root, const char *node, char out[HID_TEXT_SIZE])
{
    CORE_ASSERT(root && node);
    char link[PATH_SIZE], folder[PATH_MAX], path[PATH_MAX + 16u];
    const char *slash = strrchr(node, '/');
    const char *name = slash ? slash + 1 : node;
    const char *class = strncmp(name, "hidraw", 6u) == 0 ? "hidraw" : "input";
    out[0] = '\0';
    snprintf(link, sizeof link, "%s/class/%s/%.64s", root, class, name);
    if (!name[0] || !realpath(link, folder)) {
        return;
    }
    char *last;
    while ((last = strrchr(folder, '/')) != NULL && last != folder) {
        /* Removes the last component of the path, which continues the search in the parent
         * folder. */
        *last = '\0';
        snprintf(path, sizeof path, "%s/idVendor", folder);
        if (access(path, F_OK) == 0) {
            snprintf(path, sizeof path, "%s/serial", folder);
            out[usb_sysfs_read_file(path, out, HID_TEXT_SIZE - 1u)] = '\0';
            usb_sysfs_clean_text(out);
            return;
        }
    }
}

uint32_t usb_sysfs_descriptor(const char *root, const char *port, uint8_t configuration,
                              uint8_t interface_number, uint8_t out[HID_DESCRIPTOR_MAX])
{
    CORE_ASSERT(root && port);
    char folder[PATH_SIZE], path[PATH_SIZE + 64u];
    const struct dirent *entry;
    uint32_t size = 0;
    snprintf(folder, sizeof folder, "%s/bus/usb/devices/%s:%u.%u", root, port, configuration,
             interface_number);
    DIR *dir = opendir(folder);
    while (dir && size == 0u && (entry = readdir(dir))) {
        /* The name of a HID device's folder is BUS:VENDOR:PRODUCT.NUMBER, and the bus of USB is
         * 0003. */
        const char *name = entry->d_name;
        if (strlen(name) == 19u && strncmp(name, "0003:", 5u) == 0 && name[9] == ':' &&
            name[14] == '.') {
            snprintf(path, sizeof path, "%s/%.32s/report_descriptor", folder, name);
            size = usb_sysfs_read_file(path, out, HID_DESCRIPTOR_MAX);
        }
    }
    if (dir) {
        closedir(dir);
    }
    return size;
}
