/* hand_pass.c -- places and draws the hands; see hand_pass.h. */
#include "platform/render/pass/hand_pass.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "platform/render/pass/hand_mesh.h"
#include "platform/render/pass/quad_pass.h"
#include "shaders.h"

/* Front end of the hand along the handle, half of the largest width of the arm, and number of
 * straight parts of which the picture of the arm is assumed to consist. */
#define HAND_FRONT_Z 2.4f
#define ARM_HALF_WIDTH 1.4f
#define ARM_PARTS 6u
/* Height in m of the player's shoulder above the water, and its distance from the tank. */
#define SHOULDER_M 0.36f
#define SHOULDER_AWAY_M 0.36f
/* Greatest sine of the elevation of the forearm. A steeper forearm would hide the paper. */
#define RISE_MAX 0.72f
/* Height in m above the water that the forearm reaches within CLEAR_LENGTH ring radii of the wrist,
 * if the forearm can rise so steeply. */
#define CUFF_CLEAR_M 0.03f
#define CLEAR_LENGTH 1.3f

/* Length of a unit of the mesh of a hand that holds a fan, and the place in the mesh at which the
 * handle of the fan ends. */
#define FAN_UNIT_M 0.042f
#define FAN_END_Z 3.6f
/* Height in m above the rim of the tank to which a hand is drawn nearer. */
#define RIM_CLEAR_M 0.004f
/* Depth in normalized device coordinates per inverse metre (frame_view_projection()). */
#define DEPTH_PER_INVERSE_M 0.1007f
/* Greatest difference of the depth, for a camera that is hardly above the rim. */
#define NEARER_MAX 0.3f

/* Returns the point of the world to which a column-major matrix moves a point. */
static vec3 moved_by(const float m[16], vec3 p)
{
    return v3(m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12],
              m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
              m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]);
}

/* Returns axes whose `back` is `back` and whose `up` is as near to `up` as possible. */
static struct basis axes_along(vec3 back, vec3 up)
{
    const vec3 right = v3_normalize_or(v3_cross(up, back), v3(1.0f, 0.0f, 0.0f));
    return (struct basis){ .right = right, .up = v3_cross(back, right), .back = back };
}

/* A handle that a hand holds. */
struct grip {
    vec3 position_m;    /* Place of the origin of the mesh. */
    struct basis axes;  /* Axes of the handle, which extends along `back`. */
    float unit_m;       /* Length of a unit of the mesh. */
    bool left;          /* True for a left hand. */
    bool leads_to_hand; /* True if the handle points to the player's place. */
    bool is_of_fan;
};

static bool is_alone(const struct scene *scene)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += scene->poi[i].present;
    }
    return count < 2;
}

/* Returns the horizontal direction from a handle to the player. The handle of a bot points to the
 * bot's place, except for a player who plays alone at the short side of the tank. A person stands
 * at the side of the tank that the camera shows at the bottom. At the short side, the bowl is below
 * the hand on the screen. The arm of a player who plays alone there comes from the opposite side,
 * so that the arm does not hide the bowl. */
static vec3 way_to_player(const struct scene *scene, const struct grip *grip)
{
    const bool is_turned = view_is_turned(&scene->view);
    const bool is_inward = is_turned && is_alone(scene) && !grip->is_of_fan;
    const float aside = is_inward ? -0.75f : 0.25f;
    const vec3 near = view_to_world(is_turned, v3(grip->left ? -aside : aside, 0.0f, 1.0f));
    const vec3 flat = v3_normalize_or(v3_flat(grip->axes.back), near);
    if (grip->leads_to_hand && !is_inward) {
        return flat;
    }
    return v3_normalize_or(v3_muladd(near, flat, is_inward ? 0.5f : 0.8f), near);
}

/* Returns the distance in m along the horizontal direction `way` at which the player stands. */
static float distance_to_player(const struct scene *scene, vec3 from_m, vec3 way)
{
    const float x_m = 0.5f * scene->tank_size_m.x + SHOULDER_AWAY_M;
    const float z_m = 0.5f * scene->tank_size_m.z + SHOULDER_AWAY_M;
    const float by_x = (x_m - (way.x < 0.0f ? -from_m.x : from_m.x)) / f_max(f_abs(way.x), 0.01f);
    const float by_z = (z_m - (way.z < 0.0f ? -from_m.z : from_m.z)) / f_max(f_abs(way.z), 0.01f);
    return f_max(f_min(by_x, by_z), 0.2f);
}

