/* hid_nodes.c -- lists the HID device nodes of Linux from /sys/class/hidraw.
 *
 * Each device node has a folder in /sys/class/hidraw. The file device/uevent in the folder
 * describes the device. */
#include "platform/ctl/devices/hid_nodes.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/printable.h"
#include "platform/ctl/devices/hid_file.h"
#include "platform/os/number.h"
#include "platform/os/file.h"

#define LINE_SIZE 512

static void take_text(char *out, size_t room, const char *text)
{
    snprintf(out, room, "%.*s", (int)strcspn(text, "\n"), text);
    printable(out);
}

static void take_line(struct hid_node *node, const char *line)
{
    unsigned bus, vendor, product;
    if (sscanf(line, "HID_ID=%4x:%8x:%8x", &bus, &vendor, &product) == 3) {
        node->bus = (uint16_t)bus;
        node->vendor = (uint16_t)vendor;
        node->product = (uint16_t)product;
    } else if (strncmp(line, "HID_NAME=", 9) == 0) {
        take_text(node->name, sizeof node->name, line + 9);
    } else if (strncmp(line, "HID_PHYS=", 9) == 0) {
        take_text(node->place, sizeof node->place, line + 9);
    } else if (strncmp(line, "HID_UNIQ=", 9) == 0) {
        take_text(node->serial, sizeof node->serial, line + 9);
    } else if (strncmp(line, "DRIVER=", 7) == 0) {
        take_text(node->driver, sizeof node->driver, line + 7);
    }
}

static void read_node(const char *root, struct hid_node *node)
{
    char path[HID_NODE_PATH], line[LINE_SIZE];
    snprintf(path, sizeof path, "%s/sys/class/hidraw/hidraw%u/device/uevent", root, node->number);
    FILE *file = file_open(path, FILE_KERNEL_SIZE_MAX);
    while (file && fgets(line, sizeof line, file)) {
        take_line(node, line);
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

int hid_node_descriptor(const char *root, const struct hid_node *node, struct hid_descriptor *out,
                        int *said_errno)
{
    char path[HID_NODE_PATH];
    static uint8_t bytes[HID_DESCRIPTOR_SIZE_MAX];
    snprintf(path, sizeof path, "%s/sys/class/hidraw/hidraw%u/device/report_descriptor", root,
             node->number);
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    const ssize_t size = file < 0 ? -1 : read(file, bytes, sizeof bytes);
    *said_errno = size < 0 ? errno : 0;
    if (file >= 0) {
        close(file);
    }
    return size >= 0 && hid_descriptor_read(out, bytes, (size_t)size) == HID_OK;
}

const char *hid_node_bus(const struct hid_node *node)
{
    switch (node->bus) {
    case 0x03:
        return "USB";
    case 0x05:
        return "Bluetooth";
    case 0x06:
        return "virtual";
    case 0x18:
        return "I2C";
    default:
        return "other";
    }
}
