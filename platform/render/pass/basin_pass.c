/* basin_pass.c -- draws the tank, the water surface, the rim of the tank, and the counter (the
 * table around the tank) from one vertex buffer. */
#include "platform/render/pass/basin_pass.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "platform/render/pass/poi_pass.h"
#include "shaders.h"

/* A corner of the tank. The coordinates are small integers. The vertex shaders water.vert.glsl and
 * deck.vert.glsl map these integers to the tank's dimensions. */
struct corner {
    float position[3], normal[3];
};

struct face {
    float a[3], b[3], c[3], d[3]; /* Four corners of a face of the tank, in order around the
                                     face. */
    float normal[3];
};

enum basin_part {
    PART_FLOOR,
    PART_WALLS,
    PART_SURFACE,
    PART_EDGE,
    PART_BACKDROP,
    PART_COUNTER,
    PART_SIDES,
    PART_RIM,
    PART_MIRROR,
    PART_KEPT,
    PART_KEPT_SHADED,
    PART_END = BASIN_PARTS
};

#define UP { 0.0f, 1.0f, 0.0f }
#define H 0.5f
#define VERTICES_PER_FACE 6u
/* Number of cells of the floor from left to right and from far to near. A cell of the festival tank
 * is 40 mm wide, as narrow as the soft edge of a shade. Smaller cells cost more, because a GPU
 * shades complete quads of 2x2 pixels at the edges of triangles. */
#define FLOOR_X 32
#define FLOOR_Z 16
/* Number of cells of a wall from left to right, and from the water surface to the floor. */
#define WALL_COLUMNS 24
#define WALL_ROWS 6
#define FLOOR_DEFINES GL_DEFINE("GRID_X", FLOOR_X) GL_DEFINE("GRID_Z", FLOOR_Z)
#define WALL_DEFINES GL_DEFINE("WALL_COLUMNS", WALL_COLUMNS) GL_DEFINE("WALL_ROWS", WALL_ROWS)
/* Slope of the water surface that a value of 1 in the scene's `slope` array means. */
#define SLOPE_UNIT (1.0f / 508.0f)
/* Number of ticks after which the animation of the wind waves restarts at time 0, so that the
 * arguments of the sine functions stay small and exact. The water surface jumps slightly at each
 * restart. */
#define WIND_WRAP_TICKS (600u * CORE_TICK_HZ)

static const struct face faces[] = {
    /* Water surface, and its strips at the walls, in the order far, near, left, right. The
     * coordinates 0.5 are near the wall (water.vert.glsl). */
    { { -H, 0, -H }, { H, 0, -H }, { H, 0, H }, { -H, 0, H }, UP },
    { { -1, 0, -1 }, { 1, 0, -1 }, { H, 0, -H }, { -H, 0, -H }, UP },
    { { -H, 0, H }, { H, 0, H }, { 1, 0, 1 }, { -1, 0, 1 }, UP },
    { { -1, 0, -1 }, { -H, 0, -H }, { -H, 0, H }, { -1, 0, 1 }, UP },
    { { H, 0, -H }, { 1, 0, -1 }, { 1, 0, 1 }, { H, 0, H }, UP },
    /* Street behind the stall. */
    { { -3, -1, -3 }, { 3, -1, -3 }, { 3, 2, -3 }, { -3, 2, -3 }, { 0, 0, 1 } },
    /* Counter (the table around the tank), in the order far, near, left, right. */
    { { -3, -1, -3 }, { 3, -1, -3 }, { 3, -1, -2 }, { -3, -1, -2 }, UP },
    { { -3, -1, 2 }, { 3, -1, 2 }, { 3, -1, 3 }, { -3, -1, 3 }, UP },
    { { -3, -1, -2 }, { -2, -1, -2 }, { -2, -1, 2 }, { -3, -1, 2 }, UP },
    { { 2, -1, -2 }, { 3, -1, -2 }, { 3, -1, 2 }, { 2, -1, 2 }, UP },
    /* Inner sides of the rim, in the order far, left, right. The inner side of the near edge faces
     * away from the player and is not drawn. */
    { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { 0, 0, 1 } },
    { { -1, 0, -1 }, { -1, 0, 1 }, { -1, 1, 1 }, { -1, 1, -1 }, { 1, 0, 0 } },
    { { 1, 0, -1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 1, 1, -1 }, { -1, 0, 0 } },
    /* Outer side of the rim's near edge. The player cannot see the outer sides of the other
     * edges. */
    { { -2, -1, 2 }, { 2, -1, 2 }, { 2, 1, 2 }, { -2, 1, 2 }, { 0, 0, 1 } },
    /* Top of the rim, in the order far, near, left, right. */
    { { -2, 1, -2 }, { 2, 1, -2 }, { 2, 1, -1 }, { -2, 1, -1 }, UP },
    { { -2, 1, 1 }, { 2, 1, 1 }, { 2, 1, 2 }, { -2, 1, 2 }, UP },
    { { -2, 1, -1 }, { -1, 1, -1 }, { -1, 1, 1 }, { -2, 1, 1 }, UP },
    { { 1, 1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 1, 1, 1 }, UP },
    /* Reflections on the water surface. */
    { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -1, 0, 1 }, UP },
};
#define FACE_COUNT (sizeof faces / sizeof *faces)

