/* clock.c -- CLOCK_MONOTONIC: never set back, not even by a festival's network time. */
#include "platform/clock.h"

#include <time.h>

static uint64_t clock_now_ns(void *self)
{
    struct timespec now;
    (void)self;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

struct hal_clock clock_device(void)
{
    static const struct hal_clock_ops ops = { .now_ns = clock_now_ns };
    return (struct hal_clock){ .ops = &ops, .self = NULL };
}

void clock_sleep_until(uint64_t time_ns)
{
    const struct timespec until = {
        .tv_sec = (time_t)(time_ns / 1000000000u),
        .tv_nsec = (long)(time_ns % 1000000000u),
    };
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
}
