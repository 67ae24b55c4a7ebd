/* frame_block.c -- computes the uniform block of a frame: camera, light and water. */
#include "platform/render/frame_block.h"

#include <string.h>

#include "assets.h"
#include "core/base/panic.h"

#define NEAR_M 0.05f
#define FAR_M 8.0f
/* Number of layers of the caustics animation that are shown per second. A loop of 32 layers takes
 * about three seconds. */
#define CAUSTIC_LAYERS_HZ 11.0f
#define SECONDS_WRAP_TICKS (3600u * CORE_TICK_HZ)
/* Width of the shadow map divided by the width of the floor. The shadow map is larger than the
 * floor, so that it contains the whole shadow of a fish near a wall. */
#define SHADOW_MARGIN 1.06f
/* Tangent of the angle between the vertical and the light that reaches the floor, in the direction
 * x. The lamps hang to the right of the player and behind the player. */
#define SHADOW_DRIFT_X 0.26f
/* Tangent of the angle between the vertical and the light that reaches the floor, in the direction
 * z. */
#define SHADOW_DRIFT_Z 0.16f

/* Light absorption of the water in 1/m, multiplied by the depth of the tank's water in m. The
 * product is the same for all tanks, so that a shallow tank looks as blue as a deep tank. */
#define ABSORPTION_OVER_DEPTH 0.55f

/* Displacement of the refracted picture, in water depths, per unit of slope of the water surface.
 * The physically correct value is 0.25. A larger value makes refraction more visible. */
#define REFRACTION 0.36f

/* Width in m of the area around the tank that the shade map contains. A shadow outside this area is
 * not drawn. */
#define SHADE_MAP_MARGIN_M 0.4f

static void multiply(float out[16], const float a[16], const float b[16])
{
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            float sum = 0.0f;
            for (int k = 0; k < 4; k++) {
                sum += a[k * 4 + row] * b[column * 4 + k];
            }
            out[column * 4 + row] = sum;
        }
    }
}

static void frame_block_set(float out[4], float x, float y, float z, float w)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
    out[3] = w;
}

static void set_camera(struct frame *frame, const struct view *view,
                       const struct display_transform *transform)
{
    CORE_ASSERT(transform->width > 0.0f && transform->height > 0.0f);
    const float aspect = transform->width / transform->height;
    const float tan_y = view_half_height_tan(view, aspect);
    const struct basis axes = view_basis(view);
    const vec3 rows[3] = { axes.right, axes.up, axes.back };
    /* All matrices are column-major. */
    float rotation[16] = { [15] = 1.0f };
    for (int row = 0; row < 3; row++) {
        rotation[row] = rows[row].x;
        rotation[4 + row] = rows[row].y;
        rotation[8 + row] = rows[row].z;
        rotation[12 + row] = -v3_dot(rows[row], view->eye_m);
    }
    const float projection[16] = { [0] = 1.0f / (tan_y * aspect),
                                   [5] = 1.0f / tan_y,
                                   [10] = (FAR_M + NEAR_M) / (NEAR_M - FAR_M),
                                   [11] = -1.0f,
                                   [14] = 2.0f * FAR_M * NEAR_M / (NEAR_M - FAR_M) };
    /* The matrix `placed` converts from the picture's clip space to the screen's clip space. Every
     * pass can therefore draw directly at the final place on the screen. */
    float turned[4], move[2], seen[16];
    display_clip_matrix(transform, turned, move);
    const float placed[16] = { [0] = turned[0], [1] = turned[1], [4] = turned[2], [5] = turned[3],
                               [10] = 1.0f,     [12] = move[0],  [13] = move[1],  [15] = 1.0f };
    multiply(seen, projection, rotation);
    multiply(frame->block.view_projection, placed, seen);
    memcpy(frame->placed, turned, sizeof frame->placed);
    frame->view.eye_m = view->eye_m;
    frame->view.focal_px = 0.5f * transform->height / tan_y;
}

/* Only fish under water receive the shadows of fans and pois. All other objects receive only the
 * fans' shadows. The floor gets the pois' shadows from the shadow map, because the shadow map shows
 * the holes in the paper. */
static void list_shades(struct frame_shades *shades, const struct scene *scene)
{
    shades->count = 0;
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        const struct scene_fan *const fan = &scene->fan[i];
        if (fan->present) {
            frame_block_set(shades->circles[shades->count++], fan->x_m, fan->z_m, fan->radius_m,
                            fan->dark);
        }
    }
    shades->fan_count = shades->count;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        if (poi->present && poi->shade_dark > 0.0f) {
            frame_block_set(shades->circles[shades->count++], poi->position_m.x, poi->position_m.z,
                            poi->ring_radius_m, poi->shade_dark);
        }
    }
}

void frame_begin(struct frame *frame, const struct scene *scene,
                 const struct display_transform *transform, const uint32_t size_px[2])
{
    CORE_ASSERT(scene->tank_size_m.y > 0.0f && size_px[0] > 0 && size_px[1] > 0);
    struct frame_block *const block = &frame->block;
    const float aspect = transform->width / transform->height;
    const float seconds = (float)(scene->tick % SECONDS_WRAP_TICKS) * CORE_TICK_S;
    const float layers = seconds * CAUSTIC_LAYERS_HZ;
    const float loops = f_floor(layers / (float)ASSET_CAUSTICS_FRAMES);
    const vec3 size = scene->tank_size_m;
    set_camera(frame, &scene->view, transform);
    /* `bend` is the displacement of the refracted picture on the screen per unit of slope of the
     * water surface. The displacement is computed for a point at the camera's target. Elsewhere in
     * the tank the error is a few per cent. */
    const struct view *const view = &scene->view;
    const struct basis axes = view_basis(view);
    const float distance = v3_length(v3_sub(view->eye_m, view->target_m));
    const float half_height_m = view_half_height_tan(view, aspect) * distance;
    const float shift_m = REFRACTION * scene->tank_size_m.y;
    const float bend_x = 0.5f * shift_m / (half_height_m * aspect);
    const float bend_z = 0.5f * shift_m / half_height_m * v3_dot(axes.up, v3(0.0f, 0.0f, 1.0f));
    frame_block_set(block->bend, frame->placed[0] * bend_x, frame->placed[1] * bend_x,
                    frame->placed[2] * bend_z, frame->placed[3] * bend_z);
    list_shades(&frame->shades, scene);
    frame_block_set(block->shade_map, 1.0f / (size.x + 2.0f * SHADE_MAP_MARGIN_M),
                    1.0f / (size.z + 2.0f * SHADE_MAP_MARGIN_M), 0.0f, 0.0f);
    frame_block_set(block->eye, scene->view.eye_m.x, scene->view.eye_m.y, scene->view.eye_m.z,
                    seconds);
    frame_block_set(block->tank, 0.5f * size.x, size.y, 0.5f * size.z,
                    scene->wall_height_m - size.y);
    frame_block_set(block->screen, 1.0f / (float)size_px[0], 1.0f / (float)size_px[1],
                    ABSORPTION_OVER_DEPTH / size.y, layers - loops * (float)ASSET_CAUSTICS_FRAMES);
    frame_block_set(block->shadow, 2.0f / (size.x * SHADOW_MARGIN), 2.0f / (size.z * SHADOW_MARGIN),
                    SHADOW_DRIFT_X, SHADOW_DRIFT_Z);
    glBindBuffer(GL_UNIFORM_BUFFER, frame->buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, block, sizeof *block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame->buffer);
}
