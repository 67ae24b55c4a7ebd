/* gamepad_sim.h -- a simulated game pad that passes raw reports through the real decoder.
 *
 * The faults change the input of the decoder: unplugging before a selected report, doubled reports,
 * sticks that jump to a corner, random bits, and silence followed by a burst. The caller owns the
 * state and the reports. */
#ifndef KINGYO_DRIVERS_SIM_GAMEPAD_SIM_H
#define KINGYO_DRIVERS_SIM_GAMEPAD_SIM_H

#include "drivers/gamepad/gamepad_queue.h"
#include "platform/hal.h"

#define GAMEPAD_SIM_NEVER UINT32_MAX

struct gamepad_sim {
    struct hal_clock clock;
    const struct gamepad_report *reports; /* Reports to play, sorted by time. The array must outlive
                                             the device. */
    uint32_t report_count;
    uint32_t next; /* Index of the next report to play. */
    /* Index of the report before which the game pad is unplugged; GAMEPAD_SIM_NEVER means never. */
    uint32_t unplug_at;
    uint64_t replug_ns;    /* Time from which open() finds the game pad again. */
    uint32_t double_every; /* Interval n of doubled reports: every n-th report arrives twice. 0
                              means that no report is doubled. */
    uint32_t jump_at;      /* Index of the report in which the sticks jump to a corner;
                              GAMEPAD_SIM_NEVER means that there is no such report. */
    uint32_t spoil_from, spoil_to;         /* Index of the first report with random bits, and index
                                              after the last report with random bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Start and end of the time without reports. The reports
                                              of this time arrive together at its end. */
    uint8_t gone;                          /* 1 while the game pad is unplugged, otherwise 0. */
    uint32_t open_count;
    struct gamepad_rumble felt; /* Motor levels that were set last. */
    struct gamepad_queue track;
};

/* Initializes a game pad without reports and faults. */
void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view);

/* Returns the poi device of the simulated game pad. */
struct hal_poi gamepad_sim_device(struct gamepad_sim *sim);
/* Returns the fan device of the simulated game pad. */
struct hal_fan gamepad_sim_fan(struct gamepad_sim *sim);
/* Returns the button device of the simulated game pad. */
struct hal_buttons gamepad_sim_buttons(struct gamepad_sim *sim);

#endif
