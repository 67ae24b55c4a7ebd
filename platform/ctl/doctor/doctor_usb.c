/* doctor_usb.c -- checks every USB device except hubs.
 *
 * The small files below /sys/bus/usb/devices describe each device. The check reports whether the
 * kiosk accepts the device, whether the kiosk can open the device, whether another program has
 * claimed the device, and whether autosuspend is disabled. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_sysfs.h"
#include "platform/ctl/devices/hid_source.h"
#include "platform/ctl/doctor/doctor.h"

#define USB_DEVICES "/sys/bus/usb/devices"
#define USB_CLASS_HID 0x03u
#define USB_CLASS_HUB 0x09u
#define USB_PORT_SIZE 32u

/* A USB device as described by the files of /sys. */
struct usb_device {
    char port[USB_PORT_SIZE]; /* USB port of the device, for example "3-1.4" (bus 3, port 1, port 4
                                 of the hub). */
    struct hid_identity identity;
    char maker[HID_TEXT_SIZE];
    uint32_t bus, number, class, configuration;
    bool sleeps; /* True if autosuspend is enabled, so that the device may stop responding during a
                    round. */
};

/* An interface of a USB device, and the result of the kiosk's rules for accepting the interface. */
struct usb_interface {
    uint32_t number, class;
    char driver[48]; /* Name of the kernel driver that is bound to the interface. "" means no
                        driver. */
    struct usb_candidate subject;
    enum usb_verdict verdict;
    struct hid_mapping map;
};

/* ---- Reading a device ------------------------------------------------------------------------ */

#define BOOT 1u
#define BOOT_KEYBOARD 1u

static uint32_t number_at(const struct doctor *doctor, const char *folder, const char *name,
                          int base)
{
    char text[32];
    doctor_line(doctor, text, sizeof text, USB_DEVICES "/%s/%s", folder, name);
    return (uint32_t)strtoul(text, NULL, base);
}

static void read_interface(const struct doctor *doctor, const struct usb_choice *choice,
                           struct usb_device *device, const char *folder, struct usb_interface *out)
{
    static uint8_t bytes[HID_DESCRIPTOR_MAX];
    static struct hid_descriptor descriptor;
    char root[OPTIONS_PATH_MAX];
    *out = (struct usb_interface){
        .number = number_at(doctor, folder, "bInterfaceNumber", 16),
        .class = number_at(doctor, folder, "bInterfaceClass", 16),
    };
    const bool is_boot_keyboard =
        number_at(doctor, folder, "bInterfaceSubClass", 16) == BOOT &&
        number_at(doctor, folder, "bInterfaceProtocol", 16) == BOOT_KEYBOARD;
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
        .is_boot_keyboard = is_boot_keyboard,
    };
    usb_choice_read(&out->subject, bytes, size, &descriptor);
    out->verdict = usb_choice_evaluate(choice, &out->subject);
    if (size && hid_descriptor_read(&descriptor, bytes, size) == HID_OK) {
        hid_mapping_choose(&out->map, &device->identity, &descriptor);
    }
}

/* Returns true if the kiosk would claim interface `a` rather than interface `b`. */
static bool is_better(const struct usb_choice *choice, const struct usb_interface *a,
                      const struct usb_interface *b)
{
    struct usb_candidate first = a->subject, second = b->subject;
    /* An interface whose `identity` is null is not a HID interface. A HID interface is always
     * better than such an interface. */
    if (!first.identity || !second.identity) {
        return !first.identity == !second.identity ? a->number < b->number : !second.identity;
    }
    struct hid_identity one = *first.identity, other = *second.identity;
    one.interface_number = (uint8_t)a->number;
    other.interface_number = (uint8_t)b->number;
    first.identity = &one;
    second.identity = &other;
    return usb_choice_is_better(choice, &first, &second);
}

/* Reads the device at `device->port` and selects its best interface for the kiosk
 * (usb_choice_is_better()). An interface that the kiosk can use at once is preferred. The second
 * choice is an interface whose descriptor must be read first. The third choice is an interface
 * whose controller the operator must let the kiosk learn. For a HID interface, `best->subject`
 * points to `device->identity`. `device` must therefore outlive `best`. */
static void read_usb(const struct doctor *doctor, const struct usb_choice *choice,
                     struct usb_device *device, struct usb_interface *best)
{
    static struct doctor_names interfaces;
    char prefix[USB_PORT_SIZE + 1u];
    CORE_ASSERT(device->port[0]);
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
    *best = (struct usb_interface){ 0 };
    snprintf(prefix, sizeof prefix, "%s:", device->port);
    doctor_list(doctor, USB_DEVICES, prefix, &interfaces);
    for (uint32_t i = 0; i < interfaces.count; i++) {
        struct usb_interface interface;
        read_interface(doctor, choice, device, interfaces.name[i], &interface);
        if (i == 0 || is_better(choice, &interface, best)) {
            *best = interface;
        }
    }
}

/* Vendor and product ids of the controllers in Kingyo's udev rules file,
 * board/udev/70-kingyo.rules. The table is a copy, so that doctor runs without the rules file. A
 * test in tests/ctl compares the table with the rules file. */
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

