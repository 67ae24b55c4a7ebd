/* patterns.c -- bakes the red and white patterns of goldfish, and the rows of their scales.
 *
 * A texel has the coordinates (u, v). u runs from the snout to the tail root. v runs once round the
 * girth: from the back (0) over the right flank, the belly (0.5) and the left flank to the back
 * (1). The red channel is the redness of the skin. The green channel is the
 * brightness of a scale's reflection. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>

#define PATCHES_MAX 6u
/* Girth of the body in body lengths. With this girth, a round patch of the pattern is
 * also round on the body. */
#define GIRTH 0.85f
#define SCALE_ROWS 31.0f /* Number of rows of scales from the gill cover to the tail root. */
#define SCALES_ROUND 30.0f
#define GILL 0.23f /* Position u of the border between head and trunk. The head has no scales. */

struct patch {
    float u, v, length, width; /* Centre (u, v), half length and half width of a patch. The lengths
                                  are in body lengths. */
};

struct design {
    float base; /* Redness of the skin outside the patches. 1 makes this skin red, and 0 leaves
                     this skin white. Values between them make washed red. */
    /* Height on the flanks below which the skin stays white. 0 is the belly, 1 is the back. */
    float belly;
    float ragged; /* Strength of the noise that deforms the edges of patches. */
    float soft;   /* Width of the edge between red and white, as a change of patch_depth(), > 0. */
    struct patch patches[PATCHES_MAX];
};

/* Goldfish for scooping are bred for numbers. Most are plain. The edges of their patches are soft,
 * and the patches have none of the shapes that breeders of koi select. */
/* clang-format off */
static const struct design designs[PATTERN_LAYERS] = {
    /* Pattern "red": all red, the most common pattern of a wakin (common goldfish). */
    { .base = 1.0f, .soft = 0.035f },
    /* Pattern "pale belly": red back and flanks, and a pale belly. */
    { .base = 1.0f, .belly = 0.36f, .ragged = 0.06f, .soft = 0.22f },
    /* Pattern "pale flanks": only the back is red. */
    { .base = 1.0f, .belly = 0.58f, .ragged = 0.10f, .soft = 0.26f },
    /* Pattern "washed": red, and paler toward the tail, without an edge. */
    { 0.50f, 0.26f, 0.12f, 0.40f,
      { { 0.16f, 0.0f, 0.46f, 0.60f }, { 0.70f, 0.02f, 0.34f, 0.30f } } },
    /* Pattern "washed flank": red head, back and tail, and one flank that is paler up to the back
     * behind the gill cover. No pale band runs round the body. */
    { 0.12f, 0.24f, 0.20f, 0.30f,
      { { 0.08f, 0.0f, 0.28f, 0.60f }, { 0.52f, 0.91f, 0.60f, 0.27f },
        { 0.98f, 0.0f, 0.22f, 0.60f } } },
    /* Pattern "blotches": white, with one washed patch of red on the left of the back. */
    { 0.0f, 0.14f, 0.26f, 0.30f,
      { { 0.34f, 0.88f, 0.30f, 0.26f }, { 0.56f, 0.92f, 0.20f, 0.20f } } },
    /* Pattern "white": white, with a trace of red at the tail and on a cheek. */
    { 0.0f, 0.05f, 0.20f, 0.26f,
      { { 0.94f, 0.0f, 0.09f, 0.30f }, { 0.17f, 0.16f, 0.06f, 0.08f } } },
};
/* clang-format on */

/* Returns the distance round the girth from `centre` to `v`, in body lengths. The distance is
 * positive if `v` increases in this direction. */
static float round_distance(float v, float centre)
{
    const float d = v - centre;
    return (d - roundf(d)) * GIRTH;
}

/* Returns a value above 0 inside the union of the patches, otherwise below 0. Patches that nearly
 * touch are merged. */
