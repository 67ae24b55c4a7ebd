/* usb_event_thread.c -- the main loop of the USB event thread, and its start and stop. */
#include "drivers/usb/usb_event_thread.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "core/base/panic.h"

#define NS_PER_MS 1000000ull
/* Longest wait of the event thread in ms while no output report is being sent. */
#define IDLE_MS 1000
/* Longest wait of the event thread in ms while an output report is being sent. */
#define BUSY_MS 50
/* Longest time in ns to wait for cancelled transfers when the event thread ends. */
#define LAST_WAIT_NS 2000000000ull

void usb_event_thread_wake(void *self)
{
    const struct usb_event_thread *usb_thread = self;
    const uint64_t one = 1;
    /* The file descriptor `wake_fd` is nonblocking. If the write fails because the event counter is
     * full, the thread is already woken. */
    const ssize_t written = write(usb_thread->wake_fd, &one, sizeof one);
    (void)written;
}

/* ---- Waiting for events --------------------------------------------------------------------- */

static void LIBUSB_CALL on_fd_added(int fd, short events, void *self)
{
    (void)fd;
    (void)events;
    ((struct usb_event_thread *)self)->fds_changed = 1;
}

static void LIBUSB_CALL on_fd_removed(int fd, void *self)
{
    (void)fd;
    ((struct usb_event_thread *)self)->fds_changed = 1;
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
        usb_thread->fds_changed = 0;
        usb_thread->fd[0] = (struct pollfd){ .fd = usb_thread->wake_fd, .events = POLLIN };
        usb_thread->fd_count = 1;
        for (uint32_t i = 0; list && list[i] && usb_thread->fd_count < USB_FD_MAX; i++) {
            usb_thread->fd[usb_thread->fd_count++] =
                (struct pollfd){ .fd = list[i]->fd, .events = list[i]->events };
        }
        libusb_free_pollfds(list);
    }
    int sending = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        sending |= usb_thread->link[i].out.is_submitted;
    }
    const uint64_t due_ns = usb_event_thread_due_ns(usb_thread),
                   now_ns = hal_now_ns(usb_thread->clock);
    const uint64_t left_ms = due_ns <= now_ns ? 0 : (due_ns - now_ns) / NS_PER_MS + 1u;
    const uint64_t most_ms = sending ? BUSY_MS : IDLE_MS;
    if (poll(usb_thread->fd, usb_thread->fd_count, (int)(left_ms < most_ms ? left_ms : most_ms)) >
            0 &&
        (usb_thread->fd[0].revents & POLLIN)) {
        const ssize_t got = read(usb_thread->wake_fd, &count, sizeof count);
        (void)got;
    }
    libusb_handle_events_timeout_completed(usb_thread->context, &at_once, NULL);
}

/* ---- Main loop of the thread ---------------------------------------------------------------- */

/* Called by libusb when a device arrives or leaves. Inside this callback, requests to a device and
 * closing a device are forbidden. */
static int LIBUSB_CALL on_hotplug(libusb_context *context, libusb_device *device,
                                  libusb_hotplug_event event, void *self)
{
    (void)context;
    (void)device;
    (void)event;
    ((struct usb_event_thread *)self)->bus_changed = 1;
    return 0;
}

static int has_open_link(const struct usb_event_thread *usb_thread)
{
    int open = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        open |= usb_thread->link[i].state != USB_TRANSFERS_NONE;
    }
    return open;
}

/* Cancels all transfers, waits until they return, and closes all devices. */
static void close_all(struct usb_event_thread *usb_thread)
{
    usb_thread->compare_ns = UINT64_MAX;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (usb_thread->entry[i].device.device) {
            usb_event_thread_detach(usb_thread, &usb_thread->entry[i], 0);
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
    /* The hot-plug callback is registered before the first comparison, so that no device is missed
     * between them. */
    const int events = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    usb_thread->has_hotplug =
        libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) &&
        libusb_hotplug_register_callback(usb_thread->context, events, LIBUSB_HOTPLUG_NO_FLAGS,
                                         LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                         LIBUSB_HOTPLUG_MATCH_ANY, on_hotplug, usb_thread,
                                         &usb_thread->hotplug) == LIBUSB_SUCCESS;
    usb_thread->bus_changed = 1;
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

static void free_links(struct usb_event_thread *usb_thread)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        usb_transfers_free(&usb_thread->link[i]);
    }
}

/* Signals that the kernel sends to a thread because of an error in this thread, such as an invalid
 * memory access. */
static const int panics[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

/* Starts the event thread. The signals in `panics` are not blocked in the thread. All other signals
 * are blocked, because the main thread handles them. */
static int start_thread(struct usb_event_thread *usb_thread)
{
    sigset_t all, before;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof panics / sizeof panics[0]; i++) {
        /* A blocked fault signal would end the process without a stack trace. */
        sigdelset(&all, panics[i]);
    }
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&usb_thread->thread, NULL, usb_event_thread_main, usb_thread);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error;
}

int usb_event_thread_begin(struct usb_event_thread *usb_thread, char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(usb_thread->clock.ops);
    CORE_ASSERT(usb_thread->sysfs && usb_thread->choices_path);
    usb_device_table_init(&usb_thread->rows);
    usb_device_list_init(&usb_thread->device_list, usb_event_thread_wake, usb_thread);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        usb_slot_init(&usb_thread->seat[i], usb_event_thread_wake, usb_thread);
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        usb_thread->entry[i].device.device = NULL;
    }
    usb_thread->fds_changed = usb_thread->rows_changed = 1;
    atomic_store(&usb_thread->stop, 0);
    /* The rows and keys are published before the thread starts, because other drivers already read
     * the selected controllers. */
    usb_event_thread_publish(usb_thread);
    usb_thread->rows_changed = 1;
    usb_thread->wake_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (usb_thread->wake_fd < 0) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: %s", strerror(errno));
        return -1;
    }
    const int error = libusb_init(&usb_thread->context);
    if (error) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: libusb says %s; is /dev/bus/usb there?",
                 libusb_error_name(error));
        close(usb_thread->wake_fd);
        return -1;
    }
    int no_memory = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        no_memory |= usb_transfers_init(&usb_thread->link[i], usb_thread->clock);
    }
    if (no_memory || start_thread(usb_thread)) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: no memory for it");
        free_links(usb_thread);
        libusb_exit(usb_thread->context);
        close(usb_thread->wake_fd);
        return -1;
    }
    return 0;
}

/* Stops the event thread. If a transfer never returned from the kernel, the memory of libusb and of
 * the transfers is not freed, because freeing memory that the kernel still uses would be worse than
 * a leak. */
void usb_event_thread_end(struct usb_event_thread *usb_thread)
{
    CORE_ASSERT(usb_thread->context);
    atomic_store(&usb_thread->stop, 1);
    usb_event_thread_wake(usb_thread);
    pthread_join(usb_thread->thread, NULL);
    if (!has_open_link(usb_thread)) {
        free_links(usb_thread);
        libusb_exit(usb_thread->context);
    }
    close(usb_thread->wake_fd);
}
