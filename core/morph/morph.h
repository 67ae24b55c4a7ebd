/* morph.h -- computes the shape of a fish at any age by blending three or more drawn shapes.
 *
 * The method is the one of the 2005 thesis (core/morph/README.md). A key shape (key) is one
 * modelled growth stage. The shape is computed in this order: age -> progress through the keys ->
 * weights of the keys (one deformation graph per curve) -> pose -> shape. The length is a separate
 * function of the age or of the progress.
 *
 * Progress is in [0, 1], and key i of n keys is at progress i / (n - 1). All functions are pure,
 * and the caller owns all memory. */
#pragma once

#include <stdbool.h>

#include "core/morph/species.h"

/* ---- growth.c: length and age -------------------------------------------------------------- */

/* Returns the length in metres of a fish that is `age_days` days old, counted from hatching.
 * Asserts that `age_days` >= 0. */
float growth_length_m(const struct growth *growth, float age_days);

/* Returns the youngest age in days at which a fish has the length `length_m`, with an error of at
 * most 0.1 day. Returns 0 if a fish is already longer than `length_m` at hatching. Returns 40 years
 * (in days) if a fish never reaches `length_m`. */
float growth_age_days(const struct growth *growth, float length_m);

/* Returns the youngest age in days within [from_days, to_days] at which a fish has the length
 * `length_m`. Returns -1 if the fish has this length at no age in the range. */
float growth_age_between(const struct growth *growth, float from_days, float to_days,
                         float length_m);

/* Returns true if the length only increases or only decreases between the two ages. Returns false
 * if the length is equal at both ages. For example, the result is false for a range of ages in
 * which a conger first grows and then shrinks. */
bool growth_is_one_way(const struct growth *growth, float from_days, float to_days);

/* Returns the growth curve of the 2005 thesis, section 3.2. The curve is eq. 3.3, with its time
 * constant t0 shifted until the fish has its measured length at hatching. All later measurements
 * are ignored, and therefore the adults are too small. */
struct growth growth_shifted(const struct growth *growth);

/* Returns the progress in [0, 1] of a fish at an age of at least 0 days (life.c). If the length
 * only increases or only decreases between two keys, progress is a linear function of the
 * logarithm of length, because growth multiplies the length. Otherwise progress is a linear
 * function of age. */

float life_progress(const struct species_card *card, float age_days);

/* Returns the age in days at `progress` in [0, 1]. The function is the inverse of
 * life_progress(). */
float life_age_days(const struct species_card *card, float progress);
/* Returns the length in metres at `progress`. If the card has a hand-drawn size curve
 * (`scale_knots`), the length is interpolated logarithmically between its knots. Otherwise the
 * length follows the growth curve. */
float life_length_m(const struct species_card *card, float progress);
/* Returns the lowest progress in [0, 1] at which a fish has the length `length_m`. If the fish
 * never has this length, returns 0 for a length below the length at progress 0, and 1 for any
 * greater length. */
float morph_progress(const struct species_card *card, float length_m);

/* Faults of a deformation graph (graph.c), which gives the weight of each key as a fish grows. */

enum graph_fault {
    GRAPH_GOOD = 0,
    GRAPH_KNOT_COUNT, /* The graph has fewer than 2 knots or more than GRAPH_KNOT_MAX knots. */
    /* The first knot is not at progress 0, or the last knot is not at progress 1. */
    GRAPH_ENDS,
    /* The progress of knot `knot` is not greater than the progress of the previous knot. */
    GRAPH_ORDER,
    GRAPH_NEGATIVE, /* The weight of key `key` at knot `knot` is negative or NaN. */
    /* The weights of knot `knot` sum to `value`, which differs from 1 by more than 1e-6. */
    GRAPH_SUM,
    /* The graph has `solved` set, but graph_solve() fails, because key `key` has too little weight
     * at the progress of this key. */
    GRAPH_UNSOLVABLE,
};

struct graph_verdict {
    uint8_t fault; /* First fault that graph_check() found (enum graph_fault). The members
                      `knot`, `key` and `value` give the place of the fault. */
    uint8_t knot, key;
    float value;
};

/* Returns the first fault of a graph, with the knot, the key and the value that cause the fault. If
 * the graph is valid, the fault is GRAPH_GOOD. */
struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count);

/* Writes the weights of all keys at `progress` in [0, 1]. Each weight is at least 0, and the
 * weights sum to 1 with an error of at most 1e-6. Entries of `weights` from index `key_count` on
 * are set to 0. */
void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX]);

/* Computes exaggerated key shapes for a graph that never gives a single key the weight 1.
 * `solution[i][j]` receives the weight of drawn key j in the exaggerated shape for key i, and each
 * row sums to 1. A fish that is blended from the exaggerated shapes has exactly the drawn shape of
 * key i at progress i / (n - 1), where n is `key_count`. Returns false if an exaggeration of more
 * than ten times would be necessary, and then writes the index of the key that fails to `stuck`. */
