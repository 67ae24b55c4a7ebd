/* refit.c -- fits one key of the template to a mesh (see refit.h). The steps are the warp by
 * landmarks, the pull to the surface of the mesh, and the relaxation of the edges. */
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/import/import.h"
#include "platform/ctl/import/refit.h"

#define ROUNDS 24u
/* Number of Gauss-Seidel sweeps (passes over all vertices) in each round. After 30 sweeps the
 * remaining error is about a thousandth of the initial error. */
#define SWEEPS 30u
/* Stiffness of an edge between two template vertices in the first fitting round. A pull of a vertex
 * toward the mesh has the stiffness 1. */
#define STIFF_FIRST 20.0f
/* Stiffness of an edge between two template vertices in the last fitting round. A pull of a vertex
 * toward the mesh has the stiffness 1. */
#define STIFF_LAST 0.15f
/* Weight of the pull that a vertex of the mesh exerts on the nearest vertex of the template. */
#define BACK_PULL 0.5f
/* Maximum number of vertices of the mesh that pull the template. A larger mesh is sampled
 * evenly. */
#define BACK_MAX 6000u
#define EDGE_MAX (3u * MESH_INDEX_MAX)
/* Greatest distance over which a vertex is pulled, as a fraction of the fish's length. A vertex is
 * not pulled to a surface that is farther away. */
#define FAR_SHARE 0.30f

/* State of the fit of one level of detail. All vertices of a part that have the same position move
 * together as one point, which is called a place. */
struct fitting {
    const struct species_mesh *mesh;
    const struct refit_tree *tree;
    bool parted; /* True if the mesh has groups with the names of parts. Each part of the template
                    is then pulled only to the same part of the mesh. */
    uint32_t place[MESH_VERTEX_MAX];
    vec3 rest[MESH_VERTEX_MAX], now[MESH_VERTEX_MAX];
    vec3 pull[MESH_VERTEX_MAX];
    float weight[MESH_VERTEX_MAX];
    /* Neighbours of each place. The neighbours of place i are other[first[i]] .. other[first[i + 1]
     * - 1]. */
    uint32_t first[MESH_VERTEX_MAX + 1], other[EDGE_MAX];
};

static struct refit_tree target_tree, fitted_tree;
static struct fitting fit;

static void refit_draw(uint32_t place, vec3 toward, float weight)
{
    CORE_ASSERT(place < MESH_VERTEX_MAX);
    fit.pull[place] = v3_muladd(fit.pull[place], toward, weight);
    fit.weight[place] += weight;
}

/* Adds the pulls that the vertices of the mesh exert on the nearest vertices of the template.
 * Without these pulls, the rims and the tips of fins would become too short. */
static void draw_from_mesh(const struct import_mesh *mesh)
{
    const uint32_t step = mesh->triangle_count / BACK_MAX + 1u;
    for (uint32_t t = 0; t < mesh->triangle_count; t += step) {
        const enum species_part part = import_part_of(mesh, t);
        const vec3 q = mesh->positions[0][mesh->triangles[t][t % 3]];
        float best = FAR_SHARE * FAR_SHARE;
        uint32_t nearest = MESH_VERTEX_MAX;
        for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
            const vec3 d = v3_sub(fit.now[i], q);
            if (fit.place[i] == i && v3_dot(d, d) < best &&
                (!fit.parted || fit.mesh->vertices[i].part == part)) {
                best = v3_dot(d, d);
                nearest = i;
            }
        }
        if (nearest < MESH_VERTEX_MAX) {
            refit_draw(nearest, q, BACK_PULL);
        }
    }
    /* Limits the sum of the pull weights, so that many vertices of the mesh at one position pull
     * like a single vertex. */
    for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
        if (fit.weight[i] > 1.0f + BACK_PULL) {
            const float less = (1.0f + BACK_PULL) / fit.weight[i];
            fit.pull[i] = v3_scale(fit.pull[i], less);
            fit.weight[i] *= less;
        }
    }
}

/* Moves each place to the position at which its pull and the edges to its neighbours are in
 * balance. Each edge acts as a spring with the stiffness `stiff` and resists any change from its
 * rest shape. */
static void refit_relax(float stiff)
{
    for (uint32_t sweep = 0; sweep < SWEEPS; sweep++) {
        for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
            const uint32_t edges = fit.first[i + 1] - fit.first[i];
            if (fit.place[i] != i || edges == 0) {
                continue;
            }
            vec3 sum = fit.pull[i];
            const float each = stiff / (float)edges;
            for (uint32_t e = fit.first[i]; e < fit.first[i + 1]; e++) {
                const uint32_t j = fit.other[e];
                const vec3 goal = v3_add(fit.now[j], v3_sub(fit.rest[i], fit.rest[j]));
                sum = v3_muladd(sum, goal, each);
            }
            fit.now[i] = v3_scale(sum, 1.0f / (fit.weight[i] + stiff));
        }
    }
}

/* ---- Writing to the mesh tables -------------------------------------------------------------- */

