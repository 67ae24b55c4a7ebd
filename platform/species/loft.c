/* loft.c -- converts the smooth shape of each key (modelled growth stage) to a mesh of rings along
 * the body, and computes the masks of each vertex (the influence of each growth curve on the
 * vertex). loft_parts.c adds the fins and the eyes.
 *
 * All keys of a species use equal numbers of rings, spokes and rays. Each vertex therefore has a
 * corresponding vertex in every other key. The morph requires this of its input shapes (2005
 * thesis, section 3.1). */
#include "platform/species/loft_parts.h"

#include <math.h>
#include <string.h>

#include "core/base/panic.h"

#define RINGS_MAX 64
/* Position of the additional ring that makes the rear end of the body round. The position is a
 * fraction of the way from the last ordinary ring (0) to the body's last point (1). */
#define CAP_AT 0.6
/* Ratio of the backward component to the outward component of the normals on the additional ring at
 * the rear end of the body. */
#define CAP_FACES 0.8

/* clang-format off */
const struct detail species_detail[SPECIES_LOD_COUNT] = {
    { .rings = 24, .spokes = 16, .round_end = true, .eye_rings = 5, .eye_spokes = 14,
      .fins = { [PART_TAIL] = { 11, 5 }, [PART_DORSAL] = { 13, 4 }, [PART_ANAL] = { 8, 4 },
                [PART_PECTORAL] = { 6, 3 }, [PART_PELVIC] = { 5, 3 },
                [PART_DORSAL_2] = { 6, 3 } } },
    { .rings = 8, .spokes = 8, .eye_rings = 2, .eye_spokes = 5,
      .fins = { [PART_TAIL] = { 5, 3 }, [PART_DORSAL] = { 5, 2 }, [PART_ANAL] = { 3, 2 },
                [PART_PECTORAL] = { 3, 2 }, [PART_PELVIC] = { 3, 2 },
                [PART_DORSAL_2] = { 3, 2 } } },
};
/* clang-format on */

const v3d loft_snout = { 0.0, 0.0, -0.5 };

/* ---- Positions of the rings ------------------------------------------------------------------ */

/* This section computes the positions of the rings along the body.
 *
 * The rings have equal body coordinates in every key, and are closer to each other where the
 * outline of any key bends. Between two rings, the outline of the mesh is a straight line. The
 * distance of this line from the smooth outline is proportional to the curvature multiplied by the
 * square of the ring distance. A ring density proportional to the square root of the curvature
 * therefore gives the same error everywhere. */

#define RING_SAMPLES 256
/* Fraction of the rings that is spaced evenly, independent of the curvature. These rings are needed
 * because the swimming wave bends the whole body. */
#define EVEN_SHARE 0.30
/* Factor by which rings are denser on the head, because viewers look mostly at the mouth, the eyes
 * and the gill cover. */
#define HEAD_FAVOUR 1.9

/* Writes three values of a key's outlines at body coordinate `u` to `out`: the height of the back,
 * the height of the belly, and the distance of the flank from the middle. The values are fractions
 * of the key's length. */
static void body_outline_at(const struct key_text *key, double u, double out[3])
{
    const struct station s = shape_section(key, shape_body_x(key, u));
    out[0] = (double)s.offset + 0.5 * (double)s.depth;
    out[1] = (double)s.offset - 0.5 * (double)s.depth;
    out[2] = 0.5 * (double)s.width;
}

/* Writes the body coordinate u of each of `count` rings to `u`. The last ring is at u = 1. The
 * rings are closer to each other where an outline bends in any key. */
