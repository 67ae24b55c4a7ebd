/* patterns.c -- bakes the red and white patterns of goldfish: patches as breeders name them, and
 * rows of scales.
 *
 * A texel is (u, v): u runs from the snout to the tail's root, v once round the girth, starting on
 * the back (0), over the right flank, the belly (0.5) and the left flank back to 1. Red channel:
 * redness of the skin, with a crisp edge. Green channel: brightness of the scale's reflection. */
#include "assets/bake/bake.h"

#include <math.h>

#include "assets/bake/noise.h"

#define PATCHES_MAX 6u
#define GIRTH 0.85f      /* Girth in body lengths, which makes round patches round. */
#define SCALE_ROWS 22.0f /* Number of rows from gill to tail root. */
#define SCALES_ROUND 12.0f
#define GILL 0.23f /* Border of head and trunk. A head has no scales. */

struct patch {
    float u, v, length, width; /* Centre, and half extents in body lengths. */
};

struct design {
    float base;   /* Redness everywhere: 1 covers the fish, 0 leaves it white. */
    float belly;  /* Height on the flanks up to which the belly stays white. */
    float ragged; /* Strength of the noise that moves the edges. */
    struct patch patches[PATCHES_MAX];
};

/* clang-format off */
static const struct design designs[PATTERN_LAYERS] = {
    /* All red, the common wakin. */
    { .base = 1.0f },
    /* Red back, pale belly. */
    { .base = 1.0f, .belly = 0.36f, .ragged = 0.10f },
    /* Red with a white waist (a broad saddle). */
    { 0.0f, 0.22f, 0.15f, { { 0.12f, 0.0f, 0.25f, 0.60f }, { 0.80f, 0.0f, 0.26f, 0.60f } } },
    /* Two steps. */
    { 0.0f, 0.20f, 0.20f, { { 0.27f, 0.05f, 0.20f, 0.26f }, { 0.74f, 0.96f, 0.17f, 0.24f } } },
    /* Three steps. */
    { 0.0f, 0.18f, 0.27f,
      { { 0.12f, 0.0f, 0.12f, 0.20f }, { 0.45f, 0.06f, 0.14f, 0.26f },
        { 0.79f, 0.95f, 0.13f, 0.22f } } },
    /* Lightning: one band that swings from side to side. */
    { 0.0f, 0.12f, 0.24f,
      { { 0.16f, 0.93f, 0.13f, 0.15f }, { 0.31f, 0.09f, 0.13f, 0.16f },
        { 0.47f, 0.92f, 0.13f, 0.15f }, { 0.63f, 0.09f, 0.13f, 0.15f },
        { 0.80f, 0.95f, 0.14f, 0.15f } } },
    /* A red hood. */
    { 0.0f, 0.10f, 0.24f, { { 0.06f, 0.0f, 0.24f, 0.60f }, { 0.70f, 0.13f, 0.09f, 0.12f } } },
    /* A round spot on the head and patches behind. */
    { 0.0f, 0.15f, 0.25f,
      { { 0.14f, 0.0f, 0.085f, 0.10f }, { 0.50f, 0.97f, 0.13f, 0.22f },
        { 0.81f, 0.05f, 0.11f, 0.18f } } },
    /* The crane: white, with only the spot on the head. */
    { 0.0f, 0.0f, 0.05f, { { 0.145f, 0.0f, 0.095f, 0.11f } } },
    /* Spots scattered over both flanks. */
    { 0.0f, 0.10f, 0.32f,
      { { 0.21f, 0.17f, 0.08f, 0.10f }, { 0.36f, 0.86f, 0.10f, 0.12f },
        { 0.52f, 0.12f, 0.08f, 0.11f }, { 0.64f, 0.83f, 0.07f, 0.09f },
        { 0.83f, 0.04f, 0.10f, 0.13f }, { 0.10f, 0.92f, 0.06f, 0.08f } } },
    /* Mostly white: a blush at the tail and on one cheek. */
    { 0.0f, 0.05f, 0.18f, { { 0.92f, 0.0f, 0.10f, 0.30f }, { 0.17f, 0.16f, 0.06f, 0.08f } } },
    /* White. */
    { .base = 0.0f },
};
/* clang-format on */

