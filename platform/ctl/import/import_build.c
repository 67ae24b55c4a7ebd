/* import_build.c -- builds the mesh tables of a species from oriented key shapes.
 *
 * Vertices that are equal in every key shape are merged. A fin that is a single sheet of triangles
 * gets a second side. The body coordinates (u along the body, v around the body) are computed from
 * the vertex positions. The skin pattern and the trailing of fins in the water depend on these
 * coordinates. Imported meshes have no anchors, so each vertex position depends only on the key
 * shapes. */
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/import/import.h"

#define PI 3.14159265f

/* A corner of a triangle in the new mesh. Corners with equal content become one vertex. */
struct corner {
    int16_t at[MORPH_KEY_MAX][3];
    float u, v;
    uint8_t part, side;
    uint8_t unused[2]; /* Always zero. The struct must have no padding, because corners are compared
                          as bytes. */
};
_Static_assert(sizeof(struct corner) == 6 * MORPH_KEY_MAX + 12, "corners have no padding");

struct builder {
    const struct import_mesh *mesh;
    struct mesh_tables *tables;
    struct species_mesh *out;
    char *why;
    float reach;
    /* Index of the last key shape. The body coordinates are computed from this key shape. */
    uint32_t key;
    struct corner corners[MESH_VERTEX_MAX];
    uint32_t place[MESH_VERTEX_MAX]; /* Index of a place for each vertex. The place is the first
                                        vertex of the same part that has the same position. */
    struct part_box {
        vec3 low, high;
        bool used;
    } boxes[PART_COUNT][SIDE_LEFT + 1];
};

static enum species_side import_build_side_of(const struct builder *b, enum species_part part,
                                              uint32_t t)
{
    const struct import_mesh *m = b->mesh;
    float x = 0.0f;
    if (part != PART_EYE && part != PART_PECTORAL && part != PART_PELVIC) {
        return SIDE_MIDDLE;
    }
    for (uint32_t k = 0; k < 3; k++) {
        /* The x coordinates are taken from key shape 0, because the eyes of a young flatfish are
         * still on both sides of its head. */
        x += m->positions[0][m->triangles[t][k]].x;
    }
    return x >= 0.0f ? SIDE_RIGHT : SIDE_LEFT;
}

static void measure_parts(struct builder *b)
{
    for (uint32_t t = 0; t < b->mesh->triangle_count; t++) {
        const enum species_part part = import_part_of(b->mesh, t);
        struct part_box *box = &b->boxes[part][import_build_side_of(b, part, t)];
        for (uint32_t k = 0; k < 3; k++) {
            const vec3 p = b->mesh->positions[b->key][b->mesh->triangles[t][k]];
            box->low = box->used ? v3(fminf(box->low.x, p.x), fminf(box->low.y, p.y),
                                      fminf(box->low.z, p.z))
                                 : p;
            box->high = box->used ? v3(fmaxf(box->high.x, p.x), fmaxf(box->high.y, p.y),
                                       fmaxf(box->high.z, p.z))
                                  : p;
            box->used = true;
        }
    }
}

static float share_of_range(float x, float low, float high)
{
    return high > low ? f_clamp((x - low) / (high - low), 0.0f, 1.0f) : 0.0f;
}

/* Computes the body coordinates u and v of a vertex at the position `p` (core/morph/species.h). */
static void set_body_coordinates(const struct builder *b, vec3 p, struct corner *corner)
{
    const enum species_side side = (enum species_side)corner->side;
    const struct part_box *box = &b->boxes[corner->part][side];
    const vec3 middle = v3_scale(v3_add(box->low, box->high), 0.5f);
    const float along = share_of_range(p.z, box->low.z, box->high.z);
    if (corner->part == PART_BODY) {
        const float turn = atan2f(p.x - middle.x, p.y - middle.y) / (2.0f * PI);
        corner->u = along;
        corner->v = turn < 0.0f ? turn + 1.0f : turn;
    } else if (corner->part == PART_EYE) {
        const vec3 out_of = v3(side == SIDE_RIGHT ? 1.0f : -1.0f, 0.0f, 0.0f);
        const vec3 from = v3_normalize_or(v3_sub(p, middle), out_of);
        corner->u = acosf(f_clamp(v3_dot(from, out_of), -1.0f, 1.0f)) / (0.5f * PI);
        corner->v = side == SIDE_RIGHT ? 0.25f : 0.75f;
    } else if (corner->part == PART_TAIL) {
        corner->u = 1.0f - share_of_range(p.y, box->low.y, box->high.y);
        corner->v = along;
    } else if (side != SIDE_MIDDLE) {
        const float low = fabsf(box->low.x), high = fabsf(box->high.x);
        corner->u = along;
        corner->v = share_of_range(fabsf(p.x), fminf(low, high), fmaxf(low, high));
    } else {
        const float root = fmaxf(fmaxf(box->low.y, -box->high.y), 0.0f);
        const float reach = fmaxf(fabsf(box->low.y), fabsf(box->high.y));
        corner->u = along;
        corner->v = share_of_range(fabsf(p.y), root, reach);
    }
}

