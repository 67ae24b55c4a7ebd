/* usb_event_thread_bus.c -- compares the devices on the USB bus with the device table, executes the
 * operator's commands, and publishes the rows of the operator's controller menu. */
#include "drivers/usb/usb_event_thread.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

/* Time in ns for which the comparisons with the bus are repeated after the last bus change. After
 * this time, even devices on slow hubs are configured. */
#define SETTLE_NS (2000u * NS_PER_MS)
#define AGAIN_NS (100u * NS_PER_MS)
/* Interval of the comparisons with the bus if libusb does not support hot-plug events. */
#define NO_HOTPLUG_NS (1000u * NS_PER_MS)

/* ---- Comparison of the device table with the USB bus ---------------------------------------- */

static struct usb_device_entry *find_entry(struct usb_event_thread *usb_thread,
                                           const libusb_device *device)
{
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.device == device) {
            return &usb_thread->entry[i];
        }
    }
    return NULL;
}

/* Removes a device from the table. Clears the device's row in the controller menu, unless the row
 * now shows a lost controller. */
static void remove_table_entry(struct usb_event_thread *usb_thread, struct usb_device_entry *entry)
{
    CORE_ASSERT(entry->device.device);
    CORE_ASSERT(entry->link == USB_INDEX_NONE || entry->link < USB_LINK_MAX);
    usb_event_thread_detach(usb_thread, entry, true);
    if (entry->row < CONTROLLER_MAX && usb_thread->rows.row[entry->row].state != CONTROLLER_LOST) {
        usb_device_table_clear(&usb_thread->rows, entry->row);
    }
    usb_thread->rows_changed = true;
    usb_device_remove(&entry->device);
}

/* Returns an empty entry of the device table. If the table is full and `verdict` is not USB_BARRED,
 * removes a device with the verdict USB_BARRED to get an empty entry. Returns null if there is no
 * room. */
static struct usb_device_entry *find_room(struct usb_event_thread *usb_thread,
                                          enum usb_verdict verdict)
{
    CORE_ASSERT(verdict <= USB_PLAYS);
    struct usb_device_entry *room = find_entry(usb_thread, NULL);
    for (uint32_t i = 0; !room && verdict > USB_BARRED && i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.verdict == USB_BARRED &&
            usb_thread->entry[i].link == USB_INDEX_NONE) {
            room = &usb_thread->entry[i];
            remove_table_entry(usb_thread, room);
        }
    }
    return room;
}

static void add_device(struct usb_event_thread *usb_thread, libusb_device *device)
{
    CORE_ASSERT(device);
    struct usb_device met;
    if (usb_device_add(&met, device, &usb_thread->evaluation)) {
        return;
    }
    struct usb_device_entry *entry = find_room(usb_thread, met.verdict);
    if (!entry) {
        usb_device_remove(&met);
        return;
    }
    const uint64_t now_ns = hal_now_ns(usb_thread->clock);
    *entry = (struct usb_device_entry){ .device = met,
                                        .is_seen = true,
                                        .link = USB_INDEX_NONE,
                                        .slot = USB_INDEX_NONE,
                                        .drains = USB_INDEX_NONE,
                                        .met_ns = now_ns,
                                        .due_ns = now_ns };
    /* The row may have belonged to a lost controller in another entry of the table. That entry then
     * loses the row and gets a new row later. */
    entry->row = usb_device_table_enter(&usb_thread->rows, &entry->device.face.identity,
                                        entry->device.verdict == USB_BARRED);
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (&usb_thread->entry[i] != entry && usb_thread->entry[i].row == entry->row) {
            usb_thread->entry[i].row = USB_INDEX_NONE;
        }
    }
    usb_thread->rows_changed = true;
}

/* Compares the bus with the table. Missing devices are removed before new devices are added, so
 * that a replugged controller finds its slot vacant. */
static void compare_bus_and_table(struct usb_event_thread *usb_thread)
{
    libusb_device **list;
    const ssize_t count = libusb_get_device_list(usb_thread->context, &list);
    if (count < 0) {
        return; /* libusb could not allocate memory. The next comparison with the bus tries
                   again. */
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        usb_thread->entry[i].is_seen = false;
    }
    for (ssize_t i = 0; i < count; i++) {
        struct usb_device_entry *entry = find_entry(usb_thread, list[i]);
        if (entry) {
            entry->is_seen = true;
        }
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.device && !usb_thread->entry[i].is_seen) {
            remove_table_entry(usb_thread, &usb_thread->entry[i]);
        }
    }
    for (ssize_t i = 0; i < count; i++) {
        if (!find_entry(usb_thread, list[i])) {
            add_device(usb_thread, list[i]);
        }
    }
    libusb_free_device_list(list, 1);
}

/* Compares the bus with the table if a comparison is due. libusb announces a device before the
 * kernel has configured it. The device has no interfaces until it is configured, and no event
 * reports the configuration. Therefore the comparison is repeated until SETTLE_NS after the last
 * change. */
void usb_event_thread_compare(struct usb_event_thread *usb_thread)
{
    const uint64_t now_ns = hal_now_ns(usb_thread->clock);
    if (usb_thread->bus_changed) {
        usb_thread->bus_changed = false;
        usb_thread->settled_ns = now_ns + SETTLE_NS;
    } else if (now_ns < usb_thread->compare_ns) {
        return;
    }
    compare_bus_and_table(usb_thread);
    usb_thread->compare_ns = now_ns < usb_thread->settled_ns ? now_ns + AGAIN_NS
                             : usb_thread->has_hotplug       ? UINT64_MAX
                                                             : now_ns + NO_HOTPLUG_NS;
}

/* ---- Commands of the operator --------------------------------------------------------------- */

