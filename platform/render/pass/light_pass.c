/* light_pass.c -- draws the caustics (the pattern of focused light) and the shadow map of the
 * tank's floor. */
#include "platform/render/pass/light_pass.h"

#include <stdio.h>

#include "assets.h"
#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "shaders.h"

/* Width of the shadow map in texels. A texel is 1.7 mm wide, which is narrower than the soft edge
 * of any shadow. */
#define SHADOW_WIDTH 512u
#define SHADOW_HEIGHT 320u
/* Size of the shade map in texels. A texel is 13 mm wide in the festival tank. The edge of a shade
 * is at least 20 mm wide. */
#define SHADE_MAP_WIDTH 128u
#define SHADE_MAP_HEIGHT 96u
#define DEFINES_SIZE 48

void light_pass_open(struct gl_status *status, struct light_pass *pass)
{
    char defines[DEFINES_SIZE];
    snprintf(defines, sizeof defines, "#define CAUSTIC_LAYERS %u\n", ASSET_CAUSTICS_FRAMES);
    pass->caustics_program = gl_program(status, "caustics", defines, shader_fill_vert,
                                        shader_caustics_frag, "loop_layers");
    pass->fish_program =
        gl_program(status, "fish shadow", "", shader_shadow_fish_vert, shader_shadow_fish_frag, "");
    pass->disc_program = gl_program(status, "disc shadow", "", shader_shadow_disc_vert,
                                    shader_shadow_disc_frag, "sheet");
    pass->disc_slant = glGetUniformLocation(pass->disc_program, "slant");
    pass->disc_pose = glGetUniformLocation(pass->disc_program, "pose");
    pass->disc_softness = glGetUniformLocation(pass->disc_program, "softness");
    pass->shade_program = gl_program(status, "shades", "", shader_fill_vert, shader_shade_frag, "");
    pass->shade_circles = glGetUniformLocation(pass->shade_program, "circles");
    pass->shade_counts = glGetUniformLocation(pass->shade_program, "counts");
    gl_target_open(status, "shades", &pass->shade_map,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = SHADE_MAP_WIDTH,
                                             .height = SHADE_MAP_HEIGHT });
    glGenVertexArrays(1, &pass->no_attributes);
    glGenVertexArrays(1, &pass->casters);
    gl_target_open(status, "caustics", &pass->caustics,
                   &(struct gl_target_desc){ .internal_format = GL_RG8,
                                             .width = ASSET_CAUSTICS_SIZE,
                                             .height = ASSET_CAUSTICS_SIZE,
                                             .wrap = GL_REPEAT });
    gl_target_open(status, "shadows", &pass->shadows,
                   &(struct gl_target_desc){
                       .internal_format = GL_R8, .width = SHADOW_WIDTH, .height = SHADOW_HEIGHT });
}

void light_pass_close(struct light_pass *pass)
{
    glDeleteProgram(pass->caustics_program);
    glDeleteProgram(pass->fish_program);
    glDeleteProgram(pass->disc_program);
    glDeleteVertexArrays(1, &pass->no_attributes);
    glDeleteVertexArrays(1, &pass->casters);
    gl_target_close(&pass->caustics);
    gl_target_close(&pass->shadows);
    glDeleteProgram(pass->shade_program);
    gl_target_close(&pass->shade_map);
}

void light_pass_caustics(const struct light_pass *pass, const struct textures *textures)
{
    static const GLenum old = GL_COLOR_ATTACHMENT0;
    gl_target_bind(&pass->caustics);
    /* The old tile is invalidated, so that a tiled GPU does not load it before it is drawn over. */
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &old);
    glUseProgram(pass->caustics_program);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, textures->caustics);
    glBindVertexArray(pass->no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void light_pass_shades(const struct light_pass *pass, const struct frame_shades *shades)
{
    gl_target_bind(&pass->shade_map);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (shades->count > 0) {
        glUseProgram(pass->shade_program);
        glUniform4fv(pass->shade_circles, FRAME_SHADE_MAX, shades->circles[0]);
        glUniform2f(pass->shade_counts, (float)shades->fan_count, (float)shades->count);
        glBindVertexArray(pass->no_attributes);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    gl_bind_texture(GL_UNIT_SHADES, GL_TEXTURE_2D, pass->shade_map.texture);
}

static void disc_shadow(const struct light_pass *pass, const float pose[16], float height_m,
                        float radius_m, const float shape[3])
{
    CORE_ASSERT(radius_m > 0.0f);
    /* The width of the soft edge of a shadow increases with the height of the object above the
     * floor. The shader of the fish's shadows uses the same formula. */
    const float blur = (0.004f + f_max(height_m, 0.0f) * 0.10f) / radius_m;
    glUniformMatrix4fv(pass->disc_pose, 1, GL_FALSE, pose);
    glUniform4f(pass->disc_softness, f_clamp(blur, 0.08f, 0.9f), shape[0], shape[1], shape[2]);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, DISC_AND_HANDLE_VERTICES);
}

void light_pass_shadows(const struct light_pass *pass, const struct scene *scene,
                        const struct fish_pass *fish, const struct poi_pass *poi)
{
    gl_target_bind(&pass->shadows);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR); /* With this blend function, overlapping shadows
                                                    darken each other and never exceed full
                                                    darkness. */
    glUseProgram(pass->fish_program);
    glBindVertexArray(pass->casters);
    const GLsizei count = fish_pass_shadow_casters(fish);
    if (count > 0) {
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
    glUseProgram(pass->disc_program);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, gl_ring_texture(&poi->sheet_ring));
    glBindVertexArray(pass->no_attributes);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        float pose[16];
        if (scene->poi[i].present) {
            const struct scene_poi *const caster = &scene->poi[i];
            /* The shadow of a poi is drawn vertically below the poi, because the fish react to a
             * shadow at this place. */
            poi_pose(pose, caster->position_m, caster->angles, caster->ring_radius_m);
            glUniform1f(pass->disc_slant, 0.0f);
            disc_shadow(pass, pose, caster->position_m.y + scene->tank_size_m.y,
                        caster->ring_radius_m, (const float[3]){ 3.7f, 0.34f, (float)i });
        }
        if (scene->bowl[i].present) {
            const vec3 bottom =
                v3_sub(scene->bowl[i].position_m, v3(0.0f, scene->bowl[i].depth_m * 0.6f, 0.0f));
            poi_pose(pose, bottom, (struct angles){ 0 }, scene->bowl[i].radius_m);
            glUniform1f(pass->disc_slant, 1.0f);
            disc_shadow(pass, pose, bottom.y + scene->tank_size_m.y, scene->bowl[i].radius_m,
                        (const float[3]){ 1.0f, 0.62f, -1.0f });
        }
    }
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_BLEND);
}
