/* watchdog.h -- notifies the service manager that frames are still drawn.
 *
 * Implements systemd's notification protocol: one datagram to the socket in $NOTIFY_SOCKET. Without
 * such a manager, the board uses the null watchdog. */
#ifndef KINGYO_PLATFORM_WATCHDOG_H
#define KINGYO_PLATFORM_WATCHDOG_H

#include "platform/hal.h"

struct watchdog {
    struct hal_clock clock;
    int socket_fd;
    uint64_t period_ns; /* Interval between two notifications that are actually sent. */
    uint64_t last_kick_ns;
    uint8_t told_ready;
    uint8_t has_limit; /* 1: the manager restarts a process that is silent for too long. */
    uint8_t is_deaf;   /* 1: the manager did not accept the last notification. */
    char text[HAL_TEXT_SIZE];
};

/* Connects to `notify_socket` ("/path" or "@abstract"), which expects a notification each `usec`
 * microseconds (0: no limit). Returns 0, or HAL_ERR_ABSENT if there is no manager. */
int watchdog_init(struct watchdog *watchdog, struct hal_clock clock, const char *notify_socket,
                  uint64_t usec);

/* Returns the device of `watchdog`, which must outlive the device. */
struct hal_watchdog watchdog_device(struct watchdog *watchdog);

#endif
