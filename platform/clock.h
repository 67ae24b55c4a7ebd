/* clock.h -- the machine's clocks as a device: the monotonic one, and the wall's. */
#ifndef KINGYO_PLATFORM_CLOCK_H
#define KINGYO_PLATFORM_CLOCK_H

#include <time.h>

#include "platform/hal.h"

/* A board without a battery begins in 1970, or when its image was made: what says a year before
 * this program's was never set. Days since 2000 are 16 bits. */
#define CLOCK_FIRST_YEAR 2026
#define CLOCK_LAST_YEAR 2178

struct hal_clock clock_device(void);

/* A date of the civil calendar as hal_clock_ops.civil gives it. */
void clock_civil(const struct tm *date, uint16_t *day, uint16_t *minute);

/* Sleeps until `time_ns` of clock_device(); returns early when a signal arrives. */
void clock_sleep_until(uint64_t time_ns);

#endif