static void place_arm(struct hand_frames *out, const struct scene *scene, const struct grip *grip)
{
    const float unit_m = grip->unit_m;
    CORE_ASSERT(unit_m > 0.0f);
    /* The mesh is a right hand. Its mirror image is a left hand. */
    const float side = grip->left ? -1.0f : 1.0f;
    struct basis hand = grip->axes;
    hand.right = v3_scale(hand.right, side);
    const vec3 wrist = v3(HAND_WRIST_X, HAND_WRIST_Y, HAND_WRIST_Z);
    const vec3 wrist_m = v3_muladd(grip->position_m, vec_basis_to_world(&hand, wrist), unit_m);
    const vec3 way = way_to_player(scene, grip);
    const float far_m = distance_to_player(scene, wrist_m, way);
    const float high_m = SHOULDER_M - wrist_m.y;
    const float needed = (CUFF_CLEAR_M - wrist_m.y) / (CLEAR_LENGTH * unit_m);
    const float rise =
        f_clamp(f_max(high_m / f_sqrt(high_m * high_m + far_m * far_m), needed), 0.0f, RISE_MAX);
    const float level = f_sqrt(1.0f - rise * rise);
    const vec3 along = v3_muladd(v3_scale(way, level), v3(0.0f, 1.0f, 0.0f), rise);
    struct basis arm = axes_along(along, hand.up);
    struct basis sleeve = axes_along(along, v3(0.0f, 1.0f, 0.0f));
    arm.right = v3_scale(arm.right, side);
    sleeve.right = v3_scale(sleeve.right, side);
    const vec3 back = v3_scale(wrist, 0.0f - unit_m);
    poi_pose_of_axes(out->matrices[0], grip->position_m, &hand, unit_m);
    poi_pose_of_axes(out->matrices[1], v3_add(wrist_m, vec_basis_to_world(&arm, back)), &arm,
                     unit_m);
    poi_pose_of_axes(out->matrices[2], v3_add(wrist_m, vec_basis_to_world(&sleeve, back)), &sleeve,
                     unit_m);
    out->stretch = f_max(far_m / (level * unit_m) - (HAND_CUFF_Z - HAND_WRIST_Z), 2.0f) /
                   (HAND_SLEEVE_END_Z - HAND_CUFF_Z);
    out->left = grip->left;
}

void hand_frames_of(struct hand_frames *out, const struct scene *scene, const struct scene_poi *poi)
{
    place_arm(out, scene,
              &(struct grip){ .position_m = poi->position_m,
                              .axes = scene_handle_axes(poi),
                              .unit_m = poi->ring_radius_m,
                              .left = poi->left_hand,
                              .leads_to_hand = poi->handle_rad != 0.0f });
}

/* Computes the frames of the hand that holds a fan: the hand that does not hold the poi. */
static void fan_frames_of(struct hand_frames *out, const struct scene *scene,
                          const struct scene_fan *fan)
{
    const struct basis axes = vec_basis_from_angles(quad_fan_angles(scene, fan));
    const vec3 at_m = v3(fan->x_m, QUAD_FAN_HEIGHT_M, fan->z_m);
    const float back_m = QUAD_FAN_HANDLE * fan->radius_m - FAN_END_Z * FAN_UNIT_M;
    place_arm(out, scene,
              &(struct grip){ .position_m = v3_muladd(at_m, axes.back, back_m),
                              .axes = axes,
                              .unit_m = FAN_UNIT_M,
                              .left = !scene->poi[fan->owner].left_hand,
                              .is_of_fan = true });
    out->nearer = 0.0f; /* The arm is above the rim of the tank. */
}