static const uint8_t part_faces[PART_END + 1] = { 0,  0,  0,  1,  5,          6,
                                                  10, 14, 18, 19, FACE_COUNT, FACE_COUNT };

/* Shader program of each part of the tank. */
static const struct {
    const char *name, *defines, *vertex, *fragment, *samplers;
} programs[PART_END] = {
    [PART_FLOOR] = { "floor", FLOOR_DEFINES, shader_floor_vert, shader_floor_frag,
                     "caustics shadows" },
    [PART_WALLS] = { "walls", WALL_DEFINES, shader_wall_vert, shader_wall_frag, "caustics" },
    [PART_SURFACE] = { "water", "", shader_water_vert, shader_water_frag, "ground life mirror" },
    [PART_EDGE] = { "water edge", "#define EDGE\n", shader_water_vert, shader_water_frag,
                    "ground life mirror" },
    [PART_BACKDROP] = { "backdrop", "#define BACKDROP\n", shader_deck_vert, shader_deck_frag,
                        "wood backdrop" },
    [PART_COUNTER] = { "counter", "#define COUNTER\n", shader_deck_vert, shader_deck_frag,
                       "wood backdrop" },
    [PART_SIDES] = { "rim sides", "", shader_deck_vert, shader_deck_frag, "wood backdrop" },
    [PART_RIM] = { "rim", "#define RIM\n", shader_deck_vert, shader_deck_frag, "wood backdrop" },
    [PART_MIRROR] = { "mirror", "#define MIRROR\n", shader_water_vert, shader_mirror_frag,
                      "slopes environment" },
    [PART_KEPT] = { "kept deck", "#define KEPT\n", shader_deck_vert, shader_deck_frag, "wood" },
    [PART_KEPT_SHADED] = { "shaded kept deck", "#define KEPT\n#define SHADED\n", shader_deck_vert,
                           shader_deck_frag, "wood" },
};

/* Draws the faces of the parts `first` to `last` with the program of `part`. */
static void draw_parts(const struct basin_pass *pass, enum basin_part part, enum basin_part first,
                       enum basin_part last)
{
    CORE_ASSERT(part < PART_END && last < PART_END);
    const GLint begin = part_faces[first] * (GLint)VERTICES_PER_FACE;
    const GLint end = part_faces[last + 1] * (GLint)VERTICES_PER_FACE;
    glUseProgram(pass->programs[part]);
    glBindVertexArray(pass->vertex_array);
    glDrawArrays(GL_TRIANGLES, begin, end - begin);
}

static void draw_part(const struct basin_pass *pass, enum basin_part part)
{
    draw_parts(pass, part, part, part);
}

