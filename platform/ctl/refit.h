/* refit.h -- bends a species' own body onto meshes of any topology.
 *
 * Shapes that other programs made seldom share a topology, and morphing needs one (2005 thesis,
 * section 3.1). So our lofted template is fitted to each mesh: first a smooth warp that carries its
 * landmarks onto the mesh's (the best stretch, then a bump around each), then, again and again,
 * every vertex is drawn to the nearest place of the surface and every edge resists, ever more
 * softly. What comes out has the template's topology, coordinates, anchors,
 * curves and paint. How far it lies from the mesh is measured and told. */
#ifndef KINGYO_PLATFORM_CTL_REFIT_H
#define KINGYO_PLATFORM_CTL_REFIT_H

#include <stddef.h>

#include "platform/ctl/import_mesh.h"
#include "platform/species/pack.h"

#define MARK_LIST_MAX 24u
#define MARK_NAME_SIZE 24u

/* Landmarks in a mesh's own coordinates. */
struct mark_list {
    uint32_t count;
    struct landmark {
        char name[MARK_NAME_SIZE];
        vec3 place;
    } marks[MARK_LIST_MAX];
};

/* Lines of "NAME X Y Z"; '#' starts a comment. EXIT_BAD_DATA or EXIT_IO with "FILE:LINE: what". */
enum exit_code marks_read(const char *path, struct mark_list *list, char why[IMPORT_WHY_SIZE]);

/* Where a landmark of that name is on `mesh`, whose vertices are at `positions`. False where there
 * is no such landmark, or the fish has no such part. */
bool marks_of_template(const struct species_mesh *mesh, const vec3 *positions, const char *name,
                       vec3 *out);

/* Moves `count` points by the smooth warp that carries each of `n` <= MARK_LIST_MAX points `from`
 * to its `to`, within a thousandth of its way. */
void marks_warp(const vec3 *from, const vec3 *to, uint32_t n, vec3 *points, uint32_t count);

/* Distances in lengths of the fish, of one surface's points to the other surface. */
struct refit_error {
    float mean, rms, max;
};

struct refit_result {
    struct refit_error to_mesh;   /* Of the fitted vertices to the mesh ... */
    struct refit_error from_mesh; /* ... and of the mesh's vertices to what was fitted. */
    float mark_max;               /* The farthest landmark from its own. */
    const char *stray;            /* The landmark farthest off the mesh, in the list, or "" ... */
    float stray_gap;              /* ... and how far. */
};

/* Fits key `key` of both levels of detail in `slot` (a copy of the template) to shape 0 of `mesh`,
 * which has been oriented and is of size 1; `marks` went with it. */
void refit_key(struct species_slot *slot, uint32_t key, const struct import_mesh *mesh,
               const struct mark_list *marks, struct refit_result *result);

/* Fits the template in `slot` to a mesh a key: the files, each with its landmarks (`marks`: as many
 * paths), turned and scaled as `plan` says and the landmarks show. Prints each key's error on
 * standard output. EXIT_BAD_DATA or EXIT_IO with `why`, which names the file. */
struct import_plan;
enum exit_code refit_files(struct species_slot *slot, const char *const *files,
                           const char *const *marks, uint32_t count,
                           const struct import_plan *plan, char why[IMPORT_WHY_SIZE]);

/* ---- refit_tree.c: the nearest place of a surface -------------------------------------------- */

#define TREE_TRIANGLE_MAX IMPORT_TRIANGLE_MAX

struct tree_triangle {
    vec3 corner[3];
    uint8_t part;
};

struct tree {
    uint32_t triangle_count, node_count;
    struct tree_triangle triangles[TREE_TRIANGLE_MAX];
    struct tree_node {
        vec3 low, high;
        uint32_t first, count; /* Triangles of a leaf; of a branch `count` is 0 and `first` names
                                  the second child; the first child is the next node. */
    } nodes[2 * TREE_TRIANGLE_MAX];
};

/* Adds a triangle; then tree_build() once. */
void tree_add(struct tree *tree, vec3 a, vec3 b, vec3 c, uint8_t part);
void tree_build(struct tree *tree);

#define TREE_ANY_PART 255u

/* The nearest place to `from` on triangles of `part`, or of all; the squared distance, infinite
 * where there are none. */
float tree_nearest(const struct tree *tree, vec3 from, uint8_t part, vec3 *place);

#endif
