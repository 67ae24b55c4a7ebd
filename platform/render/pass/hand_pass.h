/* hand_pass.h -- draws the hands that hold each poi and each fan, and the sleeves of a yukata in
 * the player's colour.
 *
 * Three frames move the mesh of hand_mesh.h. The hand follows the handle, the forearm leads to the
 * player's shoulder, and the sleeve hangs from the forearm. No hand is drawn over the paper of any
 * poi. */
#pragma once

#include "core/scene.h"
#include "platform/render/pass/poi_pass.h"
#include "platform/render/shape.h"

#define HAND_FRAMES 3u

/* Frames of a hand. */
struct hand_frames {
    /* Column-major matrices from the mesh to the world: of the hand, the forearm and the sleeve. */
    float matrices[HAND_FRAMES][16];
    bool covers_paper; /* True if the picture of the arm may overlap the paper of any poi. */
    float stretch; /* Factor for the length of the sleeve, which ends at the player's shoulder. */
    /* Difference of the depth, in normalized device coordinates, by which the hand is drawn nearer
     * than its place, so that the rim of the tank does not hide it. */
    float nearer;
    bool left; /* True for a left hand, which is the mirror image of the mesh. */
};

/* A hand is drawn in two layers. The inside is drawn before all other objects of the screen, so
 * that the pixels that the hand hides are not shaded. The outline, which is blended over one pixel,
 * is drawn after all other objects. */
enum hand_layer {
    HAND_INSIDE = 0,
    HAND_OUTLINE = 1, /* Also draws the inside of a hand whose arm may overlap the paper of a poi.
                       */
    HAND_LAYERS = 2,
};

struct hand_program {
    GLuint name;
    GLint frames, paint, nearer;
};

struct hand_pass {
    struct hand_program programs[HAND_LAYERS]; /* Indexed by enum hand_layer. */
    struct shape_buffers mesh;
    GLuint axes;     /* Vertex buffer with the directions of the bones (hand_mesh()). */
    GLuint surfaces; /* Texture: layer 0 is the pattern of the cloth, and layer 1 the skin. */
    struct hand_frames frames[POI_MAX]; /* Frames of this picture. */
    struct hand_frames fan_frames[SHADE_MAX];
};

/* Computes the frames of the hand that holds a poi of the scene. */
void hand_frames_of(struct hand_frames *out, const struct scene *scene,
                    const struct scene_poi *poi);

void hand_pass_open(struct gl_status *status, struct hand_pass *pass);
void hand_pass_close(struct hand_pass *pass);

/* Computes the frames of the hands of all pois and fans. */
void hand_pass_prepare(struct hand_pass *pass, const struct scene *scene);

/* Draws one layer of the hands of all pois into a render target with a depth buffer. A hand hides
 * all objects that are lower than the rim of the tank. Before the layer HAND_OUTLINE, the depth of
 * poi_pass_cap() must be drawn. */
void hand_pass_draw(const struct hand_pass *pass, const struct scene *scene, enum hand_layer layer);
/* Draws the hands that hold fans. Must be called after the fans are drawn. */
void hand_pass_fans(const struct hand_pass *pass, const struct scene *scene);
