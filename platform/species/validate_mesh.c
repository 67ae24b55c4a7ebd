/* validate_mesh.c -- validates the meshes of an untrusted species. */
#include "platform/species/validate.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "core/morph/morph.h"

/* Maximum relative difference between the measured length of a mesh and the required length of 1.
 * The far mesh of a tail fin has few rays, so that its outermost tip may be missing. */
#define SIZE_TOLERANCE 0.04f
/* Minimum permitted body coordinate u. Together with U_MAX, the range contains the u of every
 * surface. The u of an eye exceeds 1 behind the rim of the eye's ball. */
#define U_MIN (-2.0f)
#define U_MAX 4.0f
#define FRONT_Z (-0.5f)

static const char *const lod_names[SPECIES_LOD_COUNT] = { "near", "far" };

static bool vet_counts(struct vetting *v, const char *lod, const struct species_mesh *mesh)
{
    if (mesh->vertex_count < 4 || mesh->vertex_count > MESH_VERTEX_MAX) {
        return validate_refuse(v, "%s/vertices: %u, and there are 4 to %u", lod, mesh->vertex_count,
                               MESH_VERTEX_MAX);
    }
    if (mesh->index_count < 12 || mesh->index_count % 3 != 0 ||
        mesh->index_count > MESH_INDEX_MAX) {
        return validate_refuse(v, "%s/indices: %u, and there are three times 4 to %u", lod,
                               mesh->index_count, MESH_INDEX_MAX / 3u);
    }
    if (mesh->anchor_count > ANCHOR_MAX) {
        return validate_refuse(v, "%s/anchors: more than %u", lod, ANCHOR_MAX);
    }
    return mesh->reach == 1.0f || mesh->reach == 2.0f || mesh->reach == 4.0f ||
           validate_refuse(v, "%s/reach: %g is not 1, 2 or 4", lod, (double)mesh->reach);
}

static bool vet_vertex(struct vetting *v, const char *what, const struct species_mesh *mesh,
                       const struct species_vertex *vertex)
{
    uint32_t sum = 0;
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        sum += vertex->mask[curve];
        if (vertex->mask[curve] > 0 && curve >= v->species->card.curve_count) {
            return validate_refuse(v, "%s: a mask for curve %u, which is not there", what, curve);
        }
    }
    if (sum != 255) {
        return validate_refuse(v, "%s: the masks' sum is %u, not 255", what, sum);
    }
    if (vertex->anchor != ANCHOR_NONE && vertex->anchor >= mesh->anchor_count) {
        return validate_refuse(v, "%s: rides on anchor %u of %u", what, vertex->anchor,
                               mesh->anchor_count);
    }
    return validate_number(v, what, vertex->u, U_MIN, U_MAX) &&
           validate_number(v, what, vertex->v, U_MIN, U_MAX) &&
           validate_choice(v, what, vertex->part, PART_COUNT) &&
           validate_choice(v, what, vertex->side, SIDE_LEFT + 1u);
}

static bool vet_triangles(struct vetting *v, const char *lod, const struct species_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const uint16_t *corner = &mesh->indices[i];
        for (uint32_t k = 0; k < 3; k++) {
            if (corner[k] >= mesh->vertex_count) {
                return validate_refuse(v, "%s/triangle %u: vertex %u of %u", lod, i / 3, corner[k],
                                       mesh->vertex_count);
            }
            if (mesh->vertices[corner[k]].part != mesh->vertices[corner[0]].part) {
                return validate_refuse(v, "%s/triangle %u: its corners are of two parts", lod,
                                       i / 3);
            }
        }
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
            return validate_refuse(v, "%s/triangle %u: two corners are one", lod, i / 3);
        }
    }
    return true;
}

/* Checks the grid of vertices to which anchors refer. u must increase from ring to ring, and v must
 * increase from 0 to 1 from spoke to spoke. No vertex of the grid may have an anchor. */
