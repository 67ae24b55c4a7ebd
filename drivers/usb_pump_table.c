/* usb_pump_table.c -- the event thread's device table: opens, attaches and closes controllers. */
#include <stdio.h>
#include <string.h>

#include "drivers/usb_pump.h"

#define NS_PER_S 1000000000ull
#define SOON_NS (NS_PER_S / 10u)
/* Retry interval; permissions and other programs change at human speed. */
#define RETRY_NS (2u * NS_PER_S)
/* Longest retry interval. The interval doubles with each failure, because an attempt blocks the
 * thread for seconds and other devices wait. */
#define RETRY_NS_MAX (60u * NS_PER_S)
/* Limit of the count: the retry intervals are 2, 4, 8, 16 and 32 s, and then the longest. */
#define FAILURES_MAX 6u
#define SETTLE_NS (2u * NS_PER_S)  /* Time in which a driver binds and the udev rules run. */
/* Time for which the slot of an unplugged controller is held. A round can wait equally long for
 * its controller. */
#define HOLD_NS (POI_WAIT_TICKS_MAX * NS_PER_S / CORE_TICK_HZ)

static struct usb_judge judge_of(struct usb_pump *pump)
{
    return (struct usb_judge){
        .sysfs = pump->sysfs,
        .choice = &pump->choice,
        .scratch = &pump->scratch,
    };
}

void usb_pump_show(struct usb_pump *pump, struct usb_entry *entry, uint8_t state)
{
    if (entry->row >= CONTROLLER_MAX) { /* No row was free when the device was added. */
        entry->row = usb_rows_enter(&pump->rows, &entry->device.face.identity,
                                    state == CONTROLLER_BARRED);
    }
    if (entry->row < CONTROLLER_MAX) {
        struct hid_row *row = &pump->rows.row[entry->row];
        row->identity = entry->device.face.identity;
        row->state = state;
        row->seat = (uint8_t)(entry->seat < POI_MAX ? entry->seat : POI_MAX);
        pump->rows_changed = 1;
    }
}

/* ---- Slots ---------------------------------------------------------------------------------- */

void usb_pump_unseat(struct usb_pump *pump, struct usb_entry *entry, int is_gone)
{
    if (entry->link == USB_NOBODY) {
        return;
    }
    usb_link_drain(&pump->link[entry->link], is_gone);
    pump->place[entry->seat].is_taken = 0;
    pump->lost_ns[entry->seat] = usb_pump_now_ns(pump);
    usb_pump_show(pump, entry, CONTROLLER_LOST);
    entry->drains = entry->link;
    entry->link = entry->seat = USB_NOBODY;
    entry->due_ns = usb_pump_now_ns(pump) + SOON_NS;
}

static uint32_t find_seat(struct usb_pump *pump, const struct hid_identity *identity)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        pump->place[i].is_held = usb_pump_now_ns(pump) - pump->lost_ns[i] < HOLD_NS;
    }
    return usb_choice_seat(pump->place, identity);
}

static uint32_t find_link(const struct usb_pump *pump)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (pump->link[i].state == USB_LINK_NONE) {
            return i;
        }
    }
    return USB_NOBODY;
}

/* Clears the row of a lost controller whose slot a different controller gets. */
static void forget_former(struct usb_pump *pump, const struct usb_entry *entry, uint32_t seat)
{
    const struct usb_place *place = &pump->place[seat];
    const uint32_t row = place->was_taken ? usb_rows_find(&pump->rows, &place->identity)
                                          : CONTROLLER_MAX;
    if (row < CONTROLLER_MAX && row != entry->row &&
        pump->rows.row[row].state == CONTROLLER_LOST) {
        usb_rows_clear(&pump->rows, row);
    }
}

/* Detaches links that are still closing from this slot. */
static void clear_seat(struct usb_pump *pump, uint32_t seat)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (pump->link[i].seat == &pump->seat[seat]) {
            usb_link_leave(&pump->link[i]);
        }
    }
}

static void seat_it(struct usb_pump *pump, struct usb_entry *entry, libusb_device_handle *handle,
                    uint32_t seat, uint32_t link)
{
    forget_former(pump, entry, seat);
    clear_seat(pump, seat);
    pump->place[seat] = (struct usb_place){
        .was_taken = 1, .is_taken = 1, .identity = entry->device.face.identity
    };
    entry->seat = seat;
    entry->link = link;
    usb_seat_sit(&pump->seat[seat], &entry->device.face);
    usb_link_begin(&pump->link[link], handle, &entry->device.pipe, &pump->seat[seat]);
    usb_pump_show(pump, entry, CONTROLLER_PLAYS);
}

/* ---- Examining and opening ------------------------------------------------------------------ */

/* Returns 1 if the controller had a slot and is only lost. */
static int was_here(const struct usb_pump *pump, const struct usb_entry *entry)
{
    return entry->row < CONTROLLER_MAX && pump->rows.row[entry->row].state == CONTROLLER_LOST;
}

