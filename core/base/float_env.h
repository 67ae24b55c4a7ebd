/* float_env.h -- checks that the calling thread computes floats as the simulation requires.
 *
 * Equal inputs give equal states only if denormal numbers are kept and results are rounded to the
 * nearest float, ties to even. A library may leave a thread in another mode, such as flush-to-zero.
 * The platform sets the control word of the processor (platform/cpu.h). The core only checks the
 * results. */
#pragma once

#include <stdbool.h>

/* Computes eight sums of products whose bits depend on the mode of the processor. Each sum is
 * computed as a scalar and in a vector of four floats, because 32-bit Arm has a separate unit for
 * vectors. Returns true if all bits are as IEEE 754 requires in its default mode. */
bool float_env_is_standard(void);
