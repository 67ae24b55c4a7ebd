/* usb_sim_open.c -- simulated libusb functions for open devices: handles, requests and
 * transfers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "tests/unit/support/usb/usb_sim_internal.h"

/* ---- Handles and requests -------------------------------------------------------------------- */

static void report_fd_added(int fd)
{
    if (bus.fd_added) {
        bus.fd_added(fd, 1, bus.fd_self);
    }
}

int libusb_open(libusb_device *device, libusb_device_handle **out)
{
    uint32_t slot = 0;
    bus_lock();
    bus_note_talk("libusb_open from a strange thread");
    if (!device->attached || bus.faults.open_error) {
        const int error = device->attached ? bus.faults.open_error : LIBUSB_ERROR_NO_DEVICE;
        bus_unlock();
        return error;
    }
    while (slot < HANDLE_MAX && bus.handles[slot]) {
        slot++;
    }
    struct libusb_device_handle *handle = calloc(1, sizeof *handle);
    handle->device = device;
    handle->fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    device->references++;
    device->seen.opens++;
    bus.handles[slot] = handle;
    *out = handle;
    bus_unlock();
    report_fd_added(handle->fd);
    return LIBUSB_SUCCESS;
}

void libusb_close(libusb_device_handle *handle)
{
    bus_lock();
    bus_note_talk("libusb_close from a strange thread");
    handle->device->seen.closes_begun++;
    const uint32_t close_ms = bus.faults.close_ms;
    bus_unlock();
    usleep(close_ms * 1000u);
    bus_lock();
    while (bus.faults.holds_close) {
        bus_unlock();
        usleep(1000);
        bus_lock();
    }
    struct libusb_device *device = handle->device;
    for (uint32_t i = 0; i < bus.done_count; i++) {
        if (bus.done[i].transfer && bus.done[i].transfer->dev_handle == handle) {
            bus_breach("a handle is closed while a transfer is on its way back");
        }
    }
    for (uint32_t i = 0; i < device->pending_count; i++) {
        if (device->pending[i]->dev_handle == handle) {
            bus_breach("a handle is closed under a transfer");
        }
    }
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        bus.handles[i] = bus.handles[i] == handle ? NULL : bus.handles[i];
    }
    device->references--;
    device->seen.closes++;
    const int fd = handle->fd;
    bus_unlock();
    if (bus.fd_removed) {
        bus.fd_removed(fd, bus.fd_self);
    }
    close(fd);
    free(handle);
}

int libusb_set_auto_detach_kernel_driver(libusb_device_handle *handle, int enable)
{
    handle->auto_detaches = enable != 0;
    return LIBUSB_SUCCESS;
}

int libusb_claim_interface(libusb_device_handle *handle, int interface)
{
    bus_lock();
    bus_note_talk("libusb_claim_interface from a strange thread");
    struct libusb_device *device = handle->device;
    int error = device->attached ? bus.faults.claim_error : LIBUSB_ERROR_NO_DEVICE;
    if (!error && device->kind->is_bound && !handle->auto_detaches) {
        error = LIBUSB_ERROR_BUSY;
    }
    /* An interface can have only one owner, even if both handles belong to the same process. */
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        if (bus.handles[i] && bus.handles[i] != handle && bus.handles[i]->device == device &&
            (bus.handles[i]->claimed & 1u << interface)) {
            error = LIBUSB_ERROR_BUSY;
        }
    }
    if (!error) {
        device->seen.claims++;
        device->seen.claimed_interfaces |= 1u << interface;
        handle->claimed |= 1u << interface;
        bus_hide_driver(device, (uint32_t)interface);
    }
    bus_unlock();
    return error;
}

int libusb_release_interface(libusb_device_handle *handle, int interface)
{
    bus_lock();
    bus_note_talk("libusb_release_interface from a strange thread");
    struct libusb_device *device = handle->device;
    if (!(handle->claimed & 1u << interface)) {
        bus_breach("an interface is released that was not claimed");
    }
    handle->claimed &= ~(1u << interface);
    device->seen.releases++;
    if (device->attached) {
        bus_show_driver(device, (uint32_t)interface);
    }
    const int error = device->attached ? LIBUSB_SUCCESS : LIBUSB_ERROR_NO_DEVICE;
    bus_unlock();
    return error;
}

int libusb_clear_halt(libusb_device_handle *handle, unsigned char endpoint)
{
    (void)endpoint;
    bus_lock();
    bus_note_talk("libusb_clear_halt from a strange thread");
    if (handle->device->pending_count > 0) {
        bus_breach("a halt is cleared under transfers");
    }
    handle->device->seen.clear_halts++;
    bus_unlock();
    return LIBUSB_SUCCESS;
}

