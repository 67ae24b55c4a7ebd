/* morph_glb.h -- declarations shared by the parts of the glTF writer. morph_glb.c writes the file
 * and describes its structure, morph_glb_look.c computes the shapes, morph_glb_mesh.c writes the
 * meshes, and morph_glb_life.c writes the animation. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_GLB_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_GLB_H

#include "platform/ctl/morph/glb.h"
#include "platform/ctl/morph/morph_mesh.h"

#define GLB_SECONDS 10.0f /* Seconds of the animation from progress 0 to 1. */
/* Node number of the fish. The nodes of the pieces follow this node, and the nodes of the anchors
 * follow the pieces. */
#define GLB_ROOT_NODE 0u
#define GLB_PIECE_NODE 1u
#define TARGET_MAX (MORPH_CURVE_MAX * (MORPH_KEY_MAX - 1u))

/* The morph targets of a piece. Each curve that moves the piece gives one target for each key
 * except the last. The curve of the whole fish is always included, because this curve carries the
 * colours. */
struct target_list {
    uint32_t count;
    uint8_t curves; /* Bit mask of the curves, one bit for each curve. */
    uint8_t curve[TARGET_MAX], key[TARGET_MAX];
};

struct morph_glb {
    const struct morph_options *pick;
    const struct species_mesh *mesh;
    struct glb file;
    struct morph_pose adult; /* Pose at progress 1, which a viewer shows without the animation. */
    struct morph_mesh cut;
    struct paint paints[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* Colours of each vertex for each key. */
    struct target_list targets[PIECE_MAX];
    bool skinned[PIECE_MAX]; /* True if at least one vertex of the piece follows the skin. */
    /* Number of each part's material, counted from 1. A value of 0 means that the material does not
     * exist yet. */
    uint32_t materials[PART_COUNT];
};

/* Attributes of one vertex in one shape. */
struct aspect {
    vec3 position, normal, colour;
    float hides;
};

/* Returns how much curve `curve` moves the vertex, in [0, 1]. Shares of curves that the rig does
 * not have are added to the first curve. */
float morph_glb_share_of(const struct morph_glb *fish, uint32_t vertex, uint32_t curve);

/* morph_glb_base_appearance() returns the base B and morph_glb_target_appearance() a displacement
 * D, as morph_glb_look.c defines them. A vertex that follows the skin has the place that it has at
 * progress 1. */
struct aspect morph_glb_base_appearance(const struct morph_glb *fish, uint32_t vertex);
struct aspect morph_glb_target_appearance(const struct morph_glb *fish, uint32_t vertex,
                                          uint32_t curve, uint32_t key);

/* Adds the mesh of `piece`, and sets the piece's targets and whether the piece is skinned. Returns
 * the number of the mesh. */
uint32_t morph_glb_add_mesh(struct morph_glb *fish, uint32_t piece);

/* Adds the animation of all nodes. Call this function after all meshes are added. Returns false if
 * memory allocation fails. */
bool morph_glb_animate(struct morph_glb *fish);

#endif
