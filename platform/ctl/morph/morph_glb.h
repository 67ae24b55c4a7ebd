/* morph_glb.h -- declarations that the files of the glTF writer share.
 *
 * morph_glb.c writes the file and its nodes, morph_glb_mesh.c the meshes and their shapes, and
 * morph_glb_life.c the animation. A piece is a mesh
 * of one part of the fish on one side. A key is a modelled growth stage. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_GLB_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_GLB_H

#include "platform/ctl/morph/glb.h"
#include "platform/ctl/morph/morph_export.h"

#define GLB_SECONDS 10.0f /* Duration in seconds of the animation of a whole life. */
/* Index of the fish's node in the file. The nodes of the pieces follow, and then the nodes of the
 * anchors. */
#define GLB_ROOT_NODE 0u
#define GLB_PIECE_NODE 1u
#define TARGET_MAX (MORPH_CURVE_MAX * (MORPH_KEY_MAX - 1u))

/* Morph targets of a piece. Each curve that moves the piece has one target for each key except the
 * last key. The curve of the whole fish is always included, because this curve also blends the
 * colours. */
struct target_list {
    uint32_t count;
    uint8_t curves; /* Bit mask of the curves that have targets. Bit i is curve i. */
    uint8_t curve[TARGET_MAX], key[TARGET_MAX];
};

struct morph_glb {
    const struct morph_options *pick;
    const struct species_mesh *mesh;
    struct glb file;
    struct morph_pose adult; /* Pose of the fish at progress 1. A viewer shows this pose if no
                                animation runs. */
    struct morph_mesh cut;
    struct paint paints[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* Colour of each vertex for each key,
                                                            indexed by key and vertex. */
    struct target_list targets[PIECE_MAX];
    bool skinned[PIECE_MAX]; /* True if at least one vertex of the piece has an anchor on the body's
                                surface. */
    /* Number of the material of each part, counted from 1. 0 means that the material does not exist
     * yet. */
    uint32_t materials[PART_COUNT];
};

/* Attributes of one vertex in one shape of the fish. */
struct aspect {
    vec3 position, normal, colour;
    float hides;
};

/* Returns the share, in [0, 1], with which curve `curve` moves the vertex. The shares of curves
 * that the rig does not have are added to curve 0. */
float morph_glb_share_of(const struct morph_glb *fish, uint32_t vertex, uint32_t curve);

/* morph_glb_base_appearance() returns the base B of a vertex. morph_glb_target_appearance() returns
 * a displacement D. Both terms are defined in morph_glb_mesh.c. A vertex with an anchor has its
 * position at progress 1. */
struct aspect morph_glb_base_appearance(const struct morph_glb *fish, uint32_t vertex);
struct aspect morph_glb_target_appearance(const struct morph_glb *fish, uint32_t vertex,
                                          uint32_t curve, uint32_t key);

/* Adds the mesh of `piece` to the file. Also sets the morph targets of the piece, and sets
 * `skinned` for the piece. Returns the index of the mesh. */
uint32_t morph_glb_add_mesh(struct morph_glb *fish, uint32_t piece);

/* Adds the animation of all nodes to the file. Must be called after all meshes were added. Returns
 * false if memory allocation fails. */
bool morph_glb_animate(struct morph_glb *fish);

#endif