/* Returns true if the picture of an arm may overlap the paper of `poi`. */
static bool may_cover(const struct scene *scene, const struct hand_frames *frames,
                      const struct scene_poi *poi)
{
    const vec3 paper = view_project(&scene->view, poi->position_m);
    vec3 last = paper;
    float last_half = 0.0f;
    for (uint32_t i = 0; i <= ARM_PARTS; i++) {
        const float z = HAND_FRONT_Z + (HAND_SLEEVE_END_Z - HAND_FRONT_Z) * frames->stretch *
                                           (float)i / (float)ARM_PARTS;
        const float *const m = frames->matrices[z < HAND_WRIST_Z ? 0 : 2];
        const vec3 at = view_project(&scene->view, moved_by(m, v3(HAND_WRIST_X, 0.0f, z)));
        const vec3 from = i > 0 ? last : at;
        const vec3 along = v3(at.x - from.x, at.y - from.y, 0.0f);
        const vec3 there = v3(paper.x - from.x, paper.y - from.y, 0.0f);
        const float t =
            f_clamp(v3_dot(there, along) / f_max(v3_dot(along, along), 1e-9f), 0.0f, 1.0f);
        /* Half of the arm's width in ring radii, times the length of a metre at this point. */
        const float half = at.z * f_min(0.45f + 0.3f * (z - HAND_FRONT_Z), ARM_HALF_WIDTH);
        const float width = 1.17f * paper.z + f_lerp(i > 0 ? last_half : half, half, t);
        if (v3_length(v3_muladd(there, along, -t)) < poi->ring_radius_m * width) {
            return true;
        }
        last = at;
        last_half = half;
    }
    return false;
}

/* Returns the difference of the depth that draws a hand above the rim of the tank. The difference
 * is the same for the whole hand, so that the parts of the hand hide each other as at its place. */
static float nearer_than_rim(const struct scene *scene, const struct hand_frames *frames)
{
    static const struct {
        uint32_t frame;
        vec3 point;
    } low[] = { { 0, { 0.3f, -0.6f, 2.8f } },
                { 0, { 0.3f, -0.3f, 4.6f } },
                { 2, { HAND_WRIST_X, -1.2f, HAND_CUFF_Z - 0.4f } },
                { 2, { HAND_WRIST_X, -0.8f, HAND_CUFF_Z + 2.0f } } };
    const float top_m = scene->wall_height_m - scene->tank_size_m.y + RIM_CLEAR_M;
    const float above_m = f_max(scene->view.eye_m.y - top_m, RIM_CLEAR_M);
    float nearer = 0.0f;
    for (uint32_t i = 0; i < sizeof low / sizeof *low; i++) {
        const vec3 at_m = moved_by(frames->matrices[low[i].frame], low[i].point);
        /* The ray from the camera to the point crosses the plane above the rim. */
        const float inverse = view_project(&scene->view, at_m).z;
        nearer = f_max(nearer, inverse * (top_m - at_m.y) / above_m);
    }
    return f_min(DEPTH_PER_INVERSE_M * nearer, NEARER_MAX);
}

/* Draws the pattern of the cloth: hemp leaves, which are the edges of triangles and lines from the
 * corners of each triangle to its middle. A tile has 3 triangles in a row, and 4 rows. */
static void draw_cloth(uint8_t texels[HAND_SKIN_SIDE * HAND_SKIN_SIDE][3])
{
    for (uint32_t i = 0; i < HAND_SKIN_SIDE * HAND_SKIN_SIDE; i++) {
        const float y = 4.0f * (float)(i / HAND_SKIN_SIDE) / (float)HAND_SKIN_SIDE;
        const float x = 3.0f * (float)(i % HAND_SKIN_SIDE) / (float)HAND_SKIN_SIDE + 0.5f * y;
        const float a = x - f_floor(x), b = y - f_floor(y);
        /* Distances to the three sides of the triangle, in heights of the triangle. */
        const float first = a + b < 1.0f ? a : 1.0f - a;
        const float second = a + b < 1.0f ? b : 1.0f - b;
        const float third = 1.0f - first - second;
        const float least = f_min(f_min(first, second), third);
        const float most = f_max(f_max(first, second), third);
        const float middle = 1.0f - least - most;
        const float line = f_min(least, 0.6f * (middle - least));
        memset(texels[i], (int)(84.0f * f_smoothstep(0.075f, 0.025f, line)), sizeof texels[i]);
    }
}

/* Draws the two layers of the texture: the pattern of the cloth, and the skin. */
static GLuint open_surfaces(struct gl_status *status)
{
    uint8_t layers[2][HAND_SKIN_SIDE * HAND_SKIN_SIDE][3];
    draw_cloth(layers[0]);
    hand_skin(layers[1]);
    return gl_texture(status, "hand",
                      &(struct gl_texture_desc){ .internal_format = GL_RGB8,
                                                 .width = HAND_SKIN_SIDE,
                                                 .height = HAND_SKIN_SIDE,
                                                 .layers = 2,
                                                 .pixels = layers[0][0],
                                                 .mipmaps = true,
                                                 .wrap = GL_REPEAT });
}

