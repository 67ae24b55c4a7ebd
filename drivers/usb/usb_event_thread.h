/* usb_event_thread.h -- the USB event thread, which waits for transfers and hot-plug events.
 *
 * Hot-plug callbacks only record that the bus changed. The thread then compares libusb's device
 * list with its own table (usb_event_thread_bus.c). Controllers that may play are opened and
 * missing ones are closed (usb_event_thread_slots.c). */
#ifndef KINGYO_DRIVERS_USB_USB_EVENT_THREAD_H
#define KINGYO_DRIVERS_USB_USB_EVENT_THREAD_H

#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>

#include <libusb.h>

#include "drivers/usb/device_table.h"
#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_device.h"
#include "drivers/usb/usb_device_list.h"
#include "drivers/usb/usb_slot.h"
#include "drivers/usb/usb_transfers.h"

#define USB_DEVICE_MAX 16u          /* HID devices in the table; barred ones are replaced first. */
#define USB_LINK_MAX (2u * POI_MAX) /* Four open links, and four that are being closed. */
#define USB_FD_MAX 16u              /* Two of libusb, one for each link, and our wake descriptor. */
#define USB_INDEX_NONE UINT32_MAX

/* A device on the bus and its state. */
struct usb_device_entry {
    struct usb_device device; /* The device; .device null: the entry is empty. */
    uint8_t trouble; /* enum usb_device_fault: the current value, and the one reported last. */
    uint8_t told_trouble;
    uint8_t failures; /* Consecutive failures to respond, each of which blocked the thread. */
    uint8_t is_seen;  /* 1 if the current comparison found the device. */
    /* Indexes; USB_INDEX_NONE: none. For `row`, CONTROLLER_MAX also means none. */
    uint32_t row, link, seat;
    uint32_t drains; /* Index of its previous link, which may still be closing. */
    uint64_t met_ns; /* Time at which the device was added. */
    uint64_t due_ns; /* Time at which the device is examined next. */
};

struct usb_event_thread {
    struct hal_clock clock;
    const char *sysfs;
    const char *choices_path; /* Path of the choices file; "": choices are not stored. */
    uint8_t is_unread;        /* 1 if the file exists but could not be read. */
    /* Callback for error messages, one line each; may be null. */
    void (*tell)(void *self, const char *line);
    void *tell_self;
    struct usb_choice choice;

    /* The following fields are shared by both threads. */
    struct usb_slot seat[POI_MAX];
    struct usb_device_list device_list;
    atomic_int stop;
    int wake_fd;

    /* The following fields are used only by the event thread. */
    pthread_t thread;
    libusb_context *context;
    libusb_hotplug_callback_handle hotplug;
    uint8_t has_hotplug;
    uint8_t bus_changed, fds_changed, rows_changed;
    uint64_t compare_ns; /* Time of the next comparison without a hot-plug event. */
    uint64_t settled_ns; /* Comparisons repeat quickly until this time. */
    uint32_t fd_count;
    struct pollfd fd[USB_FD_MAX];
    struct usb_device_entry entry[USB_DEVICE_MAX];
    struct usb_transfers link[USB_LINK_MAX];
    struct usb_place place[POI_MAX];
    uint64_t lost_ns[POI_MAX]; /* Time at which each slot became vacant. */
    struct device_table rows;
    struct hid_descriptor scratch;
};

/* Starts the thread. Returns 0, or -1 and one line in `why`. The caller has filled the fields
 * before the shared part, and `usb_thread` must stay valid until usb_event_thread_end() returns. */
int usb_event_thread_begin(struct usb_event_thread *usb_thread, char why[HAL_TEXT_SIZE]);

/* Stops the thread and closes all devices; waits at most two seconds for transfers. */
void usb_event_thread_end(struct usb_event_thread *usb_thread);

/* Wakes the event thread. May be called from any thread and does not block. */
void usb_event_thread_wake(void *self);

/* ---- Parts of the event thread ---- */

/* Returns the current time of the thread's clock. */
uint64_t usb_event_thread_now_ns(const struct usb_event_thread *usb_thread);

/* Compares the bus with the table when it is time to. New devices are added and missing ones
 * removed. */
void usb_event_thread_compare(struct usb_event_thread *usb_thread);

/* Examines devices that are due, opens those that may play, and closes links that failed. */
void usb_event_thread_service(struct usb_event_thread *usb_thread);

/* Executes the operator's commands. */
void usb_event_thread_handle_commands(struct usb_event_thread *usb_thread);

/* Updates the device's row in the operator's menu. */
void usb_event_thread_update_row(struct usb_event_thread *usb_thread,
                                 struct usb_device_entry *entry, uint8_t state);

/* Detaches a device from its slot. `is_gone` means that it was unplugged. */
void usb_event_thread_detach(struct usb_event_thread *usb_thread, struct usb_device_entry *entry,
                             int is_gone);

/* Returns the next time at which any of these functions is due. */
uint64_t usb_event_thread_due_ns(const struct usb_event_thread *usb_thread);

/* Reports the trouble of an entry once, through `tell`. */
void usb_event_thread_report_fault(struct usb_event_thread *usb_thread,
                                   struct usb_device_entry *entry);

/* Publishes the rows and the chosen keys if they changed. */
void usb_event_thread_publish(struct usb_event_thread *usb_thread);

#endif
