/* clock.h -- provides the HAL device of the machine's monotonic clock and of its local date and
 * time. */
#pragma once

#include <time.h>

#include "platform/hal.h"

/* Range of valid years. A board without a clock battery starts in 1970 or at the date of its disk
 * image. Therefore a year before CLOCK_FIRST_YEAR means that the clock was never set.
 * CLOCK_LAST_YEAR is the last year that 16 bits can express as days since 2000-01-01. */
#define CLOCK_FIRST_YEAR 2026
#define CLOCK_LAST_YEAR 2178

/* Returns the time of `clock` in nanoseconds. Async-signal-safe. */
uint64_t clock_ns(clockid_t clock);

/* Returns the HAL device of the machine's clocks. */
struct hal_clock clock_device(void);

/* Converts a calendar date and time to the units of hal_clock_ops.civil. Writes 0 to `day` and
 * `minute` if the year is invalid. */
void clock_civil(const struct tm *date, uint16_t *day, uint16_t *minute);

/* Sleeps until the time `time_ns` of clock_device(). Returns early if a signal arrives. */
void clock_sleep_until(uint64_t time_ns);
