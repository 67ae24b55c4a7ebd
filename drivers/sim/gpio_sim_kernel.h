/* gpio_sim_kernel.h -- the model of the kernel, which turns changes of simulated wires into queued
 * edges. A private part of gpio_lines_sim.c. */
#ifndef KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H
#define KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H

#include "drivers/sim/gpio_lines_sim.h"

/* Executes the next event of the script or of the kernel if its time is at most `until_ns`. Returns
 * true if an event was executed, otherwise false. */
bool gpio_sim_advance(struct gpio_lines_sim *sim, uint64_t until_ns);

#endif
