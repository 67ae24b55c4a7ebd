/* pointer_sim.h -- a simulated mouse or touch screen that passes raw reports through the real
 * decoders.
 *
 * report_feed.h defines the faults: unplugging, doubled reports, jumps, random numbers, and silence
 * followed by a burst. The caller owns the state and the reports, and sets the reports after the
 * initialization. */
#pragma once

#include "drivers/pointer/pointer_poi.h"
#include "drivers/pointer/touch_fingers.h"
#include "drivers/sim/report_feed.h"

struct pointer_sim {
    struct report_feed feed;
    const struct pointer_report *reports; /* Reports of a mouse. */
    const struct touch_event *events;     /* Events of a touch screen. */
    /* True for a touch screen, which plays `events`. False for a mouse, which plays `reports`. */
    bool is_touch;
    /* Every n-th event of the touch screen is lost if it lifts a finger, where n is this value. 0
     * means that no event is lost. */
    uint32_t mute_every;
    struct touch_fingers fingers;
    struct pointer_report report; /* Last report of the touch screen. */
    uint32_t random_count;        /* Number of mouse reports with random numbers so far. */
    struct poi_force felt;        /* Force feedback that was set last. */
    struct pointer_poi pointer;
};

/* Initializes a mouse without reports and faults. */
void pointer_sim_init(struct pointer_sim *sim, struct hal_clock clock, const struct view *view);

/* Initializes a touch screen for a window of `width` x `height` pixels, without events and
 * faults. */
void pointer_sim_init_touch(struct pointer_sim *sim, struct hal_clock clock,
                            const struct view *view, uint32_t width, uint32_t height);

/* Returns the poi of the simulated mouse or touch screen, and the fan that the simulated mouse
 * controls. The fan is unplugged together with the mouse. There is no button device. */
struct hal_controller_devices pointer_sim_devices(struct pointer_sim *sim);
