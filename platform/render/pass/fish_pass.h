/* fish_pass.h -- draws every goldfish of the scene as an instance of the meshes of one species.
 * Bodies are opaque. Fins are translucent and are drawn from the lowest fish to the highest. */
#pragma once

#include "core/scene.h"
#include "platform/render/fish_colours.h"
#include "platform/render/fish_mesh.h"
#include "platform/render/fish_shapes.h"
#include "platform/render/frame_block.h"
#include "platform/render/quality.h"
#include "platform/render/textures.h"

/* Group of a fish, by its place and by its size on the screen. The instance buffer contains the
 * groups in this order. */
enum fish_group {
    /* The fish is in the tank and only some tens of pixels long. Its mesh has half of the vertices
     * of the far mesh. */
    FISH_SMALL = 0,
    /* The fish is in the tank and small on the screen. Its mesh is the far mesh (few vertices). */
    FISH_FAR,
    FISH_NEAR,
    /* The fish is in the tank, small on the screen, and partly above the water surface. Its mesh is
     * the far mesh. */
    FISH_GULPING_FAR,
    FISH_GULPING,
    FISH_ON_POI,
    FISH_IN_BOWL,
    FISH_GROUP_COUNT,
};

struct fish_instance {
    float place[4], right_phase[4], up_amplitude[4];
    /* Bend of the spine, and layer of the texture of patterns. The shader reads these two values
     * and the first two of `colours` as one attribute. */
    float bend_rad, layer;
    struct fish_colours colours;
    /* Opening of the mouth, phase of the gulp (a gasp for air), row of the fish in the texture of
     * struct fish_shapes, and opening of the gill covers. The phase of a fish in a bowl is -1,
     * because the clear water of a bowl does not tint the fish. */
    float gulp[4];
};

struct fish_pass {
    GLuint body, near, sunk, snout, fin; /* Shader programs. */
    GLuint ring_program, bowl_shadow_program, rings;
    GLuint instance_buffer;
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    struct fish_shapes shapes[SPECIES_LOD_COUNT];
    struct morph_rig rig; /* Deformation graphs of the species, prepared for computing poses. */
    uint32_t first[FISH_GROUP_COUNT], count[FISH_GROUP_COUNT];
    /* Level of detail of each group: 0 is the near mesh, and 1 the far mesh. */
    uint8_t lod[FISH_GROUP_COUNT];
    /* Indices of the fish in the scene, in ascending order of height. */
    uint16_t order[SCENE_FISH_MAX];
    uint8_t group[SCENE_FISH_MAX];
    struct fish_instance instances[SCENE_FISH_MAX];
};

/* Builds all programs and buffers. `memory` is used only during the call. */
void fish_pass_open(struct gl_status *status, struct fish_pass *pass,
                    struct fish_mesh_memory *memory);
void fish_pass_close(struct fish_pass *pass);

/* Sorts the scene's fish into groups and uploads their instances. */
void fish_pass_prepare(struct fish_pass *pass, const struct scene *scene, const struct frame *frame,
                       const struct quality *quality);

/* Draws the bodies of one group of fish into a render target with a depth buffer. If `snouts` is
 * false, draws only the part below the water surface of each gulping fish. If `snouts` is true,
 * draws the whole body, because the depth of the water surface hides the part below. */
void fish_pass_bodies(const struct fish_pass *pass, enum fish_group group, bool snouts,
                      const struct textures *textures, GLuint caustics);
/* Draws the fins of one group of fish with premultiplied blending. */
void fish_pass_fins(const struct fish_pass *pass, enum fish_group group, GLuint caustics);

/* Draws the rings on the water surface that gulping fish cause. Must be called after the water is
 * drawn and before the objects above the water. */
void fish_pass_rings(const struct fish_pass *pass);

/* Draws the shadows of the fish in bowls on the insides of the bowls. */
void fish_pass_bowl_shadows(const struct fish_pass *pass);
/* Binds the instances of the fish that cast shadows to the vertex attributes 0, 1 and 2 of the
 * bound vertex array. Fish in the tank and fish on a poi (paper scoop) cast shadows. Returns the
 * number of these instances. */
GLsizei fish_pass_shadow_casters(const struct fish_pass *pass);
