/* day.h -- converts between the days and minutes of the ledger and the calendar. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_DAY_H
#define KINGYO_PLATFORM_STORE_SQLITE_DAY_H

#include <stdint.h>

#define DAY_TEXT_SIZE 11u

/* Local date and time in the units of input.day (days since 2000-01-01) and input.minute. `day` and
 * `minute` are 0 for an earlier or invalid time. */
struct day_minute {
    uint16_t day, minute;
};

/* Converts `unix_s`, seconds since 1970-01-01 UTC, to the local time of the machine. */
struct day_minute day_minute_of(int64_t unix_s);

/* Writes the date as "2026-11-21". Writes "-" if `day` is 0 (unknown). */
void day_text(uint16_t day, char out[DAY_TEXT_SIZE]);

#endif