/* Writes the advice for a controller to `out`. If Kingyo's udev rules file lists the controller,
 * the advice is to install the file. Otherwise the advice contains the udev rule that must be added
 * for the controller. */
static void write_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product)
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

/* ---- Findings -------------------------------------------------------------------------------- */

static const char *map_words(const struct usb_interface *interface)
{
    const struct hid_mapping *map = &interface->map;
    if (interface->subject.kind == USB_KIND_UNKNOWN) {
        return "its motions are known when the kiosk has claimed it";
    }
    return map->source == HID_MAPPING_OWN     ? "our own poi"
           : map->source == HID_MAPPING_KNOWN ? "a known controller"
           : map->source != HID_MAPPING_AUTO  ? "to be learned in the operator's menu"
           : map->style == HID_STYLE_POINTER  ? "it is a pointer"
                                              : "it has sticks";
}

static struct doctor_finding *doctor_usb_add_finding(struct doctor *doctor,
                                                     const struct usb_device *device,
                                                     enum doctor_level level)
{
    const struct hid_identity *identity = &device->identity;
    const char *name = identity->name[0] ? identity->name : device->maker;
    return doctor_find(doctor, "usb", level, "%04x:%04x %s, port %s", identity->vendor,
                       identity->product, name[0] ? name : "without a name", device->port);
}

static void report_ready(struct doctor *doctor, const struct usb_device *device,
                         const struct usb_interface *interface)
{
    static const char *const words[] = {
        [USB_BARRED] = "is never used",
        [USB_FREE] = "may play",
        [USB_ASK] = "is examined when the kiosk starts",
        [USB_PLAYS] = "plays",
    };
    CORE_ASSERT((size_t)interface->verdict < sizeof words / sizeof words[0]);
    struct doctor_finding *finding =
        doctor_usb_add_finding(doctor, device, device->sleeps ? DOCTOR_CHECK : DOCTOR_FINE);
    doctor_state(finding, "%s (%s)%s", words[interface->verdict], map_words(interface),
                 device->sleeps ? ", but autosuspend may stop it during a round" : "");
    if (device->sleeps) {
        char rule[DOCTOR_TEXT];
        write_rules_todo(rule, sizeof rule, device->identity.vendor, device->identity.product);
        doctor_todo(finding, "%s, or for now: echo on | sudo tee " USB_DEVICES "/%s/power/control",
                    rule, device->port);
    } else if (interface->verdict == USB_FREE) {
        doctor_todo(finding, "select it in the operator's menu, or start with --usb %04x:%04x",
                    device->identity.vendor, device->identity.product);
    }
}

static void report_controller(struct doctor *doctor, const struct usb_device *device,
                              const struct usb_interface *interface)
{
    char node[64], rule[DOCTOR_TEXT], both[2u * DOCTOR_TEXT];
    snprintf(node, sizeof node, "/dev/bus/usb/%03u/%03u", device->bus, device->number);
    const int error = doctor_access_error(doctor, node);
    if (error) {
        struct doctor_finding *denied = doctor_usb_add_finding(
            doctor, device, interface->verdict == USB_PLAYS ? DOCTOR_WRONG : DOCTOR_CHECK);
        write_rules_todo(rule, sizeof rule, device->identity.vendor, device->identity.product);
        snprintf(both, sizeof both,
                 "%s; %s must be in group kingyo, which board/sysusers/kingyo.conf makes: "
                 "sudo usermod -aG kingyo %s",
                 rule, doctor->user.name, doctor->user.name);
        doctor_state(denied, "could play, but %s may not open it: %s: %s", doctor->user.name, node,
                     strerror(error));
        doctor_todo_access(doctor, denied, node, both);
    } else if (strcmp(interface->driver, "usbfs") == 0) {
        /* libusb detaches a kernel driver automatically, but cannot take a device from another
         * program. */
        const bool by_kiosk = doctor_kiosk_is_running(doctor);
        struct doctor_finding *finding =
            doctor_usb_add_finding(doctor, device, by_kiosk ? DOCTOR_FINE : DOCTOR_WRONG);
        doctor_state(finding, by_kiosk ? "claimed, by the running kiosk"
                                       : "could play, but another program has claimed it");
        if (!by_kiosk) {
            doctor_todo(finding, "end that program; sudo fuser -v %s names it", node);
        }
    } else {
        report_ready(doctor, device, interface);
    }
}

/* Returns true if the option --usb with the index `option` names the device. */
static bool is_named(const struct doctor *doctor, uint32_t option,
                     const struct hid_identity *identity)
{
    struct usb_key key;
    return usb_key_read(&key, doctor->options.usb[option]) == 0 && key.vendor == identity->vendor &&
           key.product == identity->product &&
           (!key.serial[0] || strcmp(key.serial, identity->serial) == 0);
}

/* Adds a finding for a device that the kiosk does not use as a controller over libusb. If an option
 * names a HID device, the finding has a higher severity, so that the operator notices it. */
