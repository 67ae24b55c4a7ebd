/* doctor_usb_read.c -- reads the small files below /sys/bus/usb/devices. */
#include "platform/ctl/doctor/doctor_usb.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "drivers/usb/usb_sysfs.h"

#define BOOT 1u
#define BOOT_KEYBOARD 1u

/* Maximum number of interfaces of one device that are read. USB 2.0 sets no limit, but real devices
 * have at most 8 interfaces. */
#define INTERFACES_MAX 32u

static uint32_t number_at(const struct doctor *doctor, const char *folder, const char *name,
                          int base)
{
    char text[32];
    doctor_line(doctor, text, sizeof text, USB_DEVICES "/%s/%s", folder, name);
    return (uint32_t)strtoul(text, NULL, base);
}

static void read_device(const struct doctor *doctor, struct usb_device *device)
{
    char root[OPTIONS_PATH_MAX], text[32];
    struct hid_identity *identity = &device->identity;
    snprintf(root, sizeof root, "%s/sys", doctor->root);
    identity->vendor = (uint16_t)number_at(doctor, device->port, "idVendor", 16);
    identity->product = (uint16_t)number_at(doctor, device->port, "idProduct", 16);
    snprintf(identity->port, sizeof identity->port, "%s", device->port);
    usb_sysfs_text(root, device->port, "product", identity->name);
    usb_sysfs_text(root, device->port, "serial", identity->serial);
    usb_sysfs_text(root, device->port, "manufacturer", device->maker);
    device->bus = number_at(doctor, device->port, "busnum", 10);
    device->number = number_at(doctor, device->port, "devnum", 10);
    device->class = number_at(doctor, device->port, "bDeviceClass", 16);
    device->configuration = number_at(doctor, device->port, "bConfigurationValue", 10);
    doctor_line(doctor, text, sizeof text, USB_DEVICES "/%s/power/control", device->port);
    device->sleeps = strcmp(text, "auto") == 0;
}

static void read_interface(const struct doctor *doctor, const struct usb_choice *choice,
                           struct usb_device *device, const char *folder, struct usb_interface *out)
{
    static uint8_t bytes[HID_DESCRIPTOR_MAX];
    static struct hid_descriptor descriptor;
    char root[OPTIONS_PATH_MAX];
    *out = (struct usb_interface){ .number = number_at(doctor, folder, "bInterfaceNumber", 16) };
    out->class = number_at(doctor, folder, "bInterfaceClass", 16);
    out->subclass = number_at(doctor, folder, "bInterfaceSubClass", 16);
    out->protocol = number_at(doctor, folder, "bInterfaceProtocol", 16);
    char path[OPTIONS_PATH_MAX + 128u], target[256];
    snprintf(path, sizeof path, "%s" USB_DEVICES "/%.64s/driver", doctor->root, folder);
    const ssize_t length = readlink(path, target, sizeof target - 1u);
    target[length > 0 ? length : 0] = '\0';
    const char *slash = strrchr(target, '/');
    snprintf(out->driver, sizeof out->driver, "%.47s", slash ? slash + 1 : target);
    if (out->class != USB_CLASS_HID) {
        return;
    }
    snprintf(root, sizeof root, "%s/sys", doctor->root);
    const uint32_t size = usb_sysfs_descriptor(root, device->port, (uint8_t)device->configuration,
                                               (uint8_t)out->number, bytes);
    device->identity.interface_number = (uint8_t)out->number;
    out->subject = (struct usb_candidate){
        .identity = &device->identity,
        .is_boot_keyboard = out->subclass == BOOT && out->protocol == BOOT_KEYBOARD,
    };
    usb_choice_read(&out->subject, bytes, size, &descriptor);
    out->verdict = usb_choice_evaluate(choice, &out->subject);
    if (size && hid_descriptor_read(&descriptor, bytes, size) == HID_OK) {
        hid_mapping_choose(&out->map, &device->identity, &descriptor);
    }
}

/* Returns 1 if the kiosk would claim interface `a` rather than interface `b`, otherwise 0. */
static int is_better(const struct usb_choice *choice, const struct usb_interface *a,
                     const struct usb_interface *b)
{
    struct usb_candidate first = a->subject, second = b->subject;
    if (!first.identity || !second.identity) { /* An interface without an identity is not a HID
                                                  interface. */
        return !first.identity == !second.identity ? a->number < b->number : !second.identity;
    }
    struct hid_identity one = *first.identity, other = *second.identity;
    one.interface_number = (uint8_t)a->number;
    other.interface_number = (uint8_t)b->number;
    first.identity = &one;
    second.identity = &other;
    return usb_choice_is_better(choice, &first, &second);
}

void doctor_read_usb(const struct doctor *doctor, const struct usb_choice *choice,
                     struct usb_device *device, struct usb_interface *best)
{
    char path[OPTIONS_PATH_MAX + 64u];
    const size_t length = strlen(device->port);
    uint32_t count = 0;
    CORE_ASSERT(length > 0 && length < USB_PORT_SIZE);
    read_device(doctor, device);
    snprintf(path, sizeof path, "%s" USB_DEVICES, doctor->root);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    *best = (struct usb_interface){ 0 };
    while (folder && count < INTERFACES_MAX && (entry = readdir(folder))) {
        if (strncmp(entry->d_name, device->port, length) == 0 && entry->d_name[length] == ':') {
            struct usb_interface interface;
            read_interface(doctor, choice, device, entry->d_name, &interface);
            const bool is_first = count++ == 0;
            if (is_first || is_better(choice, &interface, best)) {
                *best = interface;
            }
        }
    }
    if (folder) {
        closedir(folder);
    }
}

/* The ids of board/udev/70-kingyo.rules. The table is a copy, so that doctor runs without the rules
 * file. A test in tests/ctl compares the table with the rules file. */
/* clang-format off */
static const struct {
    uint16_t vendor, product;
} listed[] = {
    { 0x1209, 0x0001 }, /* Kingyo's own poi controller (a paper scoop with sensors), with its
                           development id. */
    { 0x054c, 0x05c4 }, { 0x054c, 0x09cc }, { 0x054c, 0x0ba0 }, { 0x054c, 0x0ce6 },
    { 0x054c, 0x0df2 },
    /* 3Dconnexion controllers, first with the vendor id of 3Dconnexion and then with Logitech's. */
    { 0x256f, 0xc62e }, { 0x256f, 0xc62f }, { 0x256f, 0xc631 }, { 0x256f, 0xc632 },
    { 0x256f, 0xc633 }, { 0x256f, 0xc635 }, { 0x256f, 0xc636 }, { 0x256f, 0xc652 },
    { 0x046d, 0xc626 }, { 0x046d, 0xc627 }, { 0x046d, 0xc628 }, { 0x046d, 0xc629 },
    { 0x046d, 0xc62b },
};
/* clang-format on */

void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product)
{
    bool is_listed = false;
    for (uint32_t i = 0; i < sizeof listed / sizeof listed[0]; i++) {
        is_listed |= listed[i].vendor == vendor && listed[i].product == product;
    }
    if (is_listed) {
        snprintf(out, size, "sudo cp board/udev/*.rules /etc/udev/rules.d/ and replug it");
    } else {
        snprintf(out, size,
                 "put into /etc/udev/rules.d/71-kingyo-local.rules and replug it: "
                 "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"%04x\", ATTR{idProduct}==\"%04x\", "
                 "GROUP=\"kingyo\", MODE=\"0660\", ATTR{power/control}=\"on\"",
                 vendor, product);
    }
}
