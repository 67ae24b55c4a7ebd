/* barrel.h -- a simple fish species for tests: a body of the shape of a barrel, with an eye and a
 * fin ray. Each of its three key shapes (modelled growth stages) has a constant radius. The species
 * is so simple that results can be computed by hand. Lengths are in body lengths. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_BARREL_H
#define KINGYO_TESTS_UNIT_SUPPORT_BARREL_H

#include "core/morph/morph.h"

#define BARREL_RINGS 5u
#define BARREL_SPOKES 16u
#define BARREL_GRID (BARREL_RINGS * (BARREL_SPOKES + 1u))
/* Index of the eye's vertex, which is 0.01 outside the skin. */
#define BARREL_EYE BARREL_GRID
/* Index of the fin ray's vertex, which is 0.02 above the root of the ray. */
#define BARREL_RAY (BARREL_GRID + 1u)
#define BARREL_VERTICES (BARREL_GRID + 2u)

struct barrel {
    struct species_vertex vertices[BARREL_VERTICES];
    struct species_point points[3][BARREL_VERTICES];
    struct species_anchor anchors[2];
    struct species species;
};

/* Returns a length as a 16-bit fixed-point number, in steps of 1/32767. */
static int16_t barrel_count(float x)
{
    return (int16_t)(x * 32767.0f + (x < 0.0f ? -0.5f : 0.5f));
}

/* Returns a packed point with position `p` and normal `n`. */
static struct species_point barrel_point(vec3 p, vec3 n)
{
    return (struct species_point){ barrel_count(p.x), barrel_count(p.y), barrel_count(p.z),
                                   morph_fold_normal(n) };
}

/* Initializes the species. The radius is 0.1, 0.1 and 0.2 in its three keys. From key to key, the
 * eye moves around the body: from the right flank (v = 0.25) over the back (0) to the left flank
 * (-0.25). The root of the fin ray moves forward along the back (u = 0.75, 0.5, 0.25). */
static void barrel_init(struct barrel *b)
{
    static const float radius[3] = { 0.1f, 0.1f, 0.2f };
    *b = (struct barrel){ 0 };
    for (uint32_t i = 0; i < BARREL_VERTICES; i++) {
        const uint32_t ring = i / (BARREL_SPOKES + 1u), spoke = i % (BARREL_SPOKES + 1u);
        struct species_vertex *vertex = &b->vertices[i];
        *vertex = (struct species_vertex){ .anchor = ANCHOR_NONE, .mask = { 255 } };
        for (uint32_t key = 0; key < 3 && i < BARREL_GRID; key++) {
            vertex->u = (float)ring / (float)(BARREL_RINGS - 1u);
            vertex->v = (float)spoke / (float)BARREL_SPOKES;
            const float angle = vertex->v * F_TAU;
            const vec3 out = v3(f_sin(angle), f_cos(angle), 0.0f);
            b->points[key][i] =
                barrel_point(v3(out.x * radius[key], out.y * radius[key], vertex->u - 0.5f), out);
        }
    }
    b->vertices[BARREL_EYE].anchor = 0;
    b->vertices[BARREL_RAY].anchor = 1;
    b->anchors[0] = (struct species_anchor){ .turns = 1,
                                             .u = { 0.25f, 0.25f, 0.25f },
                                             .v = { 0.25f, 0.0f, -0.25f } };
    b->anchors[1] = (struct species_anchor){ .u = { 0.75f, 0.5f, 0.25f } };
    for (uint32_t key = 0; key < 3; key++) {
        b->points[key][BARREL_EYE] = barrel_point(v3(0.01f, 0.0f, 0.0f), v3(1.0f, 0.0f, 0.0f));
        b->points[key][BARREL_RAY] = barrel_point(v3(0.0f, 0.02f, 0.0f), v3(1.0f, 0.0f, 0.0f));
    }
    struct species *s = &b->species;
    s->card = (struct species_card){
        .id = "barrel",
        .key_count = 3,
        .curve_count = 1,
        .thesis_key = { 0, 1, 2 },
        .thesis_template = TEMPLATE_SIMULTANEOUS,
        .key_age_days = { 0.0f, 10.0f, 100.0f },
        .key_length_m = { 0.01f, 0.02f, 0.08f },
        .growth = { 0.2f, 1.0f, -0.5f, 0.1f, 2, { { 0.0f, 0.01f }, { 10.0f, 0.02f } } }
    };
    graph_from_template(&s->card.curves[0], TEMPLATE_PAIRWISE, 3, SIMULTANEOUS_PEAK);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        s->lod[lod] = (struct species_mesh){ .vertex_count = BARREL_VERTICES,
                                             .anchor_count = 2,
                                             .grid_rings = BARREL_RINGS,
                                             .grid_spokes = BARREL_SPOKES,
                                             .reach = 1.0f,
                                             .vertices = b->vertices,
                                             .anchors = b->anchors };
        for (uint32_t key = 0; key < 3; key++) {
            s->lod[lod].points[key] = b->points[key];
        }
    }
}

#endif
