/* thermal.h -- measures the temperature margin: how far the temperature is below the limit at which
 * the machine slows down.
 *
 * A separate thread reads the kernel's sensors every THERMAL_PERIOD_S seconds, because some sensors
 * take milliseconds and the frame loop must not block. */
#pragma once

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#define THERMAL_PERIOD_S 5u
#define THERMAL_ROOT "/sys/class/thermal" /* Folder of the machine's thermal zones. */
/* Default temperature limit in thousandths of a degree Celsius, used for a thermal zone without its
 * own limit. Typical boards slow down above this temperature. */
#define THERMAL_LIMIT_MDEG 80000
/* Value of the temperature margin if no sensor was found. */
#define THERMAL_UNKNOWN_MDEG 999000

/* Returns the smallest temperature margin of all thermal zones under `root`, a folder like
 * /sys/class/thermal. The margin of a zone is its limit minus its temperature, in thousandths of a
 * degree Celsius. Returns THERMAL_UNKNOWN_MDEG if there is no sensor. */
int32_t thermal_read(const char *root);

/* State of the temperature monitor. The caller owns the structure and initializes it to zero. The
 * address must not change while the thread runs. */
struct thermal {
    const char *root; /* Folder of the thermal zones. Null means THERMAL_ROOT. */
    pthread_t thread;
    bool runs;
    /* Descriptor of eventfd(2) that becomes readable when the temperature monitor's thread must
     * end. */
    int end_fd;
    atomic_int margin_mdeg;
    atomic_uint measured_count; /* Number of completed temperature measurements. */
};

/* Starts the temperature monitor's thread. If the thread cannot be created, the temperature margin
 * remains unknown. */
void thermal_start(struct thermal *thermal);

/* Stops the temperature monitor's thread and waits until the thread has ended. */
void thermal_stop(struct thermal *thermal);
