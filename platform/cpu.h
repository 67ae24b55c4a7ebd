/* cpu.h -- detects SIMD instructions and sets the floating-point mode for the core. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Returns the number of SIMD lanes for the core's vectorized loops: 8 with AVX2, otherwise 4. The
 * caller passes the value to struct core_config and struct tank_config. The simulation result is
 * the same for both values. */
uint8_t cpu_lanes(void);

/* Sets the calling thread's floating-point control register to the IEEE 754 default: round to
 * nearest, denormal numbers kept, no traps. The register is MXCSR on x86-64, FPCR on AArch64, FPSCR
 * on 32-bit Arm and fcsr on RISC-V. On other machines the function has no effect. Each thread must
 * call cpu_set_float() before it runs the core's ticks. The kiosk calls it before the ticks of each
 * frame, a command-line tool once. Returns true if the register was changed. */
bool cpu_set_float(void);

/* Error message if core_init() or core_tick() returns CORE_ERR_FLOAT after cpu_set_float(). */
#define CPU_FLOAT_WRONG                                                                            \
    "this machine's floating point is not IEEE 754's default (denormal numbers become zero, or "   \
    "rounding is not to nearest), so results would be wrong"
