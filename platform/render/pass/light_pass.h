/* light_pass.h -- draws two textures with the light on the tank's floor: the caustics (the pattern
 * of focused light) at the current time, and the shadows of all objects. */
#pragma once

#include "core/scene.h"
#include "platform/render/pass/fish_pass.h"
#include "platform/render/pass/poi_pass.h"
#include "platform/render/textures.h"

struct light_pass {
    GLuint caustics_program, fish_program, disc_program;
    GLint disc_pose, disc_softness, disc_slant;
    /* Vertex array without attributes (`no_attributes`), and vertex array with the instances of the
     * shadow casters (`casters`). */
    GLuint no_attributes, casters;
    /* One tile of the caustics texture, which is repeated over the floor. */
    struct gl_target caustics;
    /* Shadow map of the floor, seen from above. A value of 0 means that the floor is fully lit. */
    struct gl_target shadows;
    struct gl_target shade_map; /* Texture `shades` of common.glsl. */
    GLuint shade_program;
    GLint shade_circles, shade_counts;
};

void light_pass_open(struct gl_status *status, struct light_pass *pass);
void light_pass_close(struct light_pass *pass);

/* Draws the tile of caustics at the current time. */
void light_pass_caustics(const struct light_pass *pass, const struct textures *textures);

/* Draws the shade map, and binds it to GL_UNIT_SHADES for all later programs. */
void light_pass_shades(const struct light_pass *pass, const struct frame_shades *shades);

/* Draws the shadow map. Must be called after fish_pass_prepare() and poi_pass_prepare(). */
void light_pass_shadows(const struct light_pass *pass, const struct scene *scene,
                        const struct fish_pass *fish, const struct poi_pass *poi);
