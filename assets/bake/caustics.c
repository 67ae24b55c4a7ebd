/* caustics.c -- bakes caustics: the bright lines on the floor into which a moving water surface
 * focuses the light.
 *
 * A fine grid of light rays is traced through a surface of waves. Each ray is refracted by the
 * slope of the surface and adds its light at the point where it meets the floor. Each wave has a
 * whole number of cycles per tile and per loop, so that the result repeats in x, y and time without
 * a seam. The phase of a wave is a whole index into one sine table of RAYS values. Therefore no
 * phase drifts, and rounding is the same on every machine. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WAVES 28
/* Number of light rays per texel in each direction, which is enough for a smooth picture. */
#define RAYS_PER_TEXEL 4u
#define RAYS (CAUSTICS_SIZE * RAYS_PER_TEXEL)
#define WAVE_NUMBER_MIN 1.9f /* Minimum wave number (number of cycles per tile) of a wave. */
#define WAVE_NUMBER_MAX 6.6f
/* Distance in tiles by which a ray is shifted per unit of surface slope. The distance is
 * proportional to the water depth. */
#define FOCUS 0.033f
/* Exposure of the stored picture. A texel with the brightness b stores 1 - exp(-EXPOSURE * b). Flat
 * water has the brightness 1. */
#define EXPOSURE 0.30f

struct wave {
    int32_t kx, ky; /* Wave numbers along x and y, in cycles per tile. */
    /* Number of cycles per loop of the animation. The sign is the direction in which the wave
     * travels. */
    int32_t turns;
    uint32_t phase; /* Initial phase, in units of 1 / RAYS of a cycle. */
    float slope_x, slope_y;
};

/* Chooses the waves. Longer waves are higher. Directions are random, and every second wave travels
 * backward.
 *
 * Each wave has one cycle per loop, so that longer waves are faster. With one cycle per loop, the
 * bright lines move less than five texels from one layer to the next. The renderer blends two
 * successive layers, and such a short movement is not visible as a step. */
static void choose_waves(struct wave waves[WAVES])
{
    uint32_t random = 4711;
    for (uint32_t i = 0; i < WAVES; i++) {
        float k;
        do {
            waves[i].kx = (int32_t)(noise_random01(&random) * 15.0f) - 7;
            waves[i].ky = (int32_t)(noise_random01(&random) * 15.0f) - 7;
            k = sqrtf((float)(waves[i].kx * waves[i].kx + waves[i].ky * waves[i].ky));
        } while (k < WAVE_NUMBER_MIN || k > WAVE_NUMBER_MAX);
        waves[i].turns = i % 2u == 0 ? 1 : -1;
        waves[i].phase = (uint32_t)(noise_random01(&random) * (float)RAYS);
        const float slope = powf(k, -1.15f);
        waves[i].slope_x = slope * (float)waves[i].kx / k;
        waves[i].slope_y = slope * (float)waves[i].ky / k;
    }
}

static void trace_row(float *light, const float *cosine, const struct wave waves[WAVES],
                      uint32_t row, uint32_t frame)
{
    assert(row < RAYS && frame < CAUSTICS_FRAMES);
    static float shift_x[RAYS], shift_y[RAYS];
    memset(shift_x, 0, sizeof shift_x);
    memset(shift_y, 0, sizeof shift_y);
    for (uint32_t i = 0; i < WAVES; i++) {
        const struct wave *wave = &waves[i];
        uint32_t phase = wave->phase + (uint32_t)wave->ky * row +
                         (uint32_t)wave->turns * (frame * (RAYS / CAUSTICS_FRAMES));
        for (uint32_t x = 0; x < RAYS; x++) {
            const float c = cosine[phase & (RAYS - 1u)];
            shift_x[x] += c * wave->slope_x;
            shift_y[x] += c * wave->slope_y;
            phase += (uint32_t)wave->kx;
        }
    }
    const float reach = FOCUS * (float)CAUSTICS_SIZE;
    for (uint32_t x = 0; x < RAYS; x++) {
        const float to_x = ((float)x + 0.5f) / (float)RAYS_PER_TEXEL + reach * shift_x[x];
        const float to_y = ((float)row + 0.5f) / (float)RAYS_PER_TEXEL + reach * shift_y[x];
        noise_add_light(light, CAUSTICS_SIZE, to_x, to_y, 1.0f);
    }
}

void bake_caustics(uint8_t *r8)
{
    static float cosine[RAYS];
    static struct wave waves[WAVES];
    const uint32_t texels = CAUSTICS_SIZE * CAUSTICS_SIZE;
    float *light = bake_alloc(texels * sizeof *light);
    for (uint32_t i = 0; i < RAYS; i++) {
        cosine[i] = cosf((float)i * (TAU / (float)RAYS));
    }
    choose_waves(waves);
    for (uint32_t frame = 0; frame < CAUSTICS_FRAMES; frame++) {
        memset(light, 0, texels * sizeof *light);
        for (uint32_t row = 0; row < RAYS; row++) {
            trace_row(light, cosine, waves, row, frame);
        }
        for (uint32_t i = 0; i < texels; i++) {
            const float flat = light[i] / (float)(RAYS_PER_TEXEL * RAYS_PER_TEXEL);
            r8[frame * texels + i] = noise_to_u8(1.0f - expf(-EXPOSURE * flat));
        }
    }
    free(light);
}
