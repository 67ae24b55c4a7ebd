/* gamepad_sim.h -- a simulated game pad: plays raw pad reports through the real decoder.
 *
 * Faults are injected below the decoder: unplugging at any report, doubled reports, sticks that
 * jump to a corner, random bits, and silence followed by a burst. The caller owns the state and
 * the reports. */
#ifndef KINGYO_DRIVERS_SIM_GAMEPAD_SIM_H
#define KINGYO_DRIVERS_SIM_GAMEPAD_SIM_H

#include "drivers/gamepad/gamepad_queue.h"
#include "platform/hal.h"

#define GAMEPAD_SIM_NEVER UINT32_MAX

struct gamepad_sim {
    struct hal_clock clock;
    const struct gamepad_report *reports; /* Reports sorted by time; must outlive the device. */
    uint32_t report_count;
    uint32_t next; /* Index of the next report to play. */
    /* Index of the report before which the pad is unplugged, or GAMEPAD_SIM_NEVER. */
    uint32_t unplug_at;
    uint64_t replug_ns;    /* Time from which open() finds the pad again. */
    uint32_t double_every; /* Every n-th report arrives twice; 0: none. */
    uint32_t jump_at;      /* Report in which both sticks jump to a corner, or GAMEPAD_SIM_NEVER. */
    uint32_t spoil_from, spoil_to;         /* Range of reports with random bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Reports of this time arrive together at its end. */
    uint8_t gone;
    uint32_t open_count;
    struct gamepad_rumble felt; /* Motor levels that were set last. */
    struct gamepad_queue track;
};

/* Initializes a pad without reports and faults. */
void gamepad_sim_init(struct gamepad_sim *sim, struct hal_clock clock, const struct view *view);

struct hal_poi gamepad_sim_device(struct gamepad_sim *sim);
struct hal_fan gamepad_sim_fan(struct gamepad_sim *sim);
struct hal_buttons gamepad_sim_buttons(struct gamepad_sim *sim);

#endif
