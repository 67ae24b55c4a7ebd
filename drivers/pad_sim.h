/* pad_sim.h -- a simulated game pad: plays raw pad reports through the real decoder.
 *
 * Faults are injected below the decoder: unplugging at any report, doubled reports, sticks that
 * jump to a corner, random bits, and silence followed by a burst. The caller owns the state and
 * the reports. */
#ifndef KINGYO_DRIVERS_PAD_SIM_H
#define KINGYO_DRIVERS_PAD_SIM_H

#include "drivers/pad_track.h"
#include "platform/hal.h"

#define PAD_SIM_NEVER UINT32_MAX

struct pad_sim {
    struct hal_clock clock;
    const struct pad_report *reports; /* Reports sorted by time; must outlive the device. */
    uint32_t report_count;
    uint32_t next;                 /* Index of the next report to play. */
    /* Index of the report before which the pad is unplugged, or PAD_SIM_NEVER. */
    uint32_t unplug_at;
    uint64_t replug_ns;            /* Time from which open() finds the pad again. */
    uint32_t double_every;         /* Every n-th report arrives twice; 0: none. */
    uint32_t jump_at; /* Report in which both sticks jump to a corner, or PAD_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* Range of reports with random bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Reports of this time arrive together at its end. */
    uint8_t gone;
    uint32_t open_count;
    struct pad_rumble felt;        /* Motor levels that were set last. */
    struct pad_track track;
};

/* Initializes a pad without reports and faults. */
void pad_sim_init(struct pad_sim *sim, struct hal_clock clock, const struct view *view);

struct hal_poi pad_sim_device(struct pad_sim *sim);
struct hal_shade pad_sim_fan(struct pad_sim *sim);
struct hal_buttons pad_sim_buttons(struct pad_sim *sim);

#endif