bool graph_solve(const struct graph *graph, uint32_t key_count,
                 float solution[MORPH_KEY_MAX][MORPH_KEY_MAX], uint32_t *stuck);

/* Standard graphs, which a caller can use in place of the graphs of a species. */

enum graph_template {
    TEMPLATE_OWN = 0,  /* The graphs of the species are used unchanged. */
    TEMPLATE_ORDINARY, /* Only the first and the last key are blended (2005 thesis, eq. 3.1). */
    /* Two adjacent key shapes are blended at a time, and each reaches the weight 1 (2005 thesis,
     * figure 3.8). */
    TEMPLATE_PAIRWISE,
    /* Three adjacent key shapes are blended at a time (2005 thesis, figure 3.9). At the growth
     * progress of an inner key shape, this shape has the weight `peak`, and each of its two
     * neighbours has the weight (1 - peak) / 2. */
    TEMPLATE_SIMULTANEOUS,
    /* The weights at each key are those of a cubic B-spline, so that the path of a vertex has no
     * corner. */
    TEMPLATE_SMOOTH,
    TEMPLATE_COUNT,
};

/* Weight of the middle key at its own progress in the 2005 thesis, section 4.2, for the species
 * hirame (a flatfish). */
#define SIMULTANEOUS_PEAK 0.70f

/* Writes a standard graph to `graph`. Asserts that `template_id` is not TEMPLATE_OWN and that
 * `peak` is in (0.5, 1]. Only TEMPLATE_SIMULTANEOUS uses `peak`. */
void graph_from_template(struct graph *graph, enum graph_template template_id, uint32_t key_count,
                         float peak);

/* Deformation graphs of one fish, one graph for each curve, in a form that is fast to evaluate
 * (pose.c). */

struct morph_rig {
    uint32_t key_count, curve_count;
    struct graph curves[MORPH_CURVE_MAX];
    /* solution[c][i][j] is the weight of drawn key j in the exaggerated shape for key i of curve c.
     * solution[c] is the identity matrix if the drawn shapes are blended directly. */
    float solution[MORPH_CURVE_MAX][MORPH_KEY_MAX][MORPH_KEY_MAX];
};

/* Initializes a rig. TEMPLATE_OWN uses the graphs of the card, and any other template replaces the
 * graphs of all curves. If graph_solve() fails for a graph, the drawn shapes are blended directly.
 * In this case, graph_check() returns the fault of the graph. */
void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template_id);

/* Writes the weights of the drawn keys for each curve at `progress` in [0, 1]. The weights of a
 * curve sum to 1. Weights can be negative only if the graph of the curve has `solved` set. With
 * `solved` set, key i of n keys has exactly the weight 1 at progress i / (n - 1). */
void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX]);

/* Rotation as a unit quaternion (pose.c). */

struct quat {
    float x, y, z, w; /* Vector part (x, y, z) and scalar part w of the unit quaternion. */
};

/* Returns `a` rotated by `q`. With v = (x, y, z), the result is a + 2 * w * (v cross a) + 2 * (v
 * cross (v cross a)). */
vec3 pose_rotate(struct quat q, vec3 a);

/* Returns `a` rotated by the inverse of `q`. */
vec3 pose_rotate_inverse(struct quat q, vec3 a);

/* Weights and anchors of one fish. Only these values differ between fish of one species. A renderer
 * uploads the struct without conversion.
 *
 * Each vertex has a mask m[c] for each curve c, and a point P_k and a normal N_k in each key k.
 * W[c][k] is the weight of key k in curve c. The normals N_k are points of the octahedron |x| + |y|
 * + |z| = 1.
 *     w_k      = (sum over the curves c of m[c] * W[c][k]) / 255
 *     position = sum over the keys of w_k * P_k
 *     normal   = normalize(sum over the keys of w_k * N_k)
 * A vertex with an anchor is then moved by the rotation q and the position A of the anchor:
 *     position = A + pose_rotate(q, position)
 *     normal   = pose_rotate(q, normal)
 * For an anchor that does not rotate, q is the identity. */
struct morph_pose {
    /* Weights of the keys for each curve, as written by morph_weights(). */
    float weight[MORPH_CURVE_MAX][MORPH_KEY_MAX];
    struct anchor_pose {
        vec3 position;    /* Position of the anchor in the body frame. */
        struct quat turn; /* Rotation of the anchor; the identity if the anchor does not rotate. */
        /* Poses of the anchors of the mesh. Only the first `anchor_count` (struct species_mesh)
         * entries are valid. */
    } anchor[ANCHOR_MAX];
};

/* Writes the weights and the anchors of a fish at `progress` in [0, 1] to `pose`. */
void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose);

