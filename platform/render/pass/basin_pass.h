/* basin_pass.h -- draws the tank: the floor and the walls below the water surface, the water
 * surface, and, above the surface, the rim of the tank and the counter (the table around the
 * tank). */
#pragma once

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/textures.h"

/* Number of parts with a shader program of their own: the floor, the walls, the water surface, the
 * edge of the water surface, the street behind the stall, the counter, the sides of the rim, the
 * top of the rim, the reflections on the water, and the picture of the counter and the rim without
 * and with the shades of fans. */
#define BASIN_PARTS 11u

struct basin_pass {
    GLuint programs[BASIN_PARTS];
    GLuint vertex_array, vertex_buffer;
    GLuint no_attributes; /* Vertex array of floor and walls, whose shaders compute the grids. */
    struct gl_ring slope_ring;
    /* Camera and tank of the kept picture of the rim and the counter, the matrix from the world to
     * the clip space of the picture, and true if the picture has been drawn. `widest` is the camera
     * of the kept picture that showed the most since the tank or the orientation of the screen has
     * changed, which is the camera at rest. */
    struct deck_view {
        struct view view, widest;
        float view_projection[16], tank[4];
        bool is_drawn;
    } kept;
    GLint to_kept[2]; /* Uniforms of the programs that draw the kept picture. */
    float waves[RIPPLE_Z][RIPPLE_X][2];
    /* Four slopes for each point of the water surface, as 16-bit floats. The first two are the
     * slopes along x and along z for the reflection. The last two are the slopes along x and along
     * z for the refraction, limited to SEEN_SLOPE_MAX. */
    uint16_t slopes[RIPPLE_Z][RIPPLE_X][4];
};

void basin_pass_open(struct gl_status *status, struct basin_pass *pass);
void basin_pass_close(struct basin_pass *pass);

/* Computes the slopes of the water surface and uploads them. */
void basin_pass_prepare(struct basin_pass *pass, const struct scene *scene);

/* Draws the floor and the walls. The render target needs no depth buffer. */
void basin_pass_ground(const struct basin_pass *pass, GLuint caustics, GLuint shadows);

/* Prepares the picture of the rim and the counter (the table around the tank). `target` is as large
 * as the screen plus an equal margin on opposite sides. The picture of another camera is kept if it
 * shows all that the camera sees in this frame. Otherwise draws the picture of the widest camera or
 * of this camera into `target`. basin_pass_forget() must be called after a target was created. */
void basin_pass_keep_deck(struct basin_pass *pass, const struct frame *frame,
                          const struct scene *scene, const struct display_transform *transform,
                          const struct gl_target *target, const struct textures *textures);
void basin_pass_forget(struct basin_pass *pass);
/* Draws the rim and the counter (the table around the tank) from the picture `kept` of
 * basin_pass_keep_deck(). The depth test hides the parts behind nearer objects. The rim and the
 * counter write no depth, because a poi (paper scoop) is always held over the rim. */
void basin_pass_deck(const struct basin_pass *pass, const struct frame *frame,
                     const struct gl_target *kept);
/* Draws the reflections on the water surface and its slopes, at low resolution, into a render
 * target of their own. */
void basin_pass_mirror(const struct basin_pass *pass, const struct textures *textures);
/* Draws the water surface and writes its depth. `ground` is the texture with the floor and the
 * walls. `life` is the texture with all other objects under water. `mirror` is the texture with the
 * reflections and the slopes. */
void basin_pass_water(const struct basin_pass *pass, GLuint ground, GLuint life, GLuint mirror);
