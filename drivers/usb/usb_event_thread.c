/* usb_event_thread.c -- the main loop of the USB event thread, and the start and stop of the
 * transport. */
#include "drivers/usb/usb_event_thread.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "drivers/usb/usb_transport.h"
#include "platform/os/thread.h"

/* Longest wait of the event thread in ms while no output report is being sent. */
#define IDLE_MS 1000
/* Longest wait of the event thread in ms while an output report is being sent. */
#define BUSY_MS 50
/* Pause of the event thread in ms after a failed wait. With 100 iterations per second a controller
 * stays playable, and the thread leaves the processor to the frame loop. */
#define FAILED_MS 10
/* Longest time in ns to wait for cancelled transfers when the event thread ends. */
#define LAST_WAIT_NS 2000000000ull

/* Wakes the event thread. May be called from any thread and does not block. */
static void wake(void *self)
{
    const struct usb_event_thread *usb_thread = self;
    const uint64_t one = 1;
    /* A failed write needs no handling: `wake_fd` is nonblocking, and a write fails only if the
     * event counter is full, so the thread is already woken. */
    const ssize_t written = write(usb_thread->wake_fd, &one, sizeof one);
    (void)written;
}

/* ---- Waiting for events --------------------------------------------------------------------- */

static void LIBUSB_CALL on_fd_added(int fd, short events, void *self)
{
    (void)fd;
    (void)events;
    ((struct usb_event_thread *)self)->fds_changed = true;
}

static void LIBUSB_CALL on_fd_removed(int fd, void *self)
{
    (void)fd;
    ((struct usb_event_thread *)self)->fds_changed = true;
}

/* Waits for events and lets libusb handle them. libusb calls the callbacks here, and also inside
 * usb_device_open(), because libusb handles events while it waits for a request. Therefore the
 * callbacks only record results and queue reports, and never change the device table. */
static void wait_and_handle(struct usb_event_thread *usb_thread)
{
    CORE_ASSERT(usb_thread->fd_count <= USB_FD_MAX);
    struct timeval at_once = { 0, 0 };
    uint64_t count;
    if (usb_thread->fds_changed) {
        const struct libusb_pollfd **list = libusb_get_pollfds(usb_thread->context);
        usb_thread->fds_changed = false;
        usb_thread->fd[0] = (struct pollfd){ .fd = usb_thread->wake_fd, .events = POLLIN };
        usb_thread->fd_count = 1;
        for (uint32_t i = 0; list && list[i] && usb_thread->fd_count < USB_FD_MAX; i++) {
            usb_thread->fd[usb_thread->fd_count++] =
                (struct pollfd){ .fd = list[i]->fd, .events = list[i]->events };
        }
        libusb_free_pollfds(list);
    }
    bool is_sending = false;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        is_sending |= usb_thread->link[i].transfer[USB_OUT_TRANSFER].is_submitted;
    }
    const uint64_t due_ns = usb_event_thread_due_ns(usb_thread),
                   now_ns = hal_now_ns(usb_thread->clock);
    const uint64_t left_ms = due_ns <= now_ns ? 0 : (due_ns - now_ns) / NS_PER_MS + 1u;
    const uint64_t most_ms = is_sending ? BUSY_MS : IDLE_MS;
    const int ready =
        poll(usb_thread->fd, usb_thread->fd_count, (int)(left_ms < most_ms ? left_ms : most_ms));
    bool has_failed = ready < 0 && errno != EINTR;
    if (ready > 0 && (usb_thread->fd[0].revents & POLLIN)) {
        const ssize_t got = read(usb_thread->wake_fd, &count, sizeof count);
        (void)got;
    }
    const int error = libusb_handle_events_timeout_completed(usb_thread->context, &at_once, NULL);
    has_failed |= error != LIBUSB_SUCCESS && error != LIBUSB_ERROR_INTERRUPTED;
    if (has_failed) {
        poll(NULL, 0, FAILED_MS);
    }
}

/* ---- Main loop of the thread ---------------------------------------------------------------- */

/* libusb calls this function when a device arrives or leaves. In this callback, libusb forbids
 * requests to a device and closing a device. The function therefore only records that the bus
 * changed. */
static int LIBUSB_CALL on_hotplug(libusb_context *context, libusb_device *device,
                                  libusb_hotplug_event event, void *self)
{
    (void)context;
    (void)device;
    (void)event;
    ((struct usb_event_thread *)self)->bus_changed = true;
    return 0;
}

static bool has_open_link(const struct usb_event_thread *usb_thread)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        if (usb_thread->link[i].state != USB_TRANSFERS_NONE) {
            return true;
        }
    }
    return false;
}

/* Cancels all transfers, waits until all transfers have returned, and closes all devices. */
static void close_all(struct usb_event_thread *usb_thread)
{
    usb_thread->compare_ns = UINT64_MAX;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.device) {
            usb_event_thread_detach(usb_thread, &usb_thread->entry[i], false);
            usb_device_remove(&usb_thread->entry[i].device);
        }
    }
    const uint64_t end_ns = hal_now_ns(usb_thread->clock) + LAST_WAIT_NS;
    for (;;) {
        for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
            usb_transfers_service(&usb_thread->link[i]);
        }
        if (!has_open_link(usb_thread) || hal_now_ns(usb_thread->clock) > end_ns) {
            return;
        }
        wait_and_handle(usb_thread);
    }
}