/* Writes a pose in which key `key` has the weight 1 in every curve, and writes its anchors. */
void morph_key_pose(const struct species_mesh *mesh, uint32_t key_count, uint32_t key,
                    struct morph_pose *pose);

/* Returns the position, and optionally the rotation, of the point with the body coordinates (u, v)
 * on the blended skin. The skin is blended by `pose->weight`.
 *
 * The point lies exactly on the drawn triangles, because each grid cell is split in the same way as
 * for drawing: into two triangles, by the diagonal from (ring, next spoke) to (next ring, spoke). u
 * is clamped to the range of the grid, and v counts turns around the body.
 *
 * If `turns` is true, x of the returned rotation points along the skin's normal, z points backward
 * along the skin, and y = z cross x. If `turns` is false, the rotation is the identity.
 *
 * The grid must have at least 2 rings and 3 spokes (asserted), and the vertices of the grid must
 * have no anchor.
 *
 * The returned pose is used as the pose of an anchor. A vertex at p in the body frame has the
 * anchor coordinates pose_rotate_inverse(turn, p - position), where `position` and `turn` are the
 * position and the rotation of the anchor. */
struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns);

/* ---- blend.c: blend of the keys on the CPU (2005 thesis, eq. 3.2) --------------------------- */

/* Writes the positions and normals of all vertices by the formula in the comment of struct
 * morph_pose. `positions` and `normals` must each have mesh->vertex_count entries or be null. */
void morph_shape(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 vec3 *positions, vec3 *normals);

/* Returns the blended position and normal of one vertex. If the vertex has an anchor, the results
 * are relative to the anchor. Otherwise the results are in the body frame. */
struct morph_point {
    vec3 position, normal;
} morph_point(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
              uint32_t vertex);

/* Returns the blended position of one vertex. If the vertex has an anchor, the position is relative
 * to the anchor. Otherwise the position is in the body frame. */
vec3 morph_place(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 uint32_t vertex);

/* Returns the position of a vertex in one key, in body lengths. The position is relative to the
 * vertex's anchor, or to the body's origin if the vertex has no anchor. */
vec3 morph_position(const struct species_mesh *mesh, uint32_t key, uint32_t vertex);

/* Returns the unit normal that is encoded in `folded`, the member `normal` of struct
 * species_point. */
vec3 morph_normal(int16_t folded);

/* Returns the 16-bit encoding of a unit normal. The function is the inverse of morph_normal(). */
int16_t morph_fold_normal(vec3 normal);

/* Converts the coordinate `x`, in body lengths, to the unit of the 16-bit integers of struct
 * species_point, which is reach / 32767. Rounds to the nearest integer, with ties away from 0.
 * Coordinates beyond `reach` are clamped. For one axis, the function is the inverse of
 * morph_position(). */
int16_t morph_count(float x, float reach);

/* ---- straight.c: the method of the 2005 thesis, for comparison ------------------------------ */

/* Tables of a species that straight_species() writes. The caller owns the memory and must keep it
 * as long as the species is used. */
struct straight_memory {
    struct species_vertex vertices[SPECIES_LOD_COUNT][MESH_VERTEX_MAX];
    struct species_point points[SPECIES_LOD_COUNT][MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct morph_pose pose; /* Scratch memory, only used during a call. */
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* Writes to `out` a species with the same key shapes as `from` but without anchors and masks. Every
 * vertex then moves in straight lines from key to key (2005 thesis, eq. 3.1 and 3.2). The
 * coordinates of a vertex that has an anchor are converted to the body frame in each key, with an
 * error of at most one unit of struct species_point.
 *
 * `out` shares unchanged tables with `from`, so `from` must outlive `out`. `out` must not be
 * `from`. */
void straight_species(const struct species *from, struct straight_memory *memory,
                      struct species *out);

/* Writes to `out` the result of straight_species(), reduced to the three keys and the template
 * that the 2005 thesis, chapter 4, uses for the species. With TEMPLATE_SIMULTANEOUS, the middle
 * key is exaggerated by graph_solve(). The keys keep their ages, and the lengths follow
 * growth_shifted(). */
void straight_thesis(const struct species *from, struct straight_memory *memory,
                     struct species *out);

/* Colour and surface properties of a point on the fish (paint.c). */

struct paint {
    vec3 colour; /* Colour in sRGB, each component in [0, 1]. */
    float clear; /* Transparency in [0, 1]: 0 is opaque, 1 is fully transparent. */
    float shine; /* Silver shine in [0, 1]: 0 is dull, 1 is a full silver shine. */
};

/* Returns the paint at a point of the fish. `at` gives the u, v, part and side of the point, which
 * need not be a vertex of the mesh. `weights` are the weights of the keys' coats. Negative weights
 * count as 0, and the function divides the weights by their sum. */
struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at);
