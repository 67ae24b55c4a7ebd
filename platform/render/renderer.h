/* renderer.h -- draws one scene; the order of a frame is in renderer.c and nowhere else, what it
 * needs is made in renderer_open.c.
 *
 * Needs a current OpenGL ES 3.0 context and nothing of SDL. The picture is a function of the scene
 * and the size alone: drawing a scene twice gives the same pixels on the same machine. */
#ifndef KINGYO_PLATFORM_RENDER_RENDERER_H
#define KINGYO_PLATFORM_RENDER_RENDERER_H

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/render/air_pass.h"
#include "platform/render/basin_pass.h"
#include "platform/render/bowl_pass.h"
#include "platform/render/drip_pass.h"
#include "platform/render/edge_pass.h"
#include "platform/render/fan_pass.h"
#include "platform/render/fish_pass.h"
#include "platform/render/frame_block.h"
#include "platform/render/light_pass.h"
#include "platform/render/poi_pass.h"
#include "platform/render/quality.h"
#include "platform/render/textures.h"
#include "platform/render/specimen_pass.h"
#include "platform/render/ui.h"

#define RENDERER_WIDTH_MAX 8192u /* Of a picture that can be read back: twice 4K. */

struct renderer_config {
    uint32_t width, height; /* Pixels, > 0. */
    float scene_scale;      /* As struct display_gl_config. */
    uint32_t samples;
    const struct shelf *shelf; /* Makers' species; null: none. Stays where it is while it draws. */
};

/* The steps of a frame, for whoever measures them. */
enum render_step {
    STEP_PREPARE = 0, /* Sorting and uploads. */
    STEP_LIGHT,       /* Caustics and shadows. */
    STEP_GROUND,      /* Floor and walls. */
    STEP_LIFE,        /* Fish, and what of poi and bowl is under water. */
    STEP_SURFACE,     /* The water. */
    STEP_ABOVE,       /* Bowls, rim and counter, pois and fish out of the water. */
    STEP_UI,
    STEP_COUNT,
};

struct renderer {
    struct gl_status status;
    struct renderer_config config; /* Its size follows the window. */
    struct showing showing;
    struct placing placing;        /* Of the picture, on a screen of that size. */
    struct quality quality;
    uint32_t step;                 /* Of quality_lower(). */
    uint32_t samples_max, side_max; /* Of this context. */
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
    struct gl_target screen; /* Only with multisampling; else the default framebuffer itself. */
    uint8_t row[RENDERER_WIDTH_MAX * 4u]; /* One row on its way to a captured image. */
    /* Called after each step, when set: a bench puts glFinish() and a clock there. */
    void (*on_step)(void *context, enum render_step step);
    void *on_step_context;
};

/* Makes every program, texture and buffer. HAL_ERR_GONE: renderer_error() says why. */
int renderer_open(struct renderer *renderer, const struct renderer_config *config);
void renderer_close(struct renderer *renderer);

/* Follows the window; free when nothing changed. HAL_ERR_GONE when the new targets fail. */
int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height);

/* How the picture lies on the screen from now on; at first it fills it. Copied. */
void renderer_place(struct renderer *renderer, const struct showing *showing);

/* Draws so many steps of quality_lower() coarser from now on; free when nothing changed.
 * HAL_ERR_GONE when the new targets fail. */
int renderer_lower(struct renderer *renderer, uint32_t step);

/* Draws into the default framebuffer and leaves the swap to the caller. */
void renderer_draw(struct renderer *renderer, const struct scene *scene);

/* Copies the default framebuffer, top row first; before a swap. HAL_ERR_IO: `image` is too small.
 */
int renderer_read(struct renderer *renderer, struct hal_image *image);

/* False once OpenGL has reported a lost device or memory; renderer_error() says which. */
bool renderer_is_alive(struct renderer *renderer);

const char *renderer_error(const struct renderer *renderer);

/* "OpenGL ES 3.2 llvmpipe, 1280x720, scene 0.75x, floor 0.5x" */
void renderer_describe(const struct renderer *renderer, char *out, size_t size);

#endif
