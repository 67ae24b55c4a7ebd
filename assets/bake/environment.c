/* environment.c -- bakes the environment that the water reflects: a summer night over the stall,
 * with its lanterns.
 *
 * The picture is a paraboloid map of the upper half space, so that a shader needs no
 * trigonometry. A direction (x, y, z) with y >= 0 is at uv = 0.5 + 0.5 * (x, z) / (1 + y). The
 * middle of the picture is the zenith. Row 0 is the far side (-z), whose reflection a player
 * sees on the water. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <math.h>

struct colour {
    float r, g, b;
};

static void glow(struct colour *at, struct colour light, float amount)
{
    assert(amount >= 0.0f);
    at->r += light.r * amount;
    at->g += light.g * amount;
    at->b += light.b * amount;
}

/* Adds two strings of lanterns at the far side of the stall and one above the player's head. */
static void add_lanterns(struct colour *at, float x, float y, float z)
{
    /* The green of a colour is the root of red * blue, because the water keeps only these two
     * (mirror.frag.glsl). */
    static const struct colour paper = { 1.0f, 0.49f, 0.24f }, red = { 1.0f, 0.32f, 0.10f };
    static const float rows[3][3] = { { -0.85f, 0.50f, 7.0f },
                                      { -0.45f, 0.80f, 6.0f },
                                      /* A row gives the position z, the height and the number
                                       * of lanterns of a string of lanterns. */
                                      { 0.35f, 0.90f, 5.0f } };
    for (uint32_t row = 0; row < 3; row++) {
        const int32_t count = (int32_t)rows[row][2];
        for (int32_t i = 0; i < count; i++) {
            const float t = ((float)i + 0.5f) / (float)count * 2.0f - 1.0f;
            const float lx = t * 1.1f, lz = rows[row][0];
            const float ly =
                rows[row][1] - 0.16f * (1.0f - t * t) + 0.03f * noise_hash01(i, 1, row);
            const float inv = 1.0f / sqrtf(lx * lx + ly * ly + lz * lz);
            const float dx = x - lx * inv, dy = (y - ly * inv) * 0.82f, dz = z - lz * inv;
            const float d2 = dx * dx + dy * dy + dz * dz;
            /* Small waves, which the picture of the slopes lacks, draw a reflection out toward the
             * viewer into a streak. The shader breaks the streak into glints. */
            const float streak = dx * dx * 1000.0f + (dy * dy + dz * dz) * 90.0f;
            const struct colour light = noise_hash01(i, 7, row) < 0.35f ? red : paper;
            glow(at, light, 1.1f * expf(-streak));
            glow(at, light, 0.10f * expf(-d2 * 40.0f));
        }
    }
}

/* Adds the beam and the striped edge of the awning at the far side of the stall. */
static void add_awning(struct colour *at, float x, float y, float z)
{
    /* `up` is the height of a direction divided by its distance toward the far side (-z), which is
     * the tangent of the elevation angle. */
    const float up = y / fmaxf(-z, 0.02f);
    const float inside =
        z < 0.0f ? noise_ramp(0.22f, 0.25f, up) * noise_ramp(0.42f, 0.39f, up) : 0.0f;
    const float stripe = noise_ramp(-0.12f, 0.12f, sinf(x / fmaxf(-z, 0.02f) * 14.0f));
    at->r = noise_mix(at->r, noise_mix(0.30f, 0.34f, stripe), inside);
    at->g = noise_mix(at->g, noise_mix(0.045f, 0.27f, stripe), inside);
    at->b = noise_mix(at->b, noise_mix(0.04f, 0.20f, stripe), inside);
}

void bake_environment(uint8_t *rgb8)
{
    for (uint32_t row = 0; row < ENVIRONMENT_SIZE; row++) {
        for (uint32_t column = 0; column < ENVIRONMENT_SIZE; column++) {
            const float px = ((float)column + 0.5f) / (float)ENVIRONMENT_SIZE * 2.0f - 1.0f;
            const float pz = ((float)row + 0.5f) / (float)ENVIRONMENT_SIZE * 2.0f - 1.0f;
            /* The corners of the picture lie outside the round map. These corners repeat the
             * colour of the horizon. */
            const float r2 = fminf(px * px + pz * pz, 1.0f);
            const float y = (1.0f - r2) / (1.0f + r2), x = px * (1.0f + y), z = pz * (1.0f + y);
            const float low = expf(-3.2f * y);
            const float cloud = noise_2d_sum(x * 3.0f + 8.0f, z * 3.0f + 8.0f, 4096, 4096, 71, 4);
            struct colour at = { 0.018f, 0.030f, 0.085f };          /* Colour of the night sky. */
            glow(&at, (struct colour){ 0.16f, 0.09f, 0.10f }, low); /* Glow of the fair's lights
                                                                       near the horizon. */
            glow(&at, (struct colour){ 0.05f, 0.06f, 0.11f },
                 noise_ramp(0.45f, 0.75f, cloud) * (1.0f - low));
            add_awning(&at, x, y, z);
            add_lanterns(&at, x, y, z);
            uint8_t *texel = rgb8 + (row * ENVIRONMENT_SIZE + column) * 3u;
            texel[0] = noise_to_u8(at.r);
            texel[1] = noise_to_u8(at.g);
            texel[2] = noise_to_u8(at.b);
        }
    }
}
