/* fish_pass.c -- sorts the fish into groups and draws each group with instanced draw calls. */
#include "platform/render/pass/fish_pass.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "shaders.h"

#define SORT_LEVELS 256u
#define SAMPLERS "caustics patterns shapes"

static GLuint link_fish_program(struct gl_status *status, const char *name, const char *defines)
{
    return gl_program(status, name, defines, shader_fish_vert, shader_fish_frag, SAMPLERS);
}

void fish_pass_open(struct gl_status *status, struct fish_pass *pass,
                    struct fish_mesh_memory *memory)
{
    const struct species *const species = &species_wakin;
    pass->body = link_fish_program(status, "fish body", "");
    pass->near = link_fish_program(status, "near fish body", "#define GLOSS\n");
    pass->sunk = link_fish_program(status, "sunk fish body", "#define SUNK\n");
    pass->snout = link_fish_program(status, "snouts", "#define SNOUT\n#define GLOSS\n");
    pass->fin = link_fish_program(status, "fish fin", "#define FIN\n");
    pass->bowl_shadow_program = gl_program(status, "bowl fish shadow", "#define IN_BOWL\n",
                                           shader_shadow_fish_vert, shader_shadow_fish_frag, "");
    pass->ring_program =
        gl_program(status, "gulp rings", "", shader_gulp_ring_vert, shader_gulp_ring_frag, "");
    glGenVertexArrays(1, &pass->rings);
    morph_rig_init(&pass->rig, &species->card, TEMPLATE_OWN);
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        fish_mesh_reserve(&pass->mesh[i]);
        fish_mesh_fill_tank(&pass->mesh[i], memory, &species->lod[i], species->card.key_count);
        fish_shapes_open(status, &pass->shapes[i], &species->lod[i]);
    }
    pass->instance_buffer = gl_buffer(GL_ARRAY_BUFFER, NULL, sizeof pass->instances);
}

void fish_pass_close(struct fish_pass *pass)
{
    glDeleteProgram(pass->body);
    glDeleteProgram(pass->near);
    glDeleteProgram(pass->sunk);
    glDeleteProgram(pass->snout);
    glDeleteProgram(pass->fin);
    glDeleteProgram(pass->bowl_shadow_program);
    glDeleteProgram(pass->ring_program);
    glDeleteVertexArrays(1, &pass->rings);
    glDeleteBuffers(1, &pass->instance_buffer);
    for (uint32_t i = 0; i < SPECIES_LOD_COUNT; i++) {
        fish_mesh_close(&pass->mesh[i]);
        fish_shapes_close(&pass->shapes[i]);
    }
}

/* Sorts the fish by height into 256 levels, lowest level first. Fish of one level keep their order
 * in the scene, so that equal scenes produce equal pictures. */
static void sort_by_height(struct fish_pass *pass, const struct scene *scene)
{
    CORE_ASSERT(scene->fish_count <= SCENE_FISH_MAX && scene->tank_size_m.y > 0.0f);
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

/* Returns true if the fish is at least `length_px` pixels long, as seen from the side. */
static bool is_longer(const struct scene_fish *fish, const struct frame_view *view, float length_px)
{
    const float distance = v3_length(v3_sub(fish->position_m, view->eye_m));
    return fish->length_m * view->focal_px >= length_px * distance;
}

static enum fish_group group_of(const struct scene_fish *fish, const struct frame_view *view,
                                float near_px, float small_px)
{
    CORE_ASSERT(near_px >= small_px && small_px >= 0.0f);
    if (fish->place == SCENE_ON_POI) {
        return FISH_ON_POI;
    }
    if (fish->place == SCENE_IN_BOWL) {
        return FISH_IN_BOWL;
    }
    const bool near = is_longer(fish, view, near_px);
    /* The fish counts as gulping if its snout or its back is above the water surface. */
    const float nose_m = 0.5f * fish->length_m * f_sin(fish->angles.pitch_rad);
    return (fish->position_m.y + f_max(nose_m, 0.15f * fish->length_m) > 0.0f)
               ? (near ? FISH_GULPING : FISH_GULPING_FAR)
           : near                            ? FISH_NEAR
           : is_longer(fish, view, small_px) ? FISH_FAR
                                             : FISH_SMALL;
}

/* Chooses the mesh of each group. The fish in bowls get the near mesh if at least one of these fish
 * is large enough on the screen for it. */
static void choose_meshes(struct fish_pass *pass, const struct scene *scene,
                          const struct frame_view *view, float near_px)
{
    memset(pass->lod, 0, sizeof pass->lod);
    pass->lod[FISH_SMALL] = pass->lod[FISH_FAR] = pass->lod[FISH_GULPING_FAR] =
        pass->lod[FISH_IN_BOWL] = 1;
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        if (pass->group[i] == FISH_IN_BOWL && is_longer(&scene->fish[i], view, near_px)) {
            pass->lod[FISH_IN_BOWL] = 0;
        }
    }
}

