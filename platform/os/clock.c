/* clock.c -- reads CLOCK_MONOTONIC and the local date and time; see clock.h. */
#include "platform/os/clock.h"

#include <assert.h>
#include <time.h>

/* Days from 2000-01-01 to 2000-03-01: January and a February with a leap day. */
#define DAYS_TO_MARCH_2000 60

static uint64_t clock_now_ns(void *self)
{
    struct timespec now;
    (void)self;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

/* Returns the number of days from 2000-01-01 to `date`. The calculation uses years that start in
 * March, so that a leap day is the last day of its year. The number of days before month m is then
 * (153 * m + 2) / 5, where m is 0 for March. */
static int32_t days_since_2000(const struct tm *date)
{
    assert(date->tm_mon >= 0 && date->tm_mon < 12);
    const int32_t is_early = date->tm_mon < 2;
    const int32_t year = date->tm_year - 100 - is_early;    /* Years since March 2000. */
    const int32_t month = date->tm_mon - 2 + 12 * is_early; /* Month of the year that starts in
                                                               March. 0 is March. */
    const int32_t before = 365 * year + year / 4 - year / 100 + year / 400;
    return before + (153 * month + 2) / 5 + date->tm_mday - 1 + DAYS_TO_MARCH_2000;
}

void clock_civil(const struct tm *date, uint16_t *day, uint16_t *minute)
{
    assert(day && minute);
    *day = *minute = 0;
    if (date->tm_year + 1900 >= CLOCK_FIRST_YEAR && date->tm_year + 1900 <= CLOCK_LAST_YEAR) {
        *day = (uint16_t)days_since_2000(date);
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
        .tv_sec = (time_t)(time_ns / 1000000000u),
        .tv_nsec = (long)(time_ns % 1000000000u),
    };
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
}
