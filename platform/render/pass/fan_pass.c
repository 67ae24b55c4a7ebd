/* fan_pass.c -- implementation of fan_pass.h. */
#include "platform/render/pass/fan_pass.h"

#include "platform/render/gl_program.h"
#include "platform/render/pass/poi_pass.h"
#include "shaders.h"

/* Height of the hand-held fan above the water. At this height, from the player's eye, the fan hides
 * half of its shadow on the water and little of the floor. */
#define FAN_HEIGHT_M 0.15f
/* Tilt of the hand-held fan. The far edge is lower, so that the player sees the picture on the
 * fan. */
#define FAN_PITCH_RAD (-7.0f * F_DEG)
/* Amplitude of the fan's sway. The sway imitates a human hand, which is never quite still. */
#define SWAY_RAD (1.6f * F_DEG)
#define SWAY_HZ 0.23f
#define SEEN_THROUGH 0.34f
#define SEEN_FROM_S 0.6f
#define SEEN_TO_S 2.0f

void fan_pass_open(struct gl_status *status, struct fan_pass *pass)
{
    pass->program = gl_program(status, "fan", "", shader_fan_vert, shader_fan_frag, "fibres");
    pass->pose = glGetUniformLocation(pass->program, "pose");
    pass->trim = glGetUniformLocation(pass->program, "trim");
    glGenVertexArrays(1, &pass->no_attributes);
}

void fan_pass_close(struct fan_pass *pass)
{
    glDeleteProgram(pass->program);
    glDeleteVertexArrays(1, &pass->no_attributes);
}

static void draw_fan(const struct fan_pass *pass, const struct scene_fan *fan, uint32_t tick)
{
    float pose[16];
    const uint32_t period = (uint32_t)((float)CORE_TICK_HZ / SWAY_HZ);
    const float sway = (float)(tick % period) / (float)period * F_TAU + (float)fan->owner;
    const struct angles angles = { .yaw_rad = 0.18f + SWAY_RAD * f_sin(sway),
                                   .pitch_rad = FAN_PITCH_RAD,
                                   .roll_rad = SWAY_RAD * f_cos(sway) };
    frame_pose(pose, v3(fan->x_m, FAN_HEIGHT_M, fan->z_m), angles, fan->radius_m);
    glUniformMatrix4fv(pass->pose, 1, GL_FALSE, pose);
    /* A fan that is not moved becomes partly transparent, so that its player sees the fish behind
     * the fan. */
    const float through = SEEN_THROUGH * f_smoothstep(SEEN_FROM_S, SEEN_TO_S, fan->still_s);
    const float *const paint = poi_paint(fan->owner);
    glUniform4f(pass->trim, paint[0], paint[1], paint[2], 1.0f - through);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void fan_pass_draw(const struct fan_pass *pass, const struct scene *scene,
                   const struct textures *textures)
{
    glUseProgram(pass->program);
    gl_bind_texture(0, GL_TEXTURE_2D, textures->paper);
    glBindVertexArray(pass->no_attributes);
    glEnable(GL_BLEND);
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        if (scene->fan[i].present && !scene->fan[i].unseen) {
            draw_fan(pass, &scene->fan[i], scene->tick);
        }
    }
    glDisable(GL_BLEND);
}
