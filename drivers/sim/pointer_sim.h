/* pointer_sim.h -- a simulated mouse that passes raw pointer reports through the real decoder.
 *
 * The faults change the input of the decoder: unplugging before a selected report, doubled reports,
 * jumps across the screen, random numbers, and silence followed by a burst. The caller owns the
 * state and the reports. */
#ifndef KINGYO_DRIVERS_SIM_POINTER_SIM_H
#define KINGYO_DRIVERS_SIM_POINTER_SIM_H

#include "drivers/pointer/pointer_fan.h"
#include "drivers/pointer/pointer_poi.h"
#include "platform/hal.h"

#define POINTER_SIM_NEVER UINT32_MAX

struct pointer_sim {
    struct hal_clock clock;
    const struct pointer_report *reports; /* Reports to play, sorted by time. The array must outlive
                                             the device. */
    uint32_t report_count;
    uint32_t next; /* Index of the next report to play. */
    /* Index of the report before which the mouse is unplugged; POINTER_SIM_NEVER means never. */
    uint32_t unplug_at;
    uint64_t replug_ns;    /* Time from which open() finds the mouse again. */
    uint32_t double_every; /* Interval n of doubled reports: every n-th report arrives twice. 0
                              means that no report is doubled. */
    uint32_t jump_at;      /* Index of the report that jumps to the top right corner;
                              POINTER_SIM_NEVER means that there is no such report. */
    uint32_t spoil_from, spoil_to; /* Index of the first report with random numbers (including NaN),
                                      and index after the last report with random numbers. */
    uint32_t spoil_count;          /* Number of reports with random numbers so far. */
    uint64_t silent_from_ns, silent_to_ns; /* Start and end of the time without reports. The reports
                                              of this time arrive together at its end. */
    uint8_t gone;                          /* 1 while the mouse is unplugged, otherwise 0. */
    uint32_t open_count;
    struct poi_force felt; /* Force feedback that was set last. */
    struct pointer_poi pointer;
    struct pointer_fan fan;
};

/* Initializes a mouse without reports and faults. */
void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view);

/* Returns the poi device of the simulated mouse. */
struct hal_poi pointer_sim_device(struct pointer_sim *sim);

/* Returns the fan that the simulated mouse controls. The fan is unplugged together with the
 * mouse. */
struct hal_fan pointer_sim_fan(struct pointer_sim *sim);

#endif
