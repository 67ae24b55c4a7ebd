/* usb_pump_bus.c -- compares the bus with the table, executes commands, and publishes the
 * result. */
#include <stdio.h>
#include <string.h>

#include "drivers/usb_choice_file.h"
#include "drivers/usb_pump.h"

#define NS_PER_MS 1000000ull
/* Time after which even devices on slow hubs are configured. */
#define SETTLE_NS (2000u * NS_PER_MS)
#define AGAIN_NS (100u * NS_PER_MS)
#define NO_HOTPLUG_NS (1000u * NS_PER_MS) /* Interval of comparisons without hot-plug support. */

/* ---- Comparison ----------------------------------------------------------------------------- */

static struct usb_entry *find_entry(struct usb_pump *pump, const libusb_device *device)
{
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (pump->entry[i].device.device == device) {
            return &pump->entry[i];
        }
    }
    return NULL;
}

/* Removes a device from the table. The row of a lost controller stays while its slot is held. */
static void part(struct usb_pump *pump, struct usb_entry *entry)
{
    usb_pump_unseat(pump, entry, 1);
    if (entry->row < CONTROLLER_MAX && pump->rows.row[entry->row].state != CONTROLLER_LOST) {
        usb_rows_clear(&pump->rows, entry->row);
    }
    pump->rows_changed = 1;
    usb_device_forget(&entry->device);
}

/* Returns an empty entry. If the table is full, a device that may play replaces a barred one.
 * Returns null if there is no room. */
static struct usb_entry *find_room(struct usb_pump *pump, enum usb_verdict verdict)
{
    struct usb_entry *room = find_entry(pump, NULL);
    for (uint32_t i = 0; !room && verdict > USB_BARRED && i < USB_DEVICE_MAX; i++) {
        if (pump->entry[i].device.verdict == USB_BARRED && pump->entry[i].link == USB_NOBODY) {
            room = &pump->entry[i];
            part(pump, room);
        }
    }
    return room;
}

/* Assigns a row. If the row belonged to an entry whose device was lost, that entry gets a new
 * row later. */
static void give_row(struct usb_pump *pump, struct usb_entry *entry)
{
    entry->row = usb_rows_enter(&pump->rows, &entry->device.face.identity,
                                entry->device.verdict == USB_BARRED);
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (&pump->entry[i] != entry && pump->entry[i].row == entry->row) {
            pump->entry[i].row = USB_NOBODY;
        }
    }
    pump->rows_changed = 1;
}

static void meet(struct usb_pump *pump, libusb_device *device)
{
    const struct usb_judge judge = {
        .sysfs = pump->sysfs, .choice = &pump->choice, .scratch = &pump->scratch
    };
    struct usb_device met;
    if (usb_device_meet(&met, device, &judge)) {
        return;
    }
    struct usb_entry *entry = find_room(pump, met.verdict);
    if (!entry) {
        usb_device_forget(&met);
        return;
    }
    const uint64_t now_ns = usb_pump_now_ns(pump);
    *entry = (struct usb_entry){ .device = met, .is_seen = 1, .link = USB_NOBODY,
                                 .seat = USB_NOBODY, .drains = USB_NOBODY, .met_ns = now_ns,
                                 .due_ns = now_ns };
    give_row(pump, entry);
}

/* Removes missing devices before it adds new ones, so that a replugged controller finds its slot
 * vacant. */
static void compare(struct usb_pump *pump)
{
    libusb_device **list;
    const ssize_t count = libusb_get_device_list(pump->context, &list);
    if (count < 0) {
        return; /* No memory; the next change triggers another attempt. */
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        pump->entry[i].is_seen = 0;
    }
    for (ssize_t i = 0; i < count; i++) {
        struct usb_entry *entry = find_entry(pump, list[i]);
        if (entry) {
            entry->is_seen = 1;
        }
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (pump->entry[i].device.device && !pump->entry[i].is_seen) {
            part(pump, &pump->entry[i]);
        }
    }
    for (ssize_t i = 0; i < count; i++) {
        if (!find_entry(pump, list[i])) {
            meet(pump, list[i]);
        }
    }
    libusb_free_device_list(list, 1);
}

/* Compares the bus with the table when that is due. A device is announced before the kernel has
 * configured it, and it has no interfaces until then. No event reports the configuration.
 * Therefore the comparison repeats until SETTLE_NS after the last change. */
void usb_pump_compare(struct usb_pump *pump)
{
    const uint64_t now_ns = usb_pump_now_ns(pump);
    if (pump->bus_changed) {
        pump->bus_changed = 0;
        pump->settled_ns = now_ns + SETTLE_NS;
    } else if (now_ns < pump->compare_ns) {
        return;
    }
    compare(pump);
    pump->compare_ns = now_ns < pump->settled_ns ? now_ns + AGAIN_NS
                       : pump->has_hotplug       ? UINT64_MAX
                                                 : now_ns + NO_HOTPLUG_NS;
}

