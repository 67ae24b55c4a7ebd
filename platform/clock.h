/* clock.h -- the machine's monotonic clock as a device. */
#ifndef KINGYO_PLATFORM_CLOCK_H
#define KINGYO_PLATFORM_CLOCK_H

#include "platform/hal.h"

struct hal_clock clock_device(void);

/* Sleeps until `time_ns` of clock_device(); returns early when a signal arrives. */
void clock_sleep_until(uint64_t time_ns);

#endif
