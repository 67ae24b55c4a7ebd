/* quad_pass.c -- draws the bubbles, the drops, the hand-held fans and the black edge of the
 * picture. */
#include "platform/render/pass/quad_pass.h"

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "platform/render/pass/poi_pass.h"
#include "shaders.h"

/* Maximum number of bubbles. At any time about a third of the bubbles have risen and float on the
 * surface. */
#define BUBBLE_COUNT 72
/* Number of straight parts of the hose from the air stone over the rim to the counter, a multiple
 * of 3 (bubble.vert.glsl). */
#define HOSE_PARTS 30
/* Maximum number of drops per poi. DROPS_LOOSE drops detach one at a time, and DROPS_STREAM drops
 * form streams of water. From a poi 4 cm above the water, half of the drops of the streams fall at
 * any time, and the others wait. DROPS_LOOSE must equal LOOSE in drip.vert.glsl. */
#define DROPS_LOOSE 5
#define DROPS_STREAM 72
/* Minimum mean depth in metres of the water on the paper from which drops fall. A thinner layer of
 * water adheres to the paper. */
#define DRIPS_FROM_M 0.0002f
/* Mean depth in metres of the water on the paper from which the maximum of DROPS_LOOSE drops
 * falls. */
#define DRIPS_FULL_M 0.0015f
/* Mean depths of the water on the paper at which the streams begin, and from which the streams have
 * the maximum of DROPS_STREAM drops. A poi that leaves the tank carries 0.6 to 1.7 mm of water. */
#define STREAMS_FROM_M 0.0004f
#define STREAMS_FULL_M 0.0010f
/* Heights of a level ring above the water surface at which its streams begin to become weaker, and
 * at which its streams have ended because the water on the rim has run off. */
#define STREAMS_TO_M 0.030f
#define STREAMS_END_M 0.058f
/* Half the angle of the arc, around the lowest point of a steep ring, from which streams fall. From
 * a level ring, streams fall all around. */
#define STREAMS_STEEP_RAD 0.6f
/* Drops fall from the low side of the poi only if this side is at least this height in metres above
 * the water surface. */
#define CLEAR_M 0.008f
/* Distance of the drops from the paper's centre, in paper radii. Drops fall from the outer edge of
 * the ring around the paper. */
#define RING_REACH 1.17f
/* Tilt of the hand-held fan. The far edge is lower, so that the player sees the picture on the
 * fan. */
#define FAN_PITCH_RAD (-7.0f * F_DEG)
/* Angle between the handle of the fan and the direction to the player. */
#define FAN_YAW_RAD 0.18f
/* Amplitude of the hand-held fan's sway in rad. The sway imitates a human hand, which is never
 * quite still. */
#define SWAY_RAD (1.6f * F_DEG)
#define SWAY_HZ 0.23f
/* Size in texels of each picture of a fan, about one texel for each pixel of a fan on a screen of
 * 1080 lines. */
#define FAN_FACE_WIDTH 320u
#define FAN_FACE_HEIGHT 488u

/* Time in seconds in which a ring on the water fades, and its radius in m when it begins and after
 * one second of growth at the initial rate. */
#define SPRAY_RING_S 0.5f
#define SPRAY_RING_M 0.003f
#define SPRAY_RING_M_S 0.05f
/* Longest time in seconds from a splash until its last drop leaves the water. */
#define SPRAY_LATE_S 0.05f
#define SPRAY_GRAVITY_M_S2 9.81f
/* A splash whose circle has at least this radius in m comes from a poi. */
#define SPRAY_POI_M 0.018f
/* Number of drops that a poi, or a fish that falls into a bowl, throws in addition to the drops of
 * the splash. */
#define SPRAY_CROWN 26u
/* Speed in m/s of the wave that a poi, or a fish that falls into a bowl, makes, time in seconds in
 * which the wave fades, and opacity of the wave. */