static void place_rings(const struct species_text *species, uint32_t count, double *u)
{
    double sum[RING_SAMPLES + 1] = { 0.0 };
    for (int i = 0; i < RING_SAMPLES; i++) {
        const double at =
            fmin(fmax((i + 0.5) / RING_SAMPLES, 1.0 / RING_SAMPLES), 1.0 - 1.0 / RING_SAMPLES);
        /* `most` is the largest curvature that any outline of any key has at body coordinate
         * `at`. */
        const double d = 1.0 / RING_SAMPLES;
        double most = 0.0;
        for (uint32_t key = 0; key < species->card.key_count; key++) {
            double before[3], here[3], after[3];
            body_outline_at(&species->keys[key], at - d, before);
            body_outline_at(&species->keys[key], at, here);
            body_outline_at(&species->keys[key], at + d, after);
            for (int k = 0; k < 3; k++) {
                most = fmax(most, fabs(before[k] - 2.0 * here[k] + after[k]) / (d * d));
            }
        }
        sum[i + 1] = sum[i] + sqrt(most) * (at < (double)GILL_U ? HEAD_FAVOUR : 1.0);
    }
    const double even =
        EVEN_SHARE / (1.0 - EVEN_SHARE) * fmax(sum[RING_SAMPLES], 1e-9) / RING_SAMPLES;
    for (int i = 0; i <= RING_SAMPLES; i++) {
        sum[i] += even * i;
    }
    int i = 0;
    for (uint32_t ring = 0; ring < count; ring++) {
        const double wanted = sum[RING_SAMPLES] * (ring + 1) / count;
        while (i < RING_SAMPLES - 1 && sum[i + 1] < wanted) {
            i++;
        }
        u[ring] = fmin((i + (wanted - sum[i]) / (sum[i + 1] - sum[i])) / RING_SAMPLES, 1.0);
    }
    u[count - 1] = 1.0;
    /* Move the nearest ring to the rear edge of the gill cover, where the head and the
     * trunk meet. */
    uint32_t nearest = 0;
    for (uint32_t ring = 1; ring < count; ring++) {
        if (fabs(u[ring] - (double)GILL_U) < fabs(u[nearest] - (double)GILL_U)) {
            nearest = ring;
        }
    }
    u[nearest] = (double)GILL_U;
}

/* ---- Masks: weights of the deformation curves at each vertex --------------------------------- */

/* This section computes the weight with which each deformation curve moves each vertex. The weights
 * change smoothly on skin that several parts share.
 *
 * Fins and eyes are attached to anchors, so that a single curve can move them completely
 * without tearing the mesh. The head, the trunk, the painted areas and the tail share their skin
 * with neighbouring parts. */

/* Half of the width of the transition from the head to the trunk, in units of the body coordinate
 * u. */
#define GILL_SOFT 0.07
/* Position along the tail fin, as a fraction of the fin's length. A vertex behind this position is
 * moved only by the deformation curve of the tail fin. */
#define TAIL_SOFT 0.6
#define TAIL_ROOT_U 0.965 /* Body coordinate u of the tail fin's root. */

