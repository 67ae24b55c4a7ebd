/* null.h -- a driver for each device that is not there, so that no pointer of struct hal is null.
 *
 * Each says in describe() the caller's line: what is missing and what to do about it (kept, not
 * copied), or "" for null: this kiosk was never meant to have one. They hold no state. */
#ifndef KINGYO_DRIVERS_NULL_H
#define KINGYO_DRIVERS_NULL_H

#include "platform/hal.h"

struct hal_display null_display(const char *line);
struct hal_poi null_poi(const char *line);
struct hal_shade null_shade(const char *line);
struct hal_seats null_seats(void); /* Whoever sits somewhere stays there. */
struct hal_buttons null_buttons(const char *line);
struct hal_switches null_switches(const char *line);
struct hal_controllers null_controllers(const char *line);
struct hal_audio null_audio(const char *line);
struct hal_storage null_storage(const char *line);
struct hal_watchdog null_watchdog(const char *line);

/* Every device null, and a clock that stands still at 0. */
struct hal null_hal(void);

#endif
