/* usb_sim.c -- the simulated USB bus, and the functions with which a test plugs in and unplugs
 * devices. */
#include "tests/unit/support/usb/usb_sim.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <libusb.h>

#include "tests/unit/support/usb/usb_sim_internal.h"

struct usb_sim_bus bus = { .lock = PTHREAD_MUTEX_INITIALIZER };

uint64_t bus_now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000ull + (uint64_t)now.tv_nsec;
}

void bus_breach(const char *what)
{
    fprintf(stderr, "usb_sim: %s\n", what);
    bus.breaches++;
}

void bus_lock(void)
{
    pthread_mutex_lock(&bus.lock);
}

void bus_unlock(void)
{
    pthread_mutex_unlock(&bus.lock);
}

/* Counts a libusb call. If a thread other than the drivers' thread made the call, it is a breach.
 * The caller holds the lock of the bus. */
void bus_note_call(const char *name)
{
    bus.calls++;
    if (bus.has_thread && !pthread_equal(bus.thread, pthread_self())) {
        bus_breach(name);
    }
}

/* Counts a libusb call that communicates with a device and therefore blocks. If a callback made the
 * call, it is a breach. The caller holds the lock of the bus. */
void bus_note_talk(const char *name)
{
    bus_note_call(name);
    if (bus.in_transfer_callback || bus.in_hotplug_callback) {
        bus_breach("a device is talked to from within a callback");
    }
}

void bus_ring(int fd)
{
    const uint64_t one = 1;
    if (fd >= 0 && write(fd, &one, sizeof one) < 0) {
        bus_breach("an eventfd is full");
    }
}

static void wake_handles(const struct libusb_device *device)
{
    int rung = 0;
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        if (bus.handles[i] && bus.handles[i]->device == device) {
            bus_ring(bus.handles[i]->fd);
            rung = 1;
        }
    }
    if (!rung) {
        bus_ring(bus.context.fd);
    }
}

/* ---- Device files in /sys -------------------------------------------------------------------- */

static void write_file(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "w");
    if (file) {
        fwrite(bytes, 1, size, file);
        fclose(file);
    }
}

static void hid_path(const struct libusb_device *device, uint32_t interface, char *out, size_t size)
{
    snprintf(out, size, "%s/bus/usb/devices/%u-%u:1.%u/0003:%04X:%04X.%04X", bus.sysfs, BUS,
             device->port, interface, device->kind->vendor, device->kind->product,
             (device->index & 0xfffu) * 4u + interface);
}

void bus_show_driver(const struct libusb_device *device, uint32_t interface)
{
    char path[512], file[600];
    const struct usb_sim_interface *it = &device->kind->interface[interface];
    if (!bus.sysfs[0] || !device->kind->is_bound || it->class != LIBUSB_CLASS_HID) {
        return;
    }
    hid_path(device, interface, path, sizeof path);
    mkdir(path, 0755);
    snprintf(file, sizeof file, "%s/report_descriptor", path);
    if (it->mended) {
        write_file(file, it->mended, it->mended_size);
    } else {
        write_file(file, it->descriptor, it->descriptor_size);
    }
}

void bus_hide_driver(const struct libusb_device *device, uint32_t interface)
{
    char path[512], file[600];
    hid_path(device, interface, path, sizeof path);
    snprintf(file, sizeof file, "%s/report_descriptor", path);
    unlink(file);
    rmdir(path);
}

static void show_device(const struct libusb_device *device)
{
    char path[512], file[600];
    const struct usb_sim_kind *kind = device->kind;
    if (!bus.sysfs[0]) {
        return;
    }
    snprintf(path, sizeof path, "%s/bus/usb/devices/%u-%u", bus.sysfs, BUS, device->port);
    mkdir(path, 0755);
    snprintf(file, sizeof file, "%s/product", path);
    if (kind->name) {
        write_file(file, kind->name, strlen(kind->name));
    }
    snprintf(file, sizeof file, "%s/serial", path);
    if (kind->serial) {
        write_file(file, kind->serial, strlen(kind->serial));
    }
    for (uint32_t i = 0; i < kind->interface_count; i++) {
        snprintf(path, sizeof path, "%s/bus/usb/devices/%u-%u:1.%u", bus.sysfs, BUS, device->port,
                 i);
        mkdir(path, 0755);
        bus_show_driver(device, i);
    }
}

static void hide_device(const struct libusb_device *device)
{
    char path[512], file[600];
    if (!bus.sysfs[0]) {
        return;
    }
    for (uint32_t i = 0; i < device->kind->interface_count; i++) {
        bus_hide_driver(device, i);
        snprintf(path, sizeof path, "%s/bus/usb/devices/%u-%u:1.%u", bus.sysfs, BUS, device->port,
                 i);
        rmdir(path);
    }
    snprintf(path, sizeof path, "%s/bus/usb/devices/%u-%u", bus.sysfs, BUS, device->port);
    snprintf(file, sizeof file, "%s/product", path);
    unlink(file);
    snprintf(file, sizeof file, "%s/serial", path);
    unlink(file);
    rmdir(path);
}

