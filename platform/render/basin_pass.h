/* basin_pass.h -- the tank itself: floor and walls below, rim and counter above, and the water. */
#ifndef KINGYO_PLATFORM_RENDER_BASIN_PASS_H
#define KINGYO_PLATFORM_RENDER_BASIN_PASS_H

#include "core/scene.h"
#include "platform/render/textures.h"

struct basin_pass {
    GLuint floor_program, wall_program, water_program;
    GLuint counter_program, side_program, rim_program;
    GLuint vertex_array, vertex_buffer;
    struct gl_ring slope_ring;
    float waves[RIPPLE_Z][RIPPLE_X][2];
    float slopes[RIPPLE_Z][RIPPLE_X][4]; /* x, z for the mirror; x, z bounded for below. */
};

void basin_pass_open(struct gl_status *status, struct basin_pass *pass);
void basin_pass_close(struct basin_pass *pass);

/* Uploads the surface's slopes. */
void basin_pass_prepare(struct basin_pass *pass, const struct scene *scene);

/* Floor and walls; no depth needed. */
void basin_pass_ground(const struct basin_pass *pass, GLuint caustics, GLuint shadows);

/* Rim and counter are hidden by what stands before them in the depth buffer but leave no depth: a
 * hand holds its poi over the rim, never through it. The surface, over `ground` and `life`, does.
 */
void basin_pass_deck(const struct basin_pass *pass, const struct textures *textures);
void basin_pass_water(const struct basin_pass *pass, const struct textures *textures, GLuint ground,
                      GLuint life);

#endif