void basin_pass_open(struct gl_status *status, struct basin_pass *pass)
{
    for (uint32_t i = 0; i < PART_END; i++) {
        pass->programs[i] =
            gl_program(status, programs[i].name, programs[i].defines, programs[i].vertex,
                       programs[i].fragment, programs[i].samplers);
    }
    for (uint32_t i = 0; i < 2; i++) {
        pass->to_kept[i] = glGetUniformLocation(pass->programs[PART_KEPT + i], "to_kept");
    }
    struct corner corners[FACE_COUNT * VERTICES_PER_FACE];
    struct corner *out = corners;
    for (uint32_t i = 0; i < FACE_COUNT; i++) {
        const struct face *const face = &faces[i];
        const float *const around[VERTICES_PER_FACE] = { face->a, face->b, face->c,
                                                         face->a, face->c, face->d };
        for (uint32_t k = 0; k < VERTICES_PER_FACE; k++) {
            memcpy(out->position, around[k], sizeof out->position);
            memcpy(out->normal, face->normal, sizeof out->normal);
            out++;
        }
    }
    glGenVertexArrays(1, &pass->no_attributes);
    glGenVertexArrays(1, &pass->vertex_array);
    glBindVertexArray(pass->vertex_array);
    pass->vertex_buffer = gl_buffer(GL_ARRAY_BUFFER, corners, sizeof corners);
    gl_attribute_floats(0, 3, sizeof *corners, offsetof(struct corner, position));
    gl_attribute_floats(1, 3, sizeof *corners, offsetof(struct corner, normal));
    glBindVertexArray(0);
    gl_ring_open(
        status, "slopes", &pass->slope_ring,
        &(struct gl_texture_desc){
            /* The texels are 16-bit floats. With 8-bit slopes, the reflections of the lanterns
             * would have visible steps. */
            .internal_format = GL_RGBA16F,
            .width = RIPPLE_X,
            .height = RIPPLE_Z });
}

void basin_pass_close(struct basin_pass *pass)
{
    for (uint32_t i = 0; i < PART_END; i++) {
        glDeleteProgram(pass->programs[i]);
    }
    glDeleteVertexArrays(1, &pass->vertex_array);
    glDeleteVertexArrays(1, &pass->no_attributes);
    glDeleteBuffers(1, &pass->vertex_buffer);
    gl_ring_close(&pass->slope_ring);
}

/* A wave that a light wind causes on the water surface. The renderer adds a few of these long, low
 * waves to the slopes from the core, so that the reflections of the lanterns always move. `slope`
 * is the slope times 508, as in struct scene. */
struct wind_wave {
    float x_rad_m, z_rad_m, rad_s, slope;
};

static const struct wind_wave wind[] = {
    { 31.0f, 19.0f, 3.1f, 7.0f },
    { -22.0f, 37.0f, 3.7f, 7.0f },
    { 58.0f, -13.0f, 5.3f, 4.5f },
};

/* Adds one wave to the slopes of the whole grid. The wave is sin(p + q) with the phase p along x
 * and the phase q along z. Because sin(p + q) = sin p * cos q + cos p * sin q, the sines are
 * computed once for each column and each row and not for each grid point. */
static void add_wind(struct basin_pass *pass, const struct wind_wave *wave, vec3 size_m,
                     float time_s)
{
    const float length = f_sqrt(wave->x_rad_m * wave->x_rad_m + wave->z_rad_m * wave->z_rad_m);
    const float along_x = wave->slope * wave->x_rad_m / length;
    const float along_z = wave->slope * wave->z_rad_m / length;
    float sin_x[RIPPLE_X];
    float cos_x[RIPPLE_X];
    for (uint32_t x = 0; x < RIPPLE_X; x++) {
        const float phase = wave->x_rad_m * size_m.x * (float)x / (float)RIPPLE_X;
        sin_x[x] = f_sin(phase);
        cos_x[x] = f_cos(phase);
    }
    for (uint32_t z = 0; z < RIPPLE_Z; z++) {
        const float phase = wave->z_rad_m * size_m.z * (float)z / (float)RIPPLE_Z -
                            f_wrap_angle(wave->rad_s * time_s);
        const float sin_z = f_sin(phase);
        const float cos_z = f_cos(phase);
        for (uint32_t x = 0; x < RIPPLE_X; x++) {
            const float height = sin_x[x] * cos_z + cos_x[x] * sin_z;
            pass->waves[z][x][0] += along_x * height;
            pass->waves[z][x][1] += along_z * height;
        }
    }
}