static float patch_depth(const struct design *design, float u, float v)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < PATCHES_MAX && design->patches[i].length > 0.0f; i++) {
        const struct patch *patch = &design->patches[i];
        assert(patch->width > 0.0f);
        const float du = (u - patch->u) / patch->length;
        const float dv = round_distance(v, patch->v) / patch->width;
        sum += expf(-1.6f * (du * du + dv * dv));
    }
    /* A single patch ends at its half length and half width, because the sum there is exp(-1.6) =
     * 0.202. */
    return sum - 0.202f;
}

static float redness(uint32_t layer, float u, float v)
{
    assert(layer < PATTERN_LAYERS);
    const struct design *design = &designs[layer];
    const float coarse =
        noise_2d_sum(u * 5.0f + 0.5f, v * 5.0f, 64, 5, 100u + layer * 8u, 3) - 0.5f;
    const float fine = noise_2d_sum(u * 19.0f, v * 16.0f, 64, 16, 104u + layer * 8u, 2) - 0.5f;
    const float edge = design->ragged * (2.2f * coarse + 0.55f * fine);
    const float patches = noise_ramp(-design->soft, design->soft, patch_depth(design, u, v) + edge);
    /* `from_belly` is the height of the point on the flank: 0 is the belly, and 1 is the back. */
    const float from_belly = fabsf(round_distance(v, 0.5f)) / GIRTH * 2.0f;
    const float height = (from_belly - design->belly) * 2.0f + 0.6f * edge;
    const float above =
        design->belly > 0.0f ? noise_ramp(-design->soft, design->soft, height) : 1.0f;
    /* Red skin is slightly washed in places, so that it is not one flat colour. */
    const float wash = noise_2d_sum(u * 9.0f, v * 8.0f, 64, 8, 90u + layer, 3);
    const float washed = 1.0f - 0.30f * noise_ramp(0.48f, 0.85f, wash);
    return noise_mix(design->base, 1.0f, patches) * above * washed;
}

/* Returns the brightness of a scale at a point of the skin. Each scale covers the head side of the
 * next scale. A scale is bright near its rounded rim, and the rims are a fine dark net. */
static float scale_light(uint32_t layer, float u, float v)
{
    const float row = (u - GILL) / (1.0f - GILL) * SCALE_ROWS;
    float light = 0.5f;
    /* The scales of up to three rows cover the point (u, v). The scale nearest to the head is the
     * visible one. */
    for (int32_t i = 0; i < 3; i++) {
        const float centre = floorf(row) - (float)i + 0.5f;
        const float odd = fmodf(centre - 0.5f + 64.0f, 2.0f) * 0.5f;
        const float column = v * SCALES_ROUND + odd;
        const float du = row - centre, dv = column - floorf(column) - 0.5f;
        const float d = sqrtf(du * du * 0.40f + dv * dv * 2.6f);
        if (d < 1.0f) {
            const float own = noise_hash01((int32_t)centre, (int32_t)floorf(column), 300u + layer);
            light = noise_mix(0.56f, 0.78f + 0.22f * own, noise_ramp(0.15f, 0.80f, d)) *
                    (1.0f - 0.50f * noise_ramp(0.78f, 0.98f, d));
        }
    }
    const float back = 0.5f + 0.5f * cosf(TAU * v);
    const float fade = noise_ramp(GILL - 0.02f, GILL + 0.16f, u) * noise_ramp(0.05f, 0.35f, back);
    /* `flank` is the distance of the point from the middle of the right or left flank, as a
     * fraction of the girth. */
    const float flank = 0.25f - fabsf(v - 0.5f);
    const float gill = expf(-powf((u - GILL - 0.03f * (fabsf(flank) - 0.12f)) / 0.011f, 2.0f));
    const float mottle = noise_2d_sum(u * 14.0f, v * 12.0f, 64, 12, 80u + layer, 3) - 0.5f;
    return noise_mix(0.72f, light, fade) * (1.0f + 0.40f * mottle) -
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
                texel[1] = noise_to_u8(scale_light(layer, u, v));
            }
        }
    }
}
