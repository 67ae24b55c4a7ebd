/* usb_pump.c -- the main loop of the event thread. */
#include "drivers/usb_pump.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#define NS_PER_MS 1000000ull
#define IDLE_MS 1000               /* Longest wait in ms of an idle thread. */
#define BUSY_MS 50                 /* Longest wait in ms while an output report is in flight. */
#define LAST_WAIT_NS 2000000000ull /* Limit for transfers to return when the kiosk ends. */

uint64_t usb_pump_now_ns(const struct usb_pump *pump)
{
    return pump->clock.ops->now_ns(pump->clock.self);
}

void usb_pump_wake(void *self)
{
    const struct usb_pump *pump = self;
    const uint64_t one = 1;
    /* The descriptor is nonblocking; if it is full, the thread is already woken. */
    const ssize_t written = write(pump->wake_fd, &one, sizeof one);
    (void)written;
}

/* ---- Waiting -------------------------------------------------------------------------------- */

static void LIBUSB_CALL on_fd_added(int fd, short events, void *self)
{
    (void)fd;
    (void)events;
    ((struct usb_pump *)self)->fds_changed = 1;
}

static void LIBUSB_CALL on_fd_removed(int fd, void *self)
{
    (void)fd;
    ((struct usb_pump *)self)->fds_changed = 1;
}

static void list_fds(struct usb_pump *pump)
{
    const struct libusb_pollfd **list = libusb_get_pollfds(pump->context);
    pump->fds_changed = 0;
    pump->fd[0] = (struct pollfd){ .fd = pump->wake_fd, .events = POLLIN };
    pump->fd_count = 1;
    for (uint32_t i = 0; list && list[i] && pump->fd_count < USB_FD_MAX; i++) {
        pump->fd[pump->fd_count++] =
            (struct pollfd){ .fd = list[i]->fd, .events = list[i]->events };
    }
    libusb_free_pollfds(list);
}

static int is_sending(const struct usb_pump *pump)
{
    int sending = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        sending |= pump->link[i].out.is_flying;
    }
    return sending;
}

static int wait_ms(const struct usb_pump *pump)
{
    const uint64_t due_ns = usb_pump_due_ns(pump), now_ns = usb_pump_now_ns(pump);
    const uint64_t left_ms = due_ns <= now_ns ? 0 : (due_ns - now_ns) / NS_PER_MS + 1u;
    const uint64_t most_ms = is_sending(pump) ? BUSY_MS : IDLE_MS;
    return (int)(left_ms < most_ms ? left_ms : most_ms);
}

/* Waits for events and lets libusb handle them. libusb's callbacks run here, and also inside
 * usb_device_open(), because libusb handles events while it waits for a request. Therefore
 * callbacks only record results and queue reports, and never change the table. */
static void wait_and_handle(struct usb_pump *pump)
{
    struct timeval at_once = { 0, 0 };
    uint64_t count;
    if (pump->fds_changed) {
        list_fds(pump);
    }
    if (poll(pump->fd, pump->fd_count, wait_ms(pump)) > 0 && (pump->fd[0].revents & POLLIN)) {
        const ssize_t got = read(pump->wake_fd, &count, sizeof count);
        (void)got;
    }
    libusb_handle_events_timeout_completed(pump->context, &at_once, NULL);
}

/* ---- Thread --------------------------------------------------------------------------------- */

/* Called by libusb, where requests to a device and closing a device are forbidden. */
static int LIBUSB_CALL on_hotplug(libusb_context *context, libusb_device *device,
                                  libusb_hotplug_event event, void *self)
{
    (void)context;
    (void)device;
    (void)event;
    ((struct usb_pump *)self)->bus_changed = 1;
    return 0;
}

/* Registers for hot-plug before the first comparison, so that no device is missed between them. */
static void watch_bus(struct usb_pump *pump)
{
    const int events = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    pump->has_hotplug =
        libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) &&
        libusb_hotplug_register_callback(pump->context, events, LIBUSB_HOTPLUG_NO_FLAGS,
                                         LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                         LIBUSB_HOTPLUG_MATCH_ANY, on_hotplug, pump,
                                         &pump->hotplug) == LIBUSB_SUCCESS;
    pump->bus_changed = 1;
}

static void one_round(struct usb_pump *pump)
{
    usb_pump_obey(pump);
    usb_pump_compare(pump);
    usb_pump_tend(pump);
    usb_pump_tell(pump);
    wait_and_handle(pump);
}