/* ---- Transfers of the simulated devices ------------------------------------------------------ */

/* Completes a transfer immediately or after `delay_ms`. The caller holds the lock of the bus. */
void bus_finish(struct libusb_transfer *transfer, int status, int actual, uint32_t delay_ms)
{
    transfer->status = (enum libusb_transfer_status)status;
    transfer->actual_length = actual;
    if (bus.done_count == DONE_MAX) {
        bus_breach("nobody handles events");
        return;
    }
    bus.done[bus.done_count++] =
        (struct done){ .transfer = transfer, .at_ns = bus_now_ns() + delay_ms * 1000000ull };
    wake_handles(transfer->dev_handle->device);
}

static struct libusb_transfer *take_pending(struct libusb_device *device, uint32_t index)
{
    struct libusb_transfer *transfer = device->pending[index];
    device->pending_count--;
    memmove(&device->pending[index], &device->pending[index + 1u],
            (device->pending_count - index) * sizeof device->pending[0]);
    return transfer;
}

int bus_take_pending(struct libusb_device *device, const struct libusb_transfer *transfer)
{
    for (uint32_t i = 0; i < device->pending_count; i++) {
        if (device->pending[i] == transfer) {
            take_pending(device, i);
            return 1;
        }
    }
    return 0;
}

static int oldest_in(const struct libusb_device *device)
{
    for (uint32_t i = 0; i < device->pending_count; i++) {
        if (device->pending[i]->endpoint == IN_ENDPOINT) {
            return (int)i;
        }
    }
    return -1;
}

/* Assigns the queued reports of a device to its pending transfers. The caller holds the lock of the
 * bus. */
void bus_run_wire(struct libusb_device *device)
{
    int index;
    while (device->attached && (index = oldest_in(device)) >= 0 &&
           (device->fail || device->wire_count > 0)) {
        struct libusb_transfer *transfer = take_pending(device, (uint32_t)index);
        if (device->fail) {
            bus_finish(transfer, device->fail, 0, 0);
            device->fail = 0;
            continue;
        }
        const struct wire_report *report = &device->wire[device->wire_first];
        device->wire_first = (device->wire_first + 1u) % USB_SIM_WIRE_MAX;
        device->wire_count--;
        if (report->size > (uint32_t)transfer->length) {
            bus_finish(transfer, LIBUSB_TRANSFER_OVERFLOW, 0, 0);
            continue;
        }
        memcpy(transfer->buffer, report->bytes, report->size);
        bus_finish(transfer, LIBUSB_TRANSFER_COMPLETED, (int)report->size, 0);
    }
}

void bus_run_outs(struct libusb_device *device)
{
    uint32_t i = 0;
    while (device->attached && i < device->pending_count) {
        struct libusb_transfer *transfer = device->pending[i];
        if (transfer->endpoint == IN_ENDPOINT ||
            (bus.faults.hold_outs && !bus.faults.lets_outs_time_out)) {
            i++;
            continue;
        }
        take_pending(device, i);
        if (bus.faults.lets_outs_time_out) {
            bus_finish(transfer, LIBUSB_TRANSFER_TIMED_OUT, 0, transfer->timeout);
            continue;
        }
        struct usb_sim_seen *seen = &device->seen;
        const int is_control = transfer->type == LIBUSB_TRANSFER_TYPE_CONTROL;
        *(is_control ? &seen->set_reports : &seen->outs) += 1u;
        if (is_control) {
            seen->set_report_value = (uint16_t)(transfer->buffer[2] | transfer->buffer[3] << 8);
        }
        const int head = is_control ? LIBUSB_CONTROL_SETUP_SIZE : 0;
        seen->out_size = (uint32_t)(transfer->length - head);
        memcpy(seen->out, transfer->buffer + head,
               seen->out_size < sizeof seen->out ? seen->out_size : sizeof seen->out);
        bus_finish(transfer, LIBUSB_TRANSFER_COMPLETED, transfer->length - head, 0);
    }
}

static void send_hotplug(struct libusb_device *device, libusb_hotplug_event event)
{
    if (bus.done_count == DONE_MAX) {
        bus_breach("nobody handles events");
        return;
    }
    bus.done[bus.done_count++] = (struct done){ .device = device, .event = event };
    bus_ring(bus.context.fd);
}

/* ---- Functions for tests -------------------------------------------------------------------- */