static struct corner corner_of(const struct builder *b, uint32_t t, uint32_t k)
{
    CORE_ASSERT(t < b->mesh->triangle_count && k < 3);
    const struct import_mesh *m = b->mesh;
    const uint32_t vertex = m->triangles[t][k];
    const enum species_part part = import_part_of(m, t);
    struct corner corner = { .part = (uint8_t)part,
                             .side = (uint8_t)import_build_side_of(b, part, t) };
    for (uint32_t key = 0; key < m->key_count; key++) {
        const vec3 p = m->positions[key][vertex];
        corner.at[key][0] = morph_count(p.x, b->reach);
        corner.at[key][1] = morph_count(p.y, b->reach);
        corner.at[key][2] = morph_count(p.z, b->reach);
    }
    if (m->is_ours && m->has_uv) {
        corner.u = f_clamp(m->uv[vertex][0], -2.0f, 4.0f);
        corner.v = f_clamp(m->uv[vertex][1], -2.0f, 4.0f);
    } else {
        set_body_coordinates(b, m->positions[b->key][vertex], &corner);
    }
    return corner;
}

static bool vertex_of(struct builder *b, const struct corner *corner, uint32_t *out)
{
    for (*out = 0; *out < b->out->vertex_count; ++*out) {
        if (memcmp(&b->corners[*out], corner, sizeof *corner) == 0) {
            return true;
        }
    }
    if (b->out->vertex_count == MESH_VERTEX_MAX) {
        return import_error(b->why,
                            "vertices: more than %u; reduce the model, or fit a species to it "
                            "with 'kingyoctl morph refit'",
                            MESH_VERTEX_MAX);
    }
    b->out->vertex_count++;
    b->corners[*out] = *corner;
    b->tables->vertices[*out] = (struct species_vertex){
        .u = corner->u,
        .v = corner->v,
        .part = corner->part,
        .side = corner->side,
        .anchor = ANCHOR_NONE,
        .mask = { 255 },
        .flex = corner->part < PART_TAIL ? 0 : (uint8_t)(255.0f * f_clamp(corner->v, 0.0f, 1.0f)),
    };
    for (uint32_t key = 0; key < b->mesh->key_count; key++) {
        b->tables->points[key][*out] =
            (struct species_point){ corner->at[key][0], corner->at[key][1], corner->at[key][2], 0 };
    }
    return true;
}

static bool add_triangle(struct builder *b, uint32_t x, uint32_t y, uint32_t z)
{
    if (x == y || y == z || z == x) {
        return true; /* The triangle is omitted because two of its corners were merged into one
                        vertex. */
    }
    if (b->out->index_count + 3 > MESH_INDEX_MAX) {
        return import_error(b->why, "triangles: more than %u; reduce the model",
                            MESH_INDEX_MAX / 3u);
    }
    uint16_t *index = &b->tables->indices[b->out->index_count];
    index[0] = (uint16_t)x;
    index[1] = (uint16_t)y;
    index[2] = (uint16_t)z;
    b->out->index_count += 3;
    return true;
}

static bool add_triangles(struct builder *b)
{
    for (uint32_t t = 0; t < b->mesh->triangle_count; t++) {
        struct corner corner[3];
        uint32_t vertex[3];
        for (uint32_t k = 0; k < 3; k++) {
            corner[k] = corner_of(b, t, k);
        }
        if (!b->mesh->is_ours) {
            /* If a body triangle crosses the seam between v = 1 and v = 0, 1 is added to each v
             * below 0.5. */
            float low = 1.0f, high = 0.0f;
            for (uint32_t k = 0; k < 3; k++) {
                low = fminf(low, corner[k].v);
                high = fmaxf(high, corner[k].v);
            }
            for (uint32_t k = 0; k < 3 && corner[0].part == PART_BODY && high - low > 0.5f; k++) {
                corner[k].v += corner[k].v < 0.5f ? 1.0f : 0.0f;
            }
        }
        for (uint32_t k = 0; k < 3; k++) {
            if (!vertex_of(b, &corner[k], &vertex[k])) {
                return false;
            }
        }
        if (!add_triangle(b, vertex[0], vertex[1], vertex[2])) {
            return false;
        }
    }
    return true;
}

static bool has_edge(const struct builder *b, uint32_t from, uint32_t to)
{
    for (uint32_t i = 0; i < b->out->index_count; i += 3) {
        const uint16_t *t = &b->tables->indices[i];
        for (uint32_t k = 0; k < 3; k++) {
            if (b->place[t[k]] == from && b->place[t[(k + 1) % 3]] == to) {
                return true;
            }
        }
    }
    return false;
}

