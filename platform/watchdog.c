/* watchdog.c -- sends READY=1 after the first frame. Afterwards sends WATCHDOG=1 several times
 * within each time limit of the service manager. */
#include "platform/watchdog.h"

#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "core/base/panic.h"

#define PERIOD_DEFAULT_NS 1000000000u
/* Number of notifications that are sent within each time limit of the service manager. Three of the
 * four may be lost or late. */
#define KICKS_PER_DEADLINE 4u

int watchdog_init(struct watchdog *watchdog, struct hal_clock clock, const char *notify_socket,
                  uint64_t usec)
{
    CORE_ASSERT(clock.ops);
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    const size_t length = notify_socket ? strlen(notify_socket) : 0;
    *watchdog = (struct watchdog){ .clock = clock, .socket_fd = -1 };
    if (length < 2 || length >= sizeof address.sun_path ||
        (notify_socket[0] != '/' && notify_socket[0] != '@')) {
        return HAL_ERR_ABSENT;
    }
    memcpy(address.sun_path, notify_socket, length);
    if (notify_socket[0] == '@') {
        address.sun_path[0] = '\0'; /* Abstract socket names of Linux begin with a zero byte. */
    }
    const socklen_t size = (socklen_t)(offsetof(struct sockaddr_un, sun_path) + length);
    watchdog->socket_fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (watchdog->socket_fd < 0) {
        return HAL_ERR_ABSENT;
    }
    if (connect(watchdog->socket_fd, (const struct sockaddr *)&address, size) != 0) {
        close(watchdog->socket_fd);
        watchdog->socket_fd = -1;
        return HAL_ERR_ABSENT;
    }
    watchdog->has_limit = usec > 0;
    watchdog->period_ns = usec > 0 ? usec * 1000u / KICKS_PER_DEADLINE : PERIOD_DEFAULT_NS;
    snprintf(watchdog->text, sizeof watchdog->text, "watchdog: service manager at %.100s",
             notify_socket);
    return HAL_OK;
}

/* Sends `line` to the service manager. Returns true if the service manager accepted the line.
 * Otherwise the caller retries with the next kick. */
static bool watchdog_send(const struct watchdog *watchdog, const char *line)
{
    CORE_ASSERT(line);
    const size_t size = strlen(line);
    return send(watchdog->socket_fd, line, size, MSG_NOSIGNAL) == (ssize_t)size;
}

static void watchdog_kick(void *self)
{
    struct watchdog *watchdog = self;
    const uint64_t now_ns = watchdog->clock.ops->now_ns(watchdog->clock.self);
    if (!watchdog->reported_ready) {
        watchdog->reported_ready = watchdog_send(watchdog, "READY=1");
        watchdog->send_failed = !watchdog->reported_ready;
    } else if (now_ns - watchdog->last_kick_ns < watchdog->period_ns) {
        return;
    } else {
        watchdog->send_failed = !watchdog_send(watchdog, "WATCHDOG=1");
    }
    watchdog->last_kick_ns = now_ns;
}

static uint8_t watchdog_watches(void *self)
{
    const struct watchdog *watchdog = self;
    return watchdog->send_failed ? (uint8_t)WATCH_FAIL
           : watchdog->has_limit ? (uint8_t)WATCH_OK
                                 : (uint8_t)WATCH_NO_LIMIT;
}

static const char *watchdog_describe(void *self)
{
    const struct watchdog *watchdog = self;
    return watchdog->text;
}

struct hal_watchdog watchdog_device(struct watchdog *watchdog)
{
    CORE_ASSERT(watchdog);
    static const struct hal_watchdog_ops ops = {
        .kick = watchdog_kick,
        .watches = watchdog_watches,
        .describe = watchdog_describe,
    };
    return (struct hal_watchdog){ .ops = &ops, .self = watchdog };
}
