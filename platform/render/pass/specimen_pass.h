/* specimen_pass.h -- draws specimens (specimen.h): any species with its own paint, one fish at a
 * time.
 *
 * Each built-in species has its own slot, which is filled at first use or when there is time. Any
 * other species is uploaded at first use, into the least recently used of the remaining slots. A
 * fish texture is painted coarsely at once and finely over the following frames, for a limited time
 * in each. All memory is reserved at the start: about 0.2 MiB here and 37 MiB of textures. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_SPECIMEN_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_SPECIMEN_PASS_H

#include "platform/render/fish_mesh.h"
#include "platform/render/fish_poses.h"
#include "platform/render/fish_texture.h"
#include "platform/render/specimen.h"
#include "platform/render/textures.h"

/* Slots for the lab's comparison fish and for a species that is not built in. */
#define SPECIMEN_OTHERS 2u
#define SPECIMEN_SLOTS (SPECIES_BUILT_IN + SPECIMEN_OTHERS)

/* Uniform locations of the display geometry. */
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
    const struct species *species; /* Null: empty slot. */
    uint32_t edition;
    uint32_t last_used; /* Value of draw_count at the last use, to find the least recently used
                           slot. */
    struct fish_texture *worn; /* The slot's own texture, or a built-in species' texture with the
                                  same paint. */
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    struct morph_rig rig; /* Rig with the species' own curves. */
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

/* Builds programs and buffers. `textures` must stay open as long as the pass; only their patterns
 * are used. */
void specimen_pass_open(struct gl_status *status, struct specimen_pass *pass,
                        const struct textures *textures);
void specimen_pass_close(struct specimen_pass *pass);

/* Paints unfinished textures: for 10 ms a call while a texture drawn last is not fine, otherwise
 * for 3 ms. With `ahead`, built-in species that were not shown yet are also prepared. Call once a
 * frame. */
void specimen_pass_work(struct specimen_pass *pass, bool ahead);

/* Paints the species' texture completely, for a caller that stores a single picture. */
void specimen_pass_finish(struct specimen_pass *pass, const struct specimen *specimen);

/* Draws one specimen into the bound framebuffer, which must have depth and be the screen of
 * `transform`, over the existing picture. Clears the depth around the specimen. Leaves blending on
 * with (ONE, ONE_MINUS_SRC_ALPHA), depth test and culling off, vertex array 0, scissor off. */
void specimen_pass_draw(struct specimen_pass *pass, const struct specimen *specimen,
                        const struct display_transform *transform);

#endif
