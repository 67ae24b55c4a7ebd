/* loft.c -- makes a key's smooth shape a mesh: rings along the body, fin sheets, eye domes.
 *
 * Every key of a species walks the same rings, spokes and rays, so vertices correspond by
 * construction, as the 2005 thesis asks of its input shapes (section 3.1). */
#include "platform/species/shape.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define BODY_END 1.03 /* The body's last point, a little behind its last ring. */

const struct detail species_detail[SPECIES_LOD_COUNT] = {
    { .rings = 21, .bunching = 1.5, .spokes = 12,
      .eye_rings = 2, .eye_spokes = 8,
      .fins = { [PART_TAIL] = { 9, 5 }, [PART_DORSAL] = { 7, 3 }, [PART_ANAL] = { 4, 3 },
                [PART_PECTORAL] = { 4, 3 }, [PART_PELVIC] = { 3, 3 },
                [PART_DORSAL_2] = { 5, 3 } } },
    { .rings = 7, .bunching = 1.7, .spokes = 8,
      .eye_rings = 1, .eye_spokes = 5,
      .fins = { [PART_TAIL] = { 5, 3 }, [PART_DORSAL] = { 4, 2 }, [PART_ANAL] = { 2, 2 },
                [PART_PECTORAL] = { 3, 2 }, [PART_PELVIC] = { 3, 2 },
                [PART_DORSAL_2] = { 3, 2 } } },
};

/* What lofting one species needs at hand. `vertex` counts up while the keys' arrays fill. */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    double unit[MORPH_KEY_MAX];
};

static uint16_t next_vertex(struct lofting *l, struct species_vertex vertex)
{
    assert(l->loft->vertex_count < MESH_VERTEX_MAX);
    vertex.anchor = ANCHOR_NONE;
    vertex.mask[0] = 255;
    l->loft->vertices[l->loft->vertex_count] = vertex;
    return (uint16_t)l->loft->vertex_count++;
}

/* Sets the newest vertex's place in one key, from drawing units to the body frame. */
static void place(struct lofting *l, uint32_t key, point3 p, point3 normal)
{
    const uint32_t i = l->loft->vertex_count - 1;
    const double scale = 1.0 / l->unit[key];
    l->loft->positions[key][i] =
        (vec3){ (float)(p.x * scale), (float)(p.y * scale), (float)(p.z * scale - 0.5) };
    l->loft->normals[key][i] = (vec3){ (float)normal.x, (float)normal.y, (float)normal.z };
}

static void triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c)
{
    assert(l->loft->index_count + 3 <= MESH_INDEX_MAX);
    uint16_t *out = &l->loft->indices[l->loft->index_count];
    out[0] = (uint16_t)a;
    out[1] = (uint16_t)b;
    out[2] = (uint16_t)c;
    l->loft->index_count += 3;
}

/* The snout's or tail root's closing point, on its section's axis: once for each flank, so that a
 * pattern's v does not run through the belly's. `normal` and the answer are the right one's. */
static uint32_t add_poles(struct lofting *l, double u, double z, point3 normal)
{
    for (int side = 1; side >= -1; side -= 2) {
        next_vertex(l, (struct species_vertex){ .u = (float)u, .v = side > 0 ? 0.25f : 0.75f });
        for (uint32_t key = 0; key < l->species->key_count; key++) {
            const struct station s = section(&l->species->keys[key], u);
            place(l, key, (point3){ 0.0, (double)s.offset, z },
                  (point3){ normal.x * side, normal.y, normal.z });
        }
    }
    return l->loft->vertex_count - 2;
}

static void add_ring(struct lofting *l, double u)
{
    for (uint32_t spoke = 0; spoke <= l->detail->spokes; spoke++) {
        const double v = (double)spoke / l->detail->spokes;
        next_vertex(l, (struct species_vertex){ .u = (float)u, .v = (float)v });
        for (uint32_t key = 0; key < l->species->key_count; key++) {
            const struct key_text *text = &l->species->keys[key];
            place(l, key, body_point(text, u, v), body_normal(text, u, v));
        }
    }
}

static void add_body(struct lofting *l)
{
    const uint32_t rings = l->detail->rings, spokes = l->detail->spokes;
    const uint32_t snout = add_poles(l, 0.0, 0.0, (point3){ 0.0, 0.0, -1.0 });
    const uint32_t first = l->loft->vertex_count;
    for (uint32_t ring = 1; ring <= rings; ring++) {
        add_ring(l, pow((double)ring / rings, l->detail->bunching));
    }
    const uint32_t last = first + (rings - 1) * (spokes + 1);
    const uint32_t end = add_poles(l, 1.0, BODY_END, unit((point3){ 1.0, 0.0, 0.3 }));
    for (uint32_t j = 0; j < spokes; j++) {
        const uint32_t left = 2 * j < spokes ? 0 : 1;
        triangle(l, snout + left, first + j, first + j + 1);
        for (uint32_t row = first; row < last; row += spokes + 1) {
            const uint32_t a = row + j, b = a + 1, c = a + spokes + 1, d = c + 1;
            triangle(l, a, c, b);
            triangle(l, b, c, d);
        }
        triangle(l, last + j, end + left, last + j + 1);
    }
}

