/* usb_sim_internal.h -- internal declarations of the simulated USB bus, which the usb_sim*.c files
 * share. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_USB_USB_SIM_INTERNAL_H
#define KINGYO_TESTS_UNIT_SUPPORT_USB_USB_SIM_INTERNAL_H

#include <pthread.h>
#include <stdint.h>

#include <libusb.h>

#include "tests/unit/support/usb/usb_sim.h"

#define BUS 3u
#define IN_ENDPOINT 0x81u
#define OUT_ENDPOINT 0x02u
#define PENDING_MAX 16u
#define DONE_MAX 4096u
#define HANDLE_MAX 64u

struct wire_report {
    uint32_t size;
    uint8_t bytes[1024];
};

struct libusb_context {
    int fd;
};

struct libusb_device {
    uint32_t index;
    uint32_t references;
    uint8_t attached, port;
    const struct usb_sim_kind *kind;
    struct usb_sim_seen seen;
    struct wire_report *wire;
    uint32_t wire_first, wire_count;
    int fail; /* Status that the next transfer returns (enum libusb_transfer_status); 0 means
                 success. */
    struct libusb_transfer *pending[PENDING_MAX]; /* Pending transfers of the device, oldest
                                                     first. */
    uint32_t pending_count;
};

struct libusb_device_handle {
    struct libusb_device *device;
    int fd;
    uint32_t claimed; /* Claimed interfaces; bit i belongs to interface i. */
    uint8_t auto_detaches;
};

/* Event that libusb_handle_events() delivers next: a completed transfer or a hot-plug event. */
struct done {
    struct libusb_transfer *transfer;
    struct libusb_device *device;
    libusb_hotplug_event event;
    uint64_t at_ns;
};

struct usb_sim_bus {
    pthread_mutex_t lock;
    char sysfs[256];
    struct libusb_context context;
    struct libusb_device *devices[USB_SIM_DEVICE_MAX];
    uint32_t device_count;
    struct done done[DONE_MAX];
    uint32_t done_count;
    libusb_hotplug_callback_fn hotplug;
    void *hotplug_self;
    libusb_pollfd_added_cb fd_added;
    libusb_pollfd_removed_cb fd_removed;
    void *fd_self;
    struct libusb_device_handle *handles[HANDLE_MAX];
    struct usb_sim_faults faults;
    uint32_t lists, transfers, breaches, calls;
    uint8_t is_running, has_thread;
    /* Thread of the drivers. The first thread that requests the device list counts as this
     * thread. */
    pthread_t thread;
    int in_transfer_callback, in_hotplug_callback;
};

extern struct usb_sim_bus bus;

/* Takes the lock of the bus. */
void bus_lock(void);
/* Releases the lock of the bus. */
void bus_unlock(void);

/* Counts a breach and prints `what`. The caller must hold the lock of the bus, as for each function
 * below. */
void bus_breach(const char *what);
void bus_note_call(const char *name); /* Counts a call of libusb and checks its thread. */
void bus_note_talk(const char *name); /* Counts a libusb call that communicates with a device and
                                         therefore blocks. */
void bus_ring(int fd);

/* Calls all callbacks that are due. The lock of the bus is released during the callbacks, as in
 * libusb. */
void bus_call_back(void);

/* Completes a transfer immediately or after `delay_ms`. */
void bus_finish(struct libusb_transfer *transfer, int status, int actual, uint32_t delay_ms);

/* Assigns the queued reports of a device to its pending transfers. */
void bus_run_wire(struct libusb_device *device);
/* Delivers output reports to the device, unless a fault keeps them on the host. */
void bus_run_outs(struct libusb_device *device);
/* Removes `transfer` from the pending transfers. Returns 1, or 0 if the transfer is not pending. */
int bus_take_pending(struct libusb_device *device, const struct libusb_transfer *transfer);

/* Writes the report descriptor of an interface to the simulated /sys, as if a kernel driver had
 * bound the interface. */
void bus_show_driver(const struct libusb_device *device, uint32_t interface);
/* Removes the report descriptor of an interface from the simulated /sys. */
void bus_hide_driver(const struct libusb_device *device, uint32_t interface);

/* Returns the time of the monotonic clock in ns. */
uint64_t bus_now_ns(void);

#endif
