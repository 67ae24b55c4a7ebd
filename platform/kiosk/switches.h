/* switches.h -- lamps, the coin lock, the meter and tickets: what the core wants of them, brought
 * to a driver that may refuse. Nothing is taken for done before the driver took it. */
#ifndef KINGYO_PLATFORM_KIOSK_SWITCHES_H
#define KINGYO_PLATFORM_KIOSK_SWITCHES_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct switches {
    uint32_t active;                     /* Levels as the driver took them last, a bit
                                            (1 << enum hal_switch) each. */
    uint32_t given[HAL_SWITCH_COUNT];    /* Pulses that it took, since the start. */
    uint64_t retry_ns[HAL_SWITCH_COUNT]; /* When one that failed is asked again. */
};

/* Once a frame: the levels of the lamp and the coin lock, and a pulse of the meter and of the
 * ticket dispenser for each that was counted since. Returns how many faults it met. */
uint32_t switches_put(struct switches *switches, const struct hal_switches *device,
                      const struct output *output, uint64_t now_ns);

/* Returns how many pulses have ended, since the start. A switch that this cabinet lacks ends its
 * pulses at once. */
uint32_t switches_done(const struct switches *switches, const struct hal_switches *device,
                       enum hal_switch which);

#endif
