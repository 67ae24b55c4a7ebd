/* ui.h -- the user interface over the tank: title, choice of mode, countdown, score, calls and
 * fouls, hints, results.
 *
 * Drawn from the scene alone, in the scene's language, as one batch of quads. Letters are distance
 * fields and shapes are formulas, so everything is sharp at every size. The layout scales with the
 * screen, from 720p to 4K and upright, and keeps the tank's middle free during a round.
 *
 * The caller owns `struct ui` (about 85 KB, no pointers) and a current OpenGL ES 3.0 context. After
 * ui_init() our code allocates nothing. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_H
#define KINGYO_PLATFORM_RENDER_UI_UI_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"
#include "platform/render/pass/specimen_pass.h"
#include "platform/render/ui/ui_batch.h"
#include "platform/render/ui/ui_screens.h"

struct ui {
    struct ui_batch batch;
    struct ui_memory memory;
    uint32_t programs[UI_KIND_COUNT];                 /* OpenGL names from here on. */
    int32_t to_clip[UI_KIND_COUNT];                   /* Uniform locations of the picture's size. */
    int32_t turn[UI_KIND_COUNT], move[UI_KIND_COUNT]; /* Uniform locations of the display
                                                         geometry. */
    uint32_t vertex_array, vertex_buffer, index_buffer;
    uint32_t font_texture, paper_texture;
};

/* Compiles the shaders and uploads font and paper. Returns 1, or 0 with a one-line reason in
 * `why`. */
int ui_init(struct ui *ui, char *why, size_t why_size);

/* Draws the user interface over the bound framebuffer, which is the screen of `transform`.
 * `specimens` draws the batch's specimens between its quads. If `specimens` is null, they are
 * omitted and the framebuffer needs no depth. Needs no other state than the bound framebuffer.
 *
 * State afterwards: the viewport is the screen. Blending is on with (ONE, ONE_MINUS_SRC_ALPHA).
 * Depth test, face culling and scissor are off, and depth writes are on (OpenGL's initial
 * state). One of the programs is current, the vertex array is 0, and units 0 and 1 have
 * textures. */
void ui_draw(struct ui *ui, struct specimen_pass *specimens, const struct scene *scene,
             const struct display_transform *transform);

/* Draws the current content of the batch, with the same conditions as ui_draw(). */
void ui_show(struct ui *ui, struct specimen_pass *specimens,
             const struct display_transform *transform);

/* Frees the OpenGL objects. The same context must be current. */
void ui_close(struct ui *ui);

#endif
