/* doctor_usb.c -- checks every USB device except hubs.
 *
 * The check reports whether the kiosk accepts the device, whether the kiosk can open the device,
 * whether another program has claimed the device, and whether autosuspend is disabled. */
#include "platform/ctl/doctor/doctor_usb.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/usb/usb_choice.h"
#include "platform/ctl/devices/hid_source.h"

static const char *map_words(const struct usb_interface *interface)
{
    const struct hid_mapping *map = &interface->map;
    if (interface->subject.kind == USB_KIND_UNKNOWN) {
        return "it says how once it is claimed";
    }
    switch (map->source) {
    case HID_MAPPING_OWN:
        return "our own poi";
    case HID_MAPPING_KNOWN:
        return "a controller we know";
    case HID_MAPPING_AUTO:
        return map->style == HID_STYLE_POINTER ? "it points" : "it has sticks";
    default:
        return "to be learned in the operator's menu";
    }
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

static void say_ready(struct doctor *doctor, const struct usb_device *device,
                      const struct usb_interface *interface)
{
    static const char *const words[] = {
        [USB_BARRED] = "never plays",
        [USB_FREE] = "may play",
        [USB_ASK] = "is asked as soon as the kiosk starts",
        [USB_PLAYS] = "plays",
    };
    CORE_ASSERT((size_t)interface->verdict < sizeof words / sizeof words[0]);
    struct doctor_finding *finding =
        doctor_usb_add_finding(doctor, device, device->sleeps ? DOCTOR_LOOK : DOCTOR_FINE);
    doctor_state(finding, "%s (%s)%s", words[interface->verdict], map_words(interface),
                 device->sleeps ? ", but may fall asleep in mid-round" : "");
    if (device->sleeps) {
        char rule[DOCTOR_TEXT];
        doctor_rules_todo(rule, sizeof rule, device->identity.vendor, device->identity.product);
        doctor_todo(finding, "%s, or for now: echo on | sudo tee " USB_DEVICES "/%s/power/control",
                    rule, device->port);
    } else if (interface->verdict == USB_FREE) {
        doctor_todo(finding, "choose it in the operator's menu, or start with --usb %04x:%04x",
                    device->identity.vendor, device->identity.product);
    }
}

static void say_hand(struct doctor *doctor, const struct usb_device *device,
                     const struct usb_interface *interface)
{
    char node[64], rule[DOCTOR_TEXT], both[2u * DOCTOR_TEXT];
    snprintf(node, sizeof node, "/dev/bus/usb/%03u/%03u", device->bus, device->number);
    const int error = doctor_may_use(doctor, node);
    if (error) {
        struct doctor_finding *denied = doctor_usb_add_finding(
            doctor, device, interface->verdict == USB_PLAYS ? DOCTOR_WRONG : DOCTOR_LOOK);
        doctor_rules_todo(rule, sizeof rule, device->identity.vendor, device->identity.product);
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
        if (by_kiosk) {
            doctor_state(finding, "claimed, by the running kiosk");
            return;
        }
        doctor_state(finding, "could play, but another program has claimed it");
        doctor_todo(finding, "end that program; sudo fuser -v /dev/bus/usb/%03u/%03u names it",
                    device->bus, device->number);
    } else {
        say_ready(doctor, device, interface);
    }
}

static bool is_named(const struct usb_key *key, const struct hid_identity *identity)
{
    return key->vendor == identity->vendor && key->product == identity->product &&
           (!key->serial[0] || strcmp(key->serial, identity->serial) == 0);
}

/* Adds a finding for a device that is not a usable controller, with the reason `why`. If an option
 * names the device, the finding has a higher severity, so that the operator notices the finding. */
static void say_no_hand(struct doctor *doctor, const struct usb_device *device, const char *why)
{
    bool is_asked = false;
    for (uint32_t i = 0; i < doctor->options.usb_count; i++) {
        struct usb_key key;
        is_asked |=
            usb_key_read(&key, doctor->options.usb[i]) == 0 && is_named(&key, &device->identity);
    }
    struct doctor_finding *finding =
        doctor_usb_add_finding(doctor, device, is_asked ? DOCTOR_LOOK : DOCTOR_FINE);
    doctor_state(finding, "%s%s", is_asked ? "was asked for, but " : "", why);
}

static void say_device(struct doctor *doctor, const struct usb_device *device,
                       const struct usb_interface *interface)
{
    const uint8_t kind = interface->subject.kind;
    if (device->identity.vendor == 0 && device->identity.product == 0) {
        doctor_state(doctor_find(doctor, "usb", DOCTOR_LOOK, "port %s", device->port),
                     "says nothing of itself: it is being pulled out, or does not answer");
        return;
    }
    if (interface->class == USB_CLASS_HID && interface->verdict >= USB_FREE &&
        kind != USB_KIND_NOTHING) {
        say_hand(doctor, device, interface);
    } else if (strcmp(interface->driver, "xpad") == 0) {
        doctor_state(doctor_usb_add_finding(doctor, device, DOCTOR_FINE),
                     "plays as a pad, through SDL");
    } else if (interface->class == USB_CLASS_HID) {
        say_no_hand(doctor, device,
                    kind == USB_KIND_NOTHING ? "sends nothing: no controller"
                                             : "has keys: a keyboard is never claimed");
    } else {
        doctor_state(doctor_usb_add_finding(doctor, device, DOCTOR_FINE), "is no controller%s%s",
                     interface->driver[0] ? "; driver " : "", interface->driver);
    }
}

/* Adds a finding for each device that an option names but that is not connected. */
static void say_missing(struct doctor *doctor, const struct hid_identity *there, uint32_t count)
{
    for (uint32_t i = 0; i < doctor->options.usb_count; i++) {
        struct usb_key key;
        bool is_there = usb_key_read(&key, doctor->options.usb[i]) != 0;
        for (uint32_t j = 0; j < count; j++) {
            is_there |= is_named(&key, &there[j]);
        }
        if (!is_there) {
            struct doctor_finding *missing =
                doctor_find(doctor, "usb", DOCTOR_WRONG, "%s", doctor->options.usb[i]);
            doctor_state(missing, "was asked for, and is not plugged in");
            doctor_todo(missing, "plug it in, or see whether its ids are right: lsusb");
        }
    }
}

/* Reads the selection of devices from the options, and from the file that the operator's menu
 * writes. */
static void read_choice(const struct doctor *doctor, struct usb_choice *choice)
{
    char path[2u * OPTIONS_PATH_MAX], why[HAL_TEXT_SIZE];
    struct usb_key key;
    *choice = (struct usb_choice){ 0 };
    snprintf(path, sizeof path, "%.1000s%.1000s/usb.txt", doctor->root, doctor->options.data);
    usb_choice_load(choice, doctor->options.data[0] ? path : "", why);
    for (uint32_t i = 0; i < doctor->options.usb_count; i++) {
        if (usb_key_read(&key, doctor->options.usb[i]) == 0) {
            usb_choice_request(choice, &key, 1, 0);
        }
    }
}

static int by_name(const void *left, const void *right)
{
    return strcmp(left, right);
}

void doctor_usb(struct doctor *doctor)
{
    static char ports[DOCTOR_FINDINGS_MAX][USB_PORT_SIZE];
    static struct hid_identity there[DOCTOR_FINDINGS_MAX];
    char path[OPTIONS_PATH_MAX + 64u];
    struct usb_choice choice;
    uint32_t count = 0, shown = 0;
    snprintf(path, sizeof path, "%s" USB_DEVICES, doctor->root);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder && count < DOCTOR_FINDINGS_MAX && (entry = readdir(folder))) {
        /* A USB port consists of a bus, a port and optional hub ports, for example "3-1.4". "usb3"
         * is a bus, and "3-1.4:1.0" is an interface. */
        const char *name = entry->d_name;
        if (name[0] >= '0' && name[0] <= '9' && strchr(name, '-') && !strchr(name, ':') &&
            strlen(name) < USB_PORT_SIZE) {
            snprintf(ports[count++], USB_PORT_SIZE, "%.31s", name);
        }
    }
    if (folder) {
        closedir(folder);
    }
    qsort(ports, count, sizeof ports[0], by_name);
    read_choice(doctor, &choice);
    for (uint32_t i = 0; i < count; i++) {
        struct usb_device device = { 0 };
        struct usb_interface best;
        memcpy(device.port, ports[i], USB_PORT_SIZE);
        doctor_read_usb(doctor, &choice, &device, &best);
        there[i] = device.identity;
        if (device.class != USB_CLASS_HUB) {
            say_device(doctor, &device, &best);
            shown++;
        }
    }
    CORE_ASSERT(count <= DOCTOR_FINDINGS_MAX && shown <= count);
    say_missing(doctor, there, count);
    if (shown == 0) {
        struct doctor_finding *none = doctor_find(doctor, "usb", DOCTOR_LOOK, "controllers");
        doctor_state(none, folder ? "nothing is plugged in" : "this machine has no USB");
        doctor_todo(none, "plug one in, or play with the mouse, a pad or a finger");
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
