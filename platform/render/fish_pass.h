/* fish_pass.h -- every fish of the scene, as instances of one species' meshes.
 *
 * Bodies are opaque; fins are translucent and are drawn from the lowest fish up. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_PASS_H
#define KINGYO_PLATFORM_RENDER_FISH_PASS_H

#include "core/scene.h"
#include "platform/render/fish_mesh.h"
#include "platform/render/fish_poses.h"
#include "platform/render/frame_block.h"
#include "platform/render/quality.h"
#include "platform/render/textures.h"

enum fish_group {               /* In this order in the instance buffer. */
                  FISH_FAR = 0, /* In the tank, small on the screen. */
                  FISH_NEAR,
                  FISH_GULPING_FAR, /* In the tank, a snout above the surface; small. */
                  FISH_GULPING,
                  FISH_ON_POI,
                  FISH_IN_BOWL,
                  FISH_GROUP_COUNT,
};

struct fish_instance {
    float place[4], right_phase[4], up_amplitude[4];
    float character[4];
    float gulp[3]; /* Gape and phase; then the fish's row of poses. */
};

struct fish_program {
    GLuint name;
    GLint reach; /* Its uniform. */
};

struct fish_pass {
    struct fish_program body, sunk, snout, fin;
    GLuint ring_program, rings;
    GLuint instance_buffer;
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    struct fish_poses poses[SPECIES_LOD_COUNT];
    struct morph_rig rig; /* Of the species' own curves. */
    uint32_t first[FISH_GROUP_COUNT], count[FISH_GROUP_COUNT];
    uint16_t order[SCENE_FISH_MAX]; /* Scene indices, lowest fish first. */
    uint8_t group[SCENE_FISH_MAX];
    struct fish_instance instances[SCENE_FISH_MAX];
};

/* `memory` is only needed until it returns. */
void fish_pass_open(struct gl_status *status, struct fish_pass *pass,
                    struct fish_mesh_memory *memory);
void fish_pass_close(struct fish_pass *pass);

/* Sorts the scene's fish into groups and uploads them. */
void fish_pass_prepare(struct fish_pass *pass, const struct scene *scene,
                       const struct frame_view *view, const struct quality *quality);

/* Draw one group, into a target with depth. Bodies: no blending wanted, and of gulpers only what is
 * below the surface. Fins: premultiplied. */
void fish_pass_bodies(const struct fish_pass *pass, enum fish_group group,
                      const struct textures *textures, GLuint caustics);
void fish_pass_fins(const struct fish_pass *pass, enum fish_group group, GLuint caustics);

/* The gulpers whole, into a target whose depth hides what is below the surface: their snouts. */
void fish_pass_snouts(const struct fish_pass *pass, const struct textures *textures,
                      GLuint caustics);

/* The rings that gulpers make on the surface, over the water and under what stands out of it. */
void fish_pass_rings(const struct fish_pass *pass);

/* Points attributes 0, 1, 2 of the bound vertex array at the instances of the fish in the tank and
 * on the poi; returns how many there are. For their shadows. */
GLsizei fish_pass_shadow_casters(const struct fish_pass *pass);

#endif
