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

/* Width in m of the soft edge of a fan's shade at the water surface, and of a texel of the shade
 * map, together. */
#define SHADE_EDGE_M 0.03f
/* Height of the lowest part of the rim and the counter, as in deck.vert.glsl. */
#define DECK_LOW_M -0.02f

/* Light of the stall. The bulbs hang over the tank at these fractions of its half width and half
 * length. In a corner of the tank, a bulb gives BULB_CORNER of the light right below it. */
#define BULB_X 0.50f
#define BULB_Z -0.05f
#define BULB_CORNER 0.16f

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

void frame_view_projection(float out[16], const struct view *view,
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
    multiply(out, placed, seen);
}

static void set_camera(struct frame *frame, const struct view *view,
                       const struct display_transform *transform)
{
    float move[2];
    frame_view_projection(frame->block.view_projection, view, transform);
    display_clip_matrix(transform, frame->placed, move);
    const float tan_y = view_half_height_tan(view, transform->width / transform->height);
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

/* Margin around the water surface in pixels, for the refraction and the interpolation of texels. */
#define PART_MARGIN_PX 6.0f
/* Number of pixels to which the edges of the part are rounded. */
#define PART_STEP_PX 2u
/* Largest slope of the water surface for the refraction, as in common.glsl. */
#define SEEN_SLOPE_MAX 0.05f

/* Returns the pixel range of one axis, from `low` to `high` in clip space, within `size_px`. */
static void find_range(uint32_t out[2], float low, float high, float shift, uint32_t size_px)
{
    const float size = (float)size_px;
    const float margin = PART_MARGIN_PX + shift * size;
    const float from = f_clamp((0.5f + 0.5f * low) * size - margin, 0.0f, size);
    const float to = f_clamp((0.5f + 0.5f * high) * size + margin, 0.0f, size);
    const uint32_t first = (uint32_t)from / PART_STEP_PX * PART_STEP_PX;
    const uint32_t last = ((uint32_t)to / PART_STEP_PX + 1u) * PART_STEP_PX;
    out[0] = first + PART_STEP_PX < size_px ? first : 0u;
    out[1] = (last < size_px ? last : size_px) - out[0];
}

/* Range of the picture in clip space, on both axes. */
struct clip_range {
    float low[2], high[2];
};

/* Extends the range by a horizontal rectangle with the middle `at` and the half size `half_m`. */
static void add_rectangle(struct clip_range *range, const float m[16], vec3 at,
                          const float half_m[2])
{
    for (uint32_t i = 0; i < 4; i++) {
        const float x = at.x + (i & 1u ? half_m[0] : -half_m[0]);
        const float z = at.z + (i & 2u ? half_m[1] : -half_m[1]);
        const float w = m[3] * x + m[7] * at.y + m[11] * z + m[15];
        for (uint32_t axis = 0; axis < 2; axis++) {
            const float clip = m[axis] * x + m[4 + axis] * at.y + m[8 + axis] * z + m[12 + axis];
            /* A corner behind the camera makes the range as large as the picture. */
            range->low[axis] = w > NEAR_M ? f_min(range->low[axis], clip / w) : -1.0f;
            range->high[axis] = w > NEAR_M ? f_max(range->high[axis], clip / w) : 1.0f;
        }
    }
}

/* Finds the part of the screen in which the fans shade the rim or the counter. The part is empty
 * while all fans are over the water. */
static void find_shaded_part(struct frame *frame, const uint32_t size_px[2])
{
    const float *const tank = frame->block.tank;
    struct clip_range seen = { { 1.0f, 1.0f }, { -1.0f, -1.0f } };
    frame->shaded_part = (struct frame_part){ 0 };
    for (uint32_t i = 0; i < frame->shades.fan_count; i++) {
        const float *const fan = frame->shades.circles[i];
        const float reach_m = fan[2] + SHADE_EDGE_M;
        if (f_abs(fan[0]) + reach_m > tank[0] || f_abs(fan[1]) + reach_m > tank[2]) {
            const float half_m[2] = { reach_m, reach_m };
            add_rectangle(&seen, frame->block.view_projection, v3(fan[0], DECK_LOW_M, fan[1]),
                          half_m);
            add_rectangle(&seen, frame->block.view_projection, v3(fan[0], tank[3], fan[1]), half_m);
        }
    }
    if (seen.low[0] < seen.high[0] && seen.low[1] < seen.high[1]) {
        uint32_t range[2][2];
        find_range(range[0], seen.low[0], seen.high[0], 0.0f, size_px[0]);
        find_range(range[1], seen.low[1], seen.high[1], 0.0f, size_px[1]);
        frame->shaded_part =
            (struct frame_part){ range[0][0], range[1][0], range[0][1], range[1][1] };
    }
}

/* Finds the part of the underwater scene's picture that is visible through the water surface. */
static void find_part(struct frame *frame, const uint32_t below_px[2])
{
    const struct frame_block *const block = &frame->block;
    struct clip_range seen = { { 1.0f, 1.0f }, { -1.0f, -1.0f } };
    add_rectangle(&seen, block->view_projection, v3(0.0f, 0.0f, 0.0f),
                  (const float[2]){ block->tank[0], block->tank[2] });
    uint32_t range[2][2];
    for (uint32_t axis = 0; axis < 2; axis++) {
        const float shift = f_abs(block->bend[axis]) + f_abs(block->bend[2 + axis]);
        find_range(range[axis], seen.low[axis], seen.high[axis], 0.5f * shift, below_px[axis]);
    }
    frame->part = (struct frame_part){ range[0][0], range[1][0], range[0][1], range[1][1] };
}

/* Additional margin in pixels while the camera moves. */
#define PART_MOVING_PX 48u

static uint32_t end_of(uint32_t first, uint32_t size, uint32_t size_px)
{
    const uint32_t end = first + size + PART_MOVING_PX;
    return end < size_px ? end : size_px;
}

/* Keeps the part `last` of the previous frame while the camera moves, so that the render targets
 * are seldom created again. The part changes if it no longer contains the water, or has much more
 * than the water. */
static void keep_part(struct frame *frame, const struct frame_part *last,
                      const uint32_t below_px[2])
{
    struct frame_part *const part = &frame->part;
    const bool is_inside = part->x >= last->x && part->y >= last->y &&
                           part->x + part->width <= last->x + last->width &&
                           part->y + part->height <= last->y + last->height;
    if (is_inside && last->width * last->height < 2u * part->width * part->height) {
        *part = *last;
        return;
    }
    const uint32_t right = end_of(part->x, part->width, below_px[0]);
    const uint32_t top = end_of(part->y, part->height, below_px[1]);
    part->x = part->x > PART_MOVING_PX ? (part->x - PART_MOVING_PX) & ~1u : 0u;
    part->y = part->y > PART_MOVING_PX ? (part->y - PART_MOVING_PX) & ~1u : 0u;
    part->width = right - part->x;
    part->height = top - part->y;
}

/* Frames in which a camera that has stopped still counts as moving, so that a camera that stops for
 * a moment in a round does not change the render targets twice. */
#define MOVING_FRAMES 180u

/* Finds the part with the water, and whether the camera moves. The camera moves if one of the last
 * frames had another camera, and all of them had the same sizes. */
static void follow_camera(struct frame *frame, const uint32_t below_px[2])
{
    const struct frame_part last = frame->part;
    const bool is_same_size =
        memcmp(frame->last_below_px, below_px, sizeof frame->last_below_px) == 0;
    const bool is_same_view =
        memcmp(frame->last_view, frame->block.view_projection, sizeof frame->last_view) == 0;
    const uint32_t left = frame->moving_frames > 0 ? frame->moving_frames - 1u : 0u;
    frame->moving_frames = !is_same_size ? 0u : is_same_view ? left : MOVING_FRAMES;
    memcpy(frame->last_view, frame->block.view_projection, sizeof frame->last_view);
    memcpy(frame->last_below_px, below_px, sizeof frame->last_below_px);
    find_part(frame, below_px);
    if (frame->moving_frames > 0) {
        keep_part(frame, &last, below_px);
    }
}

/* Writes the block for the render targets below the water to `below`, and adds the position of
 * these render targets to the block for the screen. */
static void crop(struct frame *frame, struct frame_block *below, const uint32_t size_px[2],
                 const uint32_t below_px[2])
{
    const struct frame_part *const part = &frame->part;
    const float scale[2] = { (float)below_px[0] / (float)part->width,
                             (float)below_px[1] / (float)part->height };
    const float first[2] = { (float)part->x / (float)part->width,
                             (float)part->y / (float)part->height };
    *below = frame->block;
    below->vinyl[3] *= (float)size_px[1] / (float)below_px[1];
    for (uint32_t axis = 0; axis < 2; axis++) {
        for (uint32_t column = 0; column < 4; column++) {
            const float *const from = frame->block.view_projection + 4u * column;
            below->view_projection[4u * column + axis] =
                from[axis] * scale[axis] + from[3] * (scale[axis] - 2.0f * first[axis] - 1.0f);
        }
        frame->block.crop[axis] = scale[axis] / (float)size_px[axis];
        frame->block.crop[2u + axis] = -first[axis];
        frame->block.bend[axis] *= scale[axis];
        frame->block.bend[2u + axis] *= scale[axis];
    }
}

/* Sets the colours of the light: by night warm bulbs and a dark blue rest, by day an even light.
 * `pixel_m` is the width in m of a pixel at the middle of the picture. */
static void set_light(struct frame_block *block, bool is_day, float pixel_m)
{
    const float x = BULB_X * block->tank[0], z = BULB_Z * block->tank[2];
    const float far_x = block->tank[0] - x, far_z = block->tank[2] + f_abs(z);
    const float fall = (1.0f / f_sqrt(BULB_CORNER) - 1.0f) / (far_x * far_x + far_z * far_z);
    if (is_day) {
        frame_block_set(block->bulbs, 0.0f, 0.0f, 0.0f, fall);
        frame_block_set(block->evening, 1.0f, 1.0f, 1.0f, 1.0f);
        frame_block_set(block->water_tint, 0.09f, 0.42f, 0.53f, 0.0f);
        frame_block_set(block->sky_glow, 0.9f, 1.6f, x, z);
        frame_block_set(block->vinyl, 0.53f, 0.88f, 0.97f, pixel_m);
        return;
    }
    frame_block_set(block->bulbs, 1.68f, 1.25f, 0.88f, fall);
    frame_block_set(block->evening, 0.24f, 0.29f, 0.38f, 0.5f);
    frame_block_set(block->water_tint, 0.05f, 0.20f, 0.27f, 1.0f);
    frame_block_set(block->sky_glow, 4.6f, 1.4f, x, z);
    frame_block_set(block->vinyl, 0.43f, 0.63f, 0.69f, pixel_m);
}

void frame_lamp_light(const struct frame_block *block, float x, float z, float light[3])
{
    const float far_x = f_abs(x) - block->sky_glow[2], far_z = z - block->sky_glow[3];
    const float near = 1.0f / (1.0f + block->bulbs[3] * (far_x * far_x + far_z * far_z));
    for (uint32_t i = 0; i < 3; i++) {
        light[i] = block->evening[i] + block->bulbs[i] * near * near;
    }
}

void frame_open(struct frame *frame)
{
    frame->buffer = gl_buffer(GL_UNIFORM_BUFFER, NULL, sizeof frame->block);
    frame->below_buffer = gl_buffer(GL_UNIFORM_BUFFER, NULL, sizeof frame->block);
}

void frame_close(struct frame *frame)
{
    glDeleteBuffers(1, &frame->buffer);
    glDeleteBuffers(1, &frame->below_buffer);
}

void frame_bind(const struct frame *frame, bool is_below)
{
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, is_below ? frame->below_buffer : frame->buffer);
}