/* Adds a second side to each fin that is an open sheet. A sheet is open if any edge belongs to only
 * one triangle. Closed fins are not changed. */
static bool give_sheets_a_second_side(struct builder *b)
{
    bool open[PART_COUNT] = { false };
    const uint32_t index_count = b->out->index_count;
    for (uint32_t i = 0; i < index_count; i += 3) {
        const uint16_t *t = &b->tables->indices[i];
        const uint8_t part = b->tables->vertices[t[0]].part;
        for (uint32_t k = 0; k < 3 && part >= PART_TAIL && !open[part]; k++) {
            open[part] = !has_edge(b, b->place[t[(k + 1) % 3]], b->place[t[k]]);
        }
    }
    for (uint32_t i = 0; i < index_count; i += 3) {
        const uint16_t *t = &b->tables->indices[i];
        if (open[b->tables->vertices[t[0]].part] && !add_triangle(b, t[0], t[2], t[1])) {
            return false;
        }
    }
    return true;
}

void import_normals(const struct species_mesh *mesh, uint32_t index_count, const vec3 *positions,
                    const uint32_t *place, vec3 normals[MESH_VERTEX_MAX])
{
    static vec3 sums[MESH_VERTEX_MAX];
    memset(sums, 0, sizeof sums);
    for (uint32_t i = 0; i < index_count; i += 3) {
        const uint16_t *t = &mesh->indices[i];
        const vec3 a = positions[t[0]];
        const vec3 normal = v3_cross(v3_sub(positions[t[1]], a), v3_sub(positions[t[2]], a));
        for (uint32_t k = 0; k < 3; k++) {
            vec3 *sum = &sums[place[t[k]]];
            const bool is_fin = mesh->vertices[t[k]].part >= PART_TAIL;
            *sum = v3_muladd(*sum, normal, is_fin && v3_dot(*sum, normal) < 0.0f ? -1.0f : 1.0f);
        }
    }
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        normals[i] = v3_normalize_or(sums[place[i]], v3(0.0f, 1.0f, 0.0f));
    }
}

static void write_normals(struct builder *b, uint32_t index_count)
{
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    for (uint32_t key = 0; key < b->mesh->key_count; key++) {
        for (uint32_t i = 0; i < b->out->vertex_count; i++) {
            positions[i] = morph_position(b->out, key, i);
        }
        import_normals(b->out, index_count, positions, b->place, normals);
        for (uint32_t i = 0; i < b->out->vertex_count; i++) {
            b->tables->points[key][i].normal = morph_fold_normal(normals[i]);
        }
    }
}

bool import_build(const struct import_mesh *mesh, struct species_slot *slot,
                  struct import_report *report, char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(mesh->key_count >= 1 && mesh->key_count <= MORPH_KEY_MAX);
    static struct builder b;
    struct species_mesh *near = &slot->species.lod[0];
    float far = 0.0f;
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            const vec3 p = mesh->positions[key][i];
            far = fmaxf(far, fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z))));
        }
    }
    if (!(far < 4.0f)) {
        return import_error(why, "size: a vertex is %g lengths from the middle", (double)far);
    }
    memset(&b, 0, sizeof b);
    b.mesh = mesh;
    b.tables = &slot->tables[0];
    b.out = near;
    b.why = why;
    b.key = mesh->key_count - 1;
    b.reach = far < 1.0f ? 1.0f : far < 2.0f ? 2.0f : 4.0f;
    *near = (struct species_mesh){ .reach = b.reach,
                                   .vertices = b.tables->vertices,
                                   .anchors = b.tables->anchors,
                                   .indices = b.tables->indices };
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        near->points[key] = b.tables->points[key];
    }
    measure_parts(&b);
    if (!add_triangles(&b)) {
        return false;
    }
    /* Vertices with the same position get the same place. The surface is therefore continuous at a
     * texture seam, although different vertices lie on the two sides of the seam. */
    for (uint32_t i = 0; i < near->vertex_count; i++) {
        b.place[i] = i;
        for (uint32_t j = 0; j < i && b.place[i] == i; j++) {
            if (b.corners[i].part == b.corners[j].part &&
                memcmp(b.corners[i].at, b.corners[j].at, sizeof b.corners[i].at) == 0) {
                b.place[i] = b.place[j];
            }
        }
    }
    const uint32_t index_count = near->index_count;
    if (!give_sheets_a_second_side(&b)) {
        return false;
    }
    write_normals(&b, index_count);
    report->joined_count =
        mesh->vertex_count > near->vertex_count ? mesh->vertex_count - near->vertex_count : 0;
    return true;
}
