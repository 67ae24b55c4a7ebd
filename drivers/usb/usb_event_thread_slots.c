/* usb_event_thread_slots.c -- opens controllers, attaches them to slots, and closes them. */
#include "drivers/usb/usb_event_thread.h"

#include "core/base/panic.h"

#define SOON_NS (NS_PER_S / 10u)
/* Interval between two attempts to open a device. In the meantime the operator may change
 * permissions or end another program. */
#define RETRY_NS (2u * NS_PER_S)
/* Longest interval between two attempts to open a device. The interval doubles with each failure,
 * because an attempt blocks the event thread for seconds and delays other devices. */
#define RETRY_NS_MAX (60u * NS_PER_S)
/* Limit of the count of failed attempts to open a device. The interval before the next attempt is
 * 2, 4, 8, 16 and 32 s after the first five failures, then RETRY_NS_MAX after each failure. */
#define FAILURES_MAX 6u
/* Longest expected time from the detection of a new device until a kernel driver is bound to the
 * device and the udev rules have run. */
#define SETTLE_NS (2u * NS_PER_S)
/* Time for which the slot of an unplugged controller is kept for that controller. A game round is
 * paused for at most the same time while its controller is missing. */
#define HOLD_NS (POI_WAIT_TICKS_MAX * NS_PER_S / CORE_TICK_HZ)

void usb_event_thread_update_row(struct usb_event_thread *usb_thread,
                                 struct usb_device_entry *entry, uint8_t state)
{
    CORE_ASSERT(entry->device.device);
    /* The device has no row yet, because no row of the operator's menu was free when the device was
     * added. */
    if (entry->row >= CONTROLLER_MAX) {
        entry->row = usb_device_table_enter(&usb_thread->rows, &entry->device.face.identity,
                                            state == CONTROLLER_UNSUPPORTED);
    }
    if (entry->row < CONTROLLER_MAX) {
        struct hid_row *row = &usb_thread->rows.row[entry->row];
        row->identity = entry->device.face.identity;
        row->state = state;
        row->slot = (uint8_t)(entry->slot < POI_MAX ? entry->slot : POI_MAX);
        usb_thread->rows_changed = true;
    }
}

/* ---- Attaching to slots --------------------------------------------------------------------- */

void usb_event_thread_detach(struct usb_event_thread *usb_thread, struct usb_device_entry *entry,
                             bool is_gone)
{
    if (entry->link == USB_INDEX_NONE) {
        return;
    }
    CORE_ASSERT(entry->link < USB_LINK_MAX);
    CORE_ASSERT(entry->slot < POI_MAX);
    usb_transfers_drain(&usb_thread->link[entry->link], is_gone);
    usb_thread->place[entry->slot].is_taken = false;
    usb_thread->lost_ns[entry->slot] = hal_now_ns(usb_thread->clock);
    usb_event_thread_update_row(usb_thread, entry, CONTROLLER_LOST);
    entry->drains = entry->link;
    entry->link = entry->slot = USB_INDEX_NONE;
    entry->due_ns = hal_now_ns(usb_thread->clock) + SOON_NS;
}

static void attach_to_slot(struct usb_event_thread *usb_thread, struct usb_device_entry *entry,
                           libusb_device_handle *handle, uint32_t slot, uint32_t link)
{
    CORE_ASSERT(slot < POI_MAX);
    CORE_ASSERT(link < USB_LINK_MAX);
    CORE_ASSERT(entry->link == USB_INDEX_NONE);
    CORE_ASSERT(usb_thread->link[link].state == USB_TRANSFERS_NONE);
    const struct usb_place *place = &usb_thread->place[slot];
    const uint32_t row = place->was_taken
                             ? usb_device_table_find(&usb_thread->rows, &place->identity)
                             : CONTROLLER_MAX;
    if (row < CONTROLLER_MAX && row != entry->row &&
        usb_thread->rows.row[row].state == CONTROLLER_LOST) {
        /* A different controller gets the slot, so the row of the lost controller is cleared. */
        usb_device_table_clear(&usb_thread->rows, row);
    }
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (usb_thread->link[i].port == &usb_thread->port[slot]) {
            /* The previous link of this slot is still closing. Its controller must be detached
             * before the new controller is attached. */
            usb_transfers_detach(&usb_thread->link[i]);
        }
    }
    usb_thread->place[slot] = (struct usb_place){ .was_taken = true,
                                                  .is_taken = true,
                                                  .identity = entry->device.face.identity };
    entry->slot = slot;
    entry->link = link;
    hid_port_attach(&usb_thread->port[slot], &entry->device.face);
    usb_transfers_begin(&usb_thread->link[link], handle, &entry->device.pipe,
                        &usb_thread->port[slot]);
    usb_event_thread_update_row(usb_thread, entry, CONTROLLER_ACTIVE);
}

/* ---- Examining and opening of devices ------------------------------------------------------- */