/* Maximum slope of the water surface for the refraction of the objects below. With a steeper slope,
 * the refracted picture would have folds and streaks where the slope changes sign within a grid
 * cell. With this maximum, the refraction at two neighbouring cells differs by at most 0.65 cell
 * widths in the festival tank and 0.89 in the deep tank of the 2013 thesis. */
#define SEEN_SLOPE_MAX 0.05f

/* Reduces the slopes in pass->waves around a poi near the surface (poi_refraction_share()). */
static void calm_waterline(struct basin_pass *pass, const struct scene *scene,
                           const struct scene_poi *poi)
{
    const float reach_m = poi_calm_reach_m(poi);
    const float cell_x_m = scene->tank_size_m.x / (float)RIPPLE_X;
    const float cell_z_m = scene->tank_size_m.z / (float)RIPPLE_Z;
    const struct basis axes = vec_basis_from_angles(poi->angles);
    for (uint32_t z = 0; z < RIPPLE_Z; z++) {
        const float z_m = ((float)z + 0.5f) * cell_z_m - 0.5f * scene->tank_size_m.z;
        for (uint32_t x = 0; f_abs(z_m - poi->position_m.z) < reach_m && x < RIPPLE_X; x++) {
            const float x_m = ((float)x + 0.5f) * cell_x_m - 0.5f * scene->tank_size_m.x;
            const float share = poi_refraction_share(poi, &axes, x_m, z_m);
            pass->waves[z][x][0] *= share;
            pass->waves[z][x][1] *= share;
        }
    }
}

void basin_pass_prepare(struct basin_pass *pass, const struct scene *scene)
{
    CORE_ASSERT(scene->tank_size_m.x > 0.0f && scene->tank_size_m.z > 0.0f);
    const float time_s = (float)(scene->tick % WIND_WRAP_TICKS) * CORE_TICK_S;
    memset(pass->waves, 0, sizeof pass->waves);
    for (size_t i = 0; i < sizeof wind / sizeof *wind; i++) {
        add_wind(pass, &wind[i], scene->tank_size_m, time_s);
    }
    for (uint32_t z = 0; z < RIPPLE_Z; z++) {
        for (uint32_t x = 0; x < RIPPLE_X; x++) {
            pass->waves[z][x][0] += (float)scene->slope[z][x][0];
            pass->waves[z][x][1] += (float)scene->slope[z][x][1];
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi_is_below(&scene->poi[i])) {
            calm_waterline(pass, scene, &scene->poi[i]);
        }
    }
    for (uint32_t z = 0; z < RIPPLE_Z; z++) {
        for (uint32_t x = 0; x < RIPPLE_X; x++) {
            uint16_t *const texel = pass->slopes[z][x];
            const float along_x = SLOPE_UNIT * pass->waves[z][x][0];
            const float along_z = SLOPE_UNIT * pass->waves[z][x][1];
            const float seen = SEEN_SLOPE_MAX / f_sqrt(SEEN_SLOPE_MAX * SEEN_SLOPE_MAX +
                                                       along_x * along_x + along_z * along_z);
            texel[0] = half_float(along_x);
            texel[1] = half_float(along_z);
            texel[2] = half_float(along_x * seen);
            texel[3] = half_float(along_z * seen);
        }
    }
    gl_bind_texture(0, GL_TEXTURE_2D, gl_ring_turn(&pass->slope_ring));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, RIPPLE_X, RIPPLE_Z, GL_RGBA, GL_HALF_FLOAT,
                    pass->slopes);
}

void basin_pass_ground(const struct basin_pass *pass, GLuint caustics, GLuint shadows)
{
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    gl_bind_texture(1, GL_TEXTURE_2D, shadows);
    glUseProgram(pass->programs[PART_FLOOR]);
    glBindVertexArray(pass->no_attributes);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (FLOOR_X + 1), FLOOR_Z);
    glUseProgram(pass->programs[PART_WALLS]);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (4 * WALL_COLUMNS + 1), WALL_ROWS);
}

/* Draws the rim, the counter and the street into the current render target. The faces are drawn
 * from the farthest to the nearest. */