#define SPRAY_WAVE_M_S 0.16f
#define SPRAY_WAVE_S 0.9f
#define SPRAY_WAVE 0.5f
/* Distance in m from a wall at which a wave begins to fade. */
#define SPRAY_WALL_M 0.03f
/* Distance of the crest of a wave from its middle, as a share of the quad (spray.frag.glsl). */
#define SPRAY_CREST 0.72f
/* Height in m above the water, up to which a poi hides the rings of drops. */
#define SPRAY_HIDES_M 0.05f
#define SPRAY_EYE_MIN_M 0.1f /* Lowest height of the camera above the water. */
/* Distance in m from a splash in a bowl within which drops make rings. */
#define SPRAY_BOWL_M 0.05f

/* Scraps of paper: speed in m/s in air and in water, height in m of a scrap above the floor and
 * below the surface, time in seconds in which the push of the poi fades, and size of the sway. */
#define SCRAP_FALLS_M_S 0.8f
#define SCRAP_SINKS_M_S 0.012f
#define SCRAP_TOP_M 0.003f
#define SCRAP_PUSH_S 0.7f
#define SCRAP_SWAY_M 0.006f
#define SCRAP_REST_M 0.02f /* Height above the floor below which a scrap sways less. */

/* Draws the pictures of a fan (fan_face.frag.glsl), which do not change afterwards. */
static void draw_fan_faces(struct gl_status *status, struct quad_pass *pass,
                           const struct textures *textures)
{
    const GLuint program =
        gl_program(status, "fan face", "", shader_fill_vert, shader_fan_face_frag, "fibres");
    gl_target_open(status, "fan", &pass->fan_faces,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = 2u * FAN_FACE_WIDTH,
                                             .height = FAN_FACE_HEIGHT });
    gl_target_bind(&pass->fan_faces);
    glUseProgram(program);
    gl_bind_texture(0, GL_TEXTURE_2D, textures->paper);
    glBindVertexArray(pass->no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteProgram(program);
}

void quad_pass_open(struct gl_status *status, struct quad_pass *pass,
                    const struct textures *textures)
{
    pass->bubble_program = gl_program(status, "air stone", GL_DEFINE("HOSE_PARTS", HOSE_PARTS),
                                      shader_bubble_vert, shader_bubble_frag, "");
    pass->stone = glGetUniformLocation(pass->bubble_program, "stone");
    pass->drip_program = gl_program(status, "drops", "", shader_drip_vert, shader_drip_frag, "");
    pass->lip = glGetUniformLocation(pass->drip_program, "lip");
    pass->hub = glGetUniformLocation(pass->drip_program, "hub");
    pass->low = glGetUniformLocation(pass->drip_program, "low");
    pass->across = glGetUniformLocation(pass->drip_program, "across");
    pass->spray_program = gl_program(status, "spray", "", shader_spray_vert, shader_spray_frag, "");
    pass->scrap_program =
        gl_program(status, "scraps", "#define SCRAP\n", shader_spray_vert, shader_spray_frag, "");
    pass->fan_program = gl_program(status, "fan", "", shader_fan_vert, shader_fan_frag, "faces");
    pass->fan_pose = glGetUniformLocation(pass->fan_program, "pose");
    pass->fan_trim = glGetUniformLocation(pass->fan_program, "trim");
    pass->dark_program = gl_program(status, "dark", "", shader_fill_vert, shader_dark_frag, "");
    pass->dark = glGetUniformLocation(pass->dark_program, "dark");
    pass->copy_program =
        gl_program(status, "copy", "", shader_fill_vert, shader_copy_frag, "picture");
    glGenVertexArrays(1, &pass->no_attributes);
    glGenVertexArrays(1, &pass->spray_array);
    glBindVertexArray(pass->spray_array);
    pass->spray_buffer =
        gl_buffer(GL_ARRAY_BUFFER, NULL, QUAD_SPRAY_MAX * sizeof(struct quad_drop));
    gl_attribute_floats(0, 4, sizeof(struct quad_drop), offsetof(struct quad_drop, place));
    gl_attribute_floats(1, 2, sizeof(struct quad_drop), offsetof(struct quad_drop, stretch));
    glVertexAttribDivisor(0, 1);
    glVertexAttribDivisor(1, 1);
    glBindVertexArray(0);
    draw_fan_faces(status, pass, textures);
}