static double ramp(double from, double to, double x)
{
    const double t = fmin(fmax((x - from) / (to - from), 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/* Returns the index of the deformation curve that moves `part`. Index 0 is the curve of the whole
 * fish. */
static uint8_t curve_of(const struct species_text *species, uint32_t part)
{
    for (uint32_t curve = 1; curve < species->card.curve_count; curve++) {
        if (species->curves[curve].parts >> part & 1u) {
            return (uint8_t)curve;
        }
    }
    return 0;
}

/* Writes the weight of each deformation curve at the point (u, v) of the body's skin to `share`.
 * The weights sum to 1. The curve of the whole fish receives the difference between 1 and the sum
 * of the other curves' weights. */
static void skin_share(const struct species_text *species, double u, double v,
                       double share[MORPH_CURVE_MAX])
{
    const double trunk = ramp((double)GILL_U - GILL_SOFT, (double)GILL_U + GILL_SOFT, u);
    double sum = 0.0;
    for (uint32_t curve = 1; curve < MORPH_CURVE_MAX; curve++) {
        const struct curve_text *c = &species->curves[curve];
        share[curve] = 0.0;
        if (curve < species->card.curve_count) {
            share[curve] = (c->parts >> PART_HEAD & 1u ? 1.0 - trunk : 0.0) +
                           (c->parts >> PART_TRUNK & 1u ? trunk : 0.0);
            for (uint32_t i = 0; i < c->area_count; i++) {
                /* Computes the curve's weight at the point (u, v) from one of its painted areas.
                 * The weight is 1 inside the area, and falls to 0 at the distance `soft` outside
                 * the area's border. The positions of areas refer to the first key. */
                const struct area *area = &c->areas[i];
                const double from = (double)area->from, to = (double)area->to;
                const double low = (double)area->low, high = (double)area->high;
                const double x = shape_body_x(&species->keys[0], u), soft = (double)area->soft;
                const double y = 0.5 + 0.5 * cos(2.0 * 3.14159265358979323846 * v);
                share[curve] =
                    fmax(share[curve], ramp(from - soft, from, x) * (1.0 - ramp(to, to + soft, x)) *
                                           ramp(low - soft, low, y) *
                                           (1.0 - ramp(high, high + soft, y)));
            }
        }
        sum += share[curve];
    }
    for (uint32_t curve = 1; curve < MORPH_CURVE_MAX && sum > 1.0; curve++) {
        share[curve] /= sum;
    }
    share[0] = fmax(1.0 - sum, 0.0);
}

/* Computes the masks of every vertex. A mask is the weight with which a deformation curve moves the
 * vertex. */
static void paint_masks(struct lofting *l)
{
    for (uint32_t i = 0; i < l->loft->vertex_count; i++) {
        struct species_vertex *vertex = &l->loft->vertices[i];
        double share[MORPH_CURVE_MAX] = { 0.0 };
        uint32_t left = 255;
        const uint8_t own = curve_of(l->species, vertex->part);
        /* `rooted` is the fraction of the vertex's motion that comes from the deformation curve of
         * its own body part. The rest of the motion comes from the curves that move the skin. For
         * the tail fin, these are the curves of the skin at the tail root. */
        double rooted = 0.0;
        if (vertex->part == PART_TAIL) {
            skin_share(l->species, TAIL_ROOT_U, 0.25, share);
            rooted = ramp(0.0, TAIL_SOFT, (double)vertex->v);
        } else if (vertex->part == PART_BODY) {
            skin_share(l->species, (double)vertex->u, (double)vertex->v, share);
        } else {
            rooted = 1.0;
        }
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            const double skin = rooted < 1.0 ? share[curve] : 0.0;
            share[curve] = skin * (1.0 - rooted) + (curve == own ? rooted : 0.0);
        }
        for (uint32_t curve = MORPH_CURVE_MAX - 1; curve > 0; curve--) {
            const uint32_t part = (uint32_t)lround(255.0 * share[curve]);
            vertex->mask[curve] = (uint8_t)(part < left ? part : left);
            left -= vertex->mask[curve];
        }
        vertex->mask[0] = (uint8_t)left;
    }
}

/* ---- Mesh of the body ------------------------------------------------------------------------ */

uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex)
{
    CORE_ASSERT(l->loft->vertex_count < MESH_VERTEX_MAX);
    l->loft->vertices[l->loft->vertex_count] = vertex;
    return (uint16_t)l->loft->vertex_count++;
}

static vec3 single(v3d p)
{
    return (vec3){ (float)p.x, (float)p.y, (float)p.z };
}

void loft_place(struct lofting *l, uint32_t key, v3d origin, v3d offset, v3d normal)
{
    CORE_ASSERT(l->loft->vertex_count > 0);
    CORE_ASSERT(key < l->species->card.key_count);
    const uint32_t newest = l->loft->vertex_count - 1;
    l->loft->positions[key][newest] = single(v3d_muladd(origin, offset, 1.0 / l->unit[key]));
    l->loft->normals[key][newest] = single(normal);
}

void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c)
{
    CORE_ASSERT(a < l->loft->vertex_count && b < l->loft->vertex_count &&
                c < l->loft->vertex_count);
    CORE_ASSERT(l->loft->index_count + 3 <= MESH_INDEX_MAX);
    uint16_t *out = &l->loft->indices[l->loft->index_count];
    out[0] = (uint16_t)a;
    out[1] = (uint16_t)b;
    out[2] = (uint16_t)c;
    l->loft->index_count += 3;
}

struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, bool turns)
{
    CORE_ASSERT(l->loft->anchor_count < ANCHOR_MAX);
    struct species_anchor *anchor = &l->loft->anchors[l->loft->anchor_count++];
    anchor->curve = curve_of(l->species, part);
    anchor->turns = turns;
    return anchor;
}

/* Adds two vertices that close the body's surface at the snout (`u` = 0) or at the body's last
 * point (`u` = 1). Both vertices have the same position, on the body's axis. The first vertex
 * belongs to the right flank and the second vertex to the left flank. With a single vertex for both
 * flanks, the pattern coordinate v would jump at the belly. `normal` is the normal of the right
 * vertex, and its mirror image is the normal of the left vertex. Returns the index of the right
 * vertex. */