/* Stores the rules. A file that could not be read is not overwritten, because the file contains
 * other rules. */
static void save_choices(struct usb_event_thread *usb_thread)
{
    char text[HAL_TEXT_SIZE];
    const int error = usb_thread->is_unread ? 0
                                            : usb_choice_save(&usb_thread->evaluation.choice,
                                                              usb_thread->choices_path);
    if ((usb_thread->is_unread || error) && usb_thread->report) {
        snprintf(text, sizeof text, "%.60s: %s%.30s; the choice is lost when the kiosk ends",
                 usb_thread->choices_path,
                 usb_thread->is_unread ? "cannot be read, so it is not overwritten"
                                       : "cannot write: ",
                 error ? strerror(-error) : "");
        usb_thread->report(usb_thread->report_self, text);
    }
}

/* Executes a command. If the product has no serial numbers, the rule applies to all devices of the
 * product, but devices that already play continue to play. */
static void execute(struct usb_event_thread *usb_thread, const struct usb_command *order)
{
    const struct usb_key key = usb_key_of(&order->identity);
    usb_choice_request(&usb_thread->evaluation.choice, &key, order->plays, true);
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        struct usb_device_entry *entry = &usb_thread->entry[i];
        if (!entry->device.device) {
            continue;
        }
        const bool is_meant =
            usb_choice_similarity(&entry->device.face.identity, &order->identity) >= 2u;
        if (is_meant && !order->plays) {
            usb_event_thread_detach(usb_thread, entry, false);
            usb_event_thread_update_row(usb_thread, entry, CONTROLLER_FREE);
        }
        entry->due_ns =
            entry->link == USB_INDEX_NONE ? hal_now_ns(usb_thread->clock) : entry->due_ns;
        entry->failures = 0;
    }
    if (!order->plays) {
        /* If the controller in the command is unplugged, a slot (`place`) and a row of the
         * controller menu may still be reserved for the controller. Both are released here. */
        const uint32_t row = usb_device_table_find(&usb_thread->rows, &order->identity);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            struct usb_place *place = &usb_thread->place[i];
            if (place->was_taken && !place->is_taken &&
                usb_choice_similarity(&place->identity, &order->identity) >= 2u) {
                place->was_taken = false;
            }
        }
        if (row < CONTROLLER_MAX && usb_thread->rows.row[row].state == CONTROLLER_LOST) {
            usb_device_table_clear(&usb_thread->rows, row);
        }
    }
    usb_thread->rows_changed = true;
}

/* Executes at most USB_COMMAND_MAX commands and then stores all their rules together. If commands
 * arrived faster than the disk stores a file, storing each rule separately would keep the thread
 * from serving the devices. */
void usb_event_thread_handle_commands(struct usb_event_thread *usb_thread)
{
    struct usb_command order;
    uint32_t count = 0;
    while (count < USB_COMMAND_MAX &&
           usb_device_list_take_command(&usb_thread->device_list, &order)) {
        execute(usb_thread, &order);
        count++;
    }
    if (count > 0) {
        save_choices(usb_thread);
    }
}

/* ---- Messages for the operator -------------------------------------------------------------- */

/* Returns true if the operator must correct the fault. An unplugged device needs no correction. */
static bool needs_operator(const struct usb_device_entry *entry)
{
    return entry->trouble != USB_FINE && entry->trouble != USB_AWAY;
}

static void write_trouble(const struct usb_device_entry *entry, char text[HAL_TEXT_SIZE])
{
    CORE_ASSERT(needs_operator(entry));
    const struct hid_identity *who = &entry->device.face.identity;
    static const char *const remedies[] = {
        [USB_DENIED] = "access denied: install board/udev/70-kingyo.rules "
                       "(kingyoctl doctor prints its line)",
        [USB_HELD] = "is in use by another program: stop that program",
        [USB_BROKEN] = "does not respond: plug it in again",
    };
    snprintf(text, HAL_TEXT_SIZE, "%04x:%04x at USB port %s %s", who->vendor, who->product,
             who->port, remedies[entry->trouble]);
}

void usb_event_thread_report_fault(struct usb_event_thread *usb_thread,
                                   struct usb_device_entry *entry)
{
    CORE_ASSERT(entry->trouble <= USB_AWAY);
    char text[HAL_TEXT_SIZE];
    if (usb_thread->report && needs_operator(entry) && entry->trouble != entry->reported_trouble) {
        write_trouble(entry, text);
        usb_thread->report(usb_thread->report_self, text);
    }
    entry->reported_trouble = entry->trouble;
}

void usb_event_thread_publish(struct usb_event_thread *usb_thread)
{
    if (!usb_thread->rows_changed) {
        return;
    }
    usb_thread->rows_changed = false;
    uint32_t here = 0, playing = 0;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        const struct usb_device_entry *entry = &usb_thread->entry[i];
        here += entry->device.device && entry->device.verdict != USB_BARRED;
        playing += entry->device.device && entry->link != USB_INDEX_NONE;
    }
    CORE_ASSERT(playing <= POI_MAX);
    snprintf(usb_thread->rows.text, sizeof usb_thread->rows.text,
             "libusb: %u controller%s, %u of them play%s", here, here == 1 ? "" : "s", playing,
             usb_thread->has_hotplug ? "" : "; no hot-plug, searched once per second");
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.device && needs_operator(&usb_thread->entry[i])) {
            write_trouble(&usb_thread->entry[i], usb_thread->rows.text);
        }
    }
    usb_thread->rows.wanted_count =
        usb_choice_wanted(&usb_thread->evaluation.choice, usb_thread->rows.wanted);
    usb_device_list_publish(&usb_thread->device_list, &usb_thread->rows);
}
