/* gpio_sim_kernel.h -- the model of the kernel, which turns changes of simulated wires into queued
 * edges. A private part of gpio_lines_sim.c. */
#ifndef KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H
#define KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H

#include "drivers/sim/gpio_lines_sim.h"

/* Executes the next event if its time is not after `until_ns`. Returns true, or false if there is
 * no such event. */
bool gpio_sim_advance(struct gpio_lines_sim *sim, uint64_t until_ns);

#endif
