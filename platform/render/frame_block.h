/* frame_block.h -- computes and uploads the uniform block `Frame`: the values of one frame that
 * every shader may read.
 *
 * The layout is identical to the block in assets/shaders/common.glsl (std140). */
#pragma once

#include "core/scene.h"
#include "platform/render/gl_util.h"

#define FRAME_SHADE_MAX (SHADE_MAX + POI_MAX)
_Static_assert(FRAME_SHADE_MAX == 8, "as many as in common.glsl");

struct frame_block {
    float view_projection[16]; /* Matrix from world to clip space, column-major. */
    float eye[4];
    float tank[4];
    float screen[4];
    float shadow[4];
    float bend[4];
    float placed[4];
    float shades[FRAME_SHADE_MAX][4];
};
_Static_assert(sizeof(struct frame_block) == 288, "the block has the layout of common.glsl");

/* Values of the camera that the C code reads. The shaders do not read these values. */
struct frame_view {
    vec3 eye_m;
    /* Length in pixels, on the screen, of one metre at a distance of one metre from the camera. */
    float focal_px;
};

struct frame {
    GLuint buffer;
    struct frame_block block;
    struct frame_view view;
};

/* Computes the uniform block for `scene` with the display geometry `transform`, and uploads the
 * block. */
void frame_begin(struct frame *frame, const struct scene *scene,
                 const struct display_transform *transform);
