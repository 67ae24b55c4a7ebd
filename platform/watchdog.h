/* watchdog.h -- tells the service manager that frames still flow.
 *
 * Speaks systemd's notification protocol: one datagram to the socket named by $NOTIFY_SOCKET. Where
 * there is no such manager, the board uses the null watchdog. */
#ifndef KINGYO_PLATFORM_WATCHDOG_H
#define KINGYO_PLATFORM_WATCHDOG_H

#include "platform/hal.h"

struct watchdog {
    struct hal_clock clock;
    int socket_fd;
    uint64_t period_ns;    /* Between two kicks that are really sent. */
    uint64_t last_kick_ns;
    uint8_t told_ready;
    uint8_t has_limit;     /* The manager restarts who is silent for too long. */
    uint8_t is_deaf;       /* It did not take the last sign. */
    char text[HAL_TEXT_SIZE];
};

/* Connects to `notify_socket` ("/path" or "@abstract"), which wants a sign of life each `usec`
 * microseconds (0: it does not say). 0, or HAL_ERR_NONE when there is nobody to tell. */
int watchdog_init(struct watchdog *watchdog, struct hal_clock clock, const char *notify_socket,
                  uint64_t usec);

struct hal_watchdog watchdog_device(struct watchdog *watchdog);

#endif