void usb_sim_begin(const char *sysfs)
{
    char path[512];
    bus_lock();
    for (uint32_t i = 0; i < bus.device_count; i++) {
        free(bus.devices[i]->wire);
        free(bus.devices[i]);
    }
    bus.device_count = bus.done_count = 0;
    bus.lists = bus.transfers = bus.breaches = bus.calls = 0;
    bus.faults = (struct usb_sim_faults){ 0 };
    bus.is_running = 0;
    memset(bus.handles, 0, sizeof bus.handles);
    bus.has_thread = 0;
    snprintf(bus.sysfs, sizeof bus.sysfs, "%s", sysfs ? sysfs : "");
    static const char *const folders[] = { "", "/bus", "/bus/usb", "/bus/usb/devices" };
    for (uint32_t i = 0; sysfs && i < 4u; i++) {
        snprintf(path, sizeof path, "%s%s", sysfs, folders[i]);
        mkdir(path, 0755);
    }
    bus_unlock();
}

uint32_t usb_sim_end(void)
{
    bus_lock();
    uint32_t left = bus.lists + bus.transfers + bus.is_running;
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        left += bus.handles[i] != NULL;
    }
    for (uint32_t i = 0; i < bus.device_count; i++) {
        /* Subtracts the reference that the bus itself holds to each device. */
        left += bus.devices[i]->references - 1u;
        if (bus.devices[i]->attached) {
            hide_device(bus.devices[i]);
        }
    }
    bus_unlock();
    return left;
}

uint32_t usb_sim_plug(const struct usb_sim_kind *kind, uint8_t port)
{
    struct libusb_device *device = calloc(1, sizeof *device);
    device->wire = calloc(USB_SIM_WIRE_MAX, sizeof device->wire[0]);
    bus_lock();
    if (bus.device_count == USB_SIM_DEVICE_MAX) {
        bus_breach("the test plugs in too many");
        abort();
    }
    device->index = bus.device_count;
    device->kind = kind;
    device->port = port;
    device->attached = 1;
    device->references = 1;
    bus.devices[bus.device_count++] = device;
    show_device(device);
    send_hotplug(device, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED);
    bus_unlock();
    return device->index;
}

void usb_sim_unplug(uint32_t index, enum usb_sim_unplug_order how)
{
    bus_lock();
    struct libusb_device *device = bus.devices[index];
    int status = how == USB_SIM_IO_FIRST ? LIBUSB_TRANSFER_ERROR : LIBUSB_TRANSFER_NO_DEVICE;
    device->attached = 0;
    hide_device(device);
    while (how != USB_SIM_QUIET && device->pending_count > 0) {
        bus_finish(take_pending(device, 0), status, 0, 0);
        status = LIBUSB_TRANSFER_NO_DEVICE;
    }
    if (how != USB_SIM_LATE) {
        send_hotplug(device, LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT);
    }
    bus_unlock();
}

void usb_sim_announce(uint32_t index)
{
    bus_lock();
    send_hotplug(bus.devices[index], LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT);
    bus_unlock();
}

void usb_sim_report(uint32_t index, const uint8_t *bytes, uint32_t size)
{
    bus_lock();
    struct libusb_device *device = bus.devices[index];
    if (device->wire_count == USB_SIM_WIRE_MAX) {
        bus_breach("the test reports too fast");
    } else {
        struct wire_report *report =
            &device->wire[(device->wire_first + device->wire_count) % USB_SIM_WIRE_MAX];
        report->size = size;
        memcpy(report->bytes, bytes, size);
        device->wire_count++;
        bus_run_wire(device);
    }
    bus_unlock();
}

void usb_sim_fail(uint32_t index, int status)
{
    bus_lock();
    bus.devices[index]->fail = status;
    bus_run_wire(bus.devices[index]);
    bus_unlock();
}

uint32_t usb_sim_waiting(uint32_t index)
{
    bus_lock();
    const uint32_t count = bus.devices[index]->wire_count;
    bus_unlock();
    return count;
}

struct usb_sim_seen usb_sim_seen(uint32_t index)
{
    bus_lock();
    const struct usb_sim_seen seen = bus.devices[index]->seen;
    bus_unlock();
    return seen;
}

void usb_sim_set_faults(const struct usb_sim_faults *faults)
{
    bus_lock();
    bus.faults = *faults;
    for (uint32_t i = 0; i < bus.device_count; i++) {
        bus_run_outs(bus.devices[i]);
    }
    bus_unlock();
}

uint32_t usb_sim_breaches(void)
{
    bus_lock();
    const uint32_t count = bus.breaches;
    bus_unlock();
    return count;
}

uint32_t usb_sim_calls(void)
{
    bus_lock();
    const uint32_t count = bus.calls;
    bus_unlock();
    return count;
}