void quad_pass_close(struct quad_pass *pass)
{
    glDeleteProgram(pass->bubble_program);
    glDeleteProgram(pass->drip_program);
    glDeleteProgram(pass->spray_program);
    glDeleteProgram(pass->scrap_program);
    glDeleteProgram(pass->fan_program);
    glDeleteProgram(pass->dark_program);
    glDeleteProgram(pass->copy_program);
    gl_target_close(&pass->fan_faces);
    glDeleteVertexArrays(1, &pass->no_attributes);
    glDeleteVertexArrays(1, &pass->spray_array);
    glDeleteBuffers(1, &pass->spray_buffer);
}

/* Draws `count` quads with blending. The quads do not write depth. */
static void draw_translucent(GLuint vertex_array, GLsizei count)
{
    glBindVertexArray(vertex_array);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void quad_pass_air(const struct quad_pass *pass, const struct scene *scene, bool is_above)
{
    const struct scene_pump *const pump = &scene->pump;
    if (pump->present) {
        glUseProgram(pass->bubble_program);
        glUniform3f(pass->stone, pump->stone_m.x, pump->stone_m.y, pump->stone_m.z);
        /* The first quad is the air stone (the outlet of the air pump), which the depth of the
         * water hides if `is_above` is true. */
        draw_translucent(pass->no_attributes,
                         1 + HOSE_PARTS + (pump->runs && !is_above ? BUBBLE_COUNT : 0));
    }
}

void quad_pass_drips(const struct quad_pass *pass, const struct scene *scene)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        const struct basis axes = vec_basis_from_angles(poi->angles);
        const vec3 up = axes.up;
        /* `down` is the direction of steepest descent in the plane of the poi's ring. `at` is the
         * lowest point of the ring. For a level ring, `at` is the centre of the sagging paper. */
        const vec3 down = v3(up.x * up.y, up.y * up.y - 1.0f, up.z * up.y);
        const float steep = f_smoothstep(0.03f, 0.20f, v3_length(down));
        const float rim_m = RING_REACH * poi->ring_radius_m;
        const vec3 low = v3_scale(v3_normalize_or(down, axes.back), rim_m);
        const vec3 at = v3_muladd(poi->position_m, low, steep);
        if (poi->present && poi->water_m >= DRIPS_FROM_M && at.y >= CLEAR_M) {
            const float wet = (poi->water_m - DRIPS_FROM_M) / (DRIPS_FULL_M - DRIPS_FROM_M);
            const float drops = (float)DROPS_LOOSE * f_clamp(0.2f + 0.8f * wet, 0.0f, 1.0f);
            const float fresh = 1.0f - f_smoothstep(STREAMS_TO_M, STREAMS_END_M, at.y);
            const float runs =
                f_max(steep, fresh) * f_smoothstep(STREAMS_FROM_M, STREAMS_FULL_M, poi->water_m);
            const vec3 across = v3_cross(up, low);
            glUseProgram(pass->drip_program);
            glUniform4f(pass->lip, at.x, at.y, at.z, drops);
            glUniform4f(pass->hub, poi->position_m.x, poi->position_m.y, poi->position_m.z,
                        f_lerp(F_PI, STREAMS_STEEP_RAD, steep));
            glUniform4f(pass->low, low.x, low.y, low.z, runs * (float)DROPS_STREAM);
            glUniform4f(pass->across, across.x, across.y, across.z, 0.0f);
            draw_translucent(pass->no_attributes, DROPS_LOOSE + DROPS_STREAM);
        }
    }
}

/* Returns a random number in [0, 1) and advances `state`. */
static float next_chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) * (1.0f / 16777216.0f);
}

/* Returns true if the viewer sees a poi in the water, or close above it, at a point of the surface.
 * A ring of a drop there would make the paper look like water. */
static bool has_poi(const struct scene *scene, vec3 at)
{
    const vec3 sight =
        v3_scale(v3_sub(at, scene->view.eye_m), 1.0f / f_max(scene->view.eye_m.y, SPRAY_EYE_MIN_M));
    bool has = false;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        const vec3 seen = v3_muladd(at, sight, -poi->position_m.y);
        has |= poi->present && poi->position_m.y < SPRAY_HIDES_M &&
               v3_length(v3_flat(v3_sub(seen, poi->position_m))) <
                   RING_REACH * poi->ring_radius_m + SPRAY_RING_M;
    }
    return has;
}