/* Angular frequency of the gill covers. A goldfish at rest breathes about 85 times per minute. */
#define BREATH_RAD_S 9.0f

/* Returns the opening of the gill covers at the time `time_s`, [0, 1]. They open with the mouth, or
 * with the calm breath of a fish that does not gulp. */
static float gill_opening(const struct scene_fish *fish, float time_s)
{
    const float phase = (float)(fish->look & 255u) * (F_TAU / 256.0f);
    const float breath = 0.5f + 0.5f * f_sin(f_wrap_angle(time_s * BREATH_RAD_S) + phase);
    return f_max(fish->gape, breath);
}

static void fill_instance(struct fish_instance *out, const struct scene_fish *fish,
                          const struct frame_block *block, uint32_t row)
{
    const vec3 at = fish->position_m;
    const struct basis axes = vec_basis_from_angles(fish->angles);
    const float layer = textures_pattern(fish->look);
    *out = (struct fish_instance){
        .place = { at.x, at.y, at.z, fish->length_m },
        .right_phase = { axes.right.x, axes.right.y, axes.right.z, fish->tail_phase_rad },
        .up_amplitude = { axes.up.x, axes.up.y, axes.up.z, fish->tail_amplitude },
        .bend_rad = fish->bend_rad,
        .layer = layer,
        .gulp = { fish->gape, fish->place == SCENE_IN_BOWL ? -1.0f : fish->gulp, (float)row,
                  gill_opening(fish, block->eye[3]) },
    };
    fish_colours_compute(&out->colours, fish->maturity, textures_hue(fish->look), layer);
    float light[3];
    frame_lamp_light(block, at.x, at.z, light);
    fish_colours_illuminate(&out->colours, light);
}

void fish_pass_prepare(struct fish_pass *pass, const struct scene *scene, const struct frame *frame,
                       const struct quality *quality)
{
    const struct frame_view *const view = &frame->view;
    CORE_ASSERT(scene->fish_count <= SCENE_FISH_MAX);
    const float near_px = quality->lod_near_px / quality->scene_scale;
    const float small_px = quality->lod_small_px / quality->scene_scale;
    uint32_t next[FISH_GROUP_COUNT];
    memset(pass->count, 0, sizeof pass->count);
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        pass->group[i] = (uint8_t)group_of(&scene->fish[i], view, near_px, small_px);
        pass->count[pass->group[i]]++;
    }
    choose_meshes(pass, scene, view, near_px);
    for (uint32_t i = 0, first = 0; i < FISH_GROUP_COUNT; i++) {
        pass->first[i] = next[i] = first;
        first += pass->count[i];
    }
    sort_by_height(pass, scene);
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        const uint32_t row = pass->order[i];
        fill_instance(&pass->instances[next[pass->group[row]]++], &scene->fish[row], &frame->block,
                      row);
    }
    /* The texture row of each fish is its index in the scene. A row is written again only if
     * another fish or a fish that has grown needs the row. */
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        fish_shapes_begin(&pass->shapes[lod]);
        for (uint32_t i = 0; i < scene->fish_count; i++) {
            if (pass->lod[pass->group[i]] == lod) {
                const struct scene_fish *const fish = &scene->fish[i];
                fish_shapes_set(&pass->shapes[lod], &pass->rig,
                                &textures_variety(fish->look)->lod[lod], i, fish->progress);
            }
        }
        fish_shapes_end(&pass->shapes[lod]);
    }
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    gl_buffer_refill(GL_ARRAY_BUFFER, pass->instances, scene->fish_count * sizeof *pass->instances);
}

/* A vertex attribute with a value for each fish, at a location of the shader. */
struct instance_attribute {
    GLuint location;
    GLint count;
    size_t offset;
};

#define INSTANCE(location, count, field) { location, count, offsetof(struct fish_instance, field) }

/* Sets the pointers of `count` vertex attributes, so that the next instanced draw call begins with
 * the fish `first` of the instance buffer. OpenGL ES 3.0 has no draw call with a base instance. */
