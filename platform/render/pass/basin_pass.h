/* basin_pass.h -- draws the tank: floor and walls below the surface, rim and counter above it, and
 * the water surface. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_BASIN_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_BASIN_PASS_H

#include "core/scene.h"
#include "platform/render/textures.h"

struct basin_pass {
    GLuint floor_program, wall_program, water_program;
    GLuint counter_program, side_program, rim_program;
    GLuint vertex_array, vertex_buffer;
    struct gl_ring slope_ring;
    float waves[RIPPLE_Z][RIPPLE_X][2];
    float slopes[RIPPLE_Z][RIPPLE_X][4]; /* Slopes along x and z for the reflection, then slopes
                                            along x and z, limited for the refraction. */
};

void basin_pass_open(struct gl_status *status, struct basin_pass *pass);
void basin_pass_close(struct basin_pass *pass);

/* Uploads the slopes of the water surface. */
void basin_pass_prepare(struct basin_pass *pass, const struct scene *scene);

/* Draws floor and walls. The target needs no depth buffer. */
void basin_pass_ground(const struct basin_pass *pass, GLuint caustics, GLuint shadows);

/* Draws rim and counter. The depth buffer hides them behind nearer objects. They write no depth,
 * because a poi is always held over the rim. */
void basin_pass_deck(const struct basin_pass *pass, const struct textures *textures);
/* Draws the water surface with depth. `ground` and `life` are the pictures of the objects below the
 * surface. */
void basin_pass_water(const struct basin_pass *pass, const struct textures *textures, GLuint ground,
                      GLuint life);

#endif
