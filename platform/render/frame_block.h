/* frame_block.h -- computes and uploads the uniform block `Frame`: the values of one frame that
 * every shader may read.
 *
 * The layout is identical to the block in assets/shaders/common.glsl (std140). */
#pragma once

#include "core/scene.h"
#include "platform/render/gl_util.h"

#define FRAME_SHADE_MAX (SHADE_MAX + POI_MAX)
_Static_assert(FRAME_SHADE_MAX == 8, "as many as in shade.frag.glsl");

struct frame_block {
    float view_projection[16]; /* Matrix from world to clip space, column-major. */
    float eye[4];
    float tank[4];
    float screen[4];
    float shadow[4];
    float bend[4];
    float shade_map[4];
    float crop[4];
    float bulbs[4];
    float evening[4];
    float water_tint[4];
    float sky_glow[4];
    float vinyl[4];
};
_Static_assert(sizeof(struct frame_block) == 256, "the block has the layout of common.glsl");

/* Values of the camera that the C code reads. The shaders do not read these values. */
struct frame_view {
    vec3 eye_m;
    /* Length in pixels, on the screen, of one metre at a distance of one metre from the camera. */
    float focal_px;
};

/* Circular shadows of the hand-held fans, then of the dry pois. */
struct frame_shades {
    float circles[FRAME_SHADE_MAX][4]; /* Centre x and z in m, radius in m, and darkness. */
    uint32_t fan_count, count;         /* Number of fans, and number of all circles. */
};

/* Part of the screen with the water surface, in pixels of the complete picture of the underwater
 * scene. The origin is at the lower left. The render targets below the water have only this part.
 *  */
struct frame_part {
    uint32_t x, y, width, height;
};

struct frame {
    GLuint buffer, below_buffer;
    struct frame_block block;
    struct frame_part part;
    /* Camera and size of the previous frame, and the number of frames in which the camera counts as
     * moving, so that the part keeps its margin. */
    float last_view[16];
    uint32_t last_below_px[2];
    uint32_t moving_frames;
    struct frame_part shaded_part; /* Part of the screen in which fans shade the rim or the counter,
                                      in pixels. Its width is 0 if no fan does. */
    struct frame_view view;
    float placed[4]; /* Matrix that rotates the picture on the screen, column-major. */
    struct frame_shades shades;
    bool is_day; /* True if the stall stands in daylight, without lamps. */
};

/* Writes the matrix from the world to the clip space of the screen, for the camera `view` and the
 * display geometry `transform`, to `out`. The matrix is column-major. */
void frame_view_projection(float out[16], const struct view *view,
                           const struct display_transform *transform);

void frame_open(struct frame *frame);
void frame_close(struct frame *frame);

/* Computes the uniform block for `scene` with the display geometry `transform`, uploads the block,
 * and binds the block for the screen. `size_px` is the width and the height of the render target
 * for the screen. `below_px` is the width and the height of the complete picture of the underwater
 * scene, of which only frame->part is drawn. */
void frame_begin(struct frame *frame, const struct scene *scene,
                 const struct display_transform *transform, const uint32_t size_px[2],
                 const uint32_t below_px[2]);

/* Writes red, green and blue of the light at (x, z) in m to `light`, as lamp_light() of common.glsl
 * computes it. Must be called after frame_begin(). */
void frame_lamp_light(const struct frame_block *block, float x, float z, float light[3]);

/* Binds the uniform block for the render targets below the water if `is_below` is true, otherwise
 * the block for the screen. */
void frame_bind(const struct frame *frame, bool is_below);
