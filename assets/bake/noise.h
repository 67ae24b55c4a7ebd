/* noise.h -- repeatable noise and small numeric functions for the baking of textures. */
#ifndef KINGYO_ASSETS_BAKE_NOISE_H
#define KINGYO_ASSETS_BAKE_NOISE_H

#include <stdint.h>

#define TAU 6.28318530718f

/* Returns a hash of `x`, `y` and `seed` in [0, 1). */
float noise_hash01(int32_t x, int32_t y, uint32_t seed);
/* Returns the next value of a pseudo-random sequence, in [0, 1). `*state` may have any initial
 * value. */
float noise_random01(uint32_t *state);
/* Returns smooth value noise in [0, 1]. The noise repeats after `period_x` and `period_y` cells. */
float noise_2d(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed);
/* Returns the sum of `octaves` octaves of noise_2d(), scaled to [0, 1]. Each octave is twice as
 * fine and half as strong as the octave before. The sum repeats with the periods of noise_2d(). */
float noise_2d_sum(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed,
                   uint32_t octaves);

/* Adds `amount` to the four texels around the position (x, y), in texels, of a square picture whose
 * side `size` is a power of two. Positions outside the picture wrap around. */
void noise_add_light(float *sum, uint32_t size, float x, float y, float amount);

float noise_clamp01(float x);
float noise_mix(float a, float b, float t);
/* Returns 0 at and before `from`, 1 at and after `to`, and a smooth transition between them. If
 * `from` is greater than `to`, the direction is reversed. */
float noise_ramp(float from, float to, float x);
uint8_t noise_to_u8(float x01);

#endif
