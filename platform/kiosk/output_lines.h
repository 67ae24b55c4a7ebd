/* output_lines.h -- sends the core's outputs (start lamp, coin lockout, coin counter, tickets) to a
 * driver that may fail.
 *
 * An output counts as sent only after the driver has accepted it. */
#ifndef KINGYO_PLATFORM_KIOSK_OUTPUT_LINES_H
#define KINGYO_PLATFORM_KIOSK_OUTPUT_LINES_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct output_lines {
    uint32_t active;                     /* Levels that the driver accepted last, one bit (1 << enum
                                            hal_switch) per output. */
    uint32_t given[HAL_SWITCH_COUNT];    /* Pulses that the driver accepted since program start. */
    uint64_t retry_ns[HAL_SWITCH_COUNT]; /* Time of the next attempt for an output whose last
                                            request failed. */
};

/* Sets the start lamp and the coin lockout. Sends one pulse to the coin counter or the ticket
 * dispenser for each increase of its count. Call once per frame. Returns the number of faults. */
uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns);

/* Returns the number of completed pulses since program start. Pulses of an output that the cabinet
 * does not have are completed immediately. */
uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which);

#endif