void hand_pass_open(struct gl_status *status, struct hand_pass *pass)
{
    static const char *const names[HAND_LAYERS] = { "hand", "hand outline" };
    static const char *const defines[HAND_LAYERS] = { "#define INSIDE\n", "" };
    struct shape shape = { 0 };
    vec3 axes[HAND_VERTEX_MAX];
    for (uint32_t i = 0; i < HAND_LAYERS; i++) {
        struct hand_program *const program = &pass->programs[i];
        program->name = gl_program(status, names[i], defines[i], shader_hand_vert, shader_hand_frag,
                                   "surfaces");
        program->frames = glGetUniformLocation(program->name, "frames");
        program->paint = glGetUniformLocation(program->name, "paint");
        program->nearer = glGetUniformLocation(program->name, "nearer");
    }
    pass->surfaces = open_surfaces(status);
    hand_mesh(&shape, axes);
    shape_upload(&shape, &pass->mesh);
    glBindVertexArray(pass->mesh.vertex_array);
    pass->axes = gl_buffer(GL_ARRAY_BUFFER, axes, sizeof axes);
    gl_attribute_floats(3, 3, sizeof *axes, 0);
    glBindVertexArray(0);
}

void hand_pass_close(struct hand_pass *pass)
{
    for (uint32_t i = 0; i < HAND_LAYERS; i++) {
        glDeleteProgram(pass->programs[i].name);
    }
    glDeleteTextures(1, &pass->surfaces);
    glDeleteBuffers(1, &pass->axes);
    shape_close(&pass->mesh);
}

void hand_pass_prepare(struct hand_pass *pass, const struct scene *scene)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct hand_frames *const frames = &pass->frames[i];
        if (scene->poi[i].present) {
            hand_frames_of(frames, scene, &scene->poi[i]);
            frames->nearer = nearer_than_rim(scene, frames);
            frames->covers_paper = false;
            for (uint32_t k = 0; k < POI_MAX; k++) {
                frames->covers_paper |=
                    scene->poi[k].present && may_cover(scene, frames, &scene->poi[k]);
            }
        }
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        if (scene->fan[i].present) {
            fan_frames_of(&pass->fan_frames[i], scene, &scene->fan[i]);
        }
    }
}

static void draw_hand(const struct hand_pass *pass, enum hand_layer layer,
                      const struct hand_frames *frames, uint8_t owner)
{
    const struct hand_program *const program = &pass->programs[layer];
    const float *const paint = poi_paint(owner);
    glUseProgram(program->name);
    glUniformMatrix4fv(program->frames, HAND_FRAMES, GL_FALSE, frames->matrices[0]);
    glUniform4f(program->paint, paint[0], paint[1], paint[2], frames->stretch);
    glUniform1f(program->nearer, frames->nearer);
    glFrontFace(frames->left ? GL_CW : GL_CCW);
    if (layer == HAND_OUTLINE) {
        glEnable(GL_BLEND);
        glDepthFunc(GL_LESS); /* Pixels of the layer HAND_INSIDE are not drawn again. */
    }
    shape_draw(&pass->mesh);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
}

static void begin_hands(const struct hand_pass *pass)
{
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, pass->surfaces);
    glEnable(GL_CULL_FACE);
}

static void end_hands(void)
{
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
}

void hand_pass_draw(const struct hand_pass *pass, const struct scene *scene, enum hand_layer layer)
{
    begin_hands(pass);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct hand_frames *const frames = &pass->frames[i];
        if (scene->poi[i].present) {
            if (frames->covers_paper == (layer == HAND_OUTLINE)) {
                draw_hand(pass, HAND_INSIDE, frames, scene->poi[i].owner);
            }
            if (layer == HAND_OUTLINE) {
                draw_hand(pass, HAND_OUTLINE, frames, scene->poi[i].owner);
            }
        }
    }
    end_hands();
}

void hand_pass_fans(const struct hand_pass *pass, const struct scene *scene)
{
    begin_hands(pass);
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        if (scene->fan[i].present && !scene->fan[i].unseen) {
            for (uint32_t layer = 0; layer < HAND_LAYERS; layer++) {
                draw_hand(pass, layer, &pass->fan_frames[i], scene->fan[i].owner);
            }
        }
    }
    end_hands();
}