static void open_device(struct usb_event_thread *usb_thread, struct usb_device_entry *entry)
{
    CORE_ASSERT(entry->link == USB_INDEX_NONE);
    CORE_ASSERT(entry->failures <= FAILURES_MAX);
    const uint64_t now_ns = hal_now_ns(usb_thread->clock);
    libusb_device_handle *handle;
    uint32_t link = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        usb_thread->place[i].is_held = now_ns - usb_thread->lost_ns[i] < HOLD_NS;
    }
    const uint32_t slot = usb_choice_slot(usb_thread->place, &entry->device.face.identity);
    while (link < USB_LINK_MAX && usb_thread->link[link].state != USB_TRANSFERS_NONE) {
        link++;
    }
    if (slot >= POI_MAX || link == USB_LINK_MAX) {
        usb_event_thread_update_row(usb_thread, entry, CONTROLLER_FREE);
        entry->due_ns = hal_now_ns(usb_thread->clock) + RETRY_NS;
        return;
    }
    entry->trouble = (uint8_t)usb_device_open(&entry->device, &usb_thread->evaluation, &handle);
    entry->failures = (uint8_t)(entry->trouble != USB_BROKEN     ? 0u
                                : entry->failures < FAILURES_MAX ? entry->failures + 1u
                                                                 : FAILURES_MAX);
    if (handle) {
        entry->reported_trouble = USB_FINE;
        attach_to_slot(usb_thread, entry, handle, slot, link);
    } else if (entry->trouble != USB_FINE) {
        const bool is_denied = entry->trouble == USB_DENIED || entry->trouble == USB_HELD;
        const bool was_lost = entry->row < CONTROLLER_MAX &&
                              usb_thread->rows.row[entry->row].state == CONTROLLER_LOST;
        const uint64_t wait_ns = RETRY_NS << (entry->failures > 0u ? entry->failures - 1u : 0u);
        usb_event_thread_report_fault(usb_thread, entry);
        usb_event_thread_update_row(usb_thread, entry,
                                    (uint8_t)(is_denied  ? CONTROLLER_DENIED
                                              : was_lost ? CONTROLLER_LOST
                                                         : CONTROLLER_FREE));
        entry->due_ns =
            hal_now_ns(usb_thread->clock) + (wait_ns < RETRY_NS_MAX ? wait_ns : RETRY_NS_MAX);
    } else {
        /* The report descriptor that was read after claiming shows that the controller may not
         * play. Therefore the device is examined again. */
        entry->due_ns = hal_now_ns(usb_thread->clock);
    }
}

static void examine(struct usb_event_thread *usb_thread, struct usb_device_entry *entry)
{
    CORE_ASSERT(entry->device.device);
    usb_device_refresh(&entry->device, &usb_thread->evaluation);
    /* /sys has no report descriptor until a kernel driver binds the device. After SETTLE_NS no
     * driver is expected to bind the device. */
    const uint64_t now_ns = hal_now_ns(usb_thread->clock);
    const bool is_unknown = entry->device.kind == USB_KIND_UNKNOWN;
    entry->due_ns =
        is_unknown && now_ns - entry->met_ns < SETTLE_NS ? now_ns + SOON_NS : UINT64_MAX;
    if (entry->device.verdict <= USB_FREE) {
        entry->trouble = entry->reported_trouble = USB_FINE;
    }
    switch (entry->device.verdict) {
    case USB_BARRED:
        usb_event_thread_update_row(usb_thread, entry, CONTROLLER_UNSUPPORTED);
        break;
    case USB_FREE:
        usb_event_thread_update_row(usb_thread, entry, CONTROLLER_FREE);
        break;
    default:
        open_device(usb_thread, entry);
    }
}

/* Returns true while the previous handle of the device is open. The interface cannot be claimed
 * again until the handle is closed. */
static bool is_draining(const struct usb_event_thread *usb_thread,
                        const struct usb_device_entry *entry)
{
    CORE_ASSERT(entry->drains == USB_INDEX_NONE || entry->drains < USB_LINK_MAX);
    return entry->drains != USB_INDEX_NONE &&
           usb_thread->link[entry->drains].state == USB_TRANSFERS_DRAINING;
}

void usb_event_thread_service(struct usb_event_thread *usb_thread)
{
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        struct usb_device_entry *entry = &usb_thread->entry[i];
        if (!entry->device.device) {
            continue;
        }
        if (entry->link != USB_INDEX_NONE) {
            usb_transfers_send(&usb_thread->link[entry->link]);
        } else if (!is_draining(usb_thread, entry) &&
                   hal_now_ns(usb_thread->clock) >= entry->due_ns) {
            examine(usb_thread, entry);
        }
    }
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (!usb_transfers_service(&usb_thread->link[i])) {
            continue;
        }
        /* The device of a failed link is detached. The link is closed immediately if all transfers
         * have returned. */
        for (uint32_t k = 0; k < USB_DEVICE_MAX; k++) {
            struct usb_device_entry *entry = &usb_thread->entry[k];
            if (entry->device.device && entry->link == i) {
                usb_event_thread_detach(usb_thread, entry, usb_thread->link[i].is_gone);
            }
        }
        usb_transfers_service(&usb_thread->link[i]);
    }
}

uint64_t usb_event_thread_due_ns(const struct usb_event_thread *usb_thread)
{
    uint64_t due_ns = usb_thread->compare_ns;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        const struct usb_device_entry *entry = &usb_thread->entry[i];
        if (entry->device.device && entry->link == USB_INDEX_NONE &&
            !is_draining(usb_thread, entry) && entry->due_ns < due_ns) {
            due_ns = entry->due_ns;
        }
    }
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        const uint64_t link_ns = usb_transfers_due_ns(&usb_thread->link[i]);
        due_ns = link_ns < due_ns ? link_ns : due_ns;
    }
    return due_ns;
}
