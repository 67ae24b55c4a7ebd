/* day.h -- converts the days and minutes of the ledger from and to the civil calendar. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_DAY_H
#define KINGYO_PLATFORM_STORE_SQLITE_DAY_H

#include <stdint.h>

#define DAY_TEXT_SIZE 11u

/* Local time since 2000-01-01 in the units of input.day and input.minute. Both are 0 for an earlier
 * time. */
struct day_minute {
    uint16_t day, minute;
};

/* Converts `unix_s`, seconds since 1970, to the machine's time zone. */
struct day_minute day_minute_of(int64_t unix_s);

/* Writes "2026-11-21", or "-" for 0 (unknown). */
void day_text(uint16_t day, char out[DAY_TEXT_SIZE]);

#endif
