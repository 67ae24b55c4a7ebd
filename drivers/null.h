/* null.h -- provides a null driver for each missing device, so that no pointer in struct hal is
 * null.
 *
 * Each describe() returns `line`, which names the missing device and the remedy. The text is not
 * copied and must stay valid. If `line` is null the description is "", which suits a device that
 * this kiosk never has. The drivers have no state. */
#ifndef KINGYO_DRIVERS_NULL_H
#define KINGYO_DRIVERS_NULL_H

#include "platform/hal.h"

/* Each of these functions returns a null driver with the description `line` for one device of
 * struct hal. */
struct hal_display null_display(const char *line);
struct hal_poi null_poi(const char *line);
struct hal_fan null_fan(const char *line);
struct hal_seats null_seats(void); /* Returns a null driver whose arrange() changes no slot. */
struct hal_buttons null_buttons(const char *line);
struct hal_switches null_switches(const char *line);
struct hal_controllers null_controllers(const char *line);
struct hal_audio null_audio(const char *line);
struct hal_storage null_storage(const char *line);
struct hal_watchdog null_watchdog(const char *line);

/* Returns null drivers for all devices, and a clock that always returns 0. */
struct hal null_hal(void);

#endif
