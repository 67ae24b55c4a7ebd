/* cpu.h -- processor features that the core uses. */
#ifndef KINGYO_PLATFORM_CPU_H
#define KINGYO_PLATFORM_CPU_H

#include <stdint.h>

/* Returns the number of SIMD lanes for the core's kernels: 8 with AVX2, else 4. The value is for
 * core_config and tank_config. The result of the simulation does not depend on it. */
uint8_t cpu_lanes(void);

/* Sets the calling thread's floating-point control word to the IEEE 754 default: round to nearest,
 * denormal numbers kept, no traps. The word is MXCSR on x86-64, FPCR on AArch64, FPSCR on 32-bit
 * Arm and fcsr on RISC-V; on other machines the call has no effect. Each thread that runs ticks of
 * the core calls this function first: the kiosk before each frame, a command once. Returns 1 if the
 * word was changed, else 0. */
int cpu_set_float(void);

/* Message for CORE_ERR_FLOAT from core_init() or core_tick() after cpu_set_float(). */
#define CPU_FLOAT_WRONG                                                                            \
    "this machine's floating point is not IEEE 754's default (denormal numbers become zero, or "   \
    "rounding is not to nearest), so no result would be right"

#endif