static void report_unused(struct doctor *doctor, const struct usb_device *device,
                          const struct usb_interface *interface)
{
    const bool is_hid = interface->class == USB_CLASS_HID;
    bool is_requested = false;
    for (uint32_t i = 0; is_hid && i < doctor->options.usb_count; i++) {
        is_requested |= is_named(doctor, i, &device->identity);
    }
    struct doctor_finding *finding =
        doctor_usb_add_finding(doctor, device, is_requested ? DOCTOR_CHECK : DOCTOR_FINE);
    if (is_hid) {
        doctor_state(finding, "%s%s", is_requested ? "was requested, but " : "",
                     interface->subject.kind == USB_KIND_NOTHING
                         ? "sends no data: not a controller"
                         : "has keys: the kiosk never claims a keyboard");
    } else {
        doctor_state(finding, "is not a controller%s%s", interface->driver[0] ? "; driver " : "",
                     interface->driver);
    }
}

static void report_device(struct doctor *doctor, const struct usb_device *device,
                          const struct usb_interface *interface)
{
    if (device->identity.vendor == 0 && device->identity.product == 0) {
        doctor_state(doctor_find(doctor, "usb", DOCTOR_CHECK, "port %s", device->port),
                     "has no readable data: it is being unplugged, or does not respond");
    } else if (interface->class == USB_CLASS_HID && interface->verdict >= USB_FREE &&
               interface->subject.kind != USB_KIND_NOTHING) {
        report_controller(doctor, device, interface);
    } else if (strcmp(interface->driver, "xpad") == 0) {
        doctor_state(doctor_usb_add_finding(doctor, device, DOCTOR_FINE),
                     "plays as a pad, through SDL");
    } else {
        report_unused(doctor, device, interface);
    }
}

/* Adds a finding for each device that an option names but that is not connected. */
static void report_missing(struct doctor *doctor, const struct hid_identity *there, uint32_t count)
{
    for (uint32_t i = 0; i < doctor->options.usb_count; i++) {
        bool is_there = false;
        for (uint32_t j = 0; j < count; j++) {
            is_there |= is_named(doctor, i, &there[j]);
        }
        if (!is_there) {
            struct doctor_finding *missing =
                doctor_find(doctor, "usb", DOCTOR_WRONG, "%s", doctor->options.usb[i]);
            doctor_state(missing, "was requested, and is not plugged in");
            doctor_todo(missing, "plug it in, or check its ids: lsusb");
        }
    }
}

void doctor_usb(struct doctor *doctor)
{
    static struct doctor_names ports;
    static struct hid_identity there[DOCTOR_NAMES_MAX];
    char path[2u * OPTIONS_PATH_MAX], why[HAL_TEXT_SIZE];
    struct usb_choice choice = { 0 };
    uint32_t count = 0, shown = 0;
    doctor_list(doctor, USB_DEVICES, "", &ports);
    /* usb.txt contains the devices that were selected in the operator's menu. */
    snprintf(path, sizeof path, "%.1000s%.1000s/usb.txt", doctor->root, doctor->options.data);
    usb_choice_load(&choice, doctor->options.data[0] ? path : "", why);
    for (uint32_t i = 0; i < doctor->options.usb_count; i++) {
        struct usb_key key;
        if (usb_key_read(&key, doctor->options.usb[i]) == 0) {
            usb_choice_request(&choice, &key, 1, 0);
        }
    }
    for (uint32_t i = 0; i < ports.count; i++) {
        struct usb_device device = { 0 };
        struct usb_interface best;
        /* A USB port consists of a bus, a port and optional hub ports, for example "3-1.4". "usb3"
         * is a bus, and "3-1.4:1.0" is an interface. */
        const char *port = ports.name[i];
        if (port[0] < '0' || port[0] > '9' || !strchr(port, '-') || strchr(port, ':') ||
            strlen(port) >= USB_PORT_SIZE) {
            continue;
        }
        memcpy(device.port, port, strlen(port));
        read_usb(doctor, &choice, &device, &best);
        there[count++] = device.identity;
        if (device.class != USB_CLASS_HUB) {
            report_device(doctor, &device, &best);
            shown++;
        }
    }
    report_missing(doctor, there, count);
    if (shown == 0) {
        struct doctor_finding *none = doctor_find(doctor, "usb", DOCTOR_CHECK, "controllers");
        doctor_state(none, ports.count > 0 ? "nothing is plugged in" : "this machine has no USB");
        doctor_todo(none, "plug in a controller, or play with the mouse, a pad or a finger");
    }
}

void doctor_nodes(struct doctor *doctor)
{
    static struct hid_node nodes[HID_NODES_MAX];
    const uint32_t count = hid_nodes_list(doctor->root, nodes);
    for (uint32_t i = 0; i < count; i++) {
        const struct hid_node *node = &nodes[i];
        if (strcmp(hid_node_bus(node), "USB") != 0) {
            doctor_state(doctor_find(doctor, "hid", DOCTOR_FINE, "%04x:%04x %s", node->vendor,
                                     node->product, node->name),
                         "by %s: plays through SDL where it is a pad, mouse or touch screen",
                         hid_node_bus(node));
        }
    }
}