static void add_eye_vertex(struct lofting *l, int side, double rho, double angle)
{
    next_vertex(l, (struct species_vertex){ .u = (float)rho,
                                            .v = side > 0 ? 0.25f : 0.75f,
                                            .part = PART_EYE });
    for (uint32_t key = 0; key < l->species->key_count; key++) {
        const struct key_text *text = &l->species->keys[key];
        const uint32_t which = side > 0 ? 0 : 1;
        const struct eye *eye = &text->eyes[which];
        const double radius = 0.5 * (double)eye->diameter * rho;
        const double y = (double)eye->y + radius * cos(angle);
        const double z = (double)eye->x + radius * sin(angle);
        point3 p = eye_point(text, which, y, z), n = eye_normal(text, which, y, z);
        p.x *= side;
        n.x *= side;
        place(l, key, p, n);
    }
}

/* A triangle of the right side; the left side's mirror image winds the other way. */
static void mirrored(struct lofting *l, int side, uint32_t a, uint32_t b, uint32_t c)
{
    triangle(l, a, side > 0 ? b : c, side > 0 ? c : b);
}

static void add_eye(struct lofting *l, int side)
{
    const uint32_t rings = l->detail->eye_rings, spokes = l->detail->eye_spokes;
    const uint32_t centre = l->loft->vertex_count, first = centre + 1;
    add_eye_vertex(l, side, 0.0, 0.0);
    for (uint32_t ring = 1; ring <= rings; ring++) {
        for (uint32_t spoke = 0; spoke < spokes; spoke++) {
            add_eye_vertex(l, side, (double)ring / rings, 2.0 * PI * spoke / spokes);
        }
    }
    for (uint32_t j = 0; j < spokes; j++) {
        const uint32_t k = (j + 1) % spokes;
        mirrored(l, side, centre, first + j, first + k);
        for (uint32_t row = first; row < first + (rings - 1) * spokes; row += spokes) {
            mirrored(l, side, row + j, row + spokes + j, row + k);
            mirrored(l, side, row + k, row + spokes + j, row + spokes + k);
        }
    }
}

static void add_fin_vertex(struct lofting *l, enum species_part part, int side, double at,
                           double along)
{
    next_vertex(l, (struct species_vertex){ .u = (float)at,
                                            .v = (float)along,
                                            .part = (uint8_t)part,
                                            .flex = (uint8_t)lround(255.0 * along) });
    for (uint32_t key = 0; key < l->species->key_count; key++) {
        const struct key_text *text = &l->species->keys[key];
        point3 p = fin_point(text, part, at, along), n = fin_normal(text, part, at, along);
        p.x *= side;
        n.x *= side;
        place(l, key, p, n);
    }
}

/* Where column `i` of a fin lies. The tail's bunch toward its lobes, whose tips are round. */
static double column_at(enum species_part part, uint32_t i, uint32_t across)
{
    const double t = (double)i / (across - 1);
    return part == PART_TAIL ? 0.5 - 0.5 * cos(PI * t) : t;
}

static void add_fin(struct lofting *l, enum species_part part, int side)
{
    const uint32_t across = l->detail->fins[part].across, along = l->detail->fins[part].along;
    const uint32_t first = l->loft->vertex_count;
    if (l->species->keys[0].fins[part].ray_count == 0) {
        return;
    }
    for (uint32_t i = 0; i < across; i++) {
        for (uint32_t j = 0; j < along; j++) {
            add_fin_vertex(l, part, side, column_at(part, i, across), (double)j / (along - 1));
        }
    }
    for (uint32_t i = 0; i + 1 < across; i++) {
        for (uint32_t j = 0; j + 1 < along; j++) {
            const uint32_t a = first + i * along + j, b = a + 1, c = a + along, d = c + 1;
            triangle(l, a, c, b);
            triangle(l, b, c, d);
            triangle(l, a, b, c);
            triangle(l, b, d, c);
        }
    }
}

/* One triangle each, seen from both sides. */
static void add_finlets(struct lofting *l, uint32_t row)
{
    const uint32_t count = l->species->keys[0].finlets[row].count;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t first = l->loft->vertex_count;
        for (uint32_t corner = 0; corner < 3; corner++) {
            const double at = (double)i / count;
            next_vertex(l, (struct species_vertex){
                               .u = (float)(at + (corner == 1 ? 0.6 : 0.0) / count),
                               .v = corner == 2 ? 1.0f : 0.0f,
                               .part = (uint8_t)(PART_FINLET_UPPER + row),
                               .flex = corner == 2 ? 255 : 0 });
            for (uint32_t key = 0; key < l->species->key_count; key++) {
                place(l, key, finlet_point(&l->species->keys[key], row, at, corner),
                      (point3){ 1.0, 0.0, 0.0 });
            }
        }
        triangle(l, first, first + 1, first + 2);
        triangle(l, first, first + 2, first + 1);
    }
}

/* The least of 1, 2 and 4 that holds every point. */
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
            unit_length(&species->keys[key], (enum species_measure)species->measure);
    }
    add_body(&l);
    for (int side = 1; side >= -1; side -= 2) {
        add_eye(&l, side);
    }
    add_fin(&l, PART_TAIL, 1);
    add_fin(&l, PART_DORSAL, 1);
    add_fin(&l, PART_DORSAL_2, 1);
    add_fin(&l, PART_ANAL, 1);
    for (int side = 1; side >= -1; side -= 2) {
        add_fin(&l, PART_PECTORAL, side);
        add_fin(&l, PART_PELVIC, side);
    }
    add_finlets(&l, 0);
    add_finlets(&l, 1);
    loft->reach = reach_of(loft, species->key_count);
}
