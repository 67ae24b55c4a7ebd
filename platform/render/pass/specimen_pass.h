/* specimen_pass.h -- draws specimens (specimen.h). A specimen is one fish of any species with the
 * species' own paint.
 *
 * Each built-in species has its own slot, which is filled at first use or when there is time. Any
 * other species is uploaded at first use, into the least recently used of the remaining slots. A
 * fish texture is first painted coarsely and then finely over the following frames, for a limited
 * time in each frame. All memory is reserved at the start: about 0.2 MiB in struct specimen_pass
 * and 37 MiB of textures. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_SPECIMEN_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_SPECIMEN_PASS_H

#include "platform/render/fish_mesh.h"
#include "platform/render/fish_poses.h"
#include "platform/render/fish_texture.h"
#include "platform/render/specimen.h"
#include "platform/render/textures.h"

/* Number of slots for species that are not built in: the lab's comparison fish and one more
 * species. */
#define SPECIMEN_OTHERS 2u
#define SPECIMEN_SLOTS (SPECIES_BUILT_IN + SPECIMEN_OTHERS)

/* Locations of the shader uniforms for the screen size and for the rotation and position of the
 * picture. */
struct specimen_screen {
    GLint size, turn, move;
};

struct specimen_program {
    GLuint name;
    struct specimen_screen screen;
    GLint reach, axes, place, swim, look, tint, sheets, worn;
    GLint line_place, line_shape, line_colour;
};

struct specimen_slot {
    const struct species *species; /* Species in the slot. Null means that the slot is empty. */
    uint32_t edition;
    uint32_t last_used; /* Value of draw_count at the last use of the slot, from which the least
                           recently used slot is found. */
    struct fish_texture *worn; /* Texture with which the species is drawn: the slot's own texture,
                                  or the texture of a built-in species with identical paint. */
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    struct morph_rig rig; /* Prepared deformation graphs of the species. */
    struct fish_texture skin;
};

struct specimen_pass {
    struct specimen_program body, fin, shadow;
    struct specimen_slot slots[SPECIMEN_SLOTS];
    GLuint pose_buffer, no_attributes;
    GLuint patterns; /* Pattern texture owned by struct textures. */
    uint32_t draw_count;
    struct morph_pose pose;
    float texels[POSE_TEXELS_MAX][4];
    struct fish_mesh_memory memory;
    struct fish_texture_brush brush;
};

/* Creates programs and buffers. `textures` must stay open as long as the pass. Only its patterns
 * are used. */
void specimen_pass_open(struct gl_status *status, struct specimen_pass *pass,
                        const struct textures *textures);
void specimen_pass_close(struct specimen_pass *pass);

/* Paints unfinished textures. A call takes 10 ms while a visible texture is coarse, otherwise 3 ms.
 * If `ahead` is true, built-in species that were not shown yet are also prepared. Call once per
 * frame. */
void specimen_pass_work(struct specimen_pass *pass, bool ahead);

/* Paints the texture of the specimen's species completely, for a caller that stores a single
 * picture. */
void specimen_pass_finish(struct specimen_pass *pass, const struct specimen *specimen);

/* Draws one specimen over the picture in the bound framebuffer, which must have depth and be the
 * screen of `transform`. Clears the depth around the specimen.
 *
 * State afterwards: blending is on with (ONE, ONE_MINUS_SRC_ALPHA). Depth test, culling and scissor
 * test are off. The vertex array is 0. */
void specimen_pass_draw(struct specimen_pass *pass, const struct specimen *specimen,
                        const struct display_transform *transform);

#endif
