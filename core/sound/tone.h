/* tone.h -- the elements of which all instruments consist: sine oscillators, decaying modes, noise
 * and a band-pass filter.
 *
 * All sound is rendered in blocks of SOUND_BLOCK frames. Frequencies, filters and targets of levels
 * change only between two blocks. The functions use no libm, so that all platforms render the same
 * samples. */
#pragma once

#include <stdint.h>

#include "core/base/fmath.h"

#define SOUND_RATE_HZ 48000u
/* Number of frames in a block (0.67 ms). Changes of the pitch in such small steps are inaudible. */
#define SOUND_BLOCK 32u
#define SOUND_BLOCKS_PER_S ((float)SOUND_RATE_HZ / (float)SOUND_BLOCK)

/* A complex number. As an oscillator, its angle is the phase, and its length is the amplitude. As a
 * turn, it is the rotation by one frame. */
struct tone {
    float x, y;
};

/* Returns the rotation of an oscillator of `hz` by one frame. If `keep` is below 1, the oscillator
 * also decays by this factor. */
static inline struct tone tone_turn(float hz, float keep)
{
    const float angle = F_TAU * hz / (float)SOUND_RATE_HZ;
    return (struct tone){ keep * f_cos(angle), keep * f_sin(angle) };
}

/* Advances an oscillator by one frame. */
static inline struct tone tone_next(struct tone tone, struct tone turn)
{
    return (struct tone){ tone.x * turn.x - tone.y * turn.y, tone.y * turn.x + tone.x * turn.y };
}

/* Returns an oscillator whose amplitude is corrected toward 1. Rounding errors would otherwise
 * change the amplitude of an oscillator that never decays. */
static inline struct tone tone_unit(struct tone tone)
{
    const float fix = 1.5f - 0.5f * (tone.x * tone.x + tone.y * tone.y);
    return (struct tone){ tone.x * fix, tone.y * fix };
}

/* Returns the factor for each frame with which a level decays to 1/e in `ms` milliseconds. */
static inline float tone_keep(float ms)
{
    return f_exp(-1000.0f / (ms * (float)SOUND_RATE_HZ));
}

/* Returns the share by which a value approaches its target in each block, for a time constant of
 * `ms` milliseconds. */
static inline float tone_share(float ms)
{
    return 1.0f - f_exp(-1000.0f / (ms * SOUND_BLOCKS_PER_S));
}

/* Returns a number in which each bit depends on all bits of `x`. */
static inline uint32_t tone_scramble(uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/* Returns white noise in [-1, 1) from a linear congruential generator. The high bits of the
 * generator are sufficiently random for the sounds of water and paper. */
static inline float tone_noise(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(int32_t)(*state >> 8) * (2.0f / 16777216.0f) - 1.0f;
}

/* Returns a random number in [0, 1). */
static inline float tone_random(uint32_t *state)
{
    return 0.5f + 0.5f * tone_noise(state);
}

/* A state-variable filter. `damping` is the inverse of the quality factor Q. */
struct tone_filter {
    float low, band, cutoff, damping;
};

/* Sets the centre frequency, which must be below 10 kHz. */
static inline void tone_filter_tune(struct tone_filter *filter, float hz, float damping)
{
    filter->cutoff = 2.0f * f_sin(F_PI * hz / (float)SOUND_RATE_HZ);
    filter->damping = damping;
}

/* Filters one sample, and returns the band around the centre frequency. `filter->low` then is the
 * part below the centre frequency. */
static inline float tone_filter_band(struct tone_filter *filter, float sample)
{
    filter->low += filter->cutoff * filter->band;
    filter->band += filter->cutoff * (sample - filter->low - filter->damping * filter->band);
    return filter->band;
}

/* Gains of the left and the right channel for a position from -1 (left) to 1 (right). The sum of
 * their squares is 1 for every position, so that the total power is constant. */
static inline struct tone tone_pan(float pan)
{
    const float p = f_clamp(pan, -1.0f, 1.0f);
    return (struct tone){ f_sqrt(0.5f * (1.0f - p)), f_sqrt(0.5f * (1.0f + p)) };
}
