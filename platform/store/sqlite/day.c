/* day.c -- converts between day numbers and dates; see day.h. The calculation starts the year in
 * March, so that the leap day is the last day of a year. */
#include "platform/store/sqlite/day.h"

#include <stdio.h>
#include <time.h>

#define DAYS_TO_2000 730425 /* Days from 0000-03-01 to 2000-01-01 in the Gregorian calendar. */

static int64_t day_number(int64_t year, int64_t month, int64_t day)
{
    const int64_t from_march = month > 2 ? month - 3 : month + 9;
    const int64_t era = month > 2 ? year : year - 1;
    return era * 365 + era / 4 - era / 100 + era / 400 + (from_march * 153 + 2) / 5 + day - 1 -
           DAYS_TO_2000;
}

struct day_minute day_minute_of(int64_t unix_s)
{
    const time_t moment = (time_t)unix_s;
    struct tm local;
    if (!localtime_r(&moment, &local)) {
        return (struct day_minute){ 0 };
    }
    const int64_t day = day_number(local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
    if (day <= 0 || day > UINT16_MAX) {
        return (struct day_minute){ 0 };
    }
    return (struct day_minute){ .day = (uint16_t)day,
                                .minute = (uint16_t)(local.tm_hour * 60 + local.tm_min) };
}

void day_text(uint16_t day, char out[DAY_TEXT_SIZE])
{
    int64_t year = 2000 + day / 366, month = 1;
    while (day_number(year + 1, 1, 1) <= day) {
        year++;
    }
    while (month < 12 && day_number(year, month + 1, 1) <= day) {
        month++;
    }
    const int64_t in_month = day - day_number(year, month, 1) + 1;
    if (day == 0) {
        snprintf(out, DAY_TEXT_SIZE, "-");
    } else {
        snprintf(out, DAY_TEXT_SIZE, "%04u-%02u-%02u", (unsigned)year % 10000u,
                 (unsigned)month % 100u, (unsigned)in_month % 100u);
    }
}
