/* gpio_sim_kernel.h -- what happens between simulated wires and their queues. gpio_lines_sim.c's
 * own. */
#ifndef KINGYO_DRIVERS_GPIO_SIM_KERNEL_H
#define KINGYO_DRIVERS_GPIO_SIM_KERNEL_H

#include "drivers/gpio_lines_sim.h"

/* Does the next thing that happens up to `until_ns`. False: there is none. */
bool gpio_sim_advance(struct gpio_lines_sim *sim, uint64_t until_ns);

#endif
