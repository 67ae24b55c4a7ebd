/* day.h -- the ledger's days and minutes, from and to those of the calendar. */
#ifndef KINGYO_PLATFORM_STORE_DAY_H
#define KINGYO_PLATFORM_STORE_DAY_H

#include <stdint.h>

#define DAY_TEXT_SIZE 11u

/* As input.day and input.minute: local, since 2000-01-01, 0 and 0 where that was before it. */
struct day_minute {
    uint16_t day, minute;
};

/* `unix_s` seconds since 1970, in the machine's time zone. */
struct day_minute day_minute_of(int64_t unix_s);

/* "2026-11-21", or "-" for 0: unknown. */
void day_text(uint16_t day, char out[DAY_TEXT_SIZE]);

#endif
