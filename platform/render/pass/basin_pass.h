/* basin_pass.h -- draws the tank: the floor and the walls below the water surface, the water
 * surface, and, above the surface, the rim of the tank and the counter (the table around the
 * tank). */
#pragma once

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/textures.h"

/* Number of parts with a shader program of their own: the floor, the walls, the water surface, the
 * edge of the water surface, the counter, the sides of the rim, the street behind the stall, the
 * top of the rim, the reflections on the water, and the picture of the counter and the rim without
 * and with the shades of fans. */
#define BASIN_PARTS 11u

struct basin_pass {
    GLuint programs[BASIN_PARTS];
    GLuint vertex_array, vertex_buffer;
    GLuint no_attributes; /* Vertex array of floor and walls, whose shaders compute the grids. */
    struct gl_ring slope_ring;
    /* Camera and tank of the picture that basin_pass_keep_deck() drew last. */
    struct deck_view {
        float view_projection[16], tank[4];
    } kept;
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

/* Draws the rim and the counter (the table around the tank) into `target`, which has the size of
 * the screen. Does nothing if the target already has the picture for the camera and the tank of
 * `frame`, or if the camera moves. basin_pass_forget() must be called after a target was
 * created. */
void basin_pass_keep_deck(struct basin_pass *pass, const struct frame *frame,
                          const struct gl_target *target, const struct textures *textures);
void basin_pass_forget(struct basin_pass *pass);
/* Draws the rim and the counter without a kept picture and without the shades of fans. For a frame
 * in which the camera moves. */
void basin_pass_moving_deck(const struct basin_pass *pass, const struct textures *textures);
/* Draws the rim and the counter (the table around the tank) from the picture `kept` of
 * basin_pass_keep_deck(). The depth test hides the parts behind nearer objects. The rim and the
 * counter write no depth, because a poi (paper scoop) is always held over the rim. `shaded` is the
 * part of the picture in which fans cast shades; its width may be 0. */
void basin_pass_deck(const struct basin_pass *pass, const struct gl_target *kept,
                     const struct frame_part *shaded);
/* Draws the reflections on the water surface and its slopes, at low resolution, into a render
 * target of their own. */
void basin_pass_mirror(const struct basin_pass *pass, const struct textures *textures);
/* Draws the water surface and writes its depth. `ground` is the texture with the floor and the
 * walls. `life` is the texture with all other objects under water. `mirror` is the texture with the
 * reflections and the slopes. */
void basin_pass_water(const struct basin_pass *pass, GLuint ground, GLuint life, GLuint mirror);