static bool vet_grid(struct vetting *v, const char *lod, const struct species_mesh *mesh)
{
    const uint32_t rings = mesh->grid_rings, row = mesh->grid_spokes + 1u;
    if (rings == 0) {
        return mesh->anchor_count == 0 ||
               validate_refuse(v, "%s/grid: anchors, and no skin for them", lod);
    }
    if (rings < 2 || row < 4 || mesh->grid_first + rings * row > mesh->vertex_count) {
        return validate_refuse(v, "%s/grid: %u rings of %u from vertex %u do not fit", lod, rings,
                               row, mesh->grid_first);
    }
    for (uint32_t i = 0; i < rings * row; i++) {
        const struct species_vertex *at = &mesh->vertices[mesh->grid_first + i];
        const uint32_t spoke = i % row;
        const bool rises = i < row || at->u > at[-(ptrdiff_t)row].u;
        const bool turns = spoke == 0 ? at->v == 0.0f : at->v > at[-1].v;
        if (at->part != PART_BODY || at->anchor != ANCHOR_NONE || at->u < 0.0f || at->u > 1.0f ||
            !rises || !turns || (spoke + 1 == row && at->v != 1.0f)) {
            return validate_refuse(v, "%s/grid: ring %u, spoke %u is out of order", lod, i / row,
                                   spoke);
        }
    }
    return true;
}

/* Checks the size of a mesh in each key. The length must be 1 as the species' length measure (enum
 * species_measure) defines it, because only the scale curve sets the fish's size. The snout must be
 * at z = -0.5. */
static bool vet_size(struct vetting *v, const char *lod, const char *key,
                     const struct species_mesh *mesh, const vec3 *positions)
{
    float front = INFINITY, rear = -INFINITY, left = INFINITY, right = -INFINITY, end = -INFINITY;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const vec3 p = positions[i];
        front = fminf(front, p.z);
        rear = fmaxf(rear, p.z);
        left = fminf(left, p.x);
        right = fmaxf(right, p.x);
        end = mesh->vertices[i].part == PART_BODY ? fmaxf(end, p.z) : end;
    }
    char what[VALIDATE_WHAT_SIZE];
    snprintf(what, sizeof what, "%s/%s: snout at z", key, lod);
    if (!validate_number(v, what, front, FRONT_Z - SIZE_TOLERANCE, FRONT_Z + SIZE_TOLERANCE)) {
        return false;
    }
    snprintf(what, sizeof what, "%s/%s: size", key, lod);
    switch (v->species->card.measure) {
    case MEASURE_TOTAL:
        return validate_number(v, what, rear - FRONT_Z, 1.0f - SIZE_TOLERANCE,
                               1.0f + SIZE_TOLERANCE);
    case MEASURE_DISC:
        return validate_number(v, what, right - left, 1.0f - SIZE_TOLERANCE, 1.0f + SIZE_TOLERANCE);
    default: /* MEASURE_STANDARD ends at the tail root. MEASURE_FORK ends at the fork of the tail
                fin, slightly behind the tail root. */
        return validate_number(v, what, end - FRONT_Z, 0.8f, 1.0f + SIZE_TOLERANCE);
    }
}

bool validate_meshes(struct vetting *v)
{
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &v->species->lod[lod];
        const char *name = lod_names[lod];
        if (!vet_counts(v, name, mesh)) {
            return false;
        }
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            char what[VALIDATE_WHAT_SIZE];
            snprintf(what, sizeof what, "%s/vertex %u", name, i);
            if (!vet_vertex(v, what, mesh, &mesh->vertices[i])) {
                return false;
            }
        }
        if (!vet_triangles(v, name, mesh) || !vet_grid(v, name, mesh)) {
            return false;
        }
        for (uint32_t i = 0; i < mesh->anchor_count; i++) {
            const struct species_anchor *anchor = &mesh->anchors[i];
            char what[VALIDATE_WHAT_SIZE];
            snprintf(what, sizeof what, "%s/anchor %u", name, i);
            if (!validate_choice(v, what, anchor->curve, v->species->card.curve_count) ||
                !validate_choice(v, what, anchor->turns, 2)) {
                return false;
            }
            for (uint32_t key = 0; key < v->species->card.key_count; key++) {
                if (!validate_number(v, what, anchor->u[key], 0.0f, 1.0f) ||
                    !validate_number(v, what, anchor->v[key], U_MIN, U_MAX)) {
                    return false;
                }
            }
        }
        static struct morph_pose pose;
        static vec3 positions[MESH_VERTEX_MAX];
        const struct species_card *card = &v->species->card;
        for (uint32_t key = 0; key < card->key_count; key++) {
            morph_key_pose(mesh, card->key_count, key, &pose);
            morph_shape(mesh, card->key_count, &pose, positions, NULL);
            if (!vet_size(v, name, card->key_names[key], mesh, positions)) {
                return false;
            }
        }
    }
    return true;
}
