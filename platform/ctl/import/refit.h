/* refit.h -- fits a species' own body to meshes of any topology.
 *
 * Meshes from other programs seldom share a topology, but morphing needs one topology (2005 thesis,
 * section 3.1). The lofted template is therefore fitted to each mesh. First a smooth warp moves the
 * template's landmarks to the landmarks of the mesh (an affine fit, then a bump around each
 * landmark). Then each round pulls every vertex to the nearest point of the surface, while every
 * edge resists with decreasing stiffness. The result has the topology, the coordinates, the
 * anchors, the curves and the paint of the template. Its distance from the mesh is measured and
 * printed. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_REFIT_H
#define KINGYO_PLATFORM_CTL_IMPORT_REFIT_H

#include <stddef.h>

#include "platform/ctl/import/import_mesh.h"
#include "platform/species/pack.h"

#define REFIT_MARKS_MAX 24u
#define MARK_NAME_SIZE 24u

/* Landmarks in the coordinates of a mesh. */
struct refit_marks {
    uint32_t count;
    struct refit_landmark {
        char name[MARK_NAME_SIZE];
        vec3 place;
    } marks[REFIT_MARKS_MAX];
};

/* Reads lines of the form "NAME X Y Z". The character '#' starts a comment. Returns EXIT_OK.
 * Returns EXIT_BAD_DATA or EXIT_IO and writes "FILE:LINE: reason" to `why` after an error. */
enum exit_code refit_marks_read(const char *path, struct refit_marks *list,
                                char why[IMPORT_WHY_SIZE]);

/* Finds the landmark `name` on the template `mesh`, whose vertices are at `positions`. Returns
 * false if the landmark is unknown or the fish does not have the part. */
bool refit_marks_of_template(const struct species_mesh *mesh, const vec3 *positions,
                             const char *name, vec3 *out);

/* Moves `count` points by the smooth warp that moves each of `n` <= REFIT_MARKS_MAX points `from`
 * to its `to`. The error at a landmark is at most a thousandth of its displacement. */
void refit_marks_warp(const vec3 *from, const vec3 *to, uint32_t n, vec3 *points, uint32_t count);

/* Distances from the points of one surface to another surface, in lengths of the fish. */
struct refit_error {
    float mean, rms, max;
};

struct refit_result {
    struct refit_error to_mesh;   /* Distances of the fitted vertices from the mesh. */
    struct refit_error from_mesh; /* Distances of the mesh's vertices from the fitted surface. */
    /* Greatest distance of a fitted landmark from the mesh's landmark. */
    float mark_max;
    /* Name of the landmark that lies farthest from the mesh, or "". The string belongs to the
     * landmark list. */
    const char *stray;
    float stray_gap; /* Distance of the landmark `stray` from the mesh. */
};

/* Fits key `key` of both levels of detail in `slot` (a copy of the template) to shape 0 of `mesh`.
 * The mesh and `marks` must already be oriented and scaled to size 1. */
void refit_key(struct species_slot *slot, uint32_t key, const struct import_mesh *mesh,
               const struct refit_marks *marks, struct refit_result *result);

/* Fits the template in `slot` to one mesh for each key. `files` are the paths of the meshes, and
 * `marks` the paths of their landmarks. Meshes are turned and scaled as `plan` and the landmarks
 * require. Prints the error of each key to standard output. Returns EXIT_OK. Returns EXIT_BAD_DATA
 * or EXIT_IO and writes a reason with the file's name to `why` after an error. */
struct import_options;
enum exit_code refit_files(struct species_slot *slot, const char *const *files,
                           const char *const *marks, uint32_t count,
                           const struct import_options *plan, char why[IMPORT_WHY_SIZE]);

/* ---- refit_tree.c: the nearest point of a surface ------------------------------------------- */

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
        /* Range of triangles of a leaf. In a branch, `count` is 0 and `first` is the number of the
         * second child. The first child is the next node. */
        uint32_t first, count;
    } nodes[2 * REFIT_TREE_TRIANGLE_MAX];
};

/* refit_tree_add() adds a triangle. Call refit_tree_build() once after all triangles were added. */
void refit_tree_add(struct refit_tree *tree, vec3 a, vec3 b, vec3 c, uint8_t part);
void refit_tree_build(struct refit_tree *tree);

#define REFIT_TREE_ANY_PART 255u

/* Finds the point nearest to `from` on triangles of `part`, or on all triangles. Returns the
 * squared distance, or infinity if there are no such triangles. */
float refit_tree_nearest(const struct refit_tree *tree, vec3 from, uint8_t part, vec3 *place);

#endif
