/* clock_sim.h -- a simulated clock that a test or the demonstration advances. */
#ifndef KINGYO_DRIVERS_SIM_CLOCK_SIM_H
#define KINGYO_DRIVERS_SIM_CLOCK_SIM_H

#include "platform/hal.h"

struct clock_sim {
    uint64_t now_ns; /* Current time; the owner may increase it, never decrease it. */
};

struct hal_clock clock_sim_device(struct clock_sim *sim);

#endif
