/* usb_pump.h -- the thread that has USB: it waits for transfers and hot-plugs.
 *
 * Hot-plug callbacks only say that the bus changed; the thread then compares the list of devices
 * with its own (usb_pump_bus.c), opens who may play (usb_pump_table.c), and closes who is gone. */
#ifndef KINGYO_DRIVERS_USB_PUMP_H
#define KINGYO_DRIVERS_USB_PUMP_H

#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>

#include <libusb.h>

#include "drivers/usb_choice.h"
#include "drivers/usb_device.h"
#include "drivers/usb_link.h"
#include "drivers/usb_roster.h"
#include "drivers/usb_rows.h"
#include "drivers/usb_seat.h"

#define USB_DEVICE_MAX 16u        /* HID devices we keep an eye on; keyboards give way to others. */
#define USB_LINK_MAX (2u * POI_MAX) /* Four that play, and four that are still being closed. */
#define USB_FD_MAX 16u            /* libusb's own two, one a link, and ours. */
#define USB_NOBODY UINT32_MAX

/* A device, and what we do with it. */
struct usb_entry {
    struct usb_device device; /* .device null: the entry is empty. */
    uint8_t trouble;          /* enum usb_trouble, and which of them was told. */
    uint8_t told_trouble;
    uint8_t failures;         /* In a row, each of which took the thread some time. */
    uint8_t is_seen;          /* By the comparison that goes on. */
    uint32_t row, link, seat; /* USB_NOBODY: none; of rows CONTROLLER_MAX, too. */
    uint32_t drains;          /* The link that it had, which may not be closed yet. */
    uint64_t met_ns;
    uint64_t due_ns;          /* When to look at it again. */
};

struct usb_pump {
    struct hal_clock clock;
    const char *sysfs;
    const char *choices_path; /* "": choices are not kept. */
    uint8_t is_unread;        /* That file is there, but what it says is not known. */
    void (*tell)(void *self, const char *line); /* May be null. */
    void *tell_self;
    struct usb_choice choice;

    /* Both threads'. */
    struct usb_seat seat[POI_MAX];
    struct usb_roster roster;
    atomic_int stop;
    int wake_fd;

    /* The thread's. */
    pthread_t thread;
    libusb_context *context;
    libusb_hotplug_callback_handle hotplug;
    uint8_t has_hotplug;
    uint8_t bus_changed, fds_changed, rows_changed;
    uint64_t compare_ns;       /* When to compare again although nothing was said ... */
    uint64_t settled_ns;       /* ... until then. */
    uint32_t fd_count;
    struct pollfd fd[USB_FD_MAX];
    struct usb_entry entry[USB_DEVICE_MAX];
    struct usb_link link[USB_LINK_MAX];
    struct usb_place place[POI_MAX];
    uint64_t lost_ns[POI_MAX]; /* When its seat became vacant. */
    struct usb_rows rows;
    struct hid_descriptor scratch;
};

/* Begins. 0, or -1 and one line in `why`. The caller has filled what stands before the threads'
 * parts; it must outlive usb_pump_end(). */
int usb_pump_begin(struct usb_pump *pump, char why[HAL_TEXT_SIZE]);
void usb_pump_end(struct usb_pump *pump);

/* From any thread: there is something to do. Does not wait. */
void usb_pump_wake(void *self);

/* ---- Parts of the thread ---- */

uint64_t usb_pump_now_ns(const struct usb_pump *pump);

/* Compares the bus with the table, if it is time to: who is new is met, who is gone forgotten. */
void usb_pump_compare(struct usb_pump *pump);

/* Looks at whoever is due, opens who may play, closes what failed. */
void usb_pump_tend(struct usb_pump *pump);

/* Takes the operator's orders. */
void usb_pump_obey(struct usb_pump *pump);

/* What the menu shows of it. */
void usb_pump_show(struct usb_pump *pump, struct usb_entry *entry, uint8_t state);

/* Whoever sits there leaves; `is_gone`: unplugged. */
void usb_pump_unseat(struct usb_pump *pump, struct usb_entry *entry, int is_gone);

/* When the next of these is due; UINT64_MAX: never. */
uint64_t usb_pump_due_ns(const struct usb_pump *pump);

/* Says once what is in an entry's way. */
void usb_pump_tell_trouble(struct usb_pump *pump, struct usb_entry *entry);

/* Posts the rows, and who was named, if they are others than before. */
void usb_pump_tell(struct usb_pump *pump);

#endif
