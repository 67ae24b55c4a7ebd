/* ui.h -- draws the user interface over the tank: title, mode selection, countdown, score,
 * announcements, hints and results.
 *
 * The user interface depends only on the scene, is drawn in the scene's language, and consists of
 * one batch of quads. Letters are distance fields and shapes are computed from formulas, so that
 * both are sharp at every size. The layout scales from 720p to 4K, supports upright screens, and
 * keeps the tank's middle free during a round.
 *
 * The caller owns `struct ui` (about 85 KB, no pointers) and provides a current OpenGL ES 3.0
 * context. This program's code allocates no memory after ui_init(). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"
#include "platform/render/pass/specimen_pass.h"
#include "platform/render/ui/ui_batch.h"
#include "platform/render/ui/ui_screens.h"

struct ui {
    struct ui_batch batch;
    struct ui_memory memory;
    /* OpenGL shader programs, indexed by enum ui_kind. */
    uint32_t programs[UI_KIND_COUNT];
    /* Location, in each shader program, of the uniform with the factors that convert pixels to clip
     * space. */
    int32_t to_clip[UI_KIND_COUNT];
    /* Locations in each shader program of the uniforms for the rotation (`turn`) and the position
     * (`move`) of the picture. */
    int32_t turn[UI_KIND_COUNT], move[UI_KIND_COUNT];
    uint32_t vertex_array, vertex_buffer, index_buffer;
    uint32_t font_texture, paper_texture, waves_texture;
};

/* Compiles the shaders and uploads the font and the paper texture. Returns true on success. On
 * failure returns false and writes a one-line reason to `why`. */
bool ui_init(struct ui *ui, char *why, size_t why_size);

/* Draws the user interface over the bound framebuffer, whose size must be the screen size of
 * `transform`. `specimens` draws the specimens of the batch between the quads. If `specimens` is
 * null, no specimens are drawn and the framebuffer needs no depth buffer. ui_draw() sets all other
 * OpenGL state that it needs.
 *
 * State afterwards: the viewport is the screen. Blending is on with (ONE, ONE_MINUS_SRC_ALPHA).
 * Depth test, face culling and scissor test are off, and depth writes are on. One of the user
 * interface's programs is current, the vertex array is 0, and texture units 0 and 1 have
 * textures. */
void ui_draw(struct ui *ui, struct specimen_pass *specimens, const struct scene *scene,
             const struct display_transform *transform);

/* Draws the current content of the batch without filling the batch. The requirements and the OpenGL
 * state after the call are those of ui_draw(). */
void ui_show(struct ui *ui, struct specimen_pass *specimens,
             const struct display_transform *transform);

/* Deletes the OpenGL objects. The context of ui_init() must be current. */
void ui_close(struct ui *ui);
