/* loft_mask.c -- computes the weight with which each deformation curve moves each vertex. The
 * weights change smoothly on skin that several parts share.
 *
 * Fins and eyes are attached to anchors, so that a single curve can move them completely without
 * tearing the mesh. The head, the trunk, the painted areas and the tail share their skin with
 * neighbouring parts. */
#include "platform/species/loft_parts.h"

#include <math.h>

/* Half of the width of the transition from head to trunk, in body coordinate u. */
#define GILL_SOFT 0.07
/* Position along the tail fin, as a fraction of its length. Behind this position, only the tail
 * fin's own curve moves the fin. */
#define TAIL_SOFT 0.6
#define TAIL_ROOT_U 0.965 /* Body coordinate of the tail fin's root. */

static double ramp(double from, double to, double x)
{
    const double t = fmin(fmax((x - from) / (to - from), 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}

uint8_t loft_curve_of(const struct species_text *species, uint32_t part)
{
    for (uint32_t curve = 1; curve < species->curve_count; curve++) {
        if (species->curves[curve].parts >> part & 1u) {
            return (uint8_t)curve;
        }
    }
    return 0;
}

/* Returns the weight of the point (u, v) in a painted area. The weight is 1 inside the area and
 * falls to 0 at distance `soft` outside the area's border. The positions of areas refer to the
 * first key. */
static double in_area(const struct species_text *species, const struct area *a, double u, double v)
{
    const struct key_text *key = &species->keys[0];
    const double x = shape_body_x(key, u), soft = (double)a->soft;
    const double high = 0.5 + 0.5 * cos(2.0 * 3.14159265358979323846 * v);
    return ramp((double)a->from - soft, (double)a->from, x) *
           (1.0 - ramp((double)a->to, (double)a->to + soft, x)) *
           ramp((double)a->low - soft, (double)a->low, high) *
           (1.0 - ramp((double)a->high, (double)a->high + soft, high));
}

/* Writes the weight with which each curve moves the point (u, v) of the body's skin to `share`. The
 * weights sum to 1. The curve of the whole fish receives the weight that the other curves leave. */
static void skin_share(const struct species_text *species, double u, double v,
                       double share[MORPH_CURVE_MAX])
{
    const double trunk = ramp((double)GILL_U - GILL_SOFT, (double)GILL_U + GILL_SOFT, u);
    double sum = 0.0;
    for (uint32_t curve = 1; curve < MORPH_CURVE_MAX; curve++) {
        const struct curve_text *c = &species->curves[curve];
        share[curve] = 0.0;
        if (curve < species->curve_count) {
            share[curve] = (c->parts >> PART_HEAD & 1u ? 1.0 - trunk : 0.0) +
                           (c->parts >> PART_TRUNK & 1u ? trunk : 0.0);
            for (uint32_t i = 0; i < c->area_count; i++) {
                share[curve] = fmax(share[curve], in_area(species, &c->areas[i], u, v));
            }
        }
        sum += share[curve];
    }
    for (uint32_t curve = 1; curve < MORPH_CURVE_MAX && sum > 1.0; curve++) {
        share[curve] /= sum;
    }
    share[0] = fmax(1.0 - sum, 0.0);
}

static void vertex_share(const struct species_text *species, const struct species_vertex *vertex,
                         double share[MORPH_CURVE_MAX])
{
    const uint8_t own = loft_curve_of(species, vertex->part);
    double rooted = 0.0; /* Weight of the curve that moves the vertex's own body part. The rest of
                            the weight comes from the skin. */
    if (vertex->part == PART_TAIL) {
        skin_share(species, TAIL_ROOT_U, 0.25, share);
        rooted = ramp(0.0, TAIL_SOFT, (double)vertex->v);
    } else if (vertex->part == PART_BODY) {
        skin_share(species, (double)vertex->u, (double)vertex->v, share);
    } else {
        rooted = 1.0;
    }
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const double skin = rooted < 1.0 ? share[curve] : 0.0;
        share[curve] = skin * (1.0 - rooted) + (curve == own ? rooted : 0.0);
    }
}

void loft_paint_masks(struct lofting *l)
{
    for (uint32_t i = 0; i < l->loft->vertex_count; i++) {
        struct species_vertex *vertex = &l->loft->vertices[i];
        double share[MORPH_CURVE_MAX];
        uint32_t left = 255;
        vertex_share(l->species, vertex, share);
        for (uint32_t curve = MORPH_CURVE_MAX - 1; curve > 0; curve--) {
            const uint32_t part = (uint32_t)lround(255.0 * share[curve]);
            vertex->mask[curve] = (uint8_t)(part < left ? part : left);
            left -= vertex->mask[curve];
        }
        vertex->mask[0] = (uint8_t)left;
    }
}
