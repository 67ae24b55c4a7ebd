/* noise.c -- repeatable noise, and small numeric functions for the baking of textures. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>

static uint32_t scramble(uint32_t h)
{
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return h ^ (h >> 16);
}

float noise_hash01(int32_t x, int32_t y, uint32_t seed)
{
    const uint32_t h = scramble((uint32_t)x + scramble((uint32_t)y + scramble(seed + 1u)));
    return (float)(h >> 8) / 16777216.0f;
}

float noise_random01(uint32_t *state)
{
    *state += 0x9e3779b9u;
    return (float)(scramble(*state) >> 8) / 16777216.0f;
}

static float clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

float noise_mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

float noise_ramp(float from, float to, float x)
{
    assert(from != to);
    const float t = clamp01((x - from) / (to - from));
    return t * t * (3.0f - 2.0f * t);
}

uint8_t noise_to_u8(float x01)
{
    return (uint8_t)(clamp01(x01) * 255.0f + 0.5f);
}

static int32_t wrap(int32_t x, int32_t period)
{
    assert(period > 0);
    const int32_t rest = x % period;
    return rest < 0 ? rest + period : rest;
}

float noise_2d(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed)
{
    const int32_t x0 = (int32_t)floorf(x), y0 = (int32_t)floorf(y);
    const float tx = noise_ramp(0.0f, 1.0f, x - (float)x0),
                ty = noise_ramp(0.0f, 1.0f, y - (float)y0);
    const int32_t left = wrap(x0, period_x), right = wrap(x0 + 1, period_x);
    const int32_t top = wrap(y0, period_y), bottom = wrap(y0 + 1, period_y);
    return noise_mix(
        noise_mix(noise_hash01(left, top, seed), noise_hash01(right, top, seed), tx),
        noise_mix(noise_hash01(left, bottom, seed), noise_hash01(right, bottom, seed), tx), ty);
}

float noise_2d_sum(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed,
                   uint32_t octaves)
{
    assert(octaves > 0);
    float sum = 0.0f, weight = 0.5f, total = 0.0f;
    for (uint32_t i = 0; i < octaves; i++) {
        sum += weight * noise_2d(x, y, period_x, period_y, seed + i);
        total += weight;
        weight *= 0.5f;
        x *= 2.0f, y *= 2.0f;
        period_x *= 2, period_y *= 2;
    }
    return sum / total;
}

void noise_add_light(float *sum, uint32_t size, float x, float y, float amount)
{
    const float fx = floorf(x), fy = floorf(y), tx = x - fx, ty = y - fy;
    const uint32_t mask = size - 1u;
    assert(size > 0 && (size & mask) == 0);
    const uint32_t left = (uint32_t)(int32_t)fx & mask, right = (left + 1u) & mask;
    const uint32_t row = (uint32_t)(int32_t)fy & mask;
    const uint32_t top = row * size, bottom = ((row + 1u) & mask) * size;
    sum[top + left] += amount * (1.0f - tx) * (1.0f - ty);
    sum[top + right] += amount * tx * (1.0f - ty);
    sum[bottom + left] += amount * (1.0f - tx) * ty;
    sum[bottom + right] += amount * tx * ty;
}
