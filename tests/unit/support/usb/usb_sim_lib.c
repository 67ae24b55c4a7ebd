/* usb_sim_lib.c -- simulated libusb functions for initialization, events and device lists. Only
 * those functions exist that the drivers call. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "tests/unit/support/usb/usb_sim_internal.h"

/* ---- Initialization and events --------------------------------------------------------------- */

int libusb_init(libusb_context **context)
{
    bus_lock();
    const int error = bus.faults.init_error;
    if (!error) {
        bus.context.fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
        bus.is_running = 1;
        bus.done_count = 0;
        *context = &bus.context;
    }
    bus_unlock();
    return error;
}

void libusb_exit(libusb_context *context)
{
    bus_lock();
    close(context->fd);
    context->fd = -1;
    bus.is_running = bus.has_thread = 0;
    bus_unlock();
}

const char *libusb_error_name(int error)
{
    return error == LIBUSB_ERROR_ACCESS ? "LIBUSB_ERROR_ACCESS" : "LIBUSB_ERROR_OTHER";
}

int libusb_has_capability(uint32_t capability)
{
    bus_lock();
    const int has_hotplug = !bus.faults.no_hotplug;
    bus_unlock();
    return capability == LIBUSB_CAP_HAS_HOTPLUG && has_hotplug;
}

int libusb_hotplug_register_callback(libusb_context *context, int events, int flags, int vendor,
                                     int product, int class, libusb_hotplug_callback_fn callback,
                                     void *self, libusb_hotplug_callback_handle *handle)
{
    (void)context, (void)events, (void)flags, (void)vendor, (void)product, (void)class;
    bus_lock();
    bus.hotplug = callback;
    bus.hotplug_self = self;
    *handle = 1;
    bus_unlock();
    return LIBUSB_SUCCESS;
}

void libusb_hotplug_deregister_callback(libusb_context *context,
                                        libusb_hotplug_callback_handle handle)
{
    (void)context, (void)handle;
    bus_lock();
    bus.hotplug = NULL;
    bus_unlock();
}

void libusb_set_pollfd_notifiers(libusb_context *context, libusb_pollfd_added_cb added,
                                 libusb_pollfd_removed_cb removed, void *self)
{
    (void)context;
    bus_lock();
    bus.fd_added = added;
    bus.fd_removed = removed;
    bus.fd_self = self;
    bus_unlock();
}

static struct libusb_pollfd *make_pollfd(int fd)
{
    struct libusb_pollfd *pollfd = malloc(sizeof *pollfd);
    *pollfd = (struct libusb_pollfd){ .fd = fd, .events = 1 };
    return pollfd;
}

const struct libusb_pollfd **libusb_get_pollfds(libusb_context *context)
{
    bus_lock();
    bus_note_call("libusb_get_pollfds from a strange thread");
    struct libusb_pollfd **list = calloc(HANDLE_MAX + 2u, sizeof *list);
    uint32_t count = 0;
    list[count++] = make_pollfd(context->fd);
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        if (bus.handles[i]) {
            list[count++] = make_pollfd(bus.handles[i]->fd);
        }
    }
    bus_unlock();
    return (const struct libusb_pollfd **)list;
}

void libusb_free_pollfds(const struct libusb_pollfd **list)
{
    for (uint32_t i = 0; list[i]; i++) {
        free((void *)(uintptr_t)list[i]);
    }
    free(list);
}

/* Removes the next event that is due and writes it to `out`. Returns 1, or 0 if no event is due.
 * The caller holds the lock of the bus. As with usbfs, the file descriptor stays readable as long
 * as an event is due. */
static int next_done(struct done *out)
{
    const uint64_t now = bus_now_ns();
    for (uint32_t i = 0; i < bus.done_count; i++) {
        if (bus.done[i].at_ns <= now) {
            *out = bus.done[i];
            bus.done_count--;
            memmove(&bus.done[i], &bus.done[i + 1u], (bus.done_count - i) * sizeof bus.done[0]);
            return 1;
        }
    }
    return 0;
}

static void quieten(void)
{
    uint64_t count;
    ssize_t got = read(bus.context.fd, &count, sizeof count);
    for (uint32_t i = 0; i < HANDLE_MAX; i++) {
        if (bus.handles[i]) {
            got = read(bus.handles[i]->fd, &count, sizeof count);
        }
    }
    (void)got;
}

static void call_back(const struct done *done)
{
    bus_lock();
    if (done->transfer) {
        done->transfer->dev_handle->device->seen.in_flight -=
            done->transfer->endpoint == IN_ENDPOINT;
        done->transfer->num_iso_packets = 0; /* A value of 0 marks the transfer as not submitted
                                                (see libusb_submit_transfer()). */
        bus.in_transfer_callback++;
    } else {
        bus.in_hotplug_callback++;
    }
    libusb_hotplug_callback_fn hotplug = bus.hotplug;
    void *self = bus.hotplug_self;
    bus_unlock();
    if (done->transfer) {
        done->transfer->callback(done->transfer);
    } else if (hotplug) {
        hotplug(&bus.context, done->device, done->event, self);
    }
    bus_lock();
    *(done->transfer ? &bus.in_transfer_callback : &bus.in_hotplug_callback) -= 1;
    bus_unlock();
}

void bus_call_back(void)
{
    struct done done;
    uint32_t most = bus.done_count;
    while (most-- > 0 && next_done(&done)) {
        bus_unlock();
        call_back(&done);
        bus_lock();
    }
}

