/* paint.c -- computes the paint of a fish at a point of its surface by blending the coats of its
 * keys.
 *
 * A key is one modelled growth stage, and its coat is a list of colours and marks. Colours are
 * blended by the weights of the keys. Marks at the same index in the coats of two keys are treated
 * as one mark if same_mark() returns true, and the mark then moves as the fish grows. A mark that
 * the next key does not have fades out. Paint therefore never changes abruptly. */
#include "core/morph/mark.h"
#include "core/morph/morph.h"

#include "core/base/panic.h"

#define PUPIL 0.52f /* Radius of the pupil as a fraction of the eye's visible radius. */
#define IRIS_SHINE 0.6f
/* Shine of the back as a fraction of the flank's shine. The back shines less, because its scales
 * lie under dark skin. */
#define BACK_SHINE 0.35f
/* Body coordinate u of the place where the skin's paint begins to change into the tail fin's paint.
 * The change ends at the tail root, u = 1. */
#define STALK_FROM 0.96f
#define STALK_FIN 0.9f /* Fraction of the tail fin's paint in the blend at the tail root. */
/* Opacity of a mark on a transparent larva, which makes the mark slightly translucent. */
#define MARK_OPAQUE 0.85f

static vec3 rgb(uint32_t colour)
{
    const float scale = 1.0f / 255.0f;
    return v3((float)(colour >> 16 & 255u) * scale, (float)(colour >> 8 & 255u) * scale,
              (float)(colour & 255u) * scale);
}

/* Returns the paint of the point `at` of a coat without marks.
 *
 * The paint of an eyeball has three zones. The pupil is black. The iris around the pupil becomes
 * darker toward its outer edge. The rest of the eyeball, behind the outer edge of the iris, is
 * almost black. The rest is visible if the eye of a larva protrudes, and through the transparent
 * head of a larva. */
static struct paint bare_paint(const struct species_coat *coat, const struct mark_point *at)
{
    const float clear = (float)coat->clear / 255.0f;
    if (at->part == PART_EYE) {
        const vec3 black = v3(0.015f, 0.015f, 0.02f);
        const float rim = f_smoothstep(0.75f, 1.1f, at->u);
        const vec3 iris = v3_scale(rgb(coat->iris), 1.0f - 0.55f * rim);
        const float outside = f_smoothstep(PUPIL - 0.06f, PUPIL + 0.06f, at->u);
        const float lining = f_smoothstep(1.0f, 1.3f, at->u);
        return (struct paint){ .colour = v3_lerp(black, iris, outside * (1.0f - 0.9f * lining)),
                               .shine = IRIS_SHINE * outside * (1.0f - rim) };
    }
    if (at->part == PART_BODY) {
        const float flank = f_smoothstep(0.1f, 0.5f, at->down);
        const float belly = f_smoothstep(0.6f, 0.95f, at->down);
        const vec3 upper = v3_lerp(rgb(coat->back), rgb(coat->flank), flank);
        const float shine = (float)coat->shine / 255.0f;
        return (struct paint){ .colour = v3_lerp(upper, rgb(coat->belly), belly),
                               .shine = shine * f_lerp(BACK_SHINE, 1.0f, flank),
                               .clear = clear };
    }
    return (struct paint){ .colour = rgb(coat->fin), .clear = clear };
}

/* Returns true if two marks at the same index in two coats count as one mark that changes its place
 * or colour. For scattered spots, both marks must also cover equal areas, because spots in a
 * different area have different random places. */
static bool same_mark(const struct species_mark *a, const struct species_mark *b)
{
    const bool field =
        a->from == b->from && a->to == b->to && a->low == b->low && a->high == b->high;
    return a->kind == b->kind && a->part == b->part && a->count == b->count && a->seed == b->seed &&
           (a->kind != MARK_SPOTS || field);
}

/* Weighted mean of one mark over the keys that have the mark. */
struct mark_mean {
    struct species_mark mark;
    vec3 colour;
    float share;
};