static uint32_t add_poles(struct lofting *l, double u, v3d normal)
{
    for (int side = 1; side >= -1; side -= 2) {
        loft_next_vertex(l, (struct species_vertex){ .u = (float)u,
                                                     .v = side > 0 ? 0.25f : 0.75f,
                                                     .anchor = ANCHOR_NONE });
        for (uint32_t key = 0; key < l->species->card.key_count; key++) {
            const struct station s = shape_section(&l->species->keys[key], u);
            const double z = u > 0.0 ? shape_body_end(&l->species->keys[key]) : 0.0;
            loft_place(l, key, loft_snout, (v3d){ 0.0, (double)s.offset, z },
                       (v3d){ normal.x * side, normal.y, normal.z });
        }
    }
    return l->loft->vertex_count - 2;
}

static void add_body(struct lofting *l)
{
    const uint32_t rings = l->detail->rings, spokes = l->detail->spokes;
    /* If detail->round_end is true, the mesh has one additional row of vertices behind the last
     * ring, which makes the rear end of the body round. This row is not part of the vertex grid,
     * because no anchor lies on the row. */
    const uint32_t rows = rings + (l->detail->round_end ? 1u : 0u);
    double u[RINGS_MAX + 1];
    CORE_ASSERT(rings <= RINGS_MAX);
    place_rings(l->species, rings, u);
    u[rings] = 1.0;
    const uint32_t snout = add_poles(l, 0.0, (v3d){ 0.0, 0.0, -1.0 });
    const uint32_t first = l->loft->vertex_count;
    for (uint32_t row = 0; row < rows; row++) {
        for (uint32_t spoke = 0; spoke <= spokes; spoke++) {
            const double v = (double)spoke / spokes;
            loft_next_vertex(l, (struct species_vertex){
                                    .u = (float)u[row], .v = (float)v, .anchor = ANCHOR_NONE });
            for (uint32_t key = 0; key < l->species->card.key_count; key++) {
                const struct key_text *text = &l->species->keys[key];
                v3d p = shape_body_point(text, u[row], v), n = shape_body_normal(text, u[row], v);
                if (row == rings) {
                    p = shape_end_point(text, CAP_AT, v);
                    n = v3d_unit(v3d_muladd(n, (v3d){ 0.0, 0.0, 1.0 }, CAP_FACES));
                }
                loft_place(l, key, loft_snout, p, n);
            }
        }
    }
    const uint32_t last = first + (rows - 1) * (spokes + 1);
    const uint32_t end = add_poles(l, 1.0, v3d_unit((v3d){ 1.0, 0.0, 0.3 }));
    for (uint32_t j = 0; j < spokes; j++) {
        const uint32_t left = 2 * j < spokes ? 0 : 1;
        loft_triangle(l, snout + left, first + j, first + j + 1);
        for (uint32_t row = first; row < last; row += spokes + 1) {
            const uint32_t a = row + j, b = a + 1, c = a + spokes + 1, d = c + 1;
            loft_triangle(l, a, c, b);
            loft_triangle(l, b, c, d);
        }
        loft_triangle(l, last + j, end + left, last + j + 1);
    }
    l->loft->grid_first = first;
    l->loft->grid_rings = rings;
    l->loft->grid_spokes = spokes;
}

void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft)
{
    CORE_ASSERT(species->card.key_count <= MORPH_KEY_MAX);
    struct lofting l = { .species = species, .detail = detail, .loft = loft };
    memset(loft, 0, sizeof *loft);
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        l.unit[key] =
            shape_unit_length(&species->keys[key], (enum species_measure)species->card.measure);
    }
    add_body(&l);
    loft_add_eye(&l, 0);
    loft_add_eye(&l, 1);
    loft_add_fins(&l);
    paint_masks(&l);
    /* Sets `reach` to 1, 2 or 4 body lengths, the length that the largest packed coordinate
     * represents. A small `reach` gives a good resolution. `reach` must be at least `farthest`, the
     * largest absolute coordinate of the mesh. */
    float farthest = 0.0f;
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        for (uint32_t i = 0; i < loft->vertex_count; i++) {
            const vec3 p = loft->positions[key][i];
            farthest = fmaxf(farthest, fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z))));
        }
    }
    loft->reach = farthest <= 1.0f ? 1.0f : farthest <= 2.0f ? 2.0f : 4.0f;
}
