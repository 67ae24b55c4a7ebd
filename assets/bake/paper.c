/* paper.c -- bakes washi paper: long mulberry fibres at random positions over a soft cloud of
 * pulp. */
#include "assets/bake/bake.h"

#include <math.h>
#include <stdlib.h>

#define FIBRES 120u
#define FIBRE_STEPS 90u

/* Draws one fibre, either light or dark. The fibre changes its direction slightly at each step and
 * becomes thinner toward both ends. */
static void draw_fibre(float *sum, uint32_t *random)
{
    float x = noise_random01(random) * (float)PAPER_SIZE,
          y = noise_random01(random) * (float)PAPER_SIZE;
    float angle = noise_random01(random) * TAU, turn = 0.0f;
    const float strength =
        (noise_random01(random) < 0.3f ? -0.10f : 0.17f) * (0.4f + noise_random01(random));
    const uint32_t steps = FIBRE_STEPS / 3u + (uint32_t)(noise_random01(random) * FIBRE_STEPS);
    for (uint32_t i = 0; i < steps; i++) {
        const float along = (float)i / (float)steps;
        noise_add_light(sum, PAPER_SIZE, x, y, strength * 4.0f * along * (1.0f - along) * 0.6f);
        turn = 0.9f * turn + 0.08f * (noise_random01(random) - 0.5f);
        angle += turn;
        x += 0.6f * cosf(angle);
        y += 0.6f * sinf(angle);
    }
}

void bake_paper(uint8_t *r8)
{
    float *fibres = bake_alloc(PAPER_SIZE * PAPER_SIZE * sizeof *fibres);
    uint32_t random = 2005;
    for (uint32_t i = 0; i < FIBRES; i++) {
        draw_fibre(fibres, &random);
    }
    for (uint32_t y = 0; y < PAPER_SIZE; y++) {
        for (uint32_t x = 0; x < PAPER_SIZE; x++) {
            const float pulp = noise_2d_sum((float)x / 16.0f, (float)y / 16.0f, 8, 8, 61, 4) - 0.5f;
            const float speck = noise_hash01((int32_t)x, (int32_t)y, 62) - 0.5f;
            r8[y * PAPER_SIZE + x] =
                noise_to_u8(0.5f + 0.26f * pulp + 0.05f * speck + fibres[y * PAPER_SIZE + x]);
        }
    }
    free(fibres);
}