static int is_open(const struct usb_pump *pump)
{
    int open = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        open |= pump->link[i].state != USB_LINK_NONE;
    }
    return open;
}

/* Cancels all transfers, waits for them, and closes all devices. */
static void close_all(struct usb_pump *pump)
{
    pump->compare_ns = UINT64_MAX;
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        if (pump->entry[i].device.device) {
            usb_pump_unseat(pump, &pump->entry[i], 0);
            usb_device_forget(&pump->entry[i].device);
        }
    }
    const uint64_t end_ns = usb_pump_now_ns(pump) + LAST_WAIT_NS;
    for (;;) {
        for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
            usb_link_tend(&pump->link[i]);
        }
        if (!is_open(pump) || usb_pump_now_ns(pump) > end_ns) {
            return;
        }
        wait_and_handle(pump);
    }
}

/* Raises the thread's priority for accurate time stamps, if the process may (root, or
 * LimitRTPRIO= of the service). The thread needs only some microseconds for each report. */
static void hurry(void)
{
    const struct sched_param first = { .sched_priority = 1 };
    /* If permission is denied, the normal priority remains. */
    pthread_setschedparam(pthread_self(), SCHED_RR, &first);
}

static void *run(void *self)
{
    struct usb_pump *pump = self;
    pthread_setname_np(pthread_self(), "usb");
    hurry();
    libusb_set_pollfd_notifiers(pump->context, on_fd_added, on_fd_removed, pump);
    watch_bus(pump);
    while (!atomic_load(&pump->stop)) {
        one_round(pump);
    }
    if (pump->has_hotplug) {
        libusb_hotplug_deregister_callback(pump->context, pump->hotplug);
    }
    close_all(pump);
    libusb_set_pollfd_notifiers(pump->context, NULL, NULL, NULL);
    return NULL;
}

/* ---- Start and stop ------------------------------------------------------------------------- */

static int make_links(struct usb_pump *pump)
{
    int error = 0;
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        error |= usb_link_init(&pump->link[i], pump->clock);
    }
    return error;
}

static void free_links(struct usb_pump *pump)
{
    for (uint32_t i = 0; i < USB_LINK_MAX; i++) {
        usb_link_free(&pump->link[i]);
    }
}

static void init(struct usb_pump *pump)
{
    usb_rows_init(&pump->rows);
    usb_roster_init(&pump->roster, usb_pump_wake, pump);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        usb_seat_init(&pump->seat[i], usb_pump_wake, pump);
    }
    for (uint32_t i = 0; i < USB_DEVICE_MAX; i++) {
        pump->entry[i].device.device = NULL;
    }
    pump->fds_changed = pump->rows_changed = 1;
    atomic_store(&pump->stop, 0);
    /* Published before the thread starts, because other drivers read the chosen controllers
     * first. */
    usb_pump_tell(pump);
    pump->rows_changed = 1;
}

/* Signals that a fault in the thread itself raises. */
static const int panics[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

/* Starts the thread with all other signals blocked, because the main thread handles them. */
static int start_thread(struct usb_pump *pump)
{
    sigset_t all, before;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof panics / sizeof panics[0]; i++) {
        /* A blocked fault signal would end the process without a trace. */
        sigdelset(&all, panics[i]);
    }
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&pump->thread, NULL, run, pump);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error;
}

int usb_pump_begin(struct usb_pump *pump, char why[HAL_TEXT_SIZE])
{
    init(pump);
    pump->wake_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (pump->wake_fd < 0) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: %s", strerror(errno));
        return -1;
    }
    const int error = libusb_init(&pump->context);
    if (error) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: libusb says %s; is /dev/bus/usb there?",
                 libusb_error_name(error));
        close(pump->wake_fd);
        return -1;
    }
    if (make_links(pump) || start_thread(pump)) {
        snprintf(why, HAL_TEXT_SIZE, "no USB: no memory for it");
        free_links(pump);
        libusb_exit(pump->context);
        close(pump->wake_fd);
        return -1;
    }
    return 0;
}

/* Stops the thread. If a transfer never returned from the kernel, libusb and the link's memory
 * are leaked. Freeing memory under a transfer in flight would be worse. */
void usb_pump_end(struct usb_pump *pump)
{
    atomic_store(&pump->stop, 1);
    usb_pump_wake(pump);
    pthread_join(pump->thread, NULL);
    if (!is_open(pump)) {
        free_links(pump);
        libusb_exit(pump->context);
    }
    close(pump->wake_fd);
}
