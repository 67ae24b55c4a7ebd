/* noise.h -- repeatable noise and small numeric helpers for the bakers. */
#ifndef KINGYO_ASSETS_BAKE_NOISE_H
#define KINGYO_ASSETS_BAKE_NOISE_H

#include <stdint.h>

#define TAU 6.28318530718f

/* Returns a hash in [0, 1) of three integers. */
float noise_hash01(int32_t x, int32_t y, uint32_t seed);
/* Returns the next value of a pseudo-random sequence, [0, 1); `*state` may be any value. */
float noise_random01(uint32_t *state);
/* Returns smooth value noise in [0, 1], repeating after `period_x`, `period_y` whole cells. */
float noise_2d(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed);
/* Returns the sum of `octaves` of noise_2d(), each twice as fine and half as strong. The sum
 * repeats like noise_2d() and is in [0, 1]. */
float noise_2d_sum(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed,
                   uint32_t octaves);

float noise_clamp01(float x);
float noise_mix(float a, float b, float t);
/* Returns 0 below `from`, 1 above `to`, smooth between; `from` may exceed `to`. */
float noise_ramp(float from, float to, float x);
uint8_t noise_to_u8(float x01);

#endif