void frame_begin(struct frame *frame, const struct scene *scene,
                 const struct display_transform *transform, const uint32_t size_px[2],
                 const uint32_t below_px[2])
{
    CORE_ASSERT(scene->tank_size_m.y > 0.0f && size_px[0] > 0 && size_px[1] > 0);
    struct frame_block *const block = &frame->block;
    const float aspect = transform->width / transform->height;
    const float seconds = (float)(scene->tick % SECONDS_WRAP_TICKS) * CORE_TICK_S;
    const float layers = seconds * CAUSTIC_LAYERS_HZ;
    const float loops = f_floor(layers / (float)ASSET_CAUSTICS_FRAMES);
    const vec3 size = scene->tank_size_m;
    set_camera(frame, &scene->view, transform);
    /* `bend` is the displacement of the refracted picture on the screen per 2 * SEEN_SLOPE_MAX of
     * slope of the water surface. The displacement is computed for a point at the camera's target.
     * Elsewhere in the tank the error is a few per cent. */
    const struct view *const view = &scene->view;
    const struct basis axes = view_basis(view);
    const float distance = v3_length(v3_sub(view->eye_m, view->target_m));
    const float half_height_m = view_half_height_tan(view, aspect) * distance;
    const float shift_m = 2.0f * SEEN_SLOPE_MAX * REFRACTION * scene->tank_size_m.y;
    const float across = 0.5f * shift_m / (half_height_m * aspect);
    const float down = 0.5f * shift_m / half_height_m;
    const float *const placed = frame->placed;
    const float x[2] = { across * axes.right.x, down * axes.up.x };
    const float z[2] = { across * axes.right.z, down * axes.up.z };
    frame_block_set(block->bend, placed[0] * x[0] + placed[2] * x[1],
                    placed[1] * x[0] + placed[3] * x[1], placed[0] * z[0] + placed[2] * z[1],
                    placed[1] * z[0] + placed[3] * z[1]);
    list_shades(&frame->shades, scene);
    /* The player's right, which is not that of a camera that looks aside. */
    const vec3 right = view_to_world(view_is_turned(view), v3(1.0f, 0.0f, 0.0f));
    frame_block_set(block->shade_map, 1.0f / (size.x + 2.0f * SHADE_MAP_MARGIN_M),
                    1.0f / (size.z + 2.0f * SHADE_MAP_MARGIN_M), right.x, right.z);
    frame_block_set(block->eye, scene->view.eye_m.x, scene->view.eye_m.y, scene->view.eye_m.z,
                    seconds);
    frame_block_set(block->tank, 0.5f * size.x, size.y, 0.5f * size.z,
                    scene->wall_height_m - size.y);
    frame_block_set(block->screen, 1.0f / (float)size_px[0], 1.0f / (float)size_px[1],
                    ABSORPTION_OVER_DEPTH / size.y, layers - loops * (float)ASSET_CAUSTICS_FRAMES);
    frame_block_set(block->shadow, 2.0f / (size.x * SHADOW_MARGIN), 2.0f / (size.z * SHADOW_MARGIN),
                    SHADOW_DRIFT_X, SHADOW_DRIFT_Z);
    set_light(block, frame->is_day, distance / frame->view.focal_px);
    struct frame_block below;
    find_shaded_part(frame, size_px);
    follow_camera(frame, below_px);
    crop(frame, &below, size_px, below_px);
    glBindBuffer(GL_UNIFORM_BUFFER, frame->below_buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, &below, sizeof below);
    glBindBuffer(GL_UNIFORM_BUFFER, frame->buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, block, sizeof *block);
    frame_bind(frame, false);
}
