/* pad_sim.h -- a game pad made of memory: plays raw pad reports through the real decoder.
 *
 * Faults are injected below the decoder, where cables and thumbs are: unplugged at any report,
 * reports doubled, sticks that jump to their corner, any bits, silence and the burst after it. The
 * caller owns the state and the reports. */
#ifndef KINGYO_DRIVERS_PAD_SIM_H
#define KINGYO_DRIVERS_PAD_SIM_H

#include "drivers/pad_track.h"
#include "platform/hal.h"

#define PAD_SIM_NEVER UINT32_MAX

struct pad_sim {
    struct hal_clock clock;
    const struct pad_report *reports; /* Sorted by time; must outlive the device. */
    uint32_t report_count;
    uint32_t next;                 /* First report that has not arrived yet. */
    uint32_t unplug_at;            /* Before this report the cable is pulled; PAD_SIM_NEVER. */
    uint64_t replug_ns;            /* From this time on open() finds it again. */
    uint32_t double_every;         /* Every n-th report arrives twice; 0: none does. */
    uint32_t jump_at;              /* Here both sticks lie in a corner for once; PAD_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* These reports say any bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Nothing arrives in between; it comes all at once. */
    uint8_t gone;
    uint32_t open_count;
    struct pad_rumble felt;        /* How it hums. */
    struct pad_track track;
};

/* No reports and no faults. */
void pad_sim_init(struct pad_sim *sim, struct hal_clock clock, const struct view *view);

struct hal_poi pad_sim_device(struct pad_sim *sim);
struct hal_shade pad_sim_fan(struct pad_sim *sim);
struct hal_buttons pad_sim_buttons(struct pad_sim *sim);

#endif
