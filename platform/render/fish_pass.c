/* fish_pass.c -- see fish_pass.h. */
#include "platform/render/fish_pass.h"

#include <stdio.h>
#include <string.h>

#include "assets.h"
#include "core/base/panic.h"
#include "shaders.h"

#define SORT_LEVELS 256u
#define DEFINES_SIZE 48
#define INSTANCE_ATTRIBUTES 7u

void fish_pass_open(struct gl_status *status, struct fish_pass *pass)
{
    const struct species *const species = &species_wakin;
    char defines[DEFINES_SIZE];
    snprintf(defines, sizeof defines, "#define KEYS %u\n", species->card.key_count);
    pass->body_program = gl_program(status, "fish body", defines, shader_fish_vert,
                                    shader_fish_frag, "caustics patterns");
    snprintf(defines, sizeof defines, "#define KEYS %u\n#define SUNK\n", species->card.key_count);
    pass->sunk_program = gl_program(status, "sunk fish body", defines, shader_fish_vert,
                                    shader_fish_frag, "caustics patterns");
    snprintf(defines, sizeof defines, "#define KEYS %u\n#define SNOUT\n", species->card.key_count);
    pass->snout_program = gl_program(status, "snouts", defines, shader_fish_vert,
                                     shader_fish_frag, "caustics patterns");
    snprintf(defines, sizeof defines, "#define KEYS %u\n#define FIN\n", species->card.key_count);
    pass->fin_program =
        gl_program(status, "fish fin", defines, shader_fish_vert, shader_fish_frag, "caustics");
    pass->ring_program = gl_program(status, "gulp rings", "", shader_gulp_ring_vert,
                                    shader_gulp_ring_frag, "");
    glGenVertexArrays(1, &pass->rings);
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        fish_mesh_open(status, &pass->mesh[i], &species->lod[i], species->card.key_count);
    }
    pass->instance_buffer = gl_buffer(GL_ARRAY_BUFFER, NULL, sizeof pass->instances);
}

void fish_pass_close(struct fish_pass *pass)
{
    glDeleteProgram(pass->body_program);
    glDeleteProgram(pass->sunk_program);
    glDeleteProgram(pass->snout_program);
    glDeleteProgram(pass->fin_program);
    glDeleteProgram(pass->ring_program);
    glDeleteVertexArrays(1, &pass->rings);
    glDeleteBuffers(1, &pass->instance_buffer);
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        fish_mesh_close(&pass->mesh[i]);
    }
}

/* Lowest first, by 256 levels of height; fish of one level keep the scene's order, so that the same
 * scene is the same picture. */
static void sort_by_height(struct fish_pass *pass, const struct scene *scene)
{
    uint16_t start[SORT_LEVELS + 1u] = { 0 };
    uint8_t level[SCENE_FISH_MAX];
    const float bottom = -scene->tank_size_m.y;
    const float scale = (float)(SORT_LEVELS - 1u) / (scene->tank_size_m.y * 1.5f);
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        const float y = (scene->fish[i].position_m.y - bottom) * scale;
        level[i] = (uint8_t)f_clamp(y, 0.0f, (float)(SORT_LEVELS - 1u));
        start[level[i] + 1u]++;
    }
    for (uint32_t i = 0; i < SORT_LEVELS; i++) {
        start[i + 1u] = (uint16_t)(start[i + 1u] + start[i]);
    }
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        pass->order[start[level[i]]++] = (uint16_t)i;
    }
}

/* Its snout, or a back that a wave has bared. */
static bool is_bare(const struct scene_fish *fish)
{
    const float nose_m = 0.5f * fish->length_m * f_sin(fish->angles.pitch_rad);
    return fish->position_m.y + f_max(nose_m, 0.15f * fish->length_m) > 0.0f;
}

