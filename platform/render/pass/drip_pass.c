/* drip_pass.c -- implementation of drip_pass.h. */
#include "platform/render/pass/drip_pass.h"

#include "platform/render/gl_program.h"
#include "shaders.h"

#define DROPS_MAX 5
/* Minimum mean depth of the water on the paper at which drops fall. A thinner layer adheres to the
 * paper. */
#define DRIPS_FROM_M 0.0002f
#define DRIPS_FULL_M 0.0015f
/* Minimum height above the water surface of the poi's low side at which drops fall. */
#define CLEAR_M 0.008f
/* Distance of the drops from the paper's centre, in paper radii. Drops fall from the ring's outer
 * edge. */
#define RING_REACH 1.17f

void drip_pass_open(struct gl_status *status, struct drip_pass *pass)
{
    pass->program = gl_program(status, "drops", "", shader_drip_vert, shader_drip_frag, "");
    pass->lip = glGetUniformLocation(pass->program, "lip");
    glGenVertexArrays(1, &pass->no_attributes);
}

void drip_pass_close(struct drip_pass *pass)
{
    glDeleteProgram(pass->program);
    glDeleteVertexArrays(1, &pass->no_attributes);
}

/* Returns the lowest point of the ring. For a level ring, returns the centre of the sagging
 * paper. */
static vec3 low_side(const struct scene_poi *poi)
{
    const vec3 up = vec_basis_from_angles(poi->angles).up;
    /* Direction of steepest descent in the plane of the poi's ring. */
    const vec3 down = v3(up.x * up.y, up.y * up.y - 1.0f, up.z * up.y);
    const float steep = v3_length(down);
    const float reach_m = RING_REACH * poi->ring_radius_m * f_smoothstep(0.03f, 0.20f, steep);
    return v3_muladd(poi->position_m, v3_normalize_or(down, v3(0.0f, 0.0f, 0.0f)), reach_m);
}

void drip_pass_draw(const struct drip_pass *pass, const struct scene *scene)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        const vec3 at = low_side(poi);
        if (!poi->present || poi->water_m < DRIPS_FROM_M || at.y < CLEAR_M) {
            continue;
        }
        const float wet = (poi->water_m - DRIPS_FROM_M) / (DRIPS_FULL_M - DRIPS_FROM_M);
        const float drops = (float)DROPS_MAX * f_clamp(0.2f + 0.8f * wet, 0.0f, 1.0f);
        glUseProgram(pass->program);
        glUniform4f(pass->lip, at.x, at.y, at.z, drops);
        glBindVertexArray(pass->no_attributes);
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, DROPS_MAX);
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }
}
