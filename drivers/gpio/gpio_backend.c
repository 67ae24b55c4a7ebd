/* gpio_backend.c -- finds and requests lines, waits for edges, and detects removed chips. */
#include "drivers/gpio/gpio_backend.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"

/* Polling interval of lines without interrupts, such as lines of a port expander whose INT pin is
 * not connected. The shortest coin pulse of 20 ms is five times as long. */
#define POLL_MS 4u

/* ---- Requesting lines ----------------------------------------------------------------------- */

static void release_line(struct gpio_backend *backend, enum gpio_role role)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    const uint32_t bit = gpio_role_bit(role);
    if (backend->held & bit) {
        backend->ops->release(role);
    }
    backend->held &= ~bit;
    backend->debounced &= ~bit;
    backend->polled &= ~bit;
    if (gpio_role_is_input(role)) {
        backend->fds[role] = -1;
    }
}

/* Opens the chip that has the line. Returns true, or writes the reason to `why` and returns
 * false. */
static bool find_chip(const struct gpio_backend *backend, const struct gpio_wire *wire,
                      enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(wire->wired);
    struct gpio_dev_walk walk = { 0 };
    char denied[sizeof walk.path] = "";
    while (gpio_dev_next(&walk)) {
        const int found = backend->ops->find(role, walk.path, wire);
        if (found > 0) {
            gpio_dev_end(&walk);
            return true;
        }
        if (found < 0 && (errno == EACCES || errno == EPERM)) {
            memcpy(denied, walk.path, sizeof denied);
        }
    }
    gpio_dev_why_missing(why, wire, denied, walk.count);
    return false;
}

static void acquire_line(struct gpio_backend *backend, const struct gpio_wire *wire,
                         enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    const struct gpio_backend_ops *ops = backend->ops;
    const uint32_t bit = gpio_role_bit(role);
    const bool is_input = gpio_role_is_input(role);
    bool has_edges = is_input;
    char consumer[GPIO_TEXT_SIZE] = "";
    CORE_ASSERT(!(backend->held & bit));
    if (!find_chip(backend, wire, role, why)) {
        return;
    }
    int fd = ops->request(role, wire, has_edges, consumer);
    if (fd < 0 && has_edges && (errno == ENODEV || errno == ENXIO)) {
        /* The error means that the line has no interrupt (the kernel's gpiod_to_irq() failed). The
         * line is therefore requested without edge detection and polled. */
        has_edges = false;
        fd = ops->request(role, wire, has_edges, consumer);
    }
    if (fd < 0) {
        gpio_dev_why_refused(why, wire, errno, consumer);
        ops->release(role);
        return;
    }
    backend->held |= bit;
    if (has_edges) {
        const bool debounces =
            ops->debounces && gpio_backend_may_debounce(role) && wire->debounce_us > 0;
        backend->debounced |= debounces ? bit : 0u;
        backend->fds[role] = fd;
    } else if (is_input) {
        backend->polled |= bit;
        backend->active &= ~bit;
        backend->active |= ops->get(role) == 1 ? bit : 0u;
    }
}

static int backend_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                        char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    struct gpio_backend *backend = self;
    struct gpio_dev_walk walk = { 0 };
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        why[role][0] = '\0';
        if (wires[role].wired && !backend->ops->find) {
            snprintf(why[role], HAL_TEXT_SIZE,
                     "built without libgpiod: install libgpiod-dev and build again");
        } else if (wires[role].wired && !(backend->held & gpio_role_bit(role))) {
            acquire_line(backend, &wires[role], role, why[role]);
        }
    }
    if (!backend->ops->find || (backend->held == 0 && !gpio_dev_next(&walk))) {
        return HAL_ERR_ABSENT;
    }
    gpio_dev_end(&walk);
    return (int)backend->held;
}

static void backend_close(void *self)
{
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        release_line(self, role);
    }
}

/* ---- Levels --------------------------------------------------------------------------------- */

/* Returns the HAL error for the errno value of a failed call. ENODEV means that the chip was
 * removed: the line is released and the result is HAL_ERR_GONE. Every other error is HAL_ERR_IO. */
static int failure(struct gpio_backend *backend, enum gpio_role role)
{
    CORE_ASSERT(backend->held & gpio_role_bit(role));
    if (errno != ENODEV) {
        return HAL_ERR_IO;
    }
    release_line(backend, role);
    return HAL_ERR_GONE;
}

static int backend_level(void *self, enum gpio_role role)
{
    struct gpio_backend *backend = self;
    if (!(backend->held & gpio_role_bit(role))) {
        return HAL_ERR_GONE;
    }
    const int level = backend->ops->get(role);
    return level < 0 ? failure(backend, role) : level;
}