static void mix_mark(struct mark_mean *mean, const struct species_mark *m, float share)
{
    CORE_ASSERT(share > 0.0f);
    mean->share += share;
    const float t = share / mean->share;
    mean->colour = v3_lerp(mean->colour, rgb(m->colour), t);
    mean->mark.from = f_lerp(mean->mark.from, m->from, t);
    mean->mark.to = f_lerp(mean->mark.to, m->to, t);
    mean->mark.width = f_lerp(mean->mark.width, m->width, t);
    mean->mark.slant = f_lerp(mean->mark.slant, m->slant, t);
    mean->mark.low = f_lerp(mean->mark.low, m->low, t);
    mean->mark.high = f_lerp(mean->mark.high, m->high, t);
}

/* Paints the marks at index `slot` of all coats over `paint`. A mark that several keys have is
 * painted once, at the weighted mean of its places in these keys. A mark that only some keys have
 * is painted with the sum of the weights of these keys as its opacity. */
static void paint_marks(const struct species *species, const float *share, uint32_t slot,
                        const struct mark_point *at, struct paint *paint)
{
    uint32_t laid = 0; /* Keys whose mark has been painted. Bit i belongs to key i. */
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        const struct species_coat *coat = &species->coats[key];
        if (share[key] <= 0.0f || slot >= coat->mark_count || (laid >> key & 1u)) {
            continue;
        }
        struct mark_mean mean = { .mark = coat->marks[slot] };
        for (uint32_t other = key; other < species->card.key_count; other++) {
            const struct species_coat *also = &species->coats[other];
            if (share[other] > 0.0f && slot < also->mark_count &&
                same_mark(&coat->marks[slot], &also->marks[slot])) {
                mix_mark(&mean, &also->marks[slot], share[other]);
                laid |= 1u << other;
            }
        }
        const float cover = mean.share * mark_cover(&mean.mark, at);
        paint->colour = v3_lerp(paint->colour, mean.colour, cover);
        paint->clear *= 1.0f - MARK_OPAQUE * cover;
    }
}

/* Returns the weighted mean of the keys' paints at a point, including all marks. share[i] is the
 * weight of key i, and the weights sum to 1. `slots` is the highest number of marks in the coat of
 * any key with a positive weight. */
static struct paint paint_of_marks(const struct species *species, const float *share,
                                   uint32_t slots, const struct species_vertex *at)
{
    CORE_ASSERT(slots <= MARK_MAX);
    const struct mark_point point = mark_point_of(at, (enum body_form)species->card.form);
    struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        if (share[key] > 0.0f) {
            const struct paint bare = bare_paint(&species->coats[key], &point);
            paint.colour = v3_muladd(paint.colour, bare.colour, share[key]);
            paint.clear += share[key] * bare.clear;
            paint.shine += share[key] * bare.shine;
        }
    }
    for (uint32_t slot = 0; slot < slots; slot++) {
        paint_marks(species, share, slot, &point, &paint);
    }
    return paint;
}

struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at)
{
    float share[MORPH_KEY_MAX], sum = 0.0f;
    uint32_t slots = 0;
    CORE_ASSERT(species->card.form <= FORM_PUFFER);
    CORE_ASSERT(species->card.key_count <= MORPH_KEY_MAX);
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        share[key] = f_max(weights[key], 0.0f); /* Negative weights, which occur with exaggerated
                                                   key shapes, are set to 0, because a colour cannot
                                                   have a negative weight. */
        sum += share[key];
    }
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        CORE_ASSERT(species->coats[key].mark_count <= MARK_MAX);
        share[key] /= f_max(sum, 1e-6f);
        if (share[key] > 0.0f && species->coats[key].mark_count > slots) {
            slots = species->coats[key].mark_count;
        }
    }
    struct paint paint = paint_of_marks(species, share, slots, at);
    if (at->part == PART_BODY && at->u > STALK_FROM && species->card.motion != MOTION_WING) {
        /* The skin's paint is blended into the tail fin's paint near the tail root, so that the
         * skin does not end in a visible edge on the fin. */
        const float down = 1.0f - f_abs(at->v * 2.0f - 1.0f);
        const struct species_vertex root = { .u = down, .part = PART_TAIL };
        const struct paint fin = paint_of_marks(species, share, slots, &root);
        const float fin_share = STALK_FIN * f_smoothstep(STALK_FROM, 1.0f, at->u);
        paint.colour = v3_lerp(paint.colour, fin.colour, fin_share);
        paint.shine *= 1.0f - fin_share;
    }
    return paint;
}