/* Returns true if a poi in the tank, or a fish that falls into a bowl, caused the splash. Such a
 * splash has a wave and more drops. */
static bool is_strong(const struct scene_splash *splash)
{
    return splash->in_bowl || splash->radius_m >= SPRAY_POI_M;
}

/* Returns the height in m at which the rings and waves of a splash are drawn. bowl_pass_cap() hides
 * what is lower than 1 mm in a bowl, whose water is about that low. */
static float ring_height_m(const struct scene_splash *splash)
{
    return splash->in_bowl ? 0.0016f : 0.0006f;
}

/* Computes the wave that a poi makes where it enters or leaves the water, or a fish that falls into
 * a bowl. Returns false if the splash has no wave, or if the wave has faded or has reached a
 * wall. */
static bool spread(const struct scene *scene, const struct scene_splash *splash,
                   struct quad_drop *out)
{
    const vec3 at = splash->position_m;
    const float radius_m = splash->radius_m + SPRAY_WAVE_M_S * splash->age_s;
    const float middle_m = splash->in_bowl ? SPRAY_BOWL_M
                                           : f_min(0.5f * scene->tank_size_m.x - f_abs(at.x),
                                                   0.5f * scene->tank_size_m.z - f_abs(at.z));
    const float wall_m = middle_m - radius_m / SPRAY_CREST;
    const float left = f_min(1.0f - splash->age_s / SPRAY_WAVE_S, wall_m / SPRAY_WALL_M);
    *out = (struct quad_drop){ { at.x, ring_height_m(splash), at.z, radius_m / SPRAY_CREST },
                               0.0f,
                               SPRAY_WAVE * f_clamp(left, 0.0f, 1.0f) };
    return is_strong(splash) && left > 0.0f;
}

/* Computes drop `index` of a splash. Returns false if the drop has not left the water or if its
 * ring has faded. */
static bool fly(const struct scene *scene, const struct scene_splash *splash, uint32_t index,
                struct quad_drop *out)
{
    uint32_t state = splash->seed ^ ((index + 1u) * 0x9e3779b1u);
    const float turn = next_chance(&state) * F_TAU;
    const vec3 side = v3(f_cos(turn), 0.0f, f_sin(turn));
    const float speed = f_min(v3_length(splash->push_m_s), 1.2f);
    const float up_m_s = (0.55f + 0.70f * speed) * (0.40f + 0.80f * next_chance(&state));
    const vec3 way_m_s = v3_muladd(v3_scale(v3_flat(splash->push_m_s), 0.25f), side,
                                   (0.10f + 0.35f * speed) * (0.3f + next_chance(&state)));
    const float chance = next_chance(&state) * next_chance(&state);
    const float size_m = 0.0007f + 0.0036f * chance; /* Most drops are small. */
    const float time_s = splash->age_s - SPRAY_LATE_S * next_chance(&state);
    const float lands_s = 2.0f * up_m_s / SPRAY_GRAVITY_M_S2;
    const float flight_s = f_min(time_s, lands_s);
    const float ring_s = f_max(time_s - lands_s, 0.0f);
    vec3 at = v3_muladd(v3_muladd(splash->position_m, side, splash->radius_m), way_m_s, flight_s);
    if (time_s < 0.0f || ring_s > SPRAY_RING_S) {
        return false;
    }
    if (time_s < lands_s) {
        const float rise_m_s = up_m_s - SPRAY_GRAVITY_M_S2 * time_s;
        at.y += 0.5f * (up_m_s + rise_m_s) * time_s;
        *out = (struct quad_drop){ { at.x, at.y, at.z, size_m }, 1.0f + f_abs(rise_m_s), 1.0f };
        return true;
    }
    const vec3 away = v3_sub(at, splash->position_m);
    *out = (struct quad_drop){ { at.x, ring_height_m(splash), at.z,
                                 SPRAY_RING_M + SPRAY_RING_M_S * ring_s },
                               0.0f,
                               1.0f - ring_s / SPRAY_RING_S };
    return splash->in_bowl ? v3_length(away) < SPRAY_BOWL_M
                           : f_abs(at.x) < 0.5f * scene->tank_size_m.x &&
                                 f_abs(at.z) < 0.5f * scene->tank_size_m.z && !has_poi(scene, at);
}