static int backend_set(void *self, enum gpio_role role, bool active)
{
    struct gpio_backend *backend = self;
    CORE_ASSERT(!gpio_role_is_input(role));
    if (!(backend->held & gpio_role_bit(role))) {
        return HAL_ERR_GONE;
    }
    return backend->ops->set(role, active) == 0 ? HAL_OK : failure(backend, role);
}

static bool backend_debounces(void *self, enum gpio_role role)
{
    const struct gpio_backend *backend = self;
    return (backend->debounced & gpio_role_bit(role)) != 0;
}

/* ---- Waiting for edges ---------------------------------------------------------------------- */

/* Reads the level of a line without edge detection. Returns 1 and writes an edge at the current
 * time to `out` if the level changed, otherwise 0. */
static uint32_t poll_level(struct gpio_backend *backend, enum gpio_role role, struct gpio_edge *out)
{
    struct timespec now;
    const int level = backend_level(backend, role);
    backend->went = backend->went || level == HAL_ERR_GONE;
    if (level < 0 || level == (int)(backend->active >> role & 1u)) {
        return 0;
    }
    backend->active ^= gpio_role_bit(role);
    clock_gettime(CLOCK_MONOTONIC, &now);
    *out = (struct gpio_edge){
        .time_ns = (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec,
        .role = (uint8_t)role,
        .active = level == 1,
    };
    return 1;
}

static int backend_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    struct gpio_backend *backend = self;
    struct pollfd polled[GPIO_INPUT_COUNT];
    uint32_t count = 0;
    CORE_ASSERT(out && max > 0 && timeout_ms <= INT32_MAX);
    const uint32_t longest_ms = backend->polled && timeout_ms > POLL_MS ? POLL_MS : timeout_ms;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        /* poll() ignores elements whose descriptor is -1. */
        polled[i] = (struct pollfd){ .fd = backend->fds[i], .events = POLLIN };
    }
    if (poll(polled, GPIO_INPUT_COUNT, backend->went ? 0 : (int)longest_ms) < 0) {
        /* Waits for the timeout in place of the failed poll(), so that the caller's loop does not
         * run without a pause. */
        if (errno != EINTR) {
            poll(NULL, 0, (int)longest_ms);
        }
        /* The failed poll() has not set `revents`. With all `revents` 0, no descriptor counts as
         * readable. */
        memset(polled, 0, sizeof polled);
    }
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        CORE_ASSERT(count <= max);
        const uint32_t room = max - count;
        if (backend->polled & gpio_role_bit(role) && room > 0) {
            count += poll_level(backend, role, out + count);
            continue;
        }
        int taken = polled[role].revents & (POLLERR | POLLHUP | POLLNVAL) ? -1 : 0;
        if (polled[role].revents & POLLIN && room > 0) {
            taken = backend->ops->read_edges(role, out + count, room);
            CORE_ASSERT(taken <= (int)room);
        }
        if (taken < 0) {
            release_line(backend, role);
            backend->went = true;
        }
        count += taken > 0 ? (uint32_t)taken : 0u;
    }
    if (backend->went && count == 0) { /* The removal of a chip is reported only after all edges of
                                          the remaining chips. */
        backend->went = false;
        return HAL_ERR_GONE;
    }
    return (int)count;
}

/* ---- The device ----------------------------------------------------------------------------- */

static int backend_list(void *self,
                        void (*report)(void *context, const struct gpio_line_info *line),
                        void *context)
{
    const struct gpio_backend *backend = self;
    CORE_ASSERT(report);
    struct gpio_dev_walk walk = { 0 };
    uint32_t count = 0;
    while (backend->ops->list_chip_lines && gpio_dev_next(&walk)) {
        count += backend->ops->list_chip_lines(walk.path, report, context);
    }
    return walk.count > 0 ? (int)count : HAL_ERR_ABSENT;
}

static const char *backend_describe(void *self)
{
    struct gpio_backend *backend = self;
    if (!backend->ops->version) {
        return "built without libgpiod";
    }
    snprintf(backend->text, sizeof backend->text, "libgpiod %s", backend->ops->version());
    return backend->text;
}

struct gpio_lines gpio_backend_device(struct gpio_backend *backend,
                                      const struct gpio_backend_ops *ops)
{
    static const struct gpio_lines_ops lines_ops = {
        .open = backend_open,
        .wait = backend_wait,
        .level = backend_level,
        .set = backend_set,
        .debounces = backend_debounces,
        .list = backend_list,
        .close = backend_close,
        .describe = backend_describe,
    };
    CORE_ASSERT(ops && !ops->find == !ops->version);
    backend->ops = ops;
    /* No line is held yet, so the call closes nothing and only sets all file descriptors to -1.
     * This is necessary because 0 is a valid descriptor. */
    backend_close(backend);
    return (struct gpio_lines){ .ops = &lines_ops, .self = backend };
}