static uint64_t retry_ns(const struct usb_entry *entry)
{
    const uint32_t doublings = entry->failures > 0u ? entry->failures - 1u : 0u;
    const uint64_t wait_ns = RETRY_NS << doublings;
    return wait_ns < RETRY_NS_MAX ? wait_ns : RETRY_NS_MAX;
}

static void say_trouble(struct usb_pump *pump, struct usb_entry *entry)
{
    usb_pump_tell_trouble(pump, entry);
    const int is_denied = entry->trouble == USB_DENIED || entry->trouble == USB_HELD;
    usb_pump_show(pump, entry,
                  (uint8_t)(is_denied                 ? CONTROLLER_DENIED
                            : was_here(pump, entry) ? CONTROLLER_LOST
                                                      : CONTROLLER_FREE));
    entry->due_ns = usb_pump_now_ns(pump) + retry_ns(entry);
}

static void open_it(struct usb_pump *pump, struct usb_entry *entry)
{
    const struct usb_judge judge = judge_of(pump);
    const uint32_t seat = find_seat(pump, &entry->device.face.identity);
    const uint32_t link = find_link(pump);
    libusb_device_handle *handle;
    if (seat >= POI_MAX || link == USB_NOBODY) {
        usb_pump_show(pump, entry, CONTROLLER_FREE);
        entry->due_ns = usb_pump_now_ns(pump) + RETRY_NS;
        return;
    }
    entry->trouble = (uint8_t)usb_device_open(&entry->device, &judge, &handle);
    entry->failures = (uint8_t)(entry->trouble != USB_BROKEN      ? 0u
                                : entry->failures < FAILURES_MAX ? entry->failures + 1u
                                                                 : FAILURES_MAX);
    if (handle) {
        entry->told_trouble = USB_FINE;
        seat_it(pump, entry, handle, seat, link);
    } else if (entry->trouble != USB_FINE) {
        say_trouble(pump, entry);
    } else {
        entry->due_ns = usb_pump_now_ns(pump); /* The descriptor changed the verdict. */
    }
}

/* Returns when to examine a device again. /sys shows no descriptor until a driver binds the
 * device, and after SETTLE_NS none will bind. */
static uint64_t next_look_ns(const struct usb_pump *pump, const struct usb_entry *entry)
{
    const uint64_t now_ns = usb_pump_now_ns(pump);
    return entry->device.kind == USB_KIND_UNKNOWN && now_ns - entry->met_ns < SETTLE_NS
               ? now_ns + SOON_NS
               : UINT64_MAX;
}

static void look_at(struct usb_pump *pump, struct usb_entry *entry)
{
    const struct usb_judge judge = judge_of(pump);
    usb_device_look(&entry->device, &judge);
    entry->due_ns = next_look_ns(pump, entry);
    if (entry->device.verdict <= USB_FREE) {
        entry->trouble = entry->told_trouble = USB_FINE;
    }
    switch (entry->device.verdict) {
    case USB_BARRED:
        usb_pump_show(pump, entry, CONTROLLER_BARRED);
        break;
    case USB_FREE:
        usb_pump_show(pump, entry, CONTROLLER_FREE);
        break;
    default:
        open_it(pump, entry);
    }
}

/* Returns 1 while the old handle is open, since its interface cannot be claimed again until
 * then. */
static int is_draining(const struct usb_pump *pump, const struct usb_entry *entry)
{
    return entry->drains != USB_NOBODY && pump->link[entry->drains].state == USB_LINK_DRAINING;
}

/* Detaches the device of a failed link, and closes the link at once if all transfers have
 * returned. */
static void unseat_link(struct usb_pump *pump, uint32_t link)
{
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        struct usb_entry *entry = &pump->entry[i];
        if (entry->device.device && entry->link == link) {
            usb_pump_unseat(pump, entry, pump->link[link].is_gone);
        }
    }
    usb_link_tend(&pump->link[link]);
}

void usb_pump_tend(struct usb_pump *pump)
{
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        struct usb_entry *entry = &pump->entry[i];
        if (!entry->device.device) {
            continue;
        }
        if (entry->link != USB_NOBODY) {
            usb_link_send(&pump->link[entry->link]);
        } else if (!is_draining(pump, entry) && usb_pump_now_ns(pump) >= entry->due_ns) {
            look_at(pump, entry);
        }
    }
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (usb_link_tend(&pump->link[i])) {
            unseat_link(pump, i);
        }
    }
}

uint64_t usb_pump_due_ns(const struct usb_pump *pump)
{
    uint64_t due_ns = pump->compare_ns;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        const struct usb_entry *entry = &pump->entry[i];
        if (entry->device.device && entry->link == USB_NOBODY && !is_draining(pump, entry) &&
            entry->due_ns < due_ns) {
            due_ns = entry->due_ns;
        }
    }
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        const uint64_t link_ns = usb_link_due_ns(&pump->link[i]);
        due_ns = link_ns < due_ns ? link_ns : due_ns;
    }
    return due_ns;
}