static enum fish_group group_of(const struct scene_fish *fish, const struct frame_view *view,
                                float near_px)
{
    if (fish->place == SCENE_ON_POI) {
        return FISH_ON_POI;
    }
    if (fish->place == SCENE_IN_BOWL) {
        return FISH_IN_BOWL;
    }
    const float distance = v3_length(v3_sub(fish->position_m, view->eye_m));
    const bool near = fish->length_m * view->focal_px >= near_px * distance;
    return is_bare(fish) ? (near ? FISH_GULPING : FISH_GULPING_FAR)
                         : (near ? FISH_NEAR : FISH_FAR);
}

/* 8-bit weights whose sum is exactly 255: the largest takes what rounding left over, so that no
 * fish breathes in size. */
static void pack_weights(uint8_t out[8], const float weights[SCENE_KEY_MAX])
{
    int32_t left = 255;
    uint32_t largest = 0;
    for (uint32_t i = 0; i < SCENE_KEY_MAX; i++) {
        out[i] = (uint8_t)(f_clamp(weights[i], 0.0f, 1.0f) * 255.0f + 0.5f);
        left -= out[i];
        largest = weights[i] > weights[largest] ? i : largest;
    }
    out[largest] = (uint8_t)(out[largest] + left);
}

/* What breeders and fairs have: a third all red or with a pale belly, the rest in patches, few
 * white. Sixteen equal chances for the baked designs. */
static float pattern_layer(uint32_t look)
{
    static const uint8_t layers[16] = { 0, 0, 0, 1, 1, 1, 2, 3, 3, 4, 5, 6, 7, 9, 10, 8 };
    return (float)(layers[look & 15u] % ASSET_PATTERN_LAYERS);
}

static void fill_instance(struct fish_instance *out, const struct scene_fish *fish)
{
    const struct basis axes = basis_from_angles(fish->angles);
    const uint32_t look = fish->look;
    const struct fish_instance instance = {
        .place = { fish->position_m.x, fish->position_m.y, fish->position_m.z, fish->length_m },
        .right_phase = { axes.right.x, axes.right.y, axes.right.z, fish->tail_phase_rad },
        .up_amplitude = { axes.up.x, axes.up.y, axes.up.z, fish->tail_amplitude },
        .character = { fish->bend_rad, fish->maturity, pattern_layer(look >> 8u),
                       (float)((look >> 16u) & 1023u) / 1023.0f },
        .gulp = { fish->gape, fish->gulp },
    };
    *out = instance;
    pack_weights(out->weights, fish->weight);
}

void fish_pass_prepare(struct fish_pass *pass, const struct scene *scene,
                       const struct frame_view *view, const struct quality *quality)
{
    CORE_ASSERT(scene->fish_count <= SCENE_FISH_MAX);
    const float near_px = quality->lod_near_px / quality->scene_scale;
    uint32_t next[FISH_GROUP_COUNT];
    memset(pass->count, 0, sizeof pass->count);
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        pass->group[i] = (uint8_t)group_of(&scene->fish[i], view, near_px);
        pass->count[pass->group[i]]++;
    }
    for (uint32_t i = 0, first = 0; i < FISH_GROUP_COUNT; i++) {
        pass->first[i] = next[i] = first;
        first += pass->count[i];
    }
    sort_by_height(pass, scene);
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        const uint32_t fish = pass->order[i];
        fill_instance(&pass->instances[next[pass->group[fish]]++], &scene->fish[fish]);
    }
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    gl_buffer_refill(GL_ARRAY_BUFFER, pass->instances,
                     scene->fish_count * sizeof *pass->instances);
}