uint32_t quad_spray_of(const struct scene *scene, struct quad_drop out[QUAD_SPRAY_MAX])
{
    uint32_t count = 0, pool = 0;
    CORE_ASSERT(scene->splash_count <= SCENE_SPLASH_MAX);
    for (uint32_t i = 0; i < scene->splash_count; i++) {
        const struct scene_splash *const splash = &scene->splash[i];
        const uint32_t drops = splash->drops + (is_strong(splash) ? SPRAY_CROWN : 0u);
        if (pool < QUAD_SPRAY_MAX) {
            count += spread(scene, splash, &out[count]);
            pool++;
        }
        for (uint32_t k = 0; k < drops && pool < QUAD_SPRAY_MAX; k++, pool++) {
            count += fly(scene, splash, k, &out[count]);
        }
    }
    return count;
}

/* Computes the place of a scrap of paper. Returns false if the scrap is not in the water. */
static bool sink(const struct scene *scene, const struct scene_scrap *scrap, struct quad_drop *out)
{
    uint32_t state = scrap->seed;
    const float phase = F_TAU * next_chance(&state), size_m = 0.003f + 0.003f * next_chance(&state);
    const float sinks_m_s = SCRAP_SINKS_M_S * (0.6f + 0.8f * next_chance(&state));
    const float wet_s = scrap->age_s - f_max(scrap->position_m.y, 0.0f) / SCRAP_FALLS_M_S;
    const float top_m = f_min(scrap->position_m.y, 0.0f) - SCRAP_TOP_M;
    const float floor_m = SCRAP_TOP_M - scene->tank_size_m.y;
    /* The push of the poi fades, and the scrap sways like a falling leaf. */
    const float pushed_s = SCRAP_PUSH_S * (1.0f - f_exp(-f_max(wet_s, 0.0f) / SCRAP_PUSH_S));
    const vec3 drift = v3_scale(v3_flat(scrap->push_m_s), 0.5f * pushed_s);
    const float sway = f_sin(1.9f * wet_s + phase), lean = f_cos(1.3f * wet_s + 2.0f * phase);
    const float y_m = f_max(top_m - sinks_m_s * wet_s, floor_m);
    const float moves = SCRAP_SWAY_M * f_min((y_m - floor_m) / SCRAP_REST_M, 1.0f);
    const float x_m = scrap->position_m.x + drift.x + moves * sway;
    const float z_m = scrap->position_m.z + drift.z + moves * lean;
    const float fades = f_clamp(0.4f * (SCENE_SCRAP_S - scrap->age_s), 0.0f, 1.0f);
    *out = (struct quad_drop){ { x_m, y_m, z_m, size_m }, phase + 0.4f * sway, fades };
    return wet_s > 0.0f && f_abs(x_m) < 0.5f * scene->tank_size_m.x &&
           f_abs(z_m) < 0.5f * scene->tank_size_m.z;
}

uint32_t quad_scraps_of(const struct scene *scene, struct quad_drop out[SCENE_SCRAP_MAX])
{
    uint32_t count = 0;
    CORE_ASSERT(scene->scrap_count <= SCENE_SCRAP_MAX);
    for (uint32_t i = 0; i < scene->scrap_count; i++) {
        count += sink(scene, &scene->scrap[i], &out[count]);
    }
    return count;
}

static void draw_spray(const struct quad_pass *pass, GLuint program, const struct quad_drop *drops,
                       uint32_t count)
{
    if (count > 0) {
        glBindBuffer(GL_ARRAY_BUFFER, pass->spray_buffer);
        gl_buffer_refill(GL_ARRAY_BUFFER, drops, count * sizeof *drops);
        glUseProgram(program);
        draw_translucent(pass->spray_array, (GLsizei)count);
    }
}

