/* wood.c -- bakes the planks of the tank's rim and of the stall's counter, with grain along x,
 * knots and dark joints. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>

#define PLANKS 4u
#define PLANK_HEIGHT (WOOD_SIZE / PLANKS)
#define KNOTS 2u

struct knot {
    float x, y, radius; /* Position and radius in texels. y is counted from the upper edge of the
                           plank. */
};

/* Returns how far the knots of the plank bend the grain at (x, y), in texels. `*core` receives the
 * darkness of the nearest knot, which falls from 1 at its centre to 0 outside. */
static float bend(uint32_t plank, float x, float y, float *core)
{
    assert(plank < PLANKS);
    float shift = 0.0f;
    *core = 0.0f;
    for (uint32_t i = 0; i < KNOTS; i++) {
        const int32_t id = (int32_t)(plank * KNOTS + i);
        const struct knot knot = { .x = noise_hash01(id, 0, 5) * (float)WOOD_SIZE,
                                   .y =
                                       (0.2f + 0.6f * noise_hash01(id, 1, 5)) * (float)PLANK_HEIGHT,
                                   .radius = 2.5f + 3.5f * noise_hash01(id, 2, 5) };
        float dx = x - knot.x;
        dx -= (float)WOOD_SIZE * roundf(dx / (float)WOOD_SIZE);
        const float dy = y - knot.y;
        const float far2 = (dx * dx * 0.16f + dy * dy) / (knot.radius * knot.radius);
        shift += (dy >= 0.0f ? 1.0f : -1.0f) * knot.radius * expf(-far2 * 0.22f);
        *core = fmaxf(*core, expf(-far2 * 1.6f));
    }
    return shift;
}

/* Returns the brightness of the wood at (x, y). The wood is cut lengthwise. Each growth ring is one
 * unit of the slowly varying value `ring`. Within a ring, the wood darkens slowly and then becomes
 * light again abruptly. */
static float grain(uint32_t plank, float x, float y, float *core)
{
    const float shifted = y - bend(plank, x, y, core);
    const float u = x / (float)WOOD_SIZE, seed = (float)plank * 37.0f;
    const float wander = 4.5f * noise_2d_sum(u * 3.0f, shifted / 30.0f + seed, 3, 4096, 21, 3);
    const float ring = shifted * 0.15f + wander + seed;
    const float season = ring - floorf(ring);
    const float late = noise_ramp(0.15f, 0.86f, season) * noise_ramp(1.0f, 0.86f, season);
    const float pores = noise_2d(u * 30.0f, y * 0.9f + seed, 30, 4096, 33);
    const float fibre = noise_2d_sum(u * 10.0f, y * 0.55f + seed, 10, 4096, 27, 2);
    return 0.66f - 0.21f * late + 0.24f * (fibre - 0.5f) - 0.10f * noise_ramp(0.66f, 0.95f, pores);
}

void bake_wood(uint8_t *r8)
{
    for (uint32_t row = 0; row < WOOD_SIZE; row++) {
        const uint32_t plank = row / PLANK_HEIGHT;
        const float y = (float)(row % PLANK_HEIGHT) + 0.5f;
        const float to_edge = fminf(y, (float)PLANK_HEIGHT - y);
        const float joint = 0.42f + 0.58f * noise_ramp(0.4f, 3.2f, to_edge);
        const float tone = 0.18f * (noise_hash01((int32_t)plank, 9, 3) - 0.5f);
        for (uint32_t column = 0; column < WOOD_SIZE; column++) {
            float core;
            const float light = grain(plank, (float)column + 0.5f, y, &core);
            r8[row * WOOD_SIZE + column] = noise_to_u8((light + tone - 0.42f * core) * joint);
        }
    }
}