/* Returns the distance round the girth, in body lengths. */
static float round_distance(float v, float centre)
{
    const float d = v - centre;
    return (d - roundf(d)) * GIRTH;
}

/* Returns a value above 0 inside the union of the patches. Patches that nearly touch merge. */
static float patch_depth(const struct design *design, float u, float v)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < PATCHES_MAX && design->patches[i].length > 0.0f; i++) {
        const struct patch *patch = &design->patches[i];
        const float du = (u - patch->u) / patch->length;
        const float dv = round_distance(v, patch->v) / patch->width;
        sum += expf(-1.6f * (du * du + dv * dv));
    }
    return sum - 0.202f; /* exp(-1.6): a single patch ends at its extents. */
}

static float redness(uint32_t layer, float u, float v)
{
    const struct design *design = &designs[layer];
    const float coarse =
        noise_2d_sum(u * 5.0f + 0.5f, v * 5.0f, 64, 5, 100u + layer * 8u, 3) - 0.5f;
    const float fine = noise_2d_sum(u * 19.0f, v * 16.0f, 64, 16, 104u + layer * 8u, 2) - 0.5f;
    const float edge = design->ragged * (2.2f * coarse + 0.55f * fine);
    float depth = fmaxf(patch_depth(design, u, v), design->base > 0.0f ? 0.5f : -1.0f) + edge;
    const float from_belly = fabsf(round_distance(v, 0.5f)) / GIRTH * 2.0f; /* 0 belly .. 1 back */
    depth = fminf(depth, (from_belly - design->belly) * 2.0f + 0.6f * edge);
    if (design->belly <= 0.0f) {
        depth = fmaxf(depth, design->base - 0.5f);
    }
    return noise_ramp(-0.030f, 0.035f, depth);
}

/* Returns the brightness of a scale. Scales overlap toward the tail: bright in the middle, dark
 * below a neighbour's rim. */
static float scale_light(float u, float v)
{
    const float row = (u - GILL) / (1.0f - GILL) * SCALE_ROWS;
    float best = 0.0f;
    /* Rims of three rows may cover a point; the front one counts. */
    for (int32_t i = 0; i < 3; i++) {
        const float centre = floorf(row) - (float)i + 0.5f;
        const float odd = fmodf(centre - 0.5f + 64.0f, 2.0f) * 0.5f;
        float dv = v * SCALES_ROUND + odd;
        dv -= floorf(dv) + 0.5f;
        const float du = row - centre;
        const float d = sqrtf(du * du * 0.55f + dv * dv * 2.4f);
        best = fmaxf(best, noise_ramp(1.02f, 0.62f, d) * (1.0f - 0.16f * (float)i) *
                               (0.78f + 0.22f * noise_ramp(-0.2f, 0.9f, du)));
    }
    const float back = 0.5f + 0.5f * cosf(TAU * v);
    const float fade = noise_ramp(GILL - 0.01f, GILL + 0.06f, u) * noise_ramp(0.05f, 0.35f, back);
    const float flank = 0.25f - fabsf(v - 0.5f); /* 0 in the middle of either flank. */
    const float gill = expf(-powf((u - GILL - 0.03f * (fabsf(flank) - 0.12f)) / 0.011f, 2.0f));
    return noise_mix(0.80f, 0.46f + 0.54f * best, fade) -
           0.26f * gill * noise_ramp(0.13f, 0.05f, fabsf(flank));
}

void bake_patterns(uint8_t *rg8)
{
    for (uint32_t layer = 0; layer < PATTERN_LAYERS; layer++) {
        for (uint32_t y = 0; y < PATTERN_HEIGHT; y++) {
            for (uint32_t x = 0; x < PATTERN_WIDTH; x++) {
                const float u = ((float)x + 0.5f) / (float)PATTERN_WIDTH;
                const float v = ((float)y + 0.5f) / (float)PATTERN_HEIGHT;
                uint8_t *texel = rg8 + ((layer * PATTERN_HEIGHT + y) * PATTERN_WIDTH + x) * 2u;
                texel[0] = noise_to_u8(redness(layer, u, v));
                texel[1] = noise_to_u8(scale_light(u, v));
            }
        }
    }
}
