/* float_env.h -- checks that the calling thread computes floats as the simulation needs.
 *
 * Equal inputs give equal states only if denormal numbers are kept and results are rounded to the
 * nearest float, ties to even. A library may leave a thread in another mode, such as flush-to-zero.
 * The platform sets the control word (platform/cpu.h); the core only checks the results. */
#ifndef KINGYO_CORE_BASE_FLOAT_ENV_H
#define KINGYO_CORE_BASE_FLOAT_ENV_H

/* Computes eight sums of products whose bits depend on the mode, once one by one and once in lanes
 * of four, because 32-bit Arm has a second unit for lanes. Returns 1 if all bits are as IEEE 754
 * requires in its default mode, else 0. */
int float_env_is_standard(void);

#endif