/* OpenGL ES 3.0 has no base instance: a group begins where the pointers say. */
static void point_instances(uint32_t first)
{
    const size_t stride = sizeof(struct fish_instance);
    const size_t base = first * stride;
    static const size_t offsets[INSTANCE_ATTRIBUTES] = {
        offsetof(struct fish_instance, place),        offsetof(struct fish_instance, right_phase),
        offsetof(struct fish_instance, up_amplitude), offsetof(struct fish_instance, weights),
        offsetof(struct fish_instance, weights) + 4,  offsetof(struct fish_instance, character),
        offsetof(struct fish_instance, gulp),
    };
    for (uint32_t i = 0; i < INSTANCE_ATTRIBUTES; i++) {
        const GLuint location = FISH_ATTRIBUTE_INSTANCE + i;
        const bool bytes = i == 3 || i == 4;
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, i == 6 ? 2 : 4, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT,
                              bytes ? GL_TRUE : GL_FALSE, (GLsizei)stride,
                              (const void *)(base + offsets[i]));
        glVertexAttribDivisor(location, 1);
    }
}

static void draw_group(const struct fish_pass *pass, enum fish_group group, bool fins)
{
    const bool far = group == FISH_FAR || group == FISH_GULPING_FAR;
    const struct fish_mesh *const mesh = &pass->mesh[far ? 1 : 0];
    if (pass->count[group] == 0) {
        return;
    }
    glBindVertexArray(mesh->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    point_instances(pass->first[group]);
    fish_mesh_draw(mesh, fins, (GLsizei)pass->count[group]);
}

static bool is_gulping(enum fish_group group)
{
    return group == FISH_GULPING_FAR || group == FISH_GULPING;
}

static void begin_bodies(GLuint program, const struct textures *textures, GLuint caustics)
{
    glUseProgram(program);
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    gl_bind_texture(1, GL_TEXTURE_2D_ARRAY, textures->patterns);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
}

static void end_bodies(void)
{
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
}

void fish_pass_bodies(const struct fish_pass *pass, enum fish_group group,
                      const struct textures *textures, GLuint caustics)
{
    begin_bodies(is_gulping(group) ? pass->sunk_program : pass->body_program, textures, caustics);
    draw_group(pass, group, false);
    end_bodies();
}

void fish_pass_snouts(const struct fish_pass *pass, const struct textures *textures,
                      GLuint caustics)
{
    begin_bodies(pass->snout_program, textures, caustics);
    draw_group(pass, FISH_GULPING_FAR, false);
    draw_group(pass, FISH_GULPING, false);
    end_bodies();
}

void fish_pass_fins(const struct fish_pass *pass, enum fish_group group, GLuint caustics)
{
    glUseProgram(pass->fin_program);
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    draw_group(pass, group, true);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void fish_pass_rings(const struct fish_pass *pass)
{
    const size_t stride = sizeof(struct fish_instance);
    const size_t base = pass->first[FISH_GULPING_FAR] * stride;
    const uint32_t count = pass->count[FISH_GULPING_FAR] + pass->count[FISH_GULPING];
    if (count == 0) {
        return;
    }
    glUseProgram(pass->ring_program);
    glBindVertexArray(pass->rings);
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    gl_attribute_floats(0, 4, stride, base + offsetof(struct fish_instance, place));
    gl_attribute_floats(1, 4, stride, base + offsetof(struct fish_instance, right_phase));
    gl_attribute_floats(2, 4, stride, base + offsetof(struct fish_instance, up_amplitude));
    gl_attribute_floats(3, 2, stride, base + offsetof(struct fish_instance, gulp));
    for (GLuint i = 0; i < 4; i++) {
        glVertexAttribDivisor(i, 1);
    }
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)count);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

GLsizei fish_pass_shadow_casters(const struct fish_pass *pass)
{
    const size_t stride = sizeof(struct fish_instance);
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    gl_attribute_floats(0, 4, stride, offsetof(struct fish_instance, place));
    gl_attribute_floats(1, 4, stride, offsetof(struct fish_instance, right_phase));
    gl_attribute_floats(2, 4, stride, offsetof(struct fish_instance, up_amplitude));
    for (GLuint i = 0; i < 3; i++) {
        glVertexAttribDivisor(i, 1);
    }
    return (GLsizei)(pass->first[FISH_ON_POI] + pass->count[FISH_ON_POI]);
}
