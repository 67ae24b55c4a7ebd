/* validate_mesh.c -- validates the meshes of an untrusted species. */
#include "platform/species/validate.h"

#include <math.h>
#include <stddef.h>

#include "core/morph/morph.h"

/* Maximum deviation of a mesh's length from the required length of 1. The far mesh (the mesh with
 * few vertices) needs this tolerance: its tail fin has few rays, so that the drawing's rearmost fin
 * tip may lie between two rays and may be missing in the mesh. */
#define SIZE_TOLERANCE 0.04f
/* U_MIN and U_MAX are the minimum and maximum permitted body coordinates u and v of a vertex. The
 * range contains the coordinates of every surface. On an eye's ball, u is larger than 1 behind the
 * rim of the ball. */
#define U_MIN (-2.0f)
#define U_MAX 4.0f
#define FRONT_Z (-0.5f)

static bool validate_counts(const struct species_mesh *mesh, const char *lod,
                            char why[VALIDATE_WHY_SIZE])
{
    const uint32_t vertices = mesh->vertex_count, indices = mesh->index_count;
    return ((vertices >= 4 && vertices <= MESH_VERTEX_MAX) ||
            validate_refuse(why, "%s/vertices: %u, but 4 to %u vertices are allowed", lod, vertices,
                            MESH_VERTEX_MAX)) &&
           ((indices >= 12 && indices % 3 == 0 && indices <= MESH_INDEX_MAX) ||
            validate_refuse(why, "%s/indices: %u, but 4 to %u triangles are allowed", lod, indices,
                            MESH_INDEX_MAX / 3u)) &&
           (mesh->anchor_count <= ANCHOR_MAX ||
            validate_refuse(why, "%s/anchors: more than %u", lod, ANCHOR_MAX)) &&
           (mesh->reach == 1.0f || mesh->reach == 2.0f || mesh->reach == 4.0f ||
            validate_refuse(why, "%s/reach: %g is not 1, 2 or 4", lod, (double)mesh->reach));
}

static bool validate_vertex(const struct species_mesh *mesh, uint32_t index, uint32_t curve_count,
                            const char *lod, char why[VALIDATE_WHY_SIZE])
{
    const struct species_vertex *vertex = &mesh->vertices[index];
    uint32_t sum = 0;
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        sum += vertex->mask[curve];
        if (vertex->mask[curve] > 0 && curve >= curve_count) {
            return validate_refuse(why,
                                   "%s/vertex %u: a mask is set for curve %u, which does not exist",
                                   lod, index, curve);
        }
    }
    if (sum != 255) {
        return validate_refuse(why, "%s/vertex %u: the sum of the masks is %u, but must be 255",
                               lod, index, sum);
    }
    if (vertex->anchor != ANCHOR_NONE && vertex->anchor >= mesh->anchor_count) {
        return validate_refuse(why, "%s/vertex %u: anchor %u does not exist; there are %u", lod,
                               index, vertex->anchor, mesh->anchor_count);
    }
    return validate_number(why, vertex->u, U_MIN, U_MAX, "%s/vertex %u", lod, index) &&
           validate_number(why, vertex->v, U_MIN, U_MAX, "%s/vertex %u", lod, index) &&
           validate_choice(why, vertex->part, PART_COUNT, "%s/vertex %u", lod, index) &&
           validate_choice(why, vertex->side, SIDE_LEFT + 1u, "%s/vertex %u", lod, index);
}

static bool validate_triangles(const struct species_mesh *mesh, const char *lod,
                               char why[VALIDATE_WHY_SIZE])
{
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const uint16_t *corner = &mesh->indices[i];
        for (uint32_t k = 0; k < 3; k++) {
            if (corner[k] >= mesh->vertex_count) {
                return validate_refuse(why,
                                       "%s/triangle %u: vertex %u does not exist; there are %u",
                                       lod, i / 3, corner[k], mesh->vertex_count);
            }
            if (mesh->vertices[corner[k]].part != mesh->vertices[corner[0]].part) {
                return validate_refuse(why, "%s/triangle %u: the corners belong to different parts",
                                       lod, i / 3);
            }
        }
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
            return validate_refuse(why, "%s/triangle %u: two corners are the same vertex", lod,
                                   i / 3);
        }
    }
    return true;
}

/* Checks the grid of body vertices to which anchors refer. From ring to ring, the coordinate u must
 * increase. Round each ring, from spoke to spoke, the coordinate v must increase from 0 to 1. No
 * vertex of the grid may have an anchor. */
