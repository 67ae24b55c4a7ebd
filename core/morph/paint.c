/* paint.c -- what a fish's skin looks like at a point: the coats of its keys, blended.
 *
 * Colours blend in the keys' proportions, so a mark that the next key has not fades as the fish
 * grows; nothing jumps. */
#include "core/morph/mark.h"
#include "core/morph/morph.h"

#include "core/base/panic.h"

#define PUPIL 0.52f       /* Of the eye's visible radius. */
#define IRIS_SHINE 0.6f
#define BACK_SHINE 0.35f  /* Of the flank's: scales lie there under dark skin. */
#define MARK_OPAQUE 0.85f /* Pigment on a larva of glass is seen; a little shows through it. */

static vec3 rgb(uint32_t colour)
{
    const float scale = 1.0f / 255.0f;
    return v3((float)(colour >> 16 & 255u) * scale, (float)(colour >> 8 & 255u) * scale,
              (float)(colour & 255u) * scale);
}

/* Black pupil, iris with a darker rim, and behind it the skin's own colour. */
static struct paint eye_paint(const struct species_coat *coat, float u)
{
    const vec3 black = v3(0.015f, 0.015f, 0.02f);
    const float rim = f_smoothstep(0.78f, 1.0f, u);
    const vec3 iris = v3_scale(rgb(coat->iris), 1.0f - 0.45f * rim);
    const float outside = f_smoothstep(PUPIL - 0.06f, PUPIL + 0.06f, u);
    const float behind = f_smoothstep(1.05f, 1.25f, u);
    const vec3 seen = v3_lerp(black, iris, outside);
    return (struct paint){ .colour = v3_lerp(seen, rgb(coat->flank), behind),
                           .shine = IRIS_SHINE * outside * (1.0f - behind) };
}

/* Back over flank to belly, by the way round the girth. */
static struct paint skin_paint(const struct species_coat *coat, float down)
{
    const float flank = f_smoothstep(0.1f, 0.5f, down), belly = f_smoothstep(0.6f, 0.95f, down);
    const vec3 upper = v3_lerp(rgb(coat->back), rgb(coat->flank), flank);
    const float shine = (float)coat->shine / 255.0f;
    return (struct paint){ .colour = v3_lerp(upper, rgb(coat->belly), belly),
                           .shine = shine * f_lerp(BACK_SHINE, 1.0f, flank),
                           .clear = (float)coat->clear / 255.0f };
}

static struct paint coat_paint(const struct species_coat *coat, const struct mark_point *at)
{
    struct paint paint;
    CORE_ASSERT(coat->mark_count <= MARK_MAX);
    if (at->part == PART_EYE) {
        paint = eye_paint(coat, at->u);
    } else if (at->part == PART_BODY) {
        paint = skin_paint(coat, at->down);
    } else {
        paint = (struct paint){ .colour = rgb(coat->fin), .clear = (float)coat->clear / 255.0f };
    }
    for (uint32_t i = 0; i < coat->mark_count; i++) {
        const float cover = mark_cover(&coat->marks[i], at);
        paint.colour = v3_lerp(paint.colour, rgb(coat->marks[i].colour), cover);
        paint.clear *= 1.0f - MARK_OPAQUE * cover;
    }
    return paint;
}

struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at)
{
    const struct mark_point point = mark_point_of(at, (enum body_form)species->card.form);
    struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
    float sum = 1e-6f;
    CORE_ASSERT(species->card.form <= FORM_PUFFER);
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        const float weight = weights[key];
        if (weight > 0.0f) { /* What is solved may be negative: no colour is less than none. */
            const struct paint coat = coat_paint(&species->coats[key], &point);
            paint.colour = v3_mad(paint.colour, coat.colour, weight);
            paint.clear += weight * coat.clear;
            paint.shine += weight * coat.shine;
            sum += weight;
        }
    }
    paint.colour = v3_scale(paint.colour, 1.0f / sum);
    paint.clear /= sum;
    paint.shine /= sum;
    return paint;
}
