/* morph.h -- the shape of a fish of any age, blended from three or more drawings (2005 thesis).
 *
 * A key shape (key) is one modelled growth stage. The shape is computed in this order: age ->
 * progress through the keys -> weights of the keys (one deformation graph per curve) -> pose ->
 * shape. The length is a separate function of the age or of the progress.
 *
 * Progress is in [0, 1], and key i of n is at progress i / (n - 1). All functions are pure, and the
 * caller owns all memory. core/morph/README.md describes the method. */
#ifndef KINGYO_CORE_MORPH_MORPH_H
#define KINGYO_CORE_MORPH_MORPH_H

#include <stdbool.h>

#include "core/morph/species.h"

/* ---- growth.c: length and age -------------------------------------------------------------- */

/* Returns the length in metres at `age_days` days after hatching. Asserts that `age_days` >= 0. */
float growth_length_m(const struct growth *growth, float age_days);

/* Returns the youngest age in days with the length `length_m`, with an error of at most 0.1 day.
 * Returns 0 if the fish is longer at hatching, and 40 years if the fish never reaches the
 * length. */
float growth_age_days(const struct growth *growth, float length_m);

/* Returns the youngest age within [from_days, to_days] with the length `length_m`, or -1 if there
 * is none. */
float growth_age_between(const struct growth *growth, float from_days, float to_days,
                         float length_m);

/* Returns true if the length only rises or only falls between the two ages. The result is false for
 * a conger, for example, which shrinks during its metamorphosis. */
bool growth_is_one_way(const struct growth *growth, float from_days, float to_days);

/* Returns the growth curve of the thesis (section 3.2): eq. 3.3 alone, with t0 shifted so that
 * the fish hatches at its measured length. Later measurements are ignored, and adults become too
 * small. */
struct growth growth_shifted(const struct growth *growth);

/* Returns the progress [0, 1] at an age >= 0 (life.c). Between two keys, progress follows the
 * logarithm of length if the length is monotone there, because fish grow by factors. Otherwise
 * progress follows age. */

float life_progress(const struct species_card *card, float age_days);

/* Returns the age in days at `progress` in [0, 1]; the inverse of life_progress(). */
float life_age_days(const struct species_card *card, float progress);
/* Returns the length in metres at `progress`. The length follows the growth curve, or the
 * hand-drawn scale knots of the card with logarithmic interpolation if the card has any. */
float life_length_m(const struct species_card *card, float progress);
/* Returns the earliest progress with the length `length_m`. If there is none, returns 1 for a fish
 * longer than the youngest key, otherwise 0. */
float morph_progress(const struct species_card *card, float length_m);

/* Faults of a deformation graph (graph.c), which gives the weight of each key as a fish grows. */

enum graph_fault {
    GRAPH_GOOD = 0,
    GRAPH_KNOT_COUNT, /* The graph has fewer than 2 knots or more than GRAPH_KNOT_MAX. */
    GRAPH_ENDS,       /* The first knot is not at progress 0, or the last knot is not at progress
                         1. */
    GRAPH_ORDER,      /* The progress of `knot` is not greater than the progress of the previous
                         knot. */
    GRAPH_NEGATIVE,   /* The weight of `key` at `knot` is negative or NaN. */
    GRAPH_SUM,        /* The weights of `knot` sum to `value` instead of 1, with an error above
                         1e-6. */
    GRAPH_UNSOLVABLE, /* Solved shapes are requested, but the graph gives `key` hardly any weight
                         even at the progress of `key`. */
};

struct graph_verdict {
    uint8_t fault; /* Fault of the graph (enum graph_fault). */
    uint8_t knot, key;
    float value;
};

/* Returns the first fault of a graph with its knot, key and value. The fault is GRAPH_GOOD if the
 * graph is valid. */
struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count);

/* Writes the weights of all keys at `progress` in [0, 1]. Each weight is at least 0, and the
 * weights sum to 1 within 1e-6. Keys from `key_count` on get the weight 0. */
void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX]);

/* Solves exaggerated shapes for a graph that never shows a key alone (solve.c). `solution[i][j]`
 * receives the weight of drawn key j in the shape solved for key i, and each row sums to 1. A fish
 * that is blended from the solved shapes passes through the drawing of key i at progress i / (n -
 * 1). Returns false if the solution would need more than a tenfold exaggeration, and writes the
 * index of the key to `stuck`. */
