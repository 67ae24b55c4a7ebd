/* thermal.h -- measures the margin to the temperature at which the machine slows itself down.
 *
 * A separate thread reads the kernel's sensors every few seconds, because some sensors take
 * milliseconds and the frame loop must not block. */
#ifndef KINGYO_PLATFORM_THERMAL_H
#define KINGYO_PLATFORM_THERMAL_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#define THERMAL_LOOK_S 5u
/* Default limit if no zone states one; boards slow down from this temperature on. */
#define THERMAL_LIMIT_MDEG 80000
#define THERMAL_UNKNOWN_MDEG 999000 /* Margin if there is no sensor. */

/* Returns the margin of the hottest zone under `root`, a folder like /sys/class/thermal, in
 * thousandths of a degree. */
int32_t thermal_read(const char *root);

/* State of the monitor. The caller owns the structure and clears it. The address must not change
 * while the thread runs. */
struct thermal {
    const char *root; /* Null: /sys/class/thermal. */
    pthread_t thread;
    bool runs;
    pthread_mutex_t lock;
    pthread_cond_t bell;
    bool ends; /* Protected by `lock`. */
    atomic_int margin_mdeg;
    atomic_uint looks; /* Number of measurements so far. */
};

/* Starts the thread. If no thread can be created, the margin remains unknown. */
void thermal_start(struct thermal *thermal);

/* Stops the thread and waits for its end. */
void thermal_stop(struct thermal *thermal);

#endif
