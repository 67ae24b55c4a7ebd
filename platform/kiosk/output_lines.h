/* output_lines.h -- output lines: passes the core's lamps, coin lockout, meter and tickets to a
 * driver that may fail.
 *
 * Nothing counts as done before the driver accepts it. */
#ifndef KINGYO_PLATFORM_KIOSK_OUTPUT_LINES_H
#define KINGYO_PLATFORM_KIOSK_OUTPUT_LINES_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct output_lines {
    uint32_t active;                     /* Levels that the driver accepted last, one bit (1 << enum
                                            hal_switch) each. */
    uint32_t given[HAL_SWITCH_COUNT];    /* Pulses that the driver accepted since the start. */
    uint64_t retry_ns[HAL_SWITCH_COUNT]; /* Time of the next attempt for an output that failed. */
};

/* Sets the lamp and the coin lockout, and issues a pulse of the meter and of the ticket dispenser
 * for each new count. Call once a frame. Returns the number of faults. */
uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns);

/* Returns the number of pulses that have ended since the start. Pulses of an output that this
 * cabinet lacks end at once. */
uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which);

#endif
