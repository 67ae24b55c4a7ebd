/* morph.h -- the shape of a fish of any age from three or more drawings (2005 thesis).
 *
 * Chain: age -> progress between the keys -> weights (one deformation graph per curve) -> pose ->
 * shape; and age -> length (scale curve).
 *
 * Progress is in [0, 1]: key i of n is at i / (n - 1). All functions are pure; the caller owns all
 * memory. core/morph/README.md describes the method. */
#ifndef KINGYO_CORE_MORPH_MORPH_H
#define KINGYO_CORE_MORPH_MORPH_H

#include <stdbool.h>

#include "core/morph/species.h"

/* growth.c: length and age */

/* Returns the length in metres at `age_days` >= 0 after hatching. */
float growth_length_m(const struct growth *growth, float age_days);

/* Returns the youngest age with length `length_m`, within 0.1 day, clamped to [0, 40 years]. */
float growth_age_days(const struct growth *growth, float length_m);

/* Returns the youngest age with length `length_m` within [from_days, to_days]; below 0 if there is
 * none. */
float growth_age_between(const struct growth *growth, float from_days, float to_days,
                         float length_m);

/* Returns true if length only increases, or only decreases, between two ages. A conger shrinks in
 * between. */
bool growth_is_one_way(const struct growth *growth, float from_days, float to_days);

/* Returns the method of the thesis (section 3.2): eq. 3.3 alone, with t0 shifted until the fish
 * hatches at its true length. Later measurements are ignored, and adults become too small. */
struct growth growth_shifted(const struct growth *growth);

/* life.c: age <-> progress <-> length. Between two keys progress follows the logarithm of length if
 * length is monotone there (fish grow by factors); otherwise age. */

float life_progress(const struct species_card *card, float age_days);
float life_age_days(const struct species_card *card, float progress);
/* Returns the length by the scale curve: the growth curve at that age, or the scale knots of the
 * card with logarithmic interpolation. */
float life_length_m(const struct species_card *card, float progress);
/* Returns the earliest progress with length `length_m`. A length that never occurs returns 0 if the
 * youngest key is longer, otherwise 1. */
float morph_progress(const struct species_card *card, float length_m);

/* graph.c: weights */

enum graph_fault {
    GRAPH_GOOD = 0,
    GRAPH_KNOT_COUNT, /* Fewer than 2 knots, or more than GRAPH_KNOT_MAX. */
    GRAPH_ENDS,       /* The first knot is not at 0, or the last not at 1. */
    GRAPH_ORDER,      /* `knot` does not lie behind the previous knot. */
    GRAPH_NEGATIVE,   /* The weight of `key` at `knot` is negative or NaN. */
    GRAPH_SUM,        /* The weights of `knot` sum to `value` instead of 1 within 1e-6. */
    GRAPH_UNSOLVABLE, /* The graph is to be solved, but hardly shows `key` even at that key's
                         progress. */
};

struct graph_verdict {
    uint8_t fault; /* enum graph_fault */
    uint8_t knot, key;
    float value;
};

struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count);

/* Writes the weights at `progress` in [0, 1]: each >= 0, sum 1 within 1e-6; unused keys get 0. */
void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX]);

/* solve.c: exaggerated shapes for a graph that shows no key alone. `solution[i][j]` is the weight
 * of drawn key j in the shape solved for key i (rows sum to 1). A fish blended from solved shapes
 * passes through every drawing at i / (n - 1). Returns false, with the key in `stuck`, if the
 * solution would need more than a tenfold exaggeration. */
bool solve_graph(const struct graph *graph, uint32_t key_count,
                 float solution[MORPH_KEY_MAX][MORPH_KEY_MAX], uint32_t *stuck);

/* template.c: standard graphs */

enum graph_template {
    TEMPLATE_OWN = 0,      /* The graph of the species itself. */
    TEMPLATE_ORDINARY,     /* Eq. 3.1: only the first and the last key. */
    TEMPLATE_PAIRWISE,     /* Figure 3.8: two neighbours at a time; each key reaches weight 1. */
    TEMPLATE_SIMULTANEOUS, /* Figure 3.9: inner keys peak at `peak`, and their neighbours share the
                              rest. */
    TEMPLATE_SMOOTH,       /* Weights of a cubic B-spline: the path has no corner at any key. */
    TEMPLATE_COUNT,
};

#define SIMULTANEOUS_PEAK 0.70f /* Value for the hirame in section 4.2. */

/* Writes a standard graph. `template_id` must not be TEMPLATE_OWN; `peak` in (0.5, 1) affects only
 * TEMPLATE_SIMULTANEOUS. */
void template_graph(struct graph *graph, enum graph_template template_id, uint32_t key_count,
                    float peak);

/* rig.c: the curves that blend a fish, prepared for repeated evaluation */

struct morph_rig {
    uint32_t key_count, curve_count;
    struct graph curves[MORPH_CURVE_MAX];
    /* Weight of drawn key j in the shape solved for key i; the identity matrix if nothing is
     * solved. */
    float solution[MORPH_CURVE_MAX][MORPH_KEY_MAX][MORPH_KEY_MAX];
};

/* Initialises a rig. TEMPLATE_OWN uses the curves of the card; any other template replaces all of
 * them. A curve that cannot be solved (graph_check() returns the reason) blends the drawn shapes
 * directly. */
void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template_id);

