/* gamepad_sim.h -- a simulated game pad that passes raw reports through the real decoder.
 *
 * report_feed.h defines the faults: unplugging, doubled reports, sticks that jump to a corner,
 * random bits, and silence followed by a burst. The caller owns the state and the reports. */
#pragma once

#include "drivers/gamepad/gamepad_decoder.h"
#include "drivers/sim/report_feed.h"

struct gamepad_sim {
    struct report_feed feed;
    const struct gamepad_report *reports;
    struct gamepad_rumble felt; /* Motor levels that were set last. */
    struct gamepad_queue track;
};

/* Initializes a game pad without reports and faults. */
void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view);

/* Returns the devices of the simulated game pad. */
struct hal_controller_devices gamepad_sim_devices(struct gamepad_sim *sim);
