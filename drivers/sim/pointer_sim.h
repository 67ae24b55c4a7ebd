/* pointer_sim.h -- a simulated mouse and a simulated touch screen that pass raw reports through the
 * real decoders.
 *
 * report_feed.h defines the faults: unplugging, doubled reports, jumps, random numbers, and silence
 * followed by a burst. The caller owns the states and the reports. */
#ifndef KINGYO_DRIVERS_SIM_POINTER_SIM_H
#define KINGYO_DRIVERS_SIM_POINTER_SIM_H

#include "drivers/pointer/pointer_poi.h"
#include "drivers/pointer/touch_fingers.h"
#include "drivers/sim/report_feed.h"

/* ---- Mouse ----------------------------------------------------------------------------------- */

struct pointer_sim {
    struct report_feed feed;
    const struct pointer_report *reports;
    uint32_t spoil_count;  /* Number of reports with random numbers so far. */
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

/* ---- Touch screen ---------------------------------------------------------------------------- */

struct touch_sim {
    struct report_feed feed;
    const struct touch_event *events;
    uint32_t mute_every; /* Interval n of lost events: every n-th event is lost if it lifts a
                            finger. 0 means that no event is lost. */
    struct touch_fingers fingers;
    struct pointer_report report;
    struct pointer_poi pointer;
};

/* Initializes a touch screen for a window of `width` x `height` pixels, without events and
 * faults. */
void sim_touch_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

/* Returns the poi device of the simulated touch screen. */
struct hal_poi sim_touch_device(struct touch_sim *sim);

#endif
