/* clock.c -- reads CLOCK_MONOTONIC and the local date and time; see clock.h. */
#include "platform/os/clock.h"

#include <time.h>

#include "core/base/panic.h"

/* Days from 1970-01-01 to 2000-01-01. */
#define DAYS_TO_2000 10957
#define SECONDS_PER_DAY 86400

uint64_t clock_ns(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (uint64_t)now.tv_sec * NS_PER_S + (uint64_t)now.tv_nsec;
}

static uint64_t clock_now_ns(void *self)
{
    (void)self;
    return clock_ns(CLOCK_MONOTONIC);
}

void clock_civil(const struct tm *date, uint16_t *day, uint16_t *minute)
{
    CORE_ASSERT(day && minute);
    *day = *minute = 0;
    if (date->tm_year + 1900 >= CLOCK_FIRST_YEAR && date->tm_year + 1900 <= CLOCK_LAST_YEAR) {
        /* timegm() takes the local date as a date in UTC, so that the time zone does not change the
         * number of the day. */
        struct tm utc = { .tm_year = date->tm_year,
                          .tm_mon = date->tm_mon,
                          .tm_mday = date->tm_mday };
        *day = (uint16_t)(timegm(&utc) / SECONDS_PER_DAY - DAYS_TO_2000);
        *minute = (uint16_t)(date->tm_hour * 60 + date->tm_min);
    }
}

static void clock_wall(void *self, uint16_t *day, uint16_t *minute)
{
    const time_t now = time(NULL);
    struct tm date = { 0 };
    (void)self;
    if (localtime_r(&now, &date) == NULL) {
        date.tm_year = 0;
    }
    clock_civil(&date, day, minute);
}

struct hal_clock clock_device(void)
{
    static const struct hal_clock_ops ops = { .now_ns = clock_now_ns, .civil = clock_wall };
    return (struct hal_clock){ .ops = &ops, .self = NULL };
}

void clock_sleep_until(uint64_t time_ns)
{
    const struct timespec until = {
        .tv_sec = (time_t)(time_ns / NS_PER_S),
        .tv_nsec = (long)(time_ns % NS_PER_S),
    };
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
}