static bool validate_grid(const struct species_mesh *mesh, const char *lod,
                          char why[VALIDATE_WHY_SIZE])
{
    const uint32_t rings = mesh->grid_rings, row = mesh->grid_spokes + 1u;
    if (rings == 0) {
        return mesh->anchor_count == 0 ||
               validate_refuse(why, "%s/grid: the mesh has anchors, but no grid", lod);
    }
    if (rings < 2 || row < 4 || mesh->grid_first + rings * row > mesh->vertex_count) {
        return validate_refuse(why, "%s/grid: %u rings of %u from vertex %u do not fit", lod, rings,
                               row, mesh->grid_first);
    }
    for (uint32_t i = 0; i < rings * row; i++) {
        const struct species_vertex *at = &mesh->vertices[mesh->grid_first + i];
        const uint32_t spoke = i % row;
        const bool rises = i < row || at->u > at[-(ptrdiff_t)row].u;
        const bool turns = spoke == 0 ? at->v == 0.0f : at->v > at[-1].v;
        if (at->part != PART_BODY || at->anchor != ANCHOR_NONE || at->u < 0.0f || at->u > 1.0f ||
            !rises || !turns || (spoke + 1 == row && at->v != 1.0f)) {
            return validate_refuse(why, "%s/grid: ring %u, spoke %u is not in order", lod, i / row,
                                   spoke);
        }
    }
    return true;
}

static bool validate_anchors(const struct species_mesh *mesh, const struct species_card *card,
                             const char *lod, char why[VALIDATE_WHY_SIZE])
{
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        const struct species_anchor *anchor = &mesh->anchors[i];
        if (!validate_choice(why, anchor->curve, card->curve_count, "%s/anchor %u", lod, i) ||
            !validate_choice(why, anchor->turns, 2, "%s/anchor %u", lod, i)) {
            return false;
        }
        for (uint32_t key = 0; key < card->key_count; key++) {
            if (!validate_number(why, anchor->u[key], 0.0f, 1.0f, "%s/anchor %u", lod, i) ||
                !validate_number(why, anchor->v[key], U_MIN, U_MAX, "%s/anchor %u", lod, i)) {
                return false;
            }
        }
    }
    return true;
}

/* Checks the size of a mesh in one key (modelled growth stage). `positions` are the positions of
 * the vertices in this key, and `name` is the name of the key. The length of the mesh must be 1 in
 * the species' length measure (enum species_measure), because the program multiplies the mesh by
 * the fish's length. The snout must be at z = -0.5. */
static bool validate_size(const struct species_mesh *mesh, const vec3 *positions, uint8_t measure,
                          const char *name, const char *lod, char why[VALIDATE_WHY_SIZE])
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
    /* MEASURE_STANDARD is the length from the snout to the tail root. MEASURE_FORK is the length to
     * the fork of the tail fin, slightly behind the tail root. `to_root` is true for both. */
    const bool to_root = measure != MEASURE_TOTAL && measure != MEASURE_DISC;
    const float size = measure == MEASURE_DISC ? right - left : (to_root ? end : rear) - FRONT_Z;
    return validate_number(why, front, FRONT_Z - SIZE_TOLERANCE, FRONT_Z + SIZE_TOLERANCE,
                           "%s/%s: snout at z", name, lod) &&
           validate_number(why, size, to_root ? 0.8f : 1.0f - SIZE_TOLERANCE, 1.0f + SIZE_TOLERANCE,
                           "%s/%s: size", name, lod);
}

bool validate_meshes(const struct species *species, char why[VALIDATE_WHY_SIZE])
{
    static const char *const lod_names[SPECIES_LOD_COUNT] = { "near", "far" };
    static struct morph_pose pose;
    static vec3 positions[MESH_VERTEX_MAX];
    const struct species_card *card = &species->card;
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        const struct species_mesh *mesh = &species->lod[i];
        const char *lod = lod_names[i];
        if (!validate_counts(mesh, lod, why)) {
            return false;
        }
        for (uint32_t vertex = 0; vertex < mesh->vertex_count; vertex++) {
            if (!validate_vertex(mesh, vertex, card->curve_count, lod, why)) {
                return false;
            }
        }
        if (!validate_triangles(mesh, lod, why) || !validate_grid(mesh, lod, why) ||
            !validate_anchors(mesh, card, lod, why)) {
            return false;
        }
        for (uint32_t key = 0; key < card->key_count; key++) {
            morph_key_pose(mesh, card->key_count, key, &pose);
            morph_shape(mesh, card->key_count, &pose, positions, NULL);
            if (!validate_size(mesh, positions, card->measure, card->key_names[key], lod, why)) {
                return false;
            }
        }
    }
    return true;
}