bool solve_graph(const struct graph *graph, uint32_t key_count,
                 float solution[MORPH_KEY_MAX][MORPH_KEY_MAX], uint32_t *stuck);

/* Standard graphs (template.c) that can replace the graphs of a species. */

enum graph_template {
    TEMPLATE_OWN = 0,      /* The graphs of the species are used. */
    TEMPLATE_ORDINARY,     /* Only the first and the last key are blended (eq. 3.1). */
    TEMPLATE_PAIRWISE,     /* Two adjacent keys are blended at a time, and each key reaches weight 1
                              (figure 3.8). */
    TEMPLATE_SIMULTANEOUS, /* Three keys are blended at a time (figure 3.9). An inner key has the
                              weight `peak` at its own progress, and its neighbours share the
                              rest. */
    TEMPLATE_SMOOTH,       /* The weights are those of a cubic B-spline, so that the path has no
                              corner at any key. */
    TEMPLATE_COUNT,
};

/* Peak weight of the species hirame in section 4.2 of the thesis. */
#define SIMULTANEOUS_PEAK 0.70f

/* Writes a standard graph. Asserts that `template_id` is not TEMPLATE_OWN and that `peak` is in
 * (0.5, 1]. `peak` affects only TEMPLATE_SIMULTANEOUS. */
void template_graph(struct graph *graph, enum graph_template template_id, uint32_t key_count,
                    float peak);

/* The curves (deformation graphs) that blend a fish, prepared for repeated evaluation (rig.c). */

struct morph_rig {
    uint32_t key_count, curve_count;
    struct graph curves[MORPH_CURVE_MAX];
    /* solution[c][i][j]: weight of drawn key j in the shape that is solved for key i of curve c.
     * The identity matrix if curve c is not solved. */
    float solution[MORPH_CURVE_MAX][MORPH_KEY_MAX][MORPH_KEY_MAX];
};

/* Initializes a rig. TEMPLATE_OWN uses the curves of the card, and any other template replaces all
 * curves. A curve that cannot be solved blends the drawn shapes directly; graph_check() returns the
 * reason. */
void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template_id);

/* Writes the weights of the drawn keys for each curve. The weights of a curve sum to 1, and only a
 * solved curve can have negative weights. A solved curve has exactly weight 1 for key i at progress
 * i / (n - 1). */
void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX]);

/* Rotation (pose.c). */

struct quat {
    float x, y, z, w; /* Components of a unit quaternion. */
};

/* Returns `a` rotated by `q`: a + 2 w (v x a) + 2 v x (v x a), where v = (x, y, z). */
vec3 pose_rotate(struct quat q, vec3 a);

/* Returns `a` rotated by the inverse of `q`. */
vec3 pose_rotate_inverse(struct quat q, vec3 a);

/* Values that differ from fish to fish; a renderer uploads the struct without conversion.
 *
 * A vertex has the masks m, and the points P_k and normals N_k in the keys. W are the weights of
 * the curves. The normals are unfolded onto the octahedron |x| + |y| + |z| = 1 before the sum.
 *     w_k      = (sum over the curves c of m[c] * W[c][k]) / 255
 *     position = sum over the keys of w_k * P_k
 *     normal   = normalize(sum over the keys of w_k * N_k)
 * A vertex with an anchor of rotation q and position A is then moved:
 *     position = A + q position q*          (pose_rotate)
 *     normal   = q normal q*
 * For an anchor that does not rotate, q is the identity. */
struct morph_pose {
    float weight[MORPH_CURVE_MAX][MORPH_KEY_MAX]; /* Weights of the keys for each curve, as written
                                                     by morph_weights(). */
    struct anchor_pose {
        vec3 position;    /* Position of the anchor in the body frame. */
        struct quat turn; /* Rotation of the anchor; the identity if the anchor does not rotate. */
    } anchor[ANCHOR_MAX]; /* Poses of the mesh's anchors; the first `anchor_count` entries are
                             valid. */
};

/* Writes the weights and the anchors of a fish at `progress` in [0, 1]. */
void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose);

/* Writes the pose that shows key `key` alone. */
void morph_key_pose(const struct species_mesh *mesh, uint32_t key_count, uint32_t key,
                    struct morph_pose *pose);

