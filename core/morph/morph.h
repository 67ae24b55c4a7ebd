/* morph.h -- a fish of any age from three or more drawings (2005 thesis).
 *
 *   age -> progress between the keys -> weights (deformation graph, one a curve) -> pose -> shape
 *                  \-> length (scale curve)
 *
 * Progress is [0, 1]: key i of n stands at i / (n - 1). All functions are pure; the caller owns all
 * memory. core/morph/README.md tells how it works. */
#ifndef KINGYO_CORE_MORPH_MORPH_H
#define KINGYO_CORE_MORPH_MORPH_H

#include <stdbool.h>

#include "core/morph/species.h"

/* growth.c: length and age */

/* Length in metres at `age_days` >= 0 after hatching. */
float growth_length_m(const struct growth *growth, float age_days);

/* The youngest age at which it is `length_m` long, within 0.1 day; clamps to [0, 40 years]. */
float growth_age_days(const struct growth *growth, float length_m);

/* The same within [from_days, to_days]; below 0 where it is never so long between these. */
float growth_age_between(const struct growth *growth, float from_days, float to_days,
                         float length_m);

/* Whether length only rises, or only falls, between two ages: a conger shrinks on the way. */
bool growth_is_one_way(const struct growth *growth, float from_days, float to_days);

/* The thesis' own (section 3.2): eq. 3.3 alone, its start t0 shifted until it hatches with the true
 * length. Nothing measured later counts, and adults become too small. */
struct growth growth_shifted(const struct growth *growth);

/* life.c: age <-> progress <-> length. Between two keys progress goes by the logarithm of length
 * where length is monotone there (fish grow by factors), else by age. */

float life_progress(const struct species_card *card, float age_days);
float life_age_days(const struct species_card *card, float progress);
/* The scale curve: the growth curve at that age; where the card has scale knots, these, and by
 * factors between them (straight on a logarithmic axis). */
float life_length_m(const struct species_card *card, float progress);
/* The earliest progress at which it is `length_m` long. What it never is gives 0 where the youngest
 * key is longer, else 1. */
float morph_progress(const struct species_card *card, float length_m);

/* graph.c: weights */

enum graph_fault {
    GRAPH_GOOD = 0,
    GRAPH_KNOT_COUNT, /* Fewer than 2 knots, or more than GRAPH_KNOT_MAX. */
    GRAPH_ENDS,       /* The first knot is not at 0, or the last not at 1. */
    GRAPH_ORDER,      /* `knot` does not lie behind the one before. */
    GRAPH_NEGATIVE,   /* `key`'s weight at `knot` is negative (or no number). */
    GRAPH_SUM,        /* The weights of `knot` sum to `value`, not to 1 within 1e-6. */
    GRAPH_UNSOLVABLE, /* It is to be solved, but hardly shows `key` even at that key's progress. */
};

struct graph_verdict {
    uint8_t fault; /* enum graph_fault */
    uint8_t knot, key;
    float value;
};

struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count);

/* The curves at `progress` in [0, 1]: each >= 0, sum 1 within 1e-6; unused keys get 0. */
void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX]);

/* solve.c: exaggerated shapes for a graph that shows no key alone. `solution[i][j]` is the weight
 * of drawn key j in the shape solved for key i (rows sum to 1), so that a fish blended of solved
 * shapes passes through every drawing at i / (n - 1). False, with the key it is `stuck` at, where
 * that would ask for shapes exaggerated beyond sense. */
bool graph_solve(const struct graph *graph, uint32_t key_count,
                 float solution[MORPH_KEY_MAX][MORPH_KEY_MAX], uint32_t *stuck);

/* template.c: graphs to start from */

enum graph_template {
    TEMPLATE_OWN = 0,      /* The species' own. */
    TEMPLATE_ORDINARY,     /* Eq. 3.1: the first and the last key alone. */
    TEMPLATE_PAIRWISE,     /* Figure 3.8: two neighbours at a time, each key reached whole. */
    TEMPLATE_SIMULTANEOUS, /* Figure 3.9: inner keys peak at `peak`, neighbours share the rest. */
    TEMPLATE_SMOOTH,       /* A cubic B-spline's weights: the path has no corner at any key. */
    TEMPLATE_COUNT,
};

#define SIMULTANEOUS_PEAK 0.70f /* Section 4.2's hirame. */

/* `template` is not TEMPLATE_OWN; `peak` in (0.5, 1) matters to TEMPLATE_SIMULTANEOUS alone. */
void graph_template(struct graph *graph, enum graph_template template, uint32_t key_count,
                    float peak);

/* rig.c: which curves blend a fish, ready to be asked often */

struct morph_rig {
    uint32_t key_count, curve_count;
    struct graph curves[MORPH_CURVE_MAX];
    /* Weight of drawn key j in the shape solved for key i; the unit matrix if nothing is solved. */
    float solution[MORPH_CURVE_MAX][MORPH_KEY_MAX][MORPH_KEY_MAX];
};

/* TEMPLATE_OWN takes the card's curves; any other template takes the place of all of them. A curve
 * that cannot be solved (graph_check says which) blends the drawn shapes themselves. */
void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template);

/* What multiplies the drawn key shapes, by curve: sums 1; negative only where shapes are solved. A
 * solved curve gives each key alone, exactly, at i / (n - 1). */
