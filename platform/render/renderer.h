/* renderer.h -- draws one scene. renderer.c alone defines the order of a frame; renderer_open.c
 * makes all objects.
 *
 * Needs a current OpenGL ES 3.0 context and nothing of SDL. The picture depends only on the scene
 * and the size: drawing a scene twice gives the same pixels on the same machine. */
#ifndef KINGYO_PLATFORM_RENDER_RENDERER_H
#define KINGYO_PLATFORM_RENDER_RENDERER_H

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/render/pass/air_pass.h"
#include "platform/render/pass/basin_pass.h"
#include "platform/render/pass/bowl_pass.h"
#include "platform/render/pass/drip_pass.h"
#include "platform/render/pass/edge_pass.h"
#include "platform/render/pass/fan_pass.h"
#include "platform/render/pass/fish_pass.h"
#include "platform/render/frame_block.h"
#include "platform/render/pass/light_pass.h"
#include "platform/render/pass/poi_pass.h"
#include "platform/render/quality.h"
#include "platform/render/textures.h"
#include "platform/render/pass/specimen_pass.h"
#include "platform/render/ui/ui.h"

#define RENDERER_WIDTH_MAX 8192u /* Maximum width of a picture that can be read back: twice 4K. */

struct renderer_config {
    uint32_t width, height; /* Pixels, > 0. */
    float scene_scale;      /* Scale as in struct display_gl_config. */
    uint32_t samples;
    const struct library *library; /* Makers' species; null: none. Must stay valid and at the
                                      same address while the renderer is open. */
};

/* The steps of a frame, for measurements. */
enum render_step {
    STEP_PREPARE = 0, /* Sorting and uploads. */
    STEP_LIGHT,       /* Caustics and shadows. */
    STEP_GROUND,      /* Floor and walls. */
    STEP_LIFE,        /* Fish, and the parts of poi and bowl under water. */
    STEP_SURFACE,     /* Water surface. */
    STEP_ABOVE,       /* Bowls, rim and counter, pois and fish out of the water. */
    STEP_UI,
    STEP_COUNT,
};

struct renderer {
    struct gl_status status;
    struct renderer_config config; /* Configuration; its size follows the window. */
    struct display_settings display_settings;
    struct display_transform transform; /* Display geometry of the picture on a screen of the
                                           current size. */
    struct quality quality;
    uint32_t step;                  /* Current step of quality_lower(). */
    uint32_t samples_max, side_max; /* Limits of the current context. */
    char gl_name[HAL_TEXT_SIZE / 2];
    struct frame frame;
    struct textures textures;
    struct light_pass light;
    struct basin_pass basin;
    struct fish_pass fish;
    struct poi_pass poi;
    struct bowl_pass bowl;
    struct fan_pass fan;
    struct air_pass air;
    struct drip_pass drip;
    struct edge_pass edge;
    struct specimen_pass specimens;
    struct ui ui;
    struct gl_target ground, life;
    struct gl_target screen; /* Multisampled screen; without multisampling, the default framebuffer
                                itself. */
    uint8_t row[RENDERER_WIDTH_MAX * 4u]; /* Row buffer for reading back a captured image. */
    /* Optional callback after each step. A benchmark calls glFinish() and reads a clock there. */
    void (*on_step)(void *context, enum render_step step);
    void *on_step_context;
};

/* Makes every program, texture and buffer. Returns HAL_ERR_GONE on failure; renderer_error()
 * returns the reason. */
int renderer_open(struct renderer *renderer, const struct renderer_config *config);
void renderer_close(struct renderer *renderer);

/* Adapts the targets to the window's size. Costs nothing if the size did not change. Returns
 * HAL_ERR_GONE if the new targets fail. */
int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height);

/* Sets the display geometry of all later pictures. Initially the picture fills the screen.
 * `display_settings` is copied. */
void renderer_place(struct renderer *renderer, const struct display_settings *display_settings);

/* Sets the step of quality_lower() for all later pictures. Costs nothing if the step did not
 * change. Returns HAL_ERR_GONE if the new targets fail. */
int renderer_lower(struct renderer *renderer, uint32_t step);

/* Draws into the default framebuffer and leaves the swap to the caller. */
void renderer_draw(struct renderer *renderer, const struct scene *scene);

/* Copies the default framebuffer, top row first. Call before a swap. Returns HAL_ERR_IO if `image`
 * is too small. */
int renderer_read(struct renderer *renderer, struct hal_image *image);

/* Returns false after OpenGL has reported a lost device or lack of memory; renderer_error() returns
 * which. */
bool renderer_is_alive(struct renderer *renderer);

const char *renderer_error(const struct renderer *renderer);

/* Writes a description such as "OpenGL ES 3.2 llvmpipe, 1280x720, scene 0.75x, floor 0.5x". */
void renderer_describe(const struct renderer *renderer, char *out, size_t size);

#endif