static void put_point(struct species_slot *slot, uint32_t lod, uint32_t key, uint32_t vertex,
                      vec3 position, vec3 normal)
{
    const float reach = slot->species.lod[lod].reach;
    slot->tables[lod].points[key][vertex] =
        (struct species_point){ morph_count(position.x, reach), morph_count(position.y, reach),
                                morph_count(position.z, reach), morph_fold_normal(normal) };
}

/* Writes the points of the body's skin first, because the position of an anchored part depends on
 * the skin. */
static void write_points(struct species_slot *slot, uint32_t lod, uint32_t key)
{
    static vec3 normals[MESH_VERTEX_MAX];
    static struct morph_pose pose;
    const struct species_mesh *mesh = &slot->species.lod[lod];
    import_normals(mesh, mesh->index_count, fit.now, fit.place, normals);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        if (mesh->vertices[i].anchor == ANCHOR_NONE) {
            put_point(slot, lod, key, i, fit.now[i], normals[i]);
        }
    }
    morph_key_pose(mesh, slot->species.card.key_count, key, &pose);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const uint8_t anchor = mesh->vertices[i].anchor;
        if (anchor != ANCHOR_NONE) {
            const struct anchor_pose *at = &pose.anchor[anchor];
            put_point(slot, lod, key, i,
                      pose_rotate_inverse(at->turn, v3_sub(fit.now[i], at->position)),
                      pose_rotate_inverse(at->turn, normals[i]));
        }
    }
}

/* ---- Error of the fit ----------------------------------------------------------------------- */

/* Measures the distances from `count` points to the surface of `tree`. */
static struct refit_error measure_points(const vec3 *points, uint32_t count,
                                         const struct refit_tree *tree)
{
    double sum = 0.0, squares = 0.0;
    float max = 0.0f;
    const double n = fmax((double)count, 1.0);
    for (uint32_t i = 0; i < count; i++) {
        vec3 at;
        const float gap = sqrtf(refit_tree_nearest(tree, points[i], REFIT_TREE_ANY_PART, &at));
        sum += (double)gap;
        squares += (double)gap * (double)gap;
        max = fmaxf(max, gap);
    }
    return (struct refit_error){ (float)(sum / n), (float)sqrt(squares / n), max };
}

/* Measures the distance from each vertex of the fitted template to the mesh, and from each used
 * vertex of the mesh to the fitted template. */
static void refit_measure_error(const struct import_mesh *mesh, struct refit_result *result)
{
    static bool seen[IMPORT_VERTEX_MAX];
    static vec3 used[IMPORT_VERTEX_MAX];
    uint32_t used_count = 0;
    fitted_tree.triangle_count = 0;
    for (uint32_t i = 0; i < fit.mesh->index_count; i += 3) {
        const uint16_t *t = &fit.mesh->indices[i];
        refit_tree_add(&fitted_tree, fit.now[t[0]], fit.now[t[1]], fit.now[t[2]],
                       fit.mesh->vertices[t[0]].part);
    }
    refit_tree_build(&fitted_tree);
    memset(seen, 0, sizeof seen);
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const uint32_t vertex = mesh->triangles[i / 3][i % 3];
        if (!seen[vertex]) {
            used[used_count++] = mesh->positions[0][vertex];
            seen[vertex] = true;
        }
    }
    result->to_mesh = measure_points(fit.now, fit.mesh->vertex_count, fit.tree);
    result->from_mesh = measure_points(used, used_count, &fitted_tree);
}

/* Pairs each landmark of the mesh with the same landmark of the template. `from` receives the
 * positions on the template, and `to` the positions on the mesh. Returns the number of pairs. */
static uint32_t pair_marks(const struct refit_marks *marks, const vec3 *positions, vec3 *from,
                           vec3 *to)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < marks->count; i++) {
        if (refit_marks_of_template(fit.mesh, positions, marks->marks[i].name, &from[count])) {
            to[count++] = marks->marks[i].place;
        }
    }
    return count;
}

static void refit_begin(const struct species_slot *slot, uint32_t lod, uint32_t key,
                        const struct import_mesh *mesh)
{
    static struct morph_pose pose;
    fit.mesh = &slot->species.lod[lod];
    fit.tree = &target_tree;
    fit.parted = false;
    for (uint32_t i = 0; i < mesh->group_count; i++) {
        fit.parted = fit.parted || import_part(mesh->group_names[i]) != PART_BODY;
    }
    morph_key_pose(fit.mesh, slot->species.card.key_count, key, &pose);
    morph_shape(fit.mesh, slot->species.card.key_count, &pose, fit.now, NULL);
    for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
        fit.place[i] = i;
        for (uint32_t j = 0; j < i && fit.place[i] == i; j++) {
            const vec3 d = v3_sub(fit.now[i], fit.now[j]);
            if (fit.mesh->vertices[i].part == fit.mesh->vertices[j].part &&
                fit.mesh->vertices[i].side == fit.mesh->vertices[j].side && v3_dot(d, d) < 1e-12f) {
                fit.place[i] = fit.place[j];
            }
        }
    }
    /* `other` lists the neighbours of each place along the edges. A neighbour is listed once for
     * each triangle that has the edge. */
    static uint32_t fill[MESH_VERTEX_MAX];
    memset(fit.first, 0, sizeof fit.first);
    for (uint32_t i = 0; i < fit.mesh->index_count; i++) {
        fit.first[fit.place[fit.mesh->indices[i]] + 1] += 2;
    }
    for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
        fit.first[i + 1] += fit.first[i];
        fill[i] = fit.first[i];
    }
    for (uint32_t i = 0; i < fit.mesh->index_count; i++) {
        const uint32_t t = i - i % 3, at = fit.place[fit.mesh->indices[i]];
        fit.other[fill[at]++] = fit.place[fit.mesh->indices[t + (i + 1) % 3]];
        fit.other[fill[at]++] = fit.place[fit.mesh->indices[t + (i + 2) % 3]];
    }
}

