/* cpu.h -- what this machine's processor can do for the core. */
#ifndef KINGYO_PLATFORM_CPU_H
#define KINGYO_PLATFORM_CPU_H

#include <stdint.h>

/* How many lanes the core's kernels should use here: 8 with AVX2, else 4. For core_config and
 * tank_config; nothing that is simulated depends on it. */
uint8_t cpu_lanes(void);

#endif
