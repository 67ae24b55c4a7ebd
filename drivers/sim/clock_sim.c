/* clock_sim.c -- implements a clock that returns the value of a variable. */
#include "drivers/sim/clock_sim.h"

static uint64_t clock_sim_now_ns(void *self)
{
    const struct clock_sim *sim = self;
    return sim->now_ns;
}

struct hal_clock clock_sim_device(struct clock_sim *sim)
{
    static const struct hal_clock_ops ops = { .now_ns = clock_sim_now_ns };
    return (struct hal_clock){ .ops = &ops, .self = sim };
}