/* Scales the far mesh to the fish's measured length. Without this scaling, the fitted far mesh
 * would end slightly before the fish's tips, because it has few vertices and each vertex moves to
 * the mean of several pulls. */
static void stretch_to_measure(uint8_t measure)
{
    const bool across = measure == MEASURE_DISC;
    float low = INFINITY, high = -INFINITY;
    if (measure != MEASURE_TOTAL && !across) {
        return;
    }
    for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
        const float x = across ? fit.now[i].x : fit.now[i].z;
        low = fminf(low, x);
        high = fmaxf(high, x);
    }
    const float factor = 1.0f / fmaxf(high - low, 0.5f);
    for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
        if (across) {
            fit.now[i].x *= factor;
        } else {
            fit.now[i].z = -0.5f + (fit.now[i].z - low) * factor;
        }
    }
}

static void fit_lod(struct species_slot *slot, uint32_t lod, uint32_t key,
                    const struct import_mesh *mesh, const struct refit_marks *marks,
                    struct refit_result *result)
{
    CORE_ASSERT(lod < SPECIES_LOD_COUNT);
    vec3 from[REFIT_MARKS_MAX], to[REFIT_MARKS_MAX];
    refit_begin(slot, lod, key, mesh);
    const uint32_t count = pair_marks(marks, fit.now, from, to);
    refit_marks_warp(from, to, count, fit.now, fit.mesh->vertex_count);
    memcpy(fit.rest, fit.now, sizeof fit.rest);
    for (uint32_t round = 0; round < ROUNDS; round++) {
        const float t = (float)round / (float)(ROUNDS - 1u);
        memset(fit.pull, 0, sizeof fit.pull);
        memset(fit.weight, 0, sizeof fit.weight);
        for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
            vec3 at;
            if (fit.place[i] == i && refit_tree_nearest(fit.tree, fit.now[i],
                                                        fit.parted ? fit.mesh->vertices[i].part
                                                                   : (uint8_t)REFIT_TREE_ANY_PART,
                                                        &at) < FAR_SHARE * FAR_SHARE) {
                refit_draw(i, at, 1.0f);
            }
        }
        draw_from_mesh(mesh);
        refit_relax(STIFF_FIRST * powf(STIFF_LAST / STIFF_FIRST, t));
        for (uint32_t i = 0; i < fit.mesh->vertex_count; i++) {
            fit.now[i] = fit.now[fit.place[i]];
        }
        /* The result of this round becomes the rest shape of the edges in the next round. */
        memcpy(fit.rest, fit.now, sizeof fit.rest);
    }
    if (lod > 0) {
        stretch_to_measure(slot->species.card.measure);
    }
    write_points(slot, lod, key);
    if (lod == 0) {
        refit_measure_error(mesh, result);
        result->mark_max = 0.0f;
        const uint32_t pairs = pair_marks(marks, fit.now, from, to);
        for (uint32_t i = 0; i < pairs; i++) {
            result->mark_max = fmaxf(result->mark_max, v3_length(v3_sub(from[i], to[i])));
        }
    }
}

void refit_key(struct species_slot *slot, uint32_t key, const struct import_mesh *mesh,
               const struct refit_marks *marks, struct refit_result *result)
{
    CORE_ASSERT(key < slot->species.card.key_count);
    CORE_ASSERT(marks->count <= REFIT_MARKS_MAX);
    CORE_ASSERT(mesh->triangle_count <= REFIT_TREE_TRIANGLE_MAX);
    target_tree.triangle_count = 0;
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        refit_tree_add(&target_tree, mesh->positions[0][t[0]], mesh->positions[0][t[1]],
                       mesh->positions[0][t[2]], (uint8_t)import_part_of(mesh, i));
    }
    refit_tree_build(&target_tree);
    /* Finds the landmark that is farthest from the surface of the mesh. */
    result->stray = "";
    result->stray_gap = 0.0f;
    for (uint32_t i = 0; i < marks->count; i++) {
        vec3 at;
        const float gap = sqrtf(
            refit_tree_nearest(&target_tree, marks->marks[i].place, REFIT_TREE_ANY_PART, &at));
        if (gap > result->stray_gap) {
            result->stray = marks->marks[i].name;
            result->stray_gap = gap;
        }
    }
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        fit_lod(slot, lod, key, mesh, marks, result);
    }
}