static void draw_deck(const struct basin_pass *pass, const struct textures *textures)
{
    gl_bind_texture(0, GL_TEXTURE_2D, textures->wood);
    gl_bind_texture(1, GL_TEXTURE_2D_ARRAY, textures->backdrop);
    draw_part(pass, PART_BACKDROP);
    draw_part(pass, PART_COUNTER);
    draw_part(pass, PART_SIDES);
    glEnable(GL_BLEND);
    draw_part(pass, PART_RIM);
    glDisable(GL_BLEND);
}

/* Returns the row `row` of the column-major matrix `m`, multiplied by the point `at`. */
static float times_row(const float m[16], uint32_t row, vec3 at)
{
    return m[row] * at.x + m[4 + row] * at.y + m[8 + row] * at.z + m[12 + row];
}

/* Largest factor by which a texel of the kept picture may be magnified, and a factor that no two
 * cameras have. */
#define KEPT_ZOOM_MAX 1.3f
#define ANY_ZOOM 1e6f

/* Returns true if the kept picture of a tank shows the four corners of the picture of the camera
 * `view`, magnified by at most `zoom_max`. Everything between the corners is then in the kept
 * picture too. A camera that comes closer also sees nothing that the rim hides from the camera of
 * the kept picture, because the closer camera looks less steeply over the rim. In attract mode, the
 * drifting camera rises by up to 2 cm and sees a little more behind the far rim. The kept picture
 * shows the rim there. This error is accepted, because the picture barely differs (test_deck.c). */
static bool is_covered(const struct deck_view *kept, const struct view *view, float aspect,
                       float zoom_max)
{
    const vec3 back = view_basis(view).back;
    const float zoom = kept->view.half_height_tan / view->half_height_tan;
    bool is_inside = true;
    for (uint32_t i = 0; i < 4 && is_inside; i++) {
        const vec3 at_m =
            view_point_on_plane(view, aspect, i & 1u ? 1.0f : -1.0f, i & 2u ? 1.0f : -1.0f, 0.0f);
        const float depth_m = v3_dot(v3_sub(view->eye_m, at_m), back);
        const float w = times_row(kept->view_projection, 3, at_m);
        const float edge = 1.001f * w; /* A corner of the same camera is rounded. */
        is_inside = f_abs(times_row(kept->view_projection, 0, at_m)) <= edge &&
                    f_abs(times_row(kept->view_projection, 1, at_m)) <= edge &&
                    zoom * w <= zoom_max * depth_m;
    }
    return is_inside;
}

/* Computes the matrix of the kept picture with its margin. Returns true if the picture has this
 * matrix already. */
static bool set_kept_matrix(struct deck_view *kept, const struct frame *frame,
                            const struct display_transform *transform,
                            const struct gl_target *target)
{
    const float share[2] = { 1.0f / (frame->block.screen[0] * (float)target->width),
                             1.0f / (frame->block.screen[1] * (float)target->height) };
    float m[16];
    frame_view_projection(m, &kept->view, transform);
    for (uint32_t i = 0; i < 16; i++) {
        m[i] *= i % 4u < 2u ? share[i % 4u] : 1.0f;
    }
    const bool is_same = memcmp(m, kept->view_projection, sizeof m) == 0;
    memcpy(kept->view_projection, m, sizeof m);
    return is_same;
}

