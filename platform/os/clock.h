/* clock.h -- device for the machine's monotonic clock and civil clock. */
#ifndef KINGYO_PLATFORM_OS_CLOCK_H
#define KINGYO_PLATFORM_OS_CLOCK_H

#include <time.h>

#include "platform/hal.h"

/* Range of valid years. A board without a battery starts in 1970 or at the date of its image,
 * therefore an earlier year means that the clock was never set. The upper limit follows from 16
 * bits of days since 2000. */
#define CLOCK_FIRST_YEAR 2026
#define CLOCK_LAST_YEAR 2178

/* Returns the device of the machine's clocks. */
struct hal_clock clock_device(void);

/* Converts a date of the civil calendar to the units of hal_clock_ops.civil. */
void clock_civil(const struct tm *date, uint16_t *day, uint16_t *minute);

/* Sleeps until `time_ns` of clock_device(). Returns early when a signal arrives. */
void clock_sleep_until(uint64_t time_ns);

#endif