void quad_pass_scraps(const struct quad_pass *pass, const struct scene *scene)
{
    struct quad_drop scraps[SCENE_SCRAP_MAX];
    draw_spray(pass, pass->scrap_program, scraps, quad_scraps_of(scene, scraps));
}

void quad_pass_spray(const struct quad_pass *pass, const struct scene *scene)
{
    struct quad_drop drops[QUAD_SPRAY_MAX];
    draw_spray(pass, pass->spray_program, drops, quad_spray_of(scene, drops));
}

struct angles quad_fan_angles(const struct scene *scene, const struct scene_fan *fan)
{
    const uint32_t period = (uint32_t)((float)CORE_TICK_HZ / SWAY_HZ);
    const float sway = (float)(scene->tick % period) / (float)period * F_TAU + (float)fan->owner;
    /* The handle points to the player's free hand. The player may stand at the short side of the
     * tank. */
    const float toward_rad = scene->poi[fan->owner].left_hand ? FAN_YAW_RAD : 0.0f - FAN_YAW_RAD;
    return (struct angles){ .yaw_rad = toward_rad + SWAY_RAD * f_sin(sway) +
                                       (view_is_turned(&scene->view) ? VIEW_TURN_RAD : 0.0f),
                            .pitch_rad = FAN_PITCH_RAD,
                            .roll_rad = SWAY_RAD * f_cos(sway) };
}

void quad_pass_fans(const struct quad_pass *pass, const struct scene *scene)
{
    glUseProgram(pass->fan_program);
    gl_bind_texture(0, GL_TEXTURE_2D, pass->fan_faces.texture);
    glBindVertexArray(pass->no_attributes);
    glEnable(GL_BLEND);
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        const struct scene_fan *const fan = &scene->fan[i];
        float pose[16];
        if (fan->present && !fan->unseen) {
            const float *const paint = poi_paint(fan->owner);
            poi_pose(pose, v3(fan->x_m, QUAD_FAN_HEIGHT_M, fan->z_m), quad_fan_angles(scene, fan),
                     fan->radius_m);
            glUniformMatrix4fv(pass->fan_pose, 1, GL_FALSE, pose);
            glUniform3f(pass->fan_trim, paint[0], paint[1], paint[2]);
            glDrawArrays(GL_TRIANGLE_STRIP, 0, DISC_AND_HANDLE_VERTICES);
        }
    }
    glDisable(GL_BLEND);
}

void quad_pass_copy(const struct quad_pass *pass, GLuint picture)
{
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(pass->copy_program);
    gl_bind_texture(0, GL_TEXTURE_2D, picture);
    glBindVertexArray(pass->no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void quad_pass_edge(const struct quad_pass *pass, const struct display_transform *transform)
{
    const struct display_rect part = display_picture_rect(transform);
    const GLint width = (GLint)transform->screen_width, height = (GLint)transform->screen_height;
    const GLint top = height - (GLint)part.top, right = (GLint)part.right;
    /* The four strips beside the picture: left, bottom, width and height of each strip, in OpenGL's
     * window coordinates with the origin at the lower left. */
    const GLint strips[4][4] = { { 0, top, width, height - top },
                                 { 0, 0, width, height - (GLint)part.bottom },
                                 { 0, 0, (GLint)part.left, height },
                                 { right, 0, width - right, height } };
    CORE_ASSERT(width > 0 && height > 0);
    if (transform->light < 1.0f) {
        glViewport(0, 0, width, height);
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glUseProgram(pass->dark_program);
        glUniform1f(pass->dark, 1.0f - transform->light);
        glBindVertexArray(pass->no_attributes);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
    }
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    for (uint32_t i = 0; i < 4; i++) {
        if (strips[i][2] > 0 && strips[i][3] > 0) {
            glScissor(strips[i][0], strips[i][1], strips[i][2], strips[i][3]);
            glClear(GL_COLOR_BUFFER_BIT);
        }
    }
    glDisable(GL_SCISSOR_TEST);
}
