/* gpio_dev.c -- finds /dev/gpiochip*, calls poll(), and writes error messages. */
#include "drivers/gpio/gpio_backend.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"

static bool is_chip(DIR *folder, const char *name)
{
    static const char prefix[] = "gpiochip";
    struct stat status;
    return strncmp(name, prefix, sizeof prefix - 1u) == 0 &&
           fstatat(dirfd(folder), name, &status, AT_SYMLINK_NOFOLLOW) == 0 &&
           !S_ISLNK(status.st_mode);
}

bool gpio_dev_next(struct gpio_dev_walk *walk)
{
    if (!walk->folder) {
        char path[1024];
        const int length = snprintf(path, sizeof path, "%s/dev", walk->root ? walk->root : "");
        CORE_ASSERT(length > 0 && walk->count == 0);
        walk->folder = length < (int)sizeof path ? opendir(path) : NULL;
    }
    const struct dirent *entry;
    while (walk->folder && (entry = readdir(walk->folder)) != NULL) {
        if (is_chip(walk->folder, entry->d_name)) {
            snprintf(walk->path, sizeof walk->path, "/dev/%s", entry->d_name);
            walk->count++;
            return true;
        }
    }
    gpio_dev_end(walk);
    return false;
}

void gpio_dev_end(struct gpio_dev_walk *walk)
{
    if (walk->folder) {
        closedir(walk->folder);
        walk->folder = NULL;
    }
}

void gpio_dev_text(char out[GPIO_TEXT_SIZE], const char *text)
{
    CORE_ASSERT(out);
    snprintf(out, GPIO_TEXT_SIZE, "%s", text ? text : "");
}

struct gpio_dev_ready gpio_dev_wait(const int fds[GPIO_INPUT_COUNT], uint32_t timeout_ms)
{
    CORE_ASSERT(timeout_ms <= INT32_MAX);
    struct gpio_dev_ready ready = { 0 };
    struct pollfd polled[GPIO_INPUT_COUNT];
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        /* poll() ignores the descriptor -1. */
        polled[i] = (struct pollfd){ .fd = fds[i], .events = POLLIN };
    }
    if (poll(polled, GPIO_INPUT_COUNT, (int)timeout_ms) <= 0) {
        return ready; /* poll() timed out or was interrupted. */
    }
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        ready.readable |= polled[i].revents & POLLIN ? 1u << i : 0u;
        ready.gone |= polled[i].revents & (POLLERR | POLLHUP | POLLNVAL) ? 1u << i : 0u;
    }
    return ready;
}

bool gpio_dev_lacks_edges(int error)
{
    return error == ENODEV || error == ENXIO; /* The kernel's gpiod_to_irq() returns these errors if
                                                 a line has no interrupt. */
}

void gpio_dev_poll_begin(struct gpio_dev_poll_state *looks, enum gpio_role role, int level)
{
    CORE_ASSERT(role < GPIO_INPUT_COUNT && level <= 1);
    looks->roles |= 1u << role;
    looks->active = level == 1 ? looks->active | 1u << role : looks->active & ~(1u << role);
}

uint32_t gpio_dev_poll_ms(const struct gpio_dev_poll_state *looks, uint32_t timeout_ms)
{
    CORE_ASSERT(looks->roles >> GPIO_INPUT_COUNT == 0);
    return looks->roles && timeout_ms > GPIO_POLL_MS ? GPIO_POLL_MS : timeout_ms;
}

bool gpio_dev_poll_level(struct gpio_dev_poll_state *looks, enum gpio_role role, int level,
                         struct gpio_edge *out)
{
    struct timespec now;
    if (level < 0 || level == (int)(looks->active >> role & 1u)) {
        return false;
    }
    CORE_ASSERT(looks->roles & 1u << role);
    gpio_dev_poll_begin(looks, role, level);
    clock_gettime(CLOCK_MONOTONIC, &now);
    *out = (struct gpio_edge){
        .time_ns = (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec,
        .role = (uint8_t)role,
        .active = level == 1,
    };
    return true;
}

void gpio_dev_why_refused(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, int error,
                          const char *consumer)
{
    char line[GPIO_WIRE_TEXT_SIZE];
    CORE_ASSERT(wire->wired && wire->name[GPIO_TEXT_SIZE - 1u] == '\0');
    gpio_wire_text(wire, line);
    if (error == EBUSY) {
        snprintf(why, HAL_TEXT_SIZE, "%s is held by '%.31s': end that, or take it off the line",
                 line, consumer && consumer[0] ? consumer : "another program");
    } else if (error == EACCES || error == EPERM) {
        snprintf(why, HAL_TEXT_SIZE, "%s may not be used: put the kiosk's user into its group",
                 line);
    } else {
        snprintf(why, HAL_TEXT_SIZE, "%s: %s", line, strerror(error));
    }
}

void gpio_dev_why_missing(char why[HAL_TEXT_SIZE], const struct gpio_wire *wire, const char *denied,
                          uint32_t chip_count)
{
    CORE_ASSERT(wire->wired);
    char line[GPIO_WIRE_TEXT_SIZE];
    gpio_wire_text(wire, line);
    if (denied[0]) {
        snprintf(why, HAL_TEXT_SIZE,
                 "%s: %.20s is not ours to open: put the kiosk's user "
                 "into its group",
                 line, denied);
    } else if (chip_count == 0) {
        snprintf(why, HAL_TEXT_SIZE, "%s: there is no GPIO chip in /dev", line);
    } else {
        snprintf(why, HAL_TEXT_SIZE, "%s: no chip has that line; kingyoctl lines list shows them",
                 line);
    }
}
