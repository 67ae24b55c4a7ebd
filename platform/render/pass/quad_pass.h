/* quad_pass.h -- draws the objects that need no mesh, because their shaders compute each object
 * from a few quads. These objects are the air stone (the outlet of the air pump) with its bubbles,
 * the drops that fall from a wet poi, the hand-held fans, and the black edge of the picture. */
#pragma once

#include "core/scene.h"
#include "platform/render/textures.h"

/* Maximum number of drops, rings and waves of all splashes in a picture. Those of the oldest
 * splashes are left out. */
#define QUAD_SPRAY_MAX 96u

/* A drop in the air, the ring that a drop makes on the water, or the wave of a splash. */
struct quad_drop {
    float place[4]; /* Position in the world, and radius in m. */
    float stretch;  /* Length of a drop in its widths, at least 1. 0 means a ring. */
    float opacity;
};

struct quad_pass {
    GLuint no_attributes;             /* Vertex array without attributes. */
    GLuint spray_array, spray_buffer; /* Vertex array and buffer with the drops of the picture. */
    GLuint bubble_program, drip_program, spray_program, scrap_program, fan_program, dark_program,
        copy_program;
    struct gl_target fan_faces; /* Pictures of fan_face.frag.glsl. */
    /* Locations of the shader uniforms. fan_pose and fan_trim belong to the uniforms `pose` and
     * `trim` of the program for fans. */
    GLint stone, lip, hub, low, across, fan_pose, fan_trim, dark;
};

/* Builds all programs, and draws the pictures of a fan. */
void quad_pass_open(struct gl_status *status, struct quad_pass *pass,
                    const struct textures *textures);
void quad_pass_close(struct quad_pass *pass);

/* Draws the air stone on the tank's floor, its hose, and its bubbles while the air pump runs. Draws
 * into a render target with a depth buffer, after all opaque objects. Draws nothing if the tank has
 * no air stone. If `is_above` is true, draws only the part of the hose that is above the water,
 * over the rim and the counter. */
void quad_pass_air(const struct quad_pass *pass, const struct scene *scene, bool is_above);

/* Draws the drops and the streams of water that fall from each wet poi (the paper scoop) that is
 * held over the water, into a render target with a depth buffer. Must be called after the bowls and
 * before the pois are drawn. */
void quad_pass_drips(const struct quad_pass *pass, const struct scene *scene);

/* Computes the drops of all splashes of the scene, the rings of the drops, and the waves of pois
 * that enter or leave the water and of fish that fall into bowls. No drop makes a ring in the tank
 * where a poi is seen in the water or close above it. Returns the number of entries of `out`. */
uint32_t quad_spray_of(const struct scene *scene, struct quad_drop out[QUAD_SPRAY_MAX]);
/* Draws the drops of quad_spray_of() into a render target with a depth buffer, with one draw call.
 * Must be called after the pois are drawn. */
void quad_pass_spray(const struct quad_pass *pass, const struct scene *scene);

/* Computes the scraps of paper under water. The member `stretch` of a scrap is its angle in rad.
 * Returns the number of scraps. */
uint32_t quad_scraps_of(const struct scene *scene, struct quad_drop out[SCENE_SCRAP_MAX]);
/* Draws the scraps of quad_scraps_of() into the render target of the objects below the water. */
void quad_pass_scraps(const struct quad_pass *pass, const struct scene *scene);

/* Height in metres of a hand-held fan above the water. As seen by the player, a fan at this height
 * hides half of its own shadow on the water and little of the floor. */
#define QUAD_FAN_HEIGHT_M 0.15f
/* Distance from the middle of a fan to the end of its handle, in radii of the fan. Must be the
 * distance in fan_face.frag.glsl. */
#define QUAD_FAN_HANDLE 2.16f
/* Returns the angles of a hand-held fan, which sways. */
struct angles quad_fan_angles(const struct scene *scene, const struct scene_fan *fan);
/* Draws the hand-held fans over all other objects of the scene, with blending. The render target
 * needs no depth buffer. The shade map (light_pass.h) contains the fans' shadows. */
void quad_pass_fans(const struct quad_pass *pass, const struct scene *scene);

/* Fills the bound render target with the texture `picture`. */
void quad_pass_copy(const struct quad_pass *pass, GLuint picture);

/* Dims the finished picture to the configured brightness, and fills the area beside the picture
 * with black. Draws nothing if the picture fills the screen at full brightness. The size of the
 * bound framebuffer must be the screen size of `transform`. Afterwards blending is on and the
 * scissor test is off. */
void quad_pass_edge(const struct quad_pass *pass, const struct display_transform *transform);
