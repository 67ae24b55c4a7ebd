/* gpio_sim_kernel.h -- the kernel model between simulated wires and their queues. A private part
 * of gpio_lines_sim.c. */
#ifndef KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H
#define KINGYO_DRIVERS_SIM_GPIO_SIM_KERNEL_H

#include "drivers/sim/gpio_lines_sim.h"

/* Executes the next event up to `until_ns`. Returns false if there is none. */
bool gpio_sim_advance(struct gpio_lines_sim *sim, uint64_t until_ns);

#endif
