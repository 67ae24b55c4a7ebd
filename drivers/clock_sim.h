/* clock_sim.h -- a clock that a test or the demonstration moves by hand. */
#ifndef KINGYO_DRIVERS_CLOCK_SIM_H
#define KINGYO_DRIVERS_CLOCK_SIM_H

#include "platform/hal.h"

struct clock_sim {
    uint64_t now_ns; /* Write it to move time; it must never go back. */
};

struct hal_clock clock_sim_device(struct clock_sim *sim);

#endif