static int read_report_descriptor(struct libusb_device *device, uint16_t index, void *data,
                                  uint16_t size)
{
    const struct usb_sim_interface *it = &device->kind->interface[index];
    const uint32_t most = size < it->descriptor_size ? size : it->descriptor_size;
    memcpy(data, it->descriptor, most);
    device->seen.descriptor_reads++;
    return (int)most;
}

int libusb_control_transfer(libusb_device_handle *handle, uint8_t type, uint8_t request,
                            uint16_t value, uint16_t index, unsigned char *data, uint16_t size,
                            unsigned int timeout)
{
    (void)timeout;
    bus_lock();
    bus_note_talk("libusb_control_transfer from a strange thread");
    bus_call_back();
    struct libusb_device *device = handle->device;
    int result = LIBUSB_ERROR_PIPE;
    if (!(handle->claimed & 1u << index)) {
        bus_breach("an interface is asked that was not claimed");
    }
    if (!device->attached) {
        result = LIBUSB_ERROR_NO_DEVICE;
    } else if (type == 0x81 && request == 0x06 && value == 0x2200 && !bus.faults.hides_descriptor) {
        result = read_report_descriptor(device, index, data, size);
    } else if (type == 0x21 && !bus.faults.stalls_requests) {
        device->seen.set_idles += request == 0x0a;
        device->seen.set_protocols += request == 0x0b && value == 1;
        result = 0;
    }
    bus_unlock();
    return result;
}

int libusb_get_string_descriptor_ascii(libusb_device_handle *handle, uint8_t index,
                                       unsigned char *data, int size)
{
    bus_lock();
    bus_note_talk("libusb_get_string_descriptor_ascii from a strange thread");
    bus_call_back();
    const struct usb_sim_kind *kind = handle->device->kind;
    const char *text = index == 2 ? kind->serial : kind->name;
    const int length = snprintf((char *)data, (size_t)size, "%s", text ? text : "");
    bus_unlock();
    return length < size ? length : size - 1;
}

/* ---- Transfers ------------------------------------------------------------------------------ */

struct libusb_transfer *libusb_alloc_transfer(int packets)
{
    (void)packets;
    bus_lock();
    bus.transfers++;
    bus_unlock();
    return calloc(1, sizeof(struct libusb_transfer));
}

/* Frees a transfer. Freeing a submitted transfer is a breach. `num_iso_packets` is 1 while a
 * transfer is submitted, because interrupt transfers do not use this field for anything else. */
void libusb_free_transfer(struct libusb_transfer *transfer)
{
    if (!transfer) {
        return;
    }
    bus_lock();
    bus.transfers--;
    if (transfer->num_iso_packets) {
        bus_breach("a transfer is freed in flight");
    }
    bus_unlock();
    free(transfer);
}

static void watch_flight(struct libusb_device *device)
{
    struct usb_sim_seen *seen = &device->seen;
    seen->in_flight++;
    if (seen->in_flight > seen->in_flight_max) {
        seen->in_flight_max = seen->in_flight;
    }
}

int libusb_submit_transfer(struct libusb_transfer *transfer)
{
    bus_lock();
    bus_note_call("libusb_submit_transfer from a strange thread");
    struct libusb_device *device = transfer->dev_handle->device;
    if (transfer->num_iso_packets) {
        bus_breach("a transfer is submitted twice");
    }
    if (!device->attached || device->pending_count == PENDING_MAX) {
        bus_unlock();
        return LIBUSB_ERROR_NO_DEVICE;
    }
    transfer->num_iso_packets = 1;
    device->pending[device->pending_count++] = transfer;
    if (transfer->endpoint == IN_ENDPOINT) {
        watch_flight(device);
        bus_run_wire(device);
    } else {
        bus_run_outs(device);
    }
    bus_unlock();
    return LIBUSB_SUCCESS;
}

int libusb_cancel_transfer(struct libusb_transfer *transfer)
{
    bus_lock();
    bus_note_call("libusb_cancel_transfer from a strange thread");
    struct libusb_device *device = transfer->dev_handle->device;
    const int was_pending = bus_take_pending(device, transfer);
    if (was_pending) {
        bus_finish(transfer, LIBUSB_TRANSFER_CANCELLED, 0, bus.faults.cancel_ms);
    }
    bus_unlock();
    return was_pending ? LIBUSB_SUCCESS : LIBUSB_ERROR_NOT_FOUND;
}
