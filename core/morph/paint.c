/* paint.c -- what a fish's skin looks like at a point: the coats of its keys, blended. */
#include "core/morph/morph.h"

static vec3 rgb(uint32_t colour)
{
    const float scale = 1.0f / 255.0f;
    return v3((float)(colour >> 16 & 255u) * scale, (float)(colour >> 8 & 255u) * scale,
              (float)(colour & 255u) * scale);
}

/* Back over flank to belly, by the height round the girth. */
static vec3 coat_colour(const struct species_coat *coat, const struct species_vertex *at)
{
    if (at->part == PART_EYE) {
        return at->u < 0.6f ? v3(0.02f, 0.02f, 0.02f) : rgb(coat->iris);
    }
    if (at->part != PART_BODY) {
        return rgb(coat->fin);
    }
    const float under = 1.0f - f_abs(at->v * 2.0f - 1.0f); /* 0 at the back, 1 at the belly. */
    const vec3 upper = v3_lerp(rgb(coat->back), rgb(coat->flank), f_smoothstep(0.1f, 0.5f, under));
    return v3_lerp(upper, rgb(coat->belly), f_smoothstep(0.6f, 0.95f, under));
}

struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at)
{
    struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
    float sum = 1e-6f;
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        const struct species_coat *coat = &species->coats[key];
        const float weight = f_max(weights[key], 0.0f);
        paint.colour = v3_mad(paint.colour, coat_colour(coat, at), weight);
        paint.clear += weight * (float)coat->clear / 255.0f;
        paint.shine += weight * (float)coat->shine / 255.0f;
        sum += weight;
    }
    paint.colour = v3_scale(paint.colour, 1.0f / sum);
    paint.clear /= sum;
    paint.shine /= sum;
    return paint;
}