int libusb_handle_events_timeout_completed(libusb_context *context, struct timeval *timeout,
                                           int *completed)
{
    (void)context, (void)timeout, (void)completed;
    bus_lock();
    bus_note_call("libusb_handle_events from a strange thread");
    quieten();
    bus_call_back();
    /* 1 if events are left, which are delayed or arrived during the callback; otherwise 0. */
    const int has_more = bus.done_count > 0;
    if (has_more) {
        bus_ring(bus.context.fd);
    }
    bus_unlock();
    usleep(has_more ? 200u : 0u);
    return LIBUSB_SUCCESS;
}

/* ---- Devices and descriptors ----------------------------------------------------------------- */

ssize_t libusb_get_device_list(libusb_context *context, libusb_device ***list)
{
    (void)context;
    bus_lock();
    if (!bus.has_thread) {
        bus.thread = pthread_self();
        bus.has_thread = 1;
    }
    bus_note_call("libusb_get_device_list from a strange thread");
    ssize_t count = 0;
    *list = calloc(bus.device_count + 1u, sizeof **list);
    for (uint32_t i = 0; i < bus.device_count; i++) {
        if (bus.devices[i]->attached) {
            bus.devices[i]->references++;
            (*list)[count++] = bus.devices[i];
        }
    }
    bus.lists++;
    bus_unlock();
    return count;
}

void libusb_free_device_list(libusb_device **list, int unref)
{
    bus_lock();
    for (uint32_t i = 0; unref && list[i]; i++) {
        list[i]->references--;
    }
    bus.lists--;
    bus_unlock();
    free(list);
}

libusb_device *libusb_ref_device(libusb_device *device)
{
    bus_lock();
    device->references++;
    bus_unlock();
    return device;
}

void libusb_unref_device(libusb_device *device)
{
    bus_lock();
    if (device->references <= 1u) {
        bus_breach("a device is given back twice");
    } else {
        device->references--;
    }
    bus_unlock();
}

uint8_t libusb_get_bus_number(libusb_device *device)
{
    (void)device;
    return BUS;
}

int libusb_get_port_numbers(libusb_device *device, uint8_t *ports, int size)
{
    if (size < 1) {
        return LIBUSB_ERROR_OVERFLOW;
    }
    ports[0] = device->port;
    return 1;
}

int libusb_get_device_descriptor(libusb_device *device, struct libusb_device_descriptor *out)
{
    *out = (struct libusb_device_descriptor){
        .idVendor = device->kind->vendor,
        .idProduct = device->kind->product,
        .bcdDevice = 0x0100,
        .iProduct = device->kind->name != NULL,
        .iSerialNumber = device->kind->serial ? 2 : 0,
        .bNumConfigurations = 1,
    };
    return LIBUSB_SUCCESS;
}

/* Configuration of a device. All its descriptors are in one block of memory. */
struct configuration {
    struct libusb_config_descriptor head;
    struct libusb_interface interface[USB_SIM_INTERFACE_MAX];
    struct libusb_interface_descriptor setting[USB_SIM_INTERFACE_MAX];
    struct libusb_endpoint_descriptor endpoint[USB_SIM_INTERFACE_MAX][2];
    uint8_t extra[USB_SIM_INTERFACE_MAX][9];
};

static void describe_interface(struct configuration *it, const struct usb_sim_interface *from,
                               uint32_t i)
{
    /* clang-format off */
    const uint8_t extra[9] = { 9, 0x21, 0x11, 0x01, 0, 1, 0x22,
                               (uint8_t)from->descriptor_size,
                               (uint8_t)(from->descriptor_size >> 8) };
    /* clang-format on */
    memcpy(it->extra[i], extra, sizeof extra);
    it->endpoint[i][0] = (struct libusb_endpoint_descriptor){ .bEndpointAddress = IN_ENDPOINT,
                                                              .bmAttributes = 3,
                                                              .wMaxPacketSize = from->packet_size };
    it->endpoint[i][1] = (struct libusb_endpoint_descriptor){ .bEndpointAddress = OUT_ENDPOINT,
                                                              .bmAttributes = 3,
                                                              .wMaxPacketSize = 64 };
    it->setting[i] = (struct libusb_interface_descriptor){
        .bInterfaceNumber = (uint8_t)i,
        .bNumEndpoints = (uint8_t)(from->packet_size == 0 ? 0 : 1 + from->has_out),
        .bInterfaceClass = from->class,
        .bInterfaceSubClass = from->subclass,
        .bInterfaceProtocol = from->protocol,
        .endpoint = it->endpoint[i],
        .extra = it->extra[i],
        .extra_length = from->class == LIBUSB_CLASS_HID ? 9 : 0,
    };
    it->interface[i] =
        (struct libusb_interface){ .altsetting = &it->setting[i], .num_altsetting = 1 };
}

int libusb_get_active_config_descriptor(libusb_device *device,
                                        struct libusb_config_descriptor **out)
{
    bus_lock();
    const int is_unconfigured = bus.faults.is_unconfigured;
    bus_unlock();
    if (is_unconfigured) {
        return LIBUSB_ERROR_NOT_FOUND;
    }
    struct configuration *it = calloc(1, sizeof *it);
    it->head.bConfigurationValue = 1;
    it->head.bNumInterfaces = (uint8_t)device->kind->interface_count;
    it->head.interface = it->interface;
    for (uint32_t i = 0; i < device->kind->interface_count; i++) {
        describe_interface(it, &device->kind->interface[i], i);
    }
    *out = &it->head;
    return LIBUSB_SUCCESS;
}

void libusb_free_config_descriptor(struct libusb_config_descriptor *config)
{
    free(config);
}