/* Returns the place with the body coordinates (u, v) on the skin that is blended by `pose->weight`.
 * The place lies on the drawn triangles: the diagonal of each grid cell joins (ring, next spoke)
 * and (next ring, spoke). u is clamped to the rings of the grid, and v counts turns around the
 * body. If `turns` is set, the result also has a rotation: x along the skin's normal, z backward
 * along the skin, and y = z cross x. Otherwise the rotation is the identity. The mesh must have a
 * grid of at least 2 rings and 3 spokes (asserted), and the vertices of the grid must have no
 * anchor. A vertex at p in the body frame of a key is at pose_rotate_inverse(turn, p - position)
 * relative to its anchor. */
struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns);

/* Writes the anchors of `pose` from the weights of `pose`. The curve of each anchor blends the
 * anchor's u and v. */
void morph_ride_all(const struct species_mesh *mesh, uint32_t key_count, struct morph_pose *pose);

/* ---- blend.c: eq. 3.2 on the CPU ----------------------------------------------------------- */

/* Writes the positions and normals of all vertices by the formula at struct morph_pose. `positions`
 * and `normals` have mesh->vertex_count entries, and each may be null. */
void morph_shape(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 vec3 *positions, vec3 *normals);

/* Writes the same bits as morph_shape(), for `lanes` = 1, 4 or 8 vertices at a time. The caller
 * must ensure that the processor has AVX2 if `lanes` is 8. */
void morph_shape_lanes(const struct species_mesh *mesh, uint32_t key_count,
                       const struct morph_pose *pose, vec3 *positions, vec3 *normals,
                       uint32_t lanes);

/* Returns one blended vertex before its anchor rotates and moves it. */
struct morph_point {
    vec3 position, normal;
} morph_point(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
              uint32_t vertex);

/* Returns the position of a blended vertex before its anchor rotates and moves it. */
vec3 morph_place(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 uint32_t vertex);

/* Returns the position of a vertex in a key, converted from counts to body lengths. */
vec3 morph_position(const struct species_mesh *mesh, uint32_t key, uint32_t vertex);

/* Returns the unit normal for a folded normal of struct species_point. */
vec3 morph_normal(int16_t folded);

/* Returns the folded form of a unit normal; the inverse of morph_normal(). */
int16_t morph_fold_normal(vec3 normal);

/* Returns the count for the coordinate `x` in a mesh with the given `reach`, rounded to nearest
 * with ties away from 0. Coordinates beyond the reach are clamped. The inverse of morph_position()
 * on each axis. */
int16_t morph_count(float x, float reach);

/* ---- straight.c: the method of the thesis, for comparison ---------------------------------- */

struct straight_memory { /* Memory of a straightened species. The caller owns the memory and keeps
                            it as long as the species. */
    struct species_vertex vertices[SPECIES_LOD_COUNT][MESH_VERTEX_MAX];
    struct species_point points[SPECIES_LOD_COUNT][MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct morph_pose pose; /* Scratch memory, like `positions` and `normals`. */
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Writes a species with the same key shapes but without anchors and masks, so that every vertex
 * moves in a straight line (eq. 3.1 and 3.2). Vertices on anchors are converted to the body frame
 * of each key, with an error of at most one count. Unchanged tables still belong to `from`, which
 * must outlive `out`. `out` must not be `from`. */
void straight_species(const struct species *from, struct straight_memory *memory,
                      struct species *out);

/* Writes a straightened species with the three keys and the template of chapter 4 of the thesis.
 * The middle key is exaggerated (solved) if the template is TEMPLATE_SIMULTANEOUS. Keys keep their
 * ages, and their lengths follow growth_shifted(). */
void straight_thesis(const struct species *from, struct straight_memory *memory,
                     struct species *out);

/* Colour and surface of a point on the fish (paint.c). */

struct paint {
    vec3 colour; /* Colour in sRGB, each component in [0, 1]. */
    float clear; /* Transparency in [0, 1]; 0 is opaque. */
    float shine; /* Silver shine in [0, 1]; 0 is dull. */
};

/* Returns the paint at the coordinates `at` (u, v, part, side), which need not be those of a
 * vertex. `weights` blend the coats of the keys; negative weights count as 0, and the sum is
 * normalised to 1. */
struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at);

#endif
