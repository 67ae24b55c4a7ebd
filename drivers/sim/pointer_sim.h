/* pointer_sim.h -- a simulated mouse: plays raw pointer reports through the real decoder.
 *
 * Faults are injected below the decoder: unplugging at any report, doubled reports, jumps across
 * the screen, random numbers, and silence followed by a burst. The caller owns the state and the
 * reports. */
#ifndef KINGYO_DRIVERS_SIM_POINTER_SIM_H
#define KINGYO_DRIVERS_SIM_POINTER_SIM_H

#include "drivers/pointer/pointer_fan.h"
#include "drivers/pointer/pointer_poi.h"
#include "platform/hal.h"

#define POINTER_SIM_NEVER UINT32_MAX

struct pointer_sim {
    struct hal_clock clock;
    const struct pointer_report *reports; /* Reports sorted by time; must outlive the device. */
    uint32_t report_count;
    uint32_t next; /* Index of the next report to play. */
    /* Index of the report before which the mouse is unplugged, or POINTER_SIM_NEVER. */
    uint32_t unplug_at;
    uint64_t replug_ns;    /* Time from which open() finds the mouse again. */
    uint32_t double_every; /* Every n-th report arrives twice; 0: none. */
    uint32_t jump_at;      /* Index of the report at the far corner, or POINTER_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* Range of reports with random numbers, including NaN. */
    uint32_t spoil_count;          /* Number of reports with random numbers so far. */
    uint64_t silent_from_ns, silent_to_ns; /* Reports of this time arrive together at its end. */
    uint8_t gone;
    uint32_t open_count;
    struct poi_force felt; /* Force feedback that was set last. */
    struct pointer_poi pointer;
    struct pointer_fan fan;
};

/* Initializes a mouse without reports and faults. */
void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view);

struct hal_poi pointer_sim_device(struct pointer_sim *sim);

/* Returns the fan of the same mouse, which is unplugged with the mouse. */
struct hal_fan pointer_sim_fan(struct pointer_sim *sim);

#endif