static void *usb_event_thread_main(void *self)
{
    struct usb_event_thread *usb_thread = self;
    pthread_setname_np(pthread_self(), "usb");
    /* The thread gets a higher priority for accurate time stamps, if the process is permitted to
     * (root, or LimitRTPRIO= of the service). The thread needs only some microseconds for each
     * report. If the call fails, the thread keeps its normal priority. */
    const struct sched_param first = { .sched_priority = 1 };
    pthread_setschedparam(pthread_self(), SCHED_RR, &first);
    libusb_set_pollfd_notifiers(usb_thread->context, on_fd_added, on_fd_removed, usb_thread);
    /* The hot-plug callback is registered before the first comparison, so that no device that
     * arrives in between is missed. */
    const int events = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    usb_thread->has_hotplug =
        libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) &&
        libusb_hotplug_register_callback(usb_thread->context, events, LIBUSB_HOTPLUG_NO_FLAGS,
                                         LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                         LIBUSB_HOTPLUG_MATCH_ANY, on_hotplug, usb_thread,
                                         &usb_thread->hotplug) == LIBUSB_SUCCESS;
    usb_thread->bus_changed = true;
    while (!atomic_load(&usb_thread->stop)) {
        usb_event_thread_handle_commands(usb_thread);
        usb_event_thread_compare(usb_thread);
        usb_event_thread_service(usb_thread);
        usb_event_thread_publish(usb_thread);
        wait_and_handle(usb_thread);
    }
    if (usb_thread->has_hotplug) {
        libusb_hotplug_deregister_callback(usb_thread->context, usb_thread->hotplug);
    }
    close_all(usb_thread);
    libusb_set_pollfd_notifiers(usb_thread->context, NULL, NULL, NULL);
    return NULL;
}

/* ---- Start and stop ------------------------------------------------------------------------- */

static struct usb_event_thread one;

static void free_links(struct usb_event_thread *usb_thread)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        usb_transfers_free(&usb_thread->link[i]);
    }
}

/* Opens libusb and starts the thread. Returns true, or false with one line in `why`. */
static bool begin(struct usb_event_thread *usb_thread, char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(!usb_thread->is_running);
    usb_thread->wake_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (usb_thread->wake_fd < 0) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: %s", strerror(errno));
        return false;
    }
    const int error = libusb_init(&usb_thread->context);
    if (error) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: libusb reports %s; check that /dev/bus/usb exists",
                 libusb_error_name(error));
        close(usb_thread->wake_fd);
        return false;
    }
    int no_memory = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        no_memory |= usb_transfers_init(&usb_thread->link[i], usb_thread->clock);
    }
    if (no_memory || thread_start(&usb_thread->thread, usb_event_thread_main, usb_thread)) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: not enough memory");
        free_links(usb_thread);
        libusb_exit(usb_thread->context);
        close(usb_thread->wake_fd);
        return false;
    }
    return true;
}

struct usb_event_thread *usb_transport_start(const struct usb_transport_config *config,
                                             char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(config->clock.ops);
    struct usb_evaluation *evaluation = &one.evaluation;
    memset(&one, 0, sizeof one);
    why[0] = '\0';
    one.clock = config->clock;
    one.report = config->report;
    one.report_self = config->report_self;
    snprintf(one.choices_path, sizeof one.choices_path, "%s",
             config->choices ? config->choices : "");
    snprintf(evaluation->sysfs, sizeof evaluation->sysfs, "%s",
             config->sysfs ? config->sysfs : "/sys");
    one.is_unread = usb_choice_load(&evaluation->choice, one.choices_path, why) < 0;
    for (uint32_t i = 0; i < config->listed_count; i++) {
        usb_choice_request(&evaluation->choice, &config->listed[i], true, false);
    }
    usb_device_table_init(&one.rows);
    usb_device_list_init(&one.device_list, wake, &one);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hid_port_init(&one.port[i], wake, &one);
    }
    one.fds_changed = one.rows_changed = true;
    /* The rows and keys are published before the thread starts, because other drivers already read
     * the selected controllers. */
    usb_event_thread_publish(&one);
    one.rows_changed = true;
    one.is_running = begin(&one, why);
    if (!one.is_running) {
        /* USB is not available. An empty device list with the reason is published. */
        for (uint32_t i = 0; i < POI_MAX; i++) {
            one.port[i].is_unusable = true;
        }
        snprintf(one.rows.text, sizeof one.rows.text, "%s", why);
        /* The list of selected controllers is empty without USB, so that other drivers may use
         * these controllers. */
        one.rows.wanted_count = 0;
        usb_device_list_publish(&one.device_list, &one.rows);
    }
    return &one;
}

struct hid_port *usb_transport_port(struct usb_event_thread *usb_thread, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return &usb_thread->port[index];
}

struct hid_device_list usb_transport_list(struct usb_event_thread *usb_thread)
{
    return usb_device_list_device(&usb_thread->device_list);
}

uint32_t usb_transport_wanted(struct usb_event_thread *usb_thread,
                              struct usb_key out[USB_REQUEST_MAX])
{
    return usb_device_list_wanted(&usb_thread->device_list, out);
}

/* Stops the event thread and frees the memory of libusb and of the transfers. If a transfer never
 * returned from the kernel, the memory of libusb and of the transfers is not freed, because freeing
 * memory that the kernel still uses would be worse than a leak. */
void usb_transport_stop(struct usb_event_thread *usb_thread)
{
    if (!usb_thread->is_running) {
        return;
    }
    CORE_ASSERT(usb_thread->context);
    atomic_store(&usb_thread->stop, 1);
    wake(usb_thread);
    pthread_join(usb_thread->thread, NULL);
    if (!has_open_link(usb_thread)) {
        free_links(usb_thread);
        libusb_exit(usb_thread->context);
    }
    close(usb_thread->wake_fd);
    usb_thread->is_running = false;
}
