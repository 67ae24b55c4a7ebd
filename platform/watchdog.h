/* watchdog.h -- notifies the service manager that the kiosk still draws frames.
 *
 * The kiosk implements systemd's notification protocol: it sends each notification as one datagram
 * to the socket in $NOTIFY_SOCKET. Without a service manager that uses this protocol, the board
 * uses the null watchdog. */
#pragma once

#include <stdbool.h>

#include "platform/hal.h"

struct watchdog {
    struct hal_clock clock;
    int socket_fd;
    uint64_t period_ns; /* Minimum interval in nanoseconds between two sent notifications. */
    uint64_t last_kick_ns;
    bool reported_ready; /* True if the service manager has accepted READY=1. */
    /* True if the service manager restarts the kiosk when notifications are missing. */
    bool has_limit;
    bool send_failed; /* True if the service manager did not accept the last notification. */
    char text[HAL_TEXT_SIZE];
};

/* Connects to `notify_socket` ("/path" or "@abstract"). The service manager expects a notification
 * every `usec` microseconds; 0 means no time limit. Returns 0, or HAL_ERR_ABSENT if no service
 * manager is connected. */
int watchdog_init(struct watchdog *watchdog, struct hal_clock clock, const char *notify_socket,
                  uint64_t usec);

/* Returns the HAL device that uses `watchdog`. `watchdog` must outlive the returned device. */
struct hal_watchdog watchdog_device(struct watchdog *watchdog);
