/* thermal.h -- how far the machine is from the heat at which it slows itself down.
 *
 * A thread of its own asks the kernel every few seconds: some of its sensors take milliseconds to
 * answer, which no frame waits for. */
#ifndef KINGYO_PLATFORM_THERMAL_H
#define KINGYO_PLATFORM_THERMAL_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#define THERMAL_LOOK_S 5u
#define THERMAL_LIMIT_MDEG 80000    /* Where no zone says it: boards slow down from there on. */
#define THERMAL_UNKNOWN_MDEG 999000 /* Nobody measures: as cool as can be. */

/* The margin of the hottest zone under `root`, a folder like /sys/class/thermal. */
int32_t thermal_read(const char *root);

/* The caller owns it and leaves it zero. It stays at its address while it runs. */
struct thermal {
    const char *root;   /* Null: /sys/class/thermal. */
    pthread_t thread;
    bool runs;
    pthread_mutex_t lock;
    pthread_cond_t bell;
    bool ends;          /* Under the lock. */
    atomic_int margin_mdeg;
    atomic_uint looks;  /* So many were made. */
};

/* Begins to look. Where no thread is to be had nothing is known. */
void thermal_start(struct thermal *thermal);
void thermal_stop(struct thermal *thermal);

#endif