void basin_pass_keep_deck(struct basin_pass *pass, const struct frame *frame,
                          const struct scene *scene, const struct display_transform *transform,
                          const struct gl_target *target, const struct textures *textures)
{
    struct deck_view *const kept = &pass->kept;
    const float aspect = transform->width / transform->height;
    if (memcmp(kept->tank, frame->block.tank, sizeof kept->tank) != 0 ||
        view_is_turned(&kept->widest) != view_is_turned(&scene->view)) {
        memcpy(kept->tank, frame->block.tank, sizeof kept->tank);
        kept->view = kept->widest = scene->view;
        kept->is_drawn = false;
    }
    kept->is_drawn &= set_kept_matrix(kept, frame, transform, target);
    if (!is_covered(kept, &scene->view, aspect, KEPT_ZOOM_MAX)) {
        kept->is_drawn = false;
        kept->view = kept->widest;
        set_kept_matrix(kept, frame, transform, target);
    }
    if (!is_covered(kept, &scene->view, aspect, KEPT_ZOOM_MAX)) {
        kept->view = scene->view;
        set_kept_matrix(kept, frame, transform, target);
        if (is_covered(kept, &kept->widest, aspect, ANY_ZOOM)) {
            kept->widest = scene->view;
        }
    }
    if (kept->is_drawn) {
        return;
    }
    kept->is_drawn = true;
    struct frame_block block = frame->block;
    memcpy(block.view_projection, kept->view_projection, sizeof block.view_projection);
    memcpy(block.eye, &kept->view.eye_m, sizeof kept->view.eye_m);
    glBindBuffer(GL_UNIFORM_BUFFER, frame->buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, &block, sizeof block);
    gl_target_bind(target);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_deck(pass, textures);
    gl_target_resolve(target);
    gl_buffer_refill(GL_UNIFORM_BUFFER, &frame->block, sizeof frame->block);
}

void basin_pass_forget(struct basin_pass *pass)
{
    pass->kept.is_drawn = false;
}

/* Writes the rows of the matrix from the world to the texture of the kept picture: to u and v, both
 * multiplied by w, and to w. */
static void set_to_kept(const struct basin_pass *pass)
{
    const float *const m = pass->kept.view_projection;
    float rows[3][4];
    for (uint32_t i = 0; i < 4; i++) {
        rows[0][i] = 0.5f * (m[4u * i] + m[4u * i + 3u]);
        rows[1][i] = 0.5f * (m[4u * i + 1u] + m[4u * i + 3u]);
        rows[2][i] = m[4u * i + 3u];
    }
    for (uint32_t i = 0; i < 2; i++) {
        glUseProgram(pass->programs[PART_KEPT + i]);
        glUniform4fv(pass->to_kept[i], 3, rows[0]);
    }
}

/* The shades are read only in the part where fans cast them, because each texture lookup of the rim
 * and the counter takes V3D half a millisecond on the whole screen. */
void basin_pass_deck(const struct basin_pass *pass, const struct frame *frame,
                     const struct gl_target *kept)
{
    const struct frame_part *const shaded = &frame->shaded_part;
    /* The screen is smaller than the kept picture. */
    const GLsizei width = (GLsizei)kept->width, height = (GLsizei)kept->height;
    const GLsizei left = (GLsizei)shaded->x, right = left + (GLsizei)shaded->width;
    const GLsizei low = (GLsizei)shaded->y, high = low + (GLsizei)shaded->height;
    /* Left, bottom, width and height of the shaded part, and of the parts below it, above it, and
     * on both sides. */
    const GLsizei parts[5][4] = { { left, low, right - left, high - low },
                                  { 0, 0, width, low },
                                  { 0, high, width, height - high },
                                  { 0, low, left, high - low },
                                  { right, low, width - right, high - low } };
    set_to_kept(pass);
    gl_bind_texture(0, GL_TEXTURE_2D, kept->texture);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    for (uint32_t i = 0; i < 5; i++) {
        if (parts[i][2] > 0 && parts[i][3] > 0) {
            glScissor(parts[i][0], parts[i][1], parts[i][2], parts[i][3]);
            draw_parts(pass, i == 0 ? PART_KEPT_SHADED : PART_KEPT, PART_BACKDROP, PART_RIM);
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void basin_pass_mirror(const struct basin_pass *pass, const struct textures *textures)
{
    gl_bind_texture(0, GL_TEXTURE_2D, gl_ring_texture(&pass->slope_ring));
    gl_bind_texture(1, GL_TEXTURE_2D, textures->environment);
    draw_part(pass, PART_MIRROR);
}

void basin_pass_water(const struct basin_pass *pass, GLuint ground, GLuint life, GLuint mirror)
{
    gl_bind_texture(0, GL_TEXTURE_2D, ground);
    gl_bind_texture(1, GL_TEXTURE_2D, life);
    gl_bind_texture(2, GL_TEXTURE_2D, mirror);
    draw_part(pass, PART_SURFACE);
    draw_part(pass, PART_EDGE);
}