/* ---- Commands ------------------------------------------------------------------------------- */

/* Releases the slot and the row that were held for a lost controller. */
static void release(struct usb_pump *pump, const struct hid_identity *identity)
{
    const uint32_t row = usb_rows_find(&pump->rows, identity);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (pump->place[i].was_taken && !pump->place[i].is_taken &&
            usb_choice_likeness(&pump->place[i].identity, identity) >= 2u) {
            pump->place[i].was_taken = 0;
        }
    }
    if (row < CONTROLLER_MAX && pump->rows.row[row].state == CONTROLLER_LOST) {
        usb_rows_clear(&pump->rows, row);
    }
}

/* Stores the choices. A file that could not be read is not overwritten, because it contains
 * other choices. */
static void keep_choices(struct usb_pump *pump)
{
    char text[HAL_TEXT_SIZE];
    const int error =
        pump->is_unread ? 0 : usb_choice_save(&pump->choice, pump->choices_path);
    if ((pump->is_unread || error) && pump->tell) {
        snprintf(text, sizeof text, "%.60s: %s%.30s; the choice holds for today",
                 pump->choices_path, pump->is_unread ? "is not written over" : "cannot write: ",
                 error ? strerror(-error) : "");
        pump->tell(pump->tell_self, text);
    }
}

/* Executes a command. If the product has no serial numbers, the rule applies to all its devices,
 * but devices that already play continue. */
static void obey(struct usb_pump *pump, const struct usb_order *order)
{
    const struct usb_key key = usb_key_of(&order->identity);
    usb_choice_wish(&pump->choice, &key, order->plays, 1);
    keep_choices(pump);
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        struct usb_entry *entry = &pump->entry[i];
        if (!entry->device.device) {
            continue;
        }
        const int is_meant = usb_choice_likeness(&entry->device.face.identity,
                                                 &order->identity) >= 2u;
        if (is_meant && !order->plays) {
            usb_pump_unseat(pump, entry, 0);
            usb_pump_show(pump, entry, CONTROLLER_FREE);
        }
        entry->due_ns = entry->link == USB_NOBODY ? usb_pump_now_ns(pump) : entry->due_ns;
        entry->failures = 0;
    }
    if (!order->plays) {
        release(pump, &order->identity);
    }
    pump->rows_changed = 1;
}

void usb_pump_obey(struct usb_pump *pump)
{
    struct usb_order order;
    while (usb_roster_order(&pump->roster, &order)) {
        obey(pump, &order);
    }
}

/* ---- Messages ------------------------------------------------------------------------------- */

static void write_trouble(const struct usb_entry *entry, char text[HAL_TEXT_SIZE])
{
    const struct hid_identity *who = &entry->device.face.identity;
    static const char *const remedies[] = {
        [USB_DENIED] = "may not be opened: install board/udev/70-kingyo.rules "
                       "(kingyoctl doctor writes its line)",
        [USB_HELD] = "is held by another program: end that",
        [USB_BROKEN] = "does not answer: replug it",
    };
    snprintf(text, HAL_TEXT_SIZE, "%04x:%04x at USB port %s %s", who->vendor, who->product,
             who->port, remedies[entry->trouble]);
}

/* Returns 1 if the trouble needs the operator. A device that was just unplugged does not. */
static int is_in_the_way(const struct usb_entry *entry)
{
    return entry->trouble != USB_FINE && entry->trouble != USB_AWAY;
}

void usb_pump_tell_trouble(struct usb_pump *pump, struct usb_entry *entry)
{
    char text[HAL_TEXT_SIZE];
    if (pump->tell && is_in_the_way(entry) && entry->trouble != entry->told_trouble) {
        write_trouble(entry, text);
        pump->tell(pump->tell_self, text);
    }
    entry->told_trouble = entry->trouble;
}

static void tell_count(const struct usb_pump *pump, char text[HAL_TEXT_SIZE])
{
    uint32_t here = 0, playing = 0;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        const struct usb_entry *entry = &pump->entry[i];
        here += entry->device.device && entry->device.verdict != USB_BARRED;
        playing += entry->device.device && entry->link != USB_NOBODY;
    }
    snprintf(text, HAL_TEXT_SIZE, "libusb: %u controller%s, %u of them play%s", here,
             here == 1 ? "" : "s", playing,
             pump->has_hotplug ? "" : "; no hot-plug, looked for once a second");
}

void usb_pump_tell(struct usb_pump *pump)
{
    if (!pump->rows_changed) {
        return;
    }
    pump->rows_changed = 0;
    tell_count(pump, pump->rows.text);
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (pump->entry[i].device.device && is_in_the_way(&pump->entry[i])) {
            write_trouble(&pump->entry[i], pump->rows.text);
        }
    }
    pump->rows.wanted_count = usb_choice_wanted(&pump->choice, pump->rows.wanted);
    usb_roster_post(&pump->roster, &pump->rows);
}
