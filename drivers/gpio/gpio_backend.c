/* gpio_backend.c -- finds and requests lines, waits for edges, and detects removed chips. */
#include "drivers/gpio/gpio_backend.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

static uint32_t bit_of(enum gpio_role role)
{
    return 1u << role;
}

/* ---- Requesting lines ----------------------------------------------------------------------- */

static void let_go(struct gpio_backend *backend, enum gpio_role role)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    if (backend->held & bit_of(role)) {
        backend->ops->release(role);
    }
    backend->held &= ~bit_of(role);
    if (gpio_role_is_input(role)) {
        backend->fds[role] = -1;
        backend->looks.roles &= ~bit_of(role);
    }
}

static bool gpio_backend_find(const struct gpio_backend *backend, const struct gpio_wire *wire,
                              enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    const struct gpio_backend_ops *ops = backend->ops;
    CORE_ASSERT(wire->wired);
    struct gpio_dev_walk walk = { 0 };
    char denied[sizeof walk.path] = "";
    while (gpio_dev_next(&walk)) {
        if (!ops->open_chip(role, walk.path)) {
            if (errno == EACCES || errno == EPERM) {
                memcpy(denied, walk.path, sizeof denied);
            }
            continue;
        }
        if (ops->find_line(role, wire)) {
            gpio_dev_end(&walk);
            return true;
        }
        ops->release(role);
    }
    gpio_dev_why_missing(why, wire, denied, walk.count);
    return false;
}

static void acquire_line(struct gpio_backend *backend, const struct gpio_wire *wire,
                         enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    const struct gpio_backend_ops *ops = backend->ops;
    bool has_edges = gpio_role_is_input(role);
    CORE_ASSERT(!(backend->held & bit_of(role)));
    if (!gpio_backend_find(backend, wire, role, why)) {
        return;
    }
    int failed = ops->request(role, wire, has_edges);
    if (failed && has_edges && gpio_dev_lacks_edges(errno)) {
        has_edges = false;
        failed = ops->request(role, wire, has_edges);
    }
    if (failed) {
        const int error = errno;
        char consumer[GPIO_TEXT_SIZE] = "";
        ops->consumer(role, consumer);
        gpio_dev_why_refused(why, wire, error, consumer);
        ops->release(role);
        return;
    }
    backend->held |= bit_of(role);
    if (has_edges) {
        backend->fds[role] = ops->edges_fd(role);
    } else if (gpio_role_is_input(role)) {
        gpio_dev_poll_begin(&backend->looks, role, ops->get(role));
    }
}

static int backend_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                        char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    struct gpio_backend *backend = self;
    struct gpio_dev_walk walk = { 0 };
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        why[role][0] = '\0';
        if (wires[role].wired && !(backend->held & bit_of(role))) {
            acquire_line(backend, &wires[role], role, why[role]);
        }
    }
    if (backend->held == 0 && !gpio_dev_next(&walk)) {
        return HAL_ERR_ABSENT;
    }
    gpio_dev_end(&walk);
    return (int)backend->held;
}

static void backend_close(void *self)
{
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        let_go(self, role);
    }
}

/* ---- Levels --------------------------------------------------------------------------------- */

/* Returns the HAL error for the errno value of a failed call. ENODEV means that the chip was
 * removed: the line is released and the result is HAL_ERR_GONE. Every other error is HAL_ERR_IO. */
static int failure(struct gpio_backend *backend, enum gpio_role role)
{
    CORE_ASSERT(backend->held & bit_of(role));
    if (errno != ENODEV) {
        return HAL_ERR_IO;
    }
    let_go(backend, role);
    return HAL_ERR_GONE;
}

static int backend_level(void *self, enum gpio_role role)
{
    struct gpio_backend *backend = self;
    if (!(backend->held & bit_of(role))) {
        return HAL_ERR_GONE;
    }
    const int level = backend->ops->get(role);
    return level < 0 ? failure(backend, role) : level;
}

static int backend_set(void *self, enum gpio_role role, int active)
{
    struct gpio_backend *backend = self;
    CORE_ASSERT(!gpio_role_is_input(role));
    if (!(backend->held & bit_of(role))) {
        return HAL_ERR_GONE;
    }
    return backend->ops->set(role, active) == 0 ? HAL_OK : failure(backend, role);
}

static int backend_debounces(void *self, enum gpio_role role)
{
    const struct gpio_backend *backend = self;
    return backend->held & bit_of(role) ? backend->ops->debounces(role) : 0;
}

/* ---- Waiting for edges ---------------------------------------------------------------------- */

/* Reads at most `max` edges of `role` into `out`. A line without edge detection is polled and gives
 * one edge if its level changed. Returns the number of edges. */
static uint32_t gpio_backend_read_edges(struct gpio_backend *backend,
                                        const struct gpio_dev_ready *ready, enum gpio_role role,
                                        struct gpio_edge *out, uint32_t max)
{
    CORE_ASSERT(gpio_role_is_input(role) && (out || max == 0));
    if (backend->looks.roles & bit_of(role) && max > 0) {
        const int level = backend_level(backend, role);
        backend->went |= level == HAL_ERR_GONE;
        return gpio_dev_poll_level(&backend->looks, role, level, out);
    }
    int taken = ready->gone & bit_of(role) ? -1 : 0;
    if (ready->readable & bit_of(role) && max > 0) {
        taken = backend->ops->read_edges(role, out, max);
        CORE_ASSERT(taken <= (int)max);
    }
    if (taken < 0) {
        let_go(backend, role);
        backend->went = 1;
    }
    return taken > 0 ? (uint32_t)taken : 0u;
}

static int backend_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    struct gpio_backend *backend = self;
    CORE_ASSERT(out && max > 0);
    const struct gpio_dev_ready ready = gpio_dev_wait(
        backend->fds, backend->went ? 0 : gpio_dev_poll_ms(&backend->looks, timeout_ms));
    uint32_t count = 0;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        CORE_ASSERT(count <= max);
        count += gpio_backend_read_edges(backend, &ready, role, out + count, max - count);
    }
    if (backend->went && count == 0) { /* The removal of a chip is reported only after all edges of
                                          the remaining chips. */
        backend->went = 0;
        return HAL_ERR_GONE;
    }
    return (int)count;
}

/* ---- The device ----------------------------------------------------------------------------- */

static int backend_list(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                        void *context)
{
    const struct gpio_backend *backend = self;
    CORE_ASSERT(tell);
    struct gpio_dev_walk walk = { 0 };
    uint32_t count = 0;
    while (gpio_dev_next(&walk)) {
        count += backend->ops->tell_chip(walk.path, tell, context);
    }
    return walk.count > 0 ? (int)count : HAL_ERR_ABSENT;
}

static const char *backend_describe(void *self)
{
    struct gpio_backend *backend = self;
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
    CORE_ASSERT(ops && ops->open_chip && ops->request && ops->release && ops->version);
    backend->ops = ops;
    backend_close(backend); /* Closes nothing yet, but sets all file descriptors to -1, because 0 is
                               a valid descriptor. */
    return (struct gpio_lines){ .ops = &lines_ops, .self = backend };
}