void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX]);

/* pose.c: what a vertex shader needs besides the tables */

struct quat {
    float x, y, z, w; /* Unit. */
};

/* a + 2 w (q x a) + 2 q x (q x a), with q = (x, y, z); and the way back. */
vec3 quat_turn(struct quat q, vec3 a);
vec3 quat_turn_back(struct quat q, vec3 a);

/* All that changes from one fish to the next: to be uploaded as it is.
 *
 * A vertex of mask m, in curves' weights W and key points P_k, N_k (a normal is unfolded onto the
 * octahedron |x| + |y| + |z| = 1 and blended there):
 *     w_k      = (sum over the curves c of m[c] * W[c][k]) / 255
 *     position = sum over the keys of w_k * P_k
 *     normal   = normalize(sum over the keys of w_k * N_k)
 * and if it has an anchor, of turn q and position A:
 *     position = A + q position q*          (quat_turn)
 *     normal   = q normal q*
 * Where an anchor does not turn, q is the identity, so there is one formula for all. */
struct morph_pose {
    float weight[MORPH_CURVE_MAX][MORPH_KEY_MAX]; /* As morph_weights() gives them. */
    struct anchor_pose {
        vec3 position;    /* In the body frame. */
        struct quat turn; /* The identity where the anchor does not turn. */
    } anchor[ANCHOR_MAX]; /* The mesh's anchor_count of them. */
};

void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose);

/* Key `key` alone. */
void morph_key_pose(const struct species_mesh *mesh, uint32_t key_count, uint32_t key,
                    struct morph_pose *pose);

/* Where body coordinates (u, v) lie on the skin that `pose->weight` blends: on the two triangles of
 * the grid's cell, which meet between (ring, next spoke) and (next ring, spoke). u is clamped to
 * the grid's rings, v counts turns. If it `turns`: x along the skin's normal, z backward along the
 * skin, y = z cross x. The mesh has a grid of at least 2 rings and 3 spokes, whose vertices have no
 * anchor. A vertex drawn at p in the body frame of a key has, relative to its anchor there,
 * quat_turn_back(turn, p - position). */
struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns);

/* Sets the pose's anchors from its weights: each anchor's u and v are blended by its own curve. */
void morph_ride_all(const struct species_mesh *mesh, uint32_t key_count, struct morph_pose *pose);

/* blend.c: eq. 3.2 on the CPU */

/* `positions` and `normals` (either may be null) hold mesh->vertex_count: struct morph_pose says
 * what of. */
void morph_shape(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
                 vec3 *positions, vec3 *normals);

/* The same to the last bit, 1, 4 or 8 vertices at a time; 8 where the processor can (AVX2). */
void morph_shape_lanes(const struct species_mesh *mesh, uint32_t key_count,
                       const struct morph_pose *pose, vec3 *positions, vec3 *normals,
                       uint32_t lanes);

/* One vertex, before its anchor turns and carries it. */
struct morph_point {
    vec3 position, normal;
} morph_point(const struct species_mesh *mesh, uint32_t key_count, const struct morph_pose *pose,
              uint32_t vertex);

/* Its position alone. */
vec3 morph_place(const struct species_mesh *mesh, uint32_t key_count,
                 const struct morph_pose *pose, uint32_t vertex);

/* A point's position (counts times reach) and its unit normal, unfolded. */
vec3 morph_position(const struct species_mesh *mesh, uint32_t key, uint32_t vertex);
vec3 morph_normal(int16_t folded);
int16_t morph_fold_normal(vec3 normal);

/* The count nearest to a coordinate `x` in a mesh that reaches so far, ties away from 0; beyond the
 * reach, its end. The inverse of morph_position() for each axis. */
int16_t morph_count(float x, float reach);

/* straight.c: the thesis' own method, to compare with */

struct straight_memory { /* The caller's, as long as the species made from it is used. */
    struct species_vertex vertices[SPECIES_LOD_COUNT][MESH_VERTEX_MAX];
    struct species_point points[SPECIES_LOD_COUNT][MORPH_KEY_MAX][MESH_VERTEX_MAX];
    struct morph_pose pose; /* Scratch, like the two below. */
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

/* The same key shapes without anchors and masks: every vertex moves straight (eq. 3.1 and 3.2), for
 * what rode on an anchor is baked into the body frame of each key (within a count). Tables that are
 * the same stay those of `from`, which must outlive `out`; `out` is not `from`. */
void species_straighten(const struct species *from, struct straight_memory *memory,
                        struct species *out);

/* Straight, and only chapter 4's three keys with its template; the middle one exaggerated (solved)
 * where that template is the simultaneous one. Keys keep their ages; sizes are the shifted growth
 * curve's. */
void species_thesis(const struct species *from, struct straight_memory *memory,
                    struct species *out);

/* paint.c: colour */

struct paint {
    vec3 colour;  /* sRGB, [0, 1] each. */
    float clear;  /* [0, 1] how much of what is behind shows. */
    float shine;  /* [0, 1] */
};

/* What vertex coordinates `at` (u, v, part, side; any point between vertices will do) look like,
 * the keys' coats blended by `weights` (made >= 0 and summing to 1 first). */
struct paint paint_at(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct species_vertex *at);

#endif
