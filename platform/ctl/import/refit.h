/* refit.h -- fits the body mesh of a species, the template, to meshes with any triangles.
 *
 * Meshes from other programs seldom have the same triangles, but morphing requires the same
 * triangles for all keys (2005 thesis, section 3.1). The template is therefore fitted to each mesh.
 * First, a smooth warp moves the landmarks of the template to the landmarks of the mesh. The warp
 * consists of an affine transform and a displacement around each landmark. Then, in several rounds,
 * every vertex is pulled to the nearest point of the mesh, and the edges resist with decreasing
 * stiffness.
 *
 * The result has the triangles, the body coordinates, the anchors, the curves and the paint of the
 * template. The distance between the result and the mesh is measured and printed. */
#pragma once

#include "platform/ctl/import/import.h"
#include "platform/species/pack.h"

#define REFIT_MARKS_MAX 24u
#define MARK_NAME_SIZE 24u

/* Landmarks of a mesh, which are named points such as the snout, in the coordinates of the mesh. */
struct refit_marks {
    uint32_t count;
    struct refit_landmark {
        char name[MARK_NAME_SIZE];
        vec3 place;
    } marks[REFIT_MARKS_MAX];
};

/* Reads a landmark file with lines of the form "NAME X Y Z". A '#' starts a comment. Returns
 * EXIT_OK. After an error, writes "FILE:LINE: reason" to `why` and returns EXIT_BAD_DATA or
 * EXIT_IO. */
enum exit_code refit_marks_read(const char *path, struct refit_marks *list,
                                char why[IMPORT_WHY_SIZE]);

/* Finds the landmark `name` on the template `mesh`, whose vertices are at `positions`, and
 * writes its position to `out`. Returns false if the name is unknown or the fish does not have
 * the part. */
bool refit_marks_of_template(const struct species_mesh *mesh, const vec3 *positions,
                             const char *name, vec3 *out);

/* Moves `count` points with the smooth warp that moves each landmark from[i] to to[i]. `n` is the
 * number of landmarks, at most REFIT_MARKS_MAX. The error at a landmark is at most a thousandth of
 * its displacement. */
void refit_marks_warp(const vec3 *from, const vec3 *to, uint32_t n, vec3 *points, uint32_t count);

/* Distances from the points of one surface to another surface, in units of the fish's length. */
struct refit_error {
    float mean, rms, max;
};

struct refit_result {
    /* Distances from the vertices of the fitted template to the mesh. */
    struct refit_error to_mesh;
    /* Distances from the vertices of the mesh to the fitted template. */
    struct refit_error from_mesh;
    /* Greatest distance between a landmark of the fitted template and the same landmark of the
     * mesh. */
    float mark_max;
    /* Name of the landmark that is farthest from the surface of the mesh (a stray landmark). ""
     * means that there are no landmarks. The string belongs to the list of landmarks. */
    const char *stray;
    float stray_gap; /* Distance of the landmark `stray` from the surface of the mesh. */
};

/* Fits key `key` of the template in `slot`, in both levels of detail, to key shape 0 of `mesh`. The
 * caller must have oriented the mesh and `marks` and scaled them to size 1. */
void refit_key(struct species_slot *slot, uint32_t key, const struct import_mesh *mesh,
               const struct refit_marks *marks, struct refit_result *result);

/* ---- refit_tree.c: search for the nearest point of a surface --------------------------------- */

#define REFIT_TREE_TRIANGLE_MAX IMPORT_TRIANGLE_MAX

struct refit_tree_triangle {
    vec3 corner[3];
    uint8_t part;
};

struct refit_tree {
    uint32_t triangle_count, node_count;
    struct refit_tree_triangle triangles[REFIT_TREE_TRIANGLE_MAX];
    struct refit_tree_node {
        vec3 low, high;
        /* In a leaf, `first` and `count` are a range of triangles. In a branch, `count` is 0 and
         * `first` is the index of the second child. The first child of a branch is the next node in
         * the array. */
        uint32_t first, count;
    } nodes[2 * REFIT_TREE_TRIANGLE_MAX];
};

/* refit_tree_add() adds a triangle to the tree. refit_tree_build() must be called once after all
 * triangles were added, and before the first search. */
void refit_tree_add(struct refit_tree *tree, vec3 a, vec3 b, vec3 c, uint8_t part);
void refit_tree_build(struct refit_tree *tree);

#define REFIT_TREE_ANY_PART 255u

/* Finds the point nearest to `from` on the triangles of `part`, or on all triangles if `part` is
 * REFIT_TREE_ANY_PART. Returns the squared distance, or infinity if there are no such triangles. */
float refit_tree_nearest(const struct refit_tree *tree, vec3 from, uint8_t part, vec3 *place);
