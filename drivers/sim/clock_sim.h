/* clock_sim.h -- a simulated clock, which a test or the demonstration advances. */
#ifndef KINGYO_DRIVERS_SIM_CLOCK_SIM_H
#define KINGYO_DRIVERS_SIM_CLOCK_SIM_H

#include "platform/hal.h"

struct clock_sim {
    uint64_t now_ns; /* Current time. The owner may increase it and must not decrease it. */
};

/* Returns the simulated clock. */
struct hal_clock clock_sim_device(struct clock_sim *sim);

#endif
