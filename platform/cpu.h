/* cpu.h -- what this machine's processor can do for the core. */
#ifndef KINGYO_PLATFORM_CPU_H
#define KINGYO_PLATFORM_CPU_H

#include <stdint.h>

/* How many lanes the core's kernels should use here: 8 with AVX2, else 4. For core_config and
 * tank_config; nothing that is simulated depends on it. */
uint8_t cpu_lanes(void);

/* Sets the calling thread's floating-point control word to IEEE 754's default: round to nearest,
 * denormal numbers kept, no traps (MXCSR on x86-64, FPCR on AArch64, FPSCR on 32-bit Arm, fcsr on
 * RISC-V; on other machines it does nothing). Each thread that ticks the core calls it first: the
 * kiosk before each frame, a command once. Returns 1 if the word was another one, else 0. */
int cpu_set_float(void);

/* The line for core_init() or core_tick() that returned CORE_ERR_FLOAT after cpu_set_float(). */
#define CPU_FLOAT_WRONG                                                                            \
    "this machine's floating point is not IEEE 754's default (denormal numbers become zero, or "   \
    "rounding is not to nearest), so no result would be right"

#endif
