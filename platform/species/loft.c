/* loft.c -- converts the smooth shape of each key (modelled growth stage) to a mesh: rings along
 * the body, fin sheets and eyes.
 *
 * All keys of a species use equal numbers of rings, spokes and rays. Each vertex therefore has a
 * corresponding vertex in every other key. The morph requires this of its input shapes (2005
 * thesis, section 3.1). */
#include "platform/species/loft_parts.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#define RINGS_MAX 64
/* Position of the additional ring that makes the end of the body round. 0 is the last ring, 1 is
 * the closing point. */
#define CAP_AT 0.6
/* Backward component of the last ring's normals, divided by their outward component. */
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

uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex)
{
    assert(l->loft->vertex_count < MESH_VERTEX_MAX);
    l->loft->vertices[l->loft->vertex_count] = vertex;
    return (uint16_t)l->loft->vertex_count++;
}

static vec3 single(v3d p)
{
    return (vec3){ (float)p.x, (float)p.y, (float)p.z };
}

void loft_place(struct lofting *l, uint32_t key, v3d p, v3d normal)
{
    const v3d snout = { 0.0, 0.0, -0.5 };
    l->loft->positions[key][l->loft->vertex_count - 1] =
        single(v3d_muladd(snout, p, 1.0 / l->unit[key]));
    l->loft->normals[key][l->loft->vertex_count - 1] = single(normal);
}

void loft_place_from_anchor(struct lofting *l, uint32_t key, v3d offset, v3d normal)
{
    const v3d anchor = { 0.0, 0.0, 0.0 };
    l->loft->positions[key][l->loft->vertex_count - 1] =
        single(v3d_muladd(anchor, offset, 1.0 / l->unit[key]));
    l->loft->normals[key][l->loft->vertex_count - 1] = single(normal);
}

void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c)
{
    assert(l->loft->index_count + 3 <= MESH_INDEX_MAX);
    uint16_t *out = &l->loft->indices[l->loft->index_count];
    out[0] = (uint16_t)a;
    out[1] = (uint16_t)b;
    out[2] = (uint16_t)c;
    l->loft->index_count += 3;
}

struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, uint8_t turns)
{
    assert(l->loft->anchor_count < ANCHOR_MAX);
    struct species_anchor *anchor = &l->loft->anchors[l->loft->anchor_count++];
    anchor->curve = loft_curve_of(l->species, part);
    anchor->turns = turns;
    return anchor;
}

/* Adds the closing points of the snout or of the tail root, which lie on the axis of the cross
 * section. Each flank has its own closing point, so that the pattern coordinate v does not jump at
 * the belly. `normal` is the normal of the right flank's point. Returns the index of the right
 * flank's point. */
static uint32_t add_poles(struct lofting *l, double u, v3d normal)
{
    for (int side = 1; side >= -1; side -= 2) {
        loft_next_vertex(l, (struct species_vertex){ .u = (float)u,
                                                     .v = side > 0 ? 0.25f : 0.75f,
                                                     .anchor = ANCHOR_NONE });
        for (uint32_t key = 0; key < l->species->key_count; key++) {
            const struct station s = shape_section(&l->species->keys[key], u);
            const double z = u > 0.0 ? shape_body_end(&l->species->keys[key]) : 0.0;
            loft_place(l, key, (v3d){ 0.0, (double)s.offset, z },
                       (v3d){ normal.x * side, normal.y, normal.z });
        }
    }
    return l->loft->vertex_count - 2;
}

static void add_ring(struct lofting *l, double u)
{
    for (uint32_t spoke = 0; spoke <= l->detail->spokes; spoke++) {
        const double v = (double)spoke / l->detail->spokes;
        loft_next_vertex(
            l, (struct species_vertex){ .u = (float)u, .v = (float)v, .anchor = ANCHOR_NONE });
        for (uint32_t key = 0; key < l->species->key_count; key++) {
            const struct key_text *text = &l->species->keys[key];
            loft_place(l, key, shape_body_point(text, u, v), shape_body_normal(text, u, v));
        }
    }
}

/* Adds a ring between the last ring and the closing points, which makes the end of the body round.
 * The ring is not part of the vertex grid because no anchor lies on the ring. */
static void add_cap_ring(struct lofting *l)
{
    for (uint32_t spoke = 0; spoke <= l->detail->spokes; spoke++) {
        const double v = (double)spoke / l->detail->spokes;
        loft_next_vertex(
            l, (struct species_vertex){ .u = 1.0f, .v = (float)v, .anchor = ANCHOR_NONE });
        for (uint32_t key = 0; key < l->species->key_count; key++) {
            const struct key_text *text = &l->species->keys[key];
            loft_place(l, key, shape_end_point(text, CAP_AT, v),
                       v3d_unit(v3d_muladd(shape_body_normal(text, 1.0, v), (v3d){ 0.0, 0.0, 1.0 },
                                           CAP_FACES)));
        }
    }
}

static void add_body(struct lofting *l)
{
    const uint32_t rings = l->detail->rings, spokes = l->detail->spokes;
    double u[RINGS_MAX];
    assert(rings <= RINGS_MAX);
    loft_place_rings(l->species, rings, u);
    const uint32_t snout = add_poles(l, 0.0, (v3d){ 0.0, 0.0, -1.0 });
    const uint32_t first = l->loft->vertex_count;
    for (uint32_t ring = 0; ring < rings; ring++) {
        add_ring(l, u[ring]);
    }
    if (l->detail->round_end) {
        add_cap_ring(l);
    }
    const uint32_t rows = rings + (l->detail->round_end ? 1u : 0u);
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

/* Returns the reach of the mesh, which is the length that the largest packed coordinate stands for.
 * The reach is the smallest of 1, 2 and 4 that no coordinate exceeds. */
static float reach_of(const struct loft *loft, uint32_t key_count)
{
    float farthest = 0.0f;
    for (uint32_t key = 0; key < key_count; key++) {
        for (uint32_t i = 0; i < loft->vertex_count; i++) {
            const vec3 p = loft->positions[key][i];
            farthest = fmaxf(farthest, fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z))));
        }
    }
    return farthest <= 1.0f ? 1.0f : farthest <= 2.0f ? 2.0f : 4.0f;
}

void species_loft(const struct species_text *species, const struct detail *detail,
                  struct loft *loft)
{
    struct lofting l = { .species = species, .detail = detail, .loft = loft };
    memset(loft, 0, sizeof *loft);
    for (uint32_t key = 0; key < species->key_count; key++) {
        l.unit[key] =
            shape_unit_length(&species->keys[key], (enum species_measure)species->measure);
    }
    add_body(&l);
    loft_add_eyes(&l);
    loft_add_fins(&l);
    loft_paint_masks(&l);
    loft->reach = reach_of(loft, species->key_count);
}
