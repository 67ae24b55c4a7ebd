/* morph_mesh.c -- sorts the triangles of a species' mesh into pieces, and computes the colours of
 * the vertices. */
#include "platform/ctl/morph/morph_mesh.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/species/reader.h"

void morph_piece_name(const struct morph_piece *piece, char out[PIECE_NAME_SIZE])
{
    static const char *const sides[] = {
        [SIDE_MIDDLE] = "", [SIDE_RIGHT] = "_right", [SIDE_LEFT] = "_left"
    };
    snprintf(out, PIECE_NAME_SIZE, "%s%s", part_names[piece->part], sides[piece->side]);
}

/* Returns true if the front of a triangle faces in the direction of its vertex normals. `at` points
 * to the three vertex indices. */
static bool faces_out(const uint16_t *at, const vec3 *positions, const vec3 *normals)
{
    const vec3 front = v3_cross(v3_sub(positions[at[1]], positions[at[0]]),
                                v3_sub(positions[at[2]], positions[at[0]]));
    const vec3 sum = v3_add(v3_add(normals[at[0]], normals[at[1]]), normals[at[2]]);
    return v3_dot(front, sum) >= 0.0f;
}

static bool same_corners(const uint16_t *a, const uint16_t *b)
{
    for (uint32_t i = 0; i < 3; i++) {
        if (a[i] != b[0] && a[i] != b[1] && a[i] != b[2]) {
            return false;
        }
    }
    return true;
}

/* Returns true if the triangle at `index` is omitted because another triangle has the same corners.
 * The mesh stores the sheet of a fin twice, once for each side. Only the triangle whose front faces
 * in the direction of its normals is needed. */
static bool is_spare(const struct species_mesh *mesh, uint32_t index, const vec3 *positions,
                     const vec3 *normals)
{
    const uint16_t *at = &mesh->indices[index];
    const bool good = faces_out(at, positions, normals);
    for (uint32_t i = 0; mesh->vertices[at[0]].part >= PART_TAIL && i < mesh->index_count; i += 3) {
        if (i != index && same_corners(at, &mesh->indices[i])) {
            const bool twin_good = faces_out(&mesh->indices[i], positions, normals);
            return good == twin_good ? i < index : twin_good;
        }
    }
    return false;
}

static void take_faces(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                       struct morph_piece *piece, struct morph_mesh *out)
{
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const uint16_t *at = &mesh->indices[i];
        const struct species_vertex *vertex = &mesh->vertices[at[0]];
        if (vertex->part == piece->part && vertex->side == piece->side &&
            !is_spare(mesh, i, positions, normals)) {
            for (uint32_t k = 0; k < 3; k++) {
                out->faces[out->face_count][k] = at[k];
            }
            out->face_count++;
            piece->face_count++;
        }
    }
}

void morph_mesh_cut(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                    struct morph_mesh *out)
{
    CORE_ASSERT(mesh->index_count <= MESH_INDEX_MAX);
    out->piece_count = out->face_count = 0;
    for (uint8_t part = 0; part < PART_COUNT; part++) {
        for (uint8_t side = SIDE_MIDDLE; side <= SIDE_LEFT; side++) {
            struct morph_piece *piece = &out->pieces[out->piece_count];
            *piece =
                (struct morph_piece){ .part = part, .side = side, .face_first = out->face_count };
            take_faces(mesh, positions, normals, piece, out);
            out->piece_count += piece->face_count > 0;
        }
    }
}

/* Returns the point at which the colour for corner `k` of a triangle is sampled. On the body, the
 * point is half way from the corner to the middle of the opposite edge. On an eye or a fin, the
 * point is the corner itself, because the colours change exactly at the vertices. */
static struct species_vertex inside(const struct species_mesh *mesh, const uint16_t *face,
                                    uint32_t k)
{
    const struct species_vertex *a = &mesh->vertices[face[(k + 1) % 3]];
    const struct species_vertex *b = &mesh->vertices[face[(k + 2) % 3]];
    struct species_vertex at = mesh->vertices[face[k]];
    if (at.part == PART_BODY) {
        at.u = 0.5f * at.u + 0.25f * (a->u + b->u);
        at.v = 0.5f * at.v + 0.25f * (a->v + b->v);
    }
    return at;
}

static void add_paint(struct paint *sum, const struct paint *paint, float weight)
{
    sum->colour = v3_muladd(sum->colour, paint->colour, weight);
    sum->clear += paint->clear * weight;
    sum->shine += paint->shine * weight;
}

void morph_mesh_paint(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct morph_mesh *cut, struct paint *paints)
{
    const struct species_mesh *mesh = &species->lod[0];
    float counts[MESH_VERTEX_MAX] = { 0 };
    memset(paints, 0, mesh->vertex_count * sizeof *paints);
    for (uint32_t i = 0; i < 3u * cut->face_count; i++) {
        const uint16_t *face = cut->faces[i / 3u];
        const struct species_vertex at = inside(mesh, face, i % 3u);
        const struct paint paint = paint_at(species, weights, &at);
        add_paint(&paints[face[i % 3u]], &paint, 1.0f);
        counts[face[i % 3u]] += 1.0f;
    }
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct paint sum = paints[i];
        paints[i] = (struct paint){ .clear = 0.0f };
        add_paint(&paints[i], &sum, 1.0f / f_max(counts[i], 1.0f));
    }
}
