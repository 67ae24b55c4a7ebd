/* usb_event_thread.h -- the state of the USB event thread, which waits for transfers and hot-plug
 * events.
 *
 * A hot-plug callback only records that the bus changed. The thread then compares libusb's device
 * list with its own table (usb_event_thread_bus.c). The thread opens controllers that may play and
 * closes those that are missing (usb_event_thread_slots.c). A link is the set of transfers of one
 * open controller (usb_transfers.h). Only the usb_event_thread*.c files use this header. All other
 * code uses usb_transport.h. */
#pragma once

#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include <libusb.h>

#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_device.h"
#include "drivers/usb/usb_device_list.h"
#include "drivers/usb/usb_transfers.h"

/* Largest number of HID devices in the table. If the table is full, a new device replaces a device
 * that may not be claimed. */
#define USB_DEVICE_MAX 16u
/* Largest number of links: four open controllers, and four that are being closed. */
#define USB_LINK_MAX (2u * POI_MAX)
/* Largest number of file descriptors: two of libusb, one for each link, and `wake_fd`. */
#define USB_FD_MAX 16u
#define USB_INDEX_NONE UINT32_MAX
/* Size of a path buffer, which is large enough for a data folder and a file name. */
#define USB_PATH_SIZE 1100u

/* Entry of the device table: a device on the bus and its state. */
struct usb_device_entry {
    /* The USB device of the entry. A null `device.device` means that the entry is empty. */
    struct usb_device device;
    uint8_t trouble; /* Current fault of the device (enum usb_device_fault). */
    /* Fault that was last passed to the callback `report` (enum usb_device_fault). */
    uint8_t reported_trouble;
    /* Number of consecutive attempts to open the device to which the device did not respond. Each
     * such attempt blocked the event thread. */
    uint8_t failures;
    /* True if the device was found on the bus by the comparison that is in progress. */
    bool is_seen;
    /* Indexes of the device's row, link and slot. USB_INDEX_NONE means none. For `row`,
     * CONTROLLER_MAX means none too. */
    uint32_t row, link, slot;
    /* Index of the link that the device used before `link` and that may still be closing, or
     * USB_INDEX_NONE. */
    uint32_t drains;
    uint64_t met_ns; /* Time at which the device was added to the table. */
    uint64_t due_ns; /* Time at which the device is examined next. */
};

struct usb_event_thread {
    struct hal_clock clock;
    /* Path of the file of rules. "" means that the rules are not stored. */
    char choices_path[USB_PATH_SIZE];
    bool is_unread; /* True if the file of rules exists but could not be read. */
    /* Callback for error messages, which receives one line for each error. The callback may be
     * null. */
    void (*report)(void *self, const char *line);
    void *report_self;

    /* The event thread and the frame loop share the fields from `port` to `wake_fd`. */
    struct hid_port port[POI_MAX]; /* Port of each slot. */
    struct usb_device_list device_list;
    atomic_int stop;
    int wake_fd;

    bool is_running; /* True while the thread exists. Only the frame loop uses this field. */
    /* Only the event thread uses the fields from `thread` on. */
    pthread_t thread;
    libusb_context *context;
    libusb_hotplug_callback_handle hotplug;
    bool has_hotplug;
    bool bus_changed, fds_changed, rows_changed;
    /* Time of the next comparison of the bus with the device table. A hot-plug event causes an
     * earlier comparison. */
    uint64_t compare_ns;
    /* Time until which the comparisons with the bus are repeated at short intervals. */
    uint64_t settled_ns;
    uint32_t fd_count;
    struct pollfd fd[USB_FD_MAX];
    struct usb_device_entry entry[USB_DEVICE_MAX];
    struct usb_transfers link[USB_LINK_MAX];
    struct usb_place place[POI_MAX];
    uint64_t lost_ns[POI_MAX]; /* Time at which each slot became vacant. */
    struct usb_device_table rows;
    /* Rules of the operator, and the data for evaluating a device. */
    struct usb_evaluation evaluation;
};

/* Compares the bus with the device table if a comparison is due. Adds new devices to the table and
 * removes missing devices. */
void usb_event_thread_compare(struct usb_event_thread *usb_thread);

/* Examines the devices that are due, opens devices that may play, sends output reports, and closes
 * failed links. */
void usb_event_thread_service(struct usb_event_thread *usb_thread);

/* Executes the operator's commands. */
void usb_event_thread_handle_commands(struct usb_event_thread *usb_thread);

/* Sets the state of the device's row in the operator's menu, and copies the identity and the slot
 * of the device to the row. */
void usb_event_thread_update_row(struct usb_event_thread *usb_thread,
                                 struct usb_device_entry *entry, uint8_t state);

/* Detaches a device from its slot and closes its link. `is_gone` is true if the device was
 * unplugged. */
void usb_event_thread_detach(struct usb_event_thread *usb_thread, struct usb_device_entry *entry,
                             bool is_gone);

/* Returns the time at which usb_event_thread_compare() or usb_event_thread_service() must be called
 * next. */
uint64_t usb_event_thread_due_ns(const struct usb_event_thread *usb_thread);

/* Calls the callback `report` with the fault of a table entry. Each new fault is reported once. */
void usb_event_thread_report_fault(struct usb_event_thread *usb_thread,
                                   struct usb_device_entry *entry);

/* If the rows of the device list or the keys of the selected controllers changed, publishes these
 * rows and keys. */
void usb_event_thread_publish(struct usb_event_thread *usb_thread);