/* Writes the factors of the drawn key shapes for each curve: sum 1, negative only for solved
 * shapes. A solved curve gives each key alone, exactly, at i / (n - 1). */
void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX]);

/* pose.c: the values of a vertex shader besides the tables */

struct quat {
    float x, y, z, w; /* Unit quaternion. */
};

/* Returns a + 2 w (q x a) + 2 q x (q x a), with q = (x, y, z); pose_rotate_inverse() is the
 * inverse. */
vec3 pose_rotate(struct quat q, vec3 a);
vec3 pose_rotate_inverse(struct quat q, vec3 a);

/* All that changes from one fish to the next: to be uploaded as it is.
 *
 * A vertex of mask m, in curves' weights W and key points P_k, N_k (a normal is unfolded onto the
 * octahedron |x| + |y| + |z| = 1 and blended there):
 *     w_k      = (sum over the curves c of m[c] * W[c][k]) / 255
 *     position = sum over the keys of w_k * P_k
 *     normal   = normalize(sum over the keys of w_k * N_k)
 * and if it has an anchor, of turn q and position A:
 *     position = A + q position q*          (pose_rotate)
 *     normal   = q normal q*
 * Where an anchor does not turn, q is the identity, so there is one formula for all. */
struct morph_pose {
    float weight[MORPH_CURVE_MAX][MORPH_KEY_MAX]; /* As written by morph_weights(). */
    struct anchor_pose {
        vec3 position;    /* Position in the body frame. */
        struct quat turn; /* The identity if the anchor does not rotate. */
    } anchor[ANCHOR_MAX]; /* The first anchor_count entries of the mesh are valid. */
};

void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose);

/* Writes the pose that shows key `key` alone. */
void morph_key_pose(const struct species_mesh *mesh, uint32_t key_count, uint32_t key,
                    struct morph_pose *pose);

/* Returns the place of body coordinates (u, v) on the skin blended by `pose->weight`. The place
 * lies on the two triangles of the grid cell, which meet between (ring, next spoke) and (next ring,
 * spoke). u is clamped to the rings of the grid, v counts turns. If `turns`: x is along the skin's
 * normal, z backward along the skin, y = z cross x. The mesh must have a grid of at least 2 rings
 * and 3 spokes whose vertices have no anchor. A vertex drawn at p in the body frame of a key is,
 * relative to its anchor there, pose_rotate_inverse(turn, p - position). */
struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns);

/* Sets the anchors of the pose from its weights: the u and v of each anchor are blended by its own
 * curve. */
void morph_ride_all(const struct species_mesh *mesh, uint32_t key_count, struct morph_pose *pose);

/* blend.c: eq. 3.2 on the CPU */

/* Writes `positions` and `normals` (either may be null), each mesh->vertex_count long; the formula
 * stands at struct morph_pose. */
void morph_shape(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 vec3 *positions, vec3 *normals);

/* Writes the same bits as morph_shape(), 1, 4 or 8 vertices at a time; 8 needs AVX2. */
void morph_shape_lanes(const struct species_mesh *mesh, uint32_t key_count,
                       const struct morph_pose *pose, vec3 *positions, vec3 *normals,
                       uint32_t lanes);

/* One vertex, before its anchor rotates and moves it. */
struct morph_point {
    vec3 position, normal;
} morph_point(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
              uint32_t vertex);

/* Returns the position of a vertex before its anchor moves it. */
vec3 morph_place(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 uint32_t vertex);

/* Convert the position (counts times reach) and the unit normal of a point. */
vec3 morph_position(const struct species_mesh *mesh, uint32_t key, uint32_t vertex);
vec3 morph_normal(int16_t folded);
int16_t morph_fold_normal(vec3 normal);

/* Returns the count nearest to a coordinate `x` in a mesh with this `reach`, ties away from 0.
 * Values beyond the reach are clamped. The inverse of morph_position() for each axis. */
int16_t morph_count(float x, float reach);

/* straight.c: the method of the thesis, for comparison */

struct straight_memory { /* Owned by the caller, and in use as long as the species made from it. */
    struct species_vertex vertices[SPECIES_LOD_COUNT][MESH_VERTEX_MAX];
    struct species_point points[SPECIES_LOD_COUNT][MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct morph_pose pose; /* Scratch memory, like the two arrays below. */
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Writes the same key shapes without anchors and masks, so that every vertex moves straight (eq.
 * 3.1 and 3.2). Vertices on anchors are baked into the body frame of each key (within a count).
 * Unchanged tables remain those of `from`, which must outlive `out`; `out` must not be `from`. */
void straight_species(const struct species *from, struct straight_memory *memory,
                      struct species *out);

/* Straightens a species to the three keys of chapter 4 with its template. The middle key is
 * exaggerated (solved) if that template is the simultaneous one. Keys keep their ages; sizes are
 * those of the shifted growth curve. */
void straight_thesis(const struct species *from, struct straight_memory *memory,
                     struct species *out);

/* paint.c: colour */

struct paint {
    vec3 colour; /* sRGB, [0, 1] each. */
    float clear; /* [0, 1] transparency. */
    float shine; /* [0, 1] */
};

/* Returns the paint at vertex coordinates `at` (u, v, part, side), at vertices or between them. The
 * coats of the keys are blended by `weights`, which are first clamped to >= 0 and normalised to sum
 * 1. */
struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at);

#endif
