/* poi_sim.h -- a mouse made of memory: plays raw pointer reports through the real decoder.
 *
 * Faults are injected below the decoder, where cables and hands are: unplugged at any report,
 * reports doubled, jumps across the screen, any bits for numbers, silence and the burst after it.
 * The caller owns the state and the reports. */
#ifndef KINGYO_DRIVERS_POI_SIM_H
#define KINGYO_DRIVERS_POI_SIM_H

#include "drivers/pointer_fan.h"
#include "drivers/pointer_poi.h"
#include "platform/hal.h"

#define POI_SIM_NEVER UINT32_MAX

struct poi_sim {
    struct hal_clock clock;
    const struct pointer_report *reports; /* Sorted by time; must outlive the device. */
    uint32_t report_count;
    uint32_t next;            /* First report that has not arrived yet. */
    uint32_t unplug_at;       /* Before this report the cable is pulled; POI_SIM_NEVER: never. */
    uint64_t replug_ns;       /* From this time on open() finds it again. */
    uint32_t double_every;    /* Every n-th report arrives twice; 0: none does. */
    uint32_t jump_at;         /* This report lands in the far corner for once; POI_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* These reports say any bits for numbers: NaN, too. */
    uint32_t spoil_count;     /* So many did. */
    uint64_t silent_from_ns, silent_to_ns; /* Nothing arrives in between; it comes all at once. */
    uint8_t gone;
    uint32_t open_count;
    struct poi_force felt;    /* What the hand was last made to feel. */
    struct pointer_poi pointer;
    struct pointer_fan fan;
};

/* No reports and no faults. */
void poi_sim_init(struct poi_sim *sim, struct hal_clock clock, const struct view *view);

struct hal_poi poi_sim_device(struct poi_sim *sim);

/* The fan of the same mouse; it goes and comes with it. */
struct hal_shade poi_sim_fan(struct poi_sim *sim);

#endif
