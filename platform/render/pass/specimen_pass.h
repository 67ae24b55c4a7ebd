/* specimen_pass.h -- draws specimens (specimen.h). A specimen is one fish of any species, with the
 * paint of its species.
 *
 * Each built-in species has its own cache slot, which is filled at first use or in a frame without
 * other work. Any other species is uploaded at first use, into the least recently used of the
 * remaining cache slots. A fish texture is first painted coarsely. The following frames paint the
 * texture finely, for a limited time in each frame. All memory is reserved when the pass opens:
 * about 0.2 MiB in struct specimen_pass and 45 MiB of textures. */
#pragma once

#include "platform/render/fish_mesh.h"
#include "platform/render/fish_texture.h"
#include "platform/render/specimen.h"
#include "platform/render/textures.h"

/* Number of cache slots for species that are not in the table of built-in species. Two slots are
 * for the varieties of the goldfish in the album, one is for the comparison fish of the growth lab
 * (the kiosk's page about the growth of fish), and one is for one more species. */
#define SPECIMEN_OTHERS 4u
#define SPECIMEN_SLOTS (SPECIES_BUILT_IN + SPECIMEN_OTHERS)

/* clang-format off */
/* List of the uniforms of the specimen shaders. The macro X() is called with the name of each
 * uniform. `screen_px` is the screen size in pixels. `turn` and `move` are the rotation and the
 * position of the picture on the screen. */
#define SPECIMEN_UNIFORMS                                                                          \
    X(screen_px) X(turn) X(move) X(reach) X(axes) X(place) X(swim) X(look) X(tint) X(sheets)       \
    X(worn) X(worn_red) X(line_place) X(line_shape) X(line_colour)
/* clang-format on */

/* A shader program, and the location of each uniform in it. */
struct specimen_program {
    GLuint name;
#define X(uniform) GLint uniform;
    SPECIMEN_UNIFORMS
#undef X
};

struct specimen_slot {
    /* Species in the cache slot. Null means that the slot is empty. */
    const struct species *species;
    uint32_t edition;
    /* Value of draw_count when the slot was last used. The slot with the smallest value is the
     * least recently used. */
    uint32_t last_used;
    /* Texture with which the species is drawn: the slot's own `skin`, or the texture of a built-in
     * species with identical paint. */
    struct fish_texture *worn;
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    /* Deformation graphs of the species in the cache slot, prepared for computing poses. */
    struct morph_rig rig;
    struct fish_texture skin;
};

struct specimen_pass {
    struct specimen_program body, fin, shadow;
    struct specimen_slot slots[SPECIMEN_SLOTS];
    GLuint pose_buffer, no_attributes;
    GLuint patterns; /* Texture with the goldfish patterns, which struct textures owns. */
    uint32_t draw_count;
    struct morph_pose pose;
    float texels[POSE_TEXELS_MAX][4];
    struct fish_mesh_memory memory;
    struct paint_brush brush;
};

/* Creates the shader programs and buffers. The caller must keep `textures` open until
 * specimen_pass_close(), because the pass uses the pattern texture. */
void specimen_pass_open(struct gl_status *status, struct specimen_pass *pass,
                        const struct textures *textures);
void specimen_pass_close(struct specimen_pass *pass);

/* Paints unfinished textures, for about 10 ms while a visible texture is coarse, otherwise for
 * about 3 ms. If all textures are finished and `ahead` is true, prepares one built-in species that
 * has not been shown yet. Call once per frame. */
void specimen_pass_work(struct specimen_pass *pass, bool ahead);

/* Paints the texture of the specimen's species completely, for a caller that stores a single
 * picture. */
void specimen_pass_finish(struct specimen_pass *pass, const struct specimen *specimen);

/* Draws one specimen over the picture in the bound framebuffer, which must have a depth buffer and
 * the screen size of `transform`. Clears the depth around the specimen.
 *
 * State afterwards: blending is on with (ONE, ONE_MINUS_SRC_ALPHA). Depth test, culling and scissor
 * test are off. The vertex array is 0. */
void specimen_pass_draw(struct specimen_pass *pass, const struct specimen *specimen,
                        const struct display_transform *transform);
