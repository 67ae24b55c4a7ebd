/* morph_glb.h -- what the parts of the glTF writer share: the file (morph_glb.c, which says how a
 * fish becomes one), its shapes (morph_glb_look.c), its meshes (morph_glb_mesh.c) and its life
 * (morph_glb_life.c). */
#ifndef KINGYO_PLATFORM_CTL_MORPH_GLB_H
#define KINGYO_PLATFORM_CTL_MORPH_GLB_H

#include "platform/ctl/glb.h"
#include "platform/ctl/morph_mesh.h"

#define GLB_SECONDS 10.0f  /* From progress 0 to 1. */
#define GLB_ROOT_NODE 0u   /* The fish; behind it its pieces, behind these its anchors. */
#define GLB_PIECE_NODE 1u
#define TARGET_MAX (MORPH_CURVE_MAX * (MORPH_KEY_MAX - 1u))

/* The targets of a piece: each key but the last, by each curve that moves the piece. The whole
 * fish's curve is always one of them, since it carries the colours. */
struct target_list {
    uint32_t count;
    uint8_t curves; /* A bit a curve. */
    uint8_t curve[TARGET_MAX], key[TARGET_MAX];
};

struct fish_glb {
    const struct morph_pick *pick;
    const struct species_mesh *mesh;
    struct glb file;
    struct morph_pose adult; /* At progress 1: how the file stands when nothing moves it. */
    struct morph_mesh cut;
    struct paint paints[MORPH_KEY_MAX][MESH_VERTEX_MAX]; /* Of each key. */
    struct target_list targets[PIECE_MAX];
    bool skinned[PIECE_MAX]; /* Some of the piece rides on the skin. */
    uint32_t materials[PART_COUNT]; /* From 1; 0: not there yet. */
};

/* A vertex's numbers in one shape. */
struct aspect {
    vec3 position, normal, colour;
    float hides;
};

/* How much curve `curve` moves the vertex; those that the rig has not count for the first. */
float glb_share_of(const struct fish_glb *fish, uint32_t vertex, uint32_t curve);

/* B of morph_glb_look.c, and D of a curve's key; what rides on the skin stands where it is at
 * progress 1. */
struct aspect glb_base_look(const struct fish_glb *fish, uint32_t vertex);
struct aspect glb_target_look(const struct fish_glb *fish, uint32_t vertex, uint32_t curve,
                              uint32_t key);

/* Adds the mesh of `piece`; sets its targets and whether it is skinned. Answers the mesh. */
uint32_t fish_glb_mesh(struct fish_glb *fish, uint32_t piece);

/* Adds the animation of all nodes, behind all meshes. False when there is no memory. */
bool fish_glb_animate(struct fish_glb *fish);

#endif