static void point_instances(const struct fish_pass *pass, uint32_t first,
                            const struct instance_attribute *attributes, uint32_t count)
{
    CORE_ASSERT(first <= SCENE_FISH_MAX && count > 0);
    const size_t stride = sizeof(struct fish_instance);
    glBindBuffer(GL_ARRAY_BUFFER, pass->instance_buffer);
    for (uint32_t i = 0; i < count; i++) {
        gl_attribute_floats(attributes[i].location, attributes[i].count, stride,
                            first * stride + attributes[i].offset);
        glVertexAttribDivisor(attributes[i].location, 1);
    }
}

/* Draws one group of fish with the current program of OpenGL. */
static void draw_group(const struct fish_pass *pass, enum fish_group group, bool fins)
{
    static const struct instance_attribute common[] = {
        INSTANCE(9, 4, place),     INSTANCE(10, 4, right_phase), INSTANCE(11, 4, up_amplitude),
        INSTANCE(14, 4, bend_rad), INSTANCE(15, 4, gulp),
    };
    static const struct instance_attribute body[] = {
        INSTANCE(0, 3, colours.pale_back),
        INSTANCE(1, 3, colours.stain_back),
        INSTANCE(2, 3, colours.pale_belly),
        INSTANCE(3, 3, colours.stain_belly),
    };
    static const struct instance_attribute fin[] = {
        INSTANCE(0, 4, colours.pale_fin),
        INSTANCE(1, 3, colours.stain_fin),
    };
    CORE_ASSERT(group < FISH_GROUP_COUNT);
    CORE_ASSERT(pass->first[group] + pass->count[group] <= SCENE_FISH_MAX);
    const uint32_t lod = pass->lod[group];
    const struct fish_mesh *const mesh = &pass->mesh[lod];
    if (pass->count[group] == 0) {
        return;
    }
    gl_bind_texture(2, GL_TEXTURE_2D, pass->shapes[lod].texture);
    glBindVertexArray(mesh->vertex_array);
    point_instances(pass, pass->first[group], common, sizeof common / sizeof *common);
    point_instances(pass, pass->first[group], fins ? fin : body, fins ? 2u : 4u);
    const enum fish_triangles triangles = group == FISH_SMALL
                                              ? (fins ? FISH_SMALL_FINS : FISH_SMALL_BODY)
                                              : (fins ? FISH_FINS : FISH_BODY);
    fish_mesh_draw(mesh, triangles, (GLsizei)pass->count[group]);
}

void fish_pass_bodies(const struct fish_pass *pass, enum fish_group group, bool snouts,
                      const struct textures *textures, GLuint caustics)
{
    const bool gulps = group == FISH_GULPING_FAR || group == FISH_GULPING;
    CORE_ASSERT(gulps || !snouts);
    const GLuint plain = pass->lod[group] == 0 ? pass->near : pass->body;
    glUseProgram(snouts ? pass->snout : gulps ? pass->sunk : plain);
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    gl_bind_texture(1, GL_TEXTURE_2D_ARRAY, textures->patterns);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    draw_group(pass, group, false);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
}

void fish_pass_fins(const struct fish_pass *pass, enum fish_group group, GLuint caustics)
{
    glUseProgram(pass->fin);
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    draw_group(pass, group, true);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/* Draws one translucent quad for each of `count` fish, beginning with the fish `first`. */
static void draw_quads(const struct fish_pass *pass, GLuint program, uint32_t first, uint32_t count)
{
    static const struct instance_attribute attributes[] = {
        INSTANCE(0, 4, place),
        INSTANCE(1, 4, right_phase),
        INSTANCE(2, 4, up_amplitude),
        INSTANCE(3, 3, gulp),
    };
    if (count == 0) {
        return;
    }
    glUseProgram(program);
    glBindVertexArray(pass->rings);
    point_instances(pass, first, attributes, 4);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)count);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void fish_pass_rings(const struct fish_pass *pass)
{
    draw_quads(pass, pass->ring_program, pass->first[FISH_GULPING_FAR],
               pass->count[FISH_GULPING_FAR] + pass->count[FISH_GULPING]);
}

void fish_pass_bowl_shadows(const struct fish_pass *pass)
{
    draw_quads(pass, pass->bowl_shadow_program, pass->first[FISH_IN_BOWL],
               pass->count[FISH_IN_BOWL]);
}

GLsizei fish_pass_shadow_casters(const struct fish_pass *pass)
{
    static const struct instance_attribute attributes[] = {
        INSTANCE(0, 4, place),
        INSTANCE(1, 4, right_phase),
        INSTANCE(2, 4, up_amplitude),
    };
    point_instances(pass, 0, attributes, 3);
    return (GLsizei)(pass->first[FISH_ON_POI] + pass->count[FISH_ON_POI]);
}
