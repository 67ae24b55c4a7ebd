/* specimen_pass.h -- draws specimens (specimen.h): any species, its own paint, one fish at a time.
 *
 * Each built-in species has a slot of its own, which is filled when it is first asked for or when
 * there is time; another is brought to the GPU when it is asked for, in the other slot that has
 * rested longest. Its skin is painted coarsely at once and finely over the next frames, so long in
 * each. All memory is taken at the start: about 0.2 MiB here, 37 MiB of textures. */
#ifndef KINGYO_PLATFORM_RENDER_SPECIMEN_PASS_H
#define KINGYO_PLATFORM_RENDER_SPECIMEN_PASS_H

#include "platform/render/fish_mesh.h"
#include "platform/render/fish_poses.h"
#include "platform/render/skin.h"
#include "platform/render/specimen.h"
#include "platform/render/textures.h"

#define SPECIMEN_OTHERS 2u /* The lab's rival, and a species that is not built in. */
#define SPECIMEN_SLOTS (SPECIES_BUILT_IN + SPECIMEN_OTHERS)

/* How the picture lies on the screen, as its shaders are told. */
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
    const struct species *species; /* Null: empty. */
    uint32_t edition;
    uint32_t last_used;   /* In draws, to find who rests longest. */
    struct skin *worn;    /* Its own skin, or a built-in's that is painted alike. */
    struct fish_mesh mesh[SPECIES_LOD_COUNT];
    struct morph_rig rig; /* The species' own. */
    struct skin skin;
};

struct specimen_pass {
    struct specimen_program body, fin, shadow;
    struct specimen_slot slots[SPECIMEN_SLOTS];
    GLuint pose_buffer, no_attributes;
    GLuint patterns; /* Of the textures. */
    uint32_t draw_count;
    struct morph_pose pose;
    float texels[POSE_TEXELS_MAX][4];
    struct fish_mesh_memory memory;
    struct skin_brush brush;
};

/* `textures` stay open as long; only their patterns are used. */
void specimen_pass_open(struct gl_status *status, struct specimen_pass *pass,
                        const struct textures *textures);
void specimen_pass_close(struct specimen_pass *pass);

/* Paints on what is unfinished: 10 ms a call while what was drawn last is not fine, else 3 ms while
 * there is any. With `ahead`, built-in species that nobody asked for yet, too. Once a frame. */
void specimen_pass_work(struct specimen_pass *pass, bool ahead);

/* Paints all of a species now, for who keeps a single picture. */
void specimen_pass_finish(struct specimen_pass *pass, const struct specimen *specimen);

/* Draws one into the bound framebuffer, which has depth and is the screen of `placing`, over
 * what is there. Clears depth around it. Leaves blending on with (ONE, ONE_MINUS_SRC_ALPHA), depth
 * test and culling off, vertex array 0, scissor off. */
void specimen_pass_draw(struct specimen_pass *pass, const struct specimen *specimen,
                        const struct placing *placing);

#endif
