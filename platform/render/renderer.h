/* renderer.h -- draws one scene (the data that the core provides for a picture). renderer.c alone
 * defines the order of drawing in a frame. renderer_open.c creates all objects.
 *
 * The renderer requires a current OpenGL ES 3.0 context and does not use SDL. The picture depends
 * only on the scene, the size, and the earlier camera whose picture of the rim and the counter is
 * kept (basin_pass.h). Drawing a scene twice on one machine with the same earlier camera therefore
 * produces the same pixels. */
#pragma once

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/render/frame_block.h"
#include "platform/render/pass/basin_pass.h"
#include "platform/render/pass/bowl_pass.h"
#include "platform/render/pass/fish_pass.h"
#include "platform/render/pass/hand_pass.h"
#include "platform/render/pass/light_pass.h"
#include "platform/render/pass/poi_pass.h"
#include "platform/render/pass/quad_pass.h"
#include "platform/render/pass/specimen_pass.h"
#include "platform/render/quality.h"
#include "platform/render/textures.h"
#include "platform/render/ui/ui.h"

/* Maximum width in pixels of a picture that can be read back, twice the width of 4K. */
#define RENDERER_WIDTH_MAX 8192u

struct renderer_config {
    uint32_t width, height; /* Picture size in pixels, > 0. */
    /* Width of the underwater scene's picture divided by the width of the screen, as in struct
     * display_gl_config. */
    float scene_scale;
    /* Number of multisampling samples. 0 means that the renderer chooses the number. */
    uint32_t samples;
    /* Library of the species that users have drawn. Null means no library. The library must stay
     * valid and at the same address while the renderer is open. */
    const struct library *library;
};

/* Steps in which a frame is drawn. A benchmark can measure the duration of each step. */
enum render_step {
    STEP_PREPARE = 0, /* Sorting of the fish, and uploads of the data of this frame. */
    STEP_LIGHT,       /* Caustics and shadows. */
    STEP_GROUND,      /* Floor and walls. */
    STEP_LIFE,        /* Fish, and the parts of pois and bowls that are below the water surface. */
    STEP_SURFACE,     /* Water surface. */
    /* Bowls, rim of the tank, table around the tank, and the pois and fish that are above the
     * water. */
    STEP_ABOVE,
    STEP_UI,
    STEP_COUNT,
};

struct renderer {
    struct gl_status status;
    /* Configuration of the renderer. The fields `width` and `height` follow the window size. */
    struct renderer_config config;
    struct display_settings display_settings;
    /* Rotation, position and size of the picture on a screen of the current size. */
    struct display_transform transform;
    struct quality quality;
    /* Current quality step, which is the argument `step` of quality_lower(). */
    uint32_t step;
    /* Limits of the OpenGL context: the maximum number of samples, and the maximum side of a render
     * target in pixels. */
    uint32_t samples_max, side_max;
    char gl_name[HAL_TEXT_SIZE / 2];
    struct frame frame;
    struct textures textures;
    struct light_pass light;
    struct basin_pass basin;
    struct fish_pass fish;
    struct poi_pass poi;
    struct hand_pass hand;
    struct bowl_pass bowl;
    struct quad_pass quad;
    struct specimen_pass specimens;
    struct ui ui;
    /* Width and height in pixels of the complete picture of the underwater scene. The targets
     * `ground`, `life` and `mirror` have only the part `part` of the picture. */
    uint32_t below_px[2];
    /* Width and height in pixels of the picture above the water, without its words. The target
     * `deck` has an additional margin. */
    uint32_t screen_px[2];
    struct frame_part part;
    struct gl_target ground, life, mirror, deck;
    /* Render target for the screen, if the picture is multisampled or smaller than the screen.
     * Otherwise its framebuffer is 0, the default framebuffer. */
    struct gl_target screen;
    /* Buffer of one pixel row, used to read back a captured image. */
    uint8_t row[RENDERER_WIDTH_MAX * 4u];
    /* Optional callback after each step. A benchmark calls glFinish() in the callback and reads a
     * clock. */
    void (*on_step)(void *context, enum render_step step);
    void *on_step_context;
};

/* Creates all programs, textures and buffers. Returns HAL_OK, or HAL_ERR_GONE on failure. After a
 * failure, `status` contains the reason. */
int renderer_open(struct renderer *renderer, const struct renderer_config *config);
void renderer_close(struct renderer *renderer);

/* Number of artificial pictures in which every shader program is used. */
#define RENDERER_WARM_UPS 4u

/* Draws one of the artificial pictures, so that the driver compiles the programs now and not in a
 * frame of the game. Overwrites `scratch` and the picture. Returns HAL_OK, or HAL_ERR_GONE on
 * failure. After a failure, `status` contains the reason. */
int renderer_warm_up(struct renderer *renderer, struct scene *scratch, uint32_t picture);

/* Adapts the render targets to the window size. Does nothing if the size did not change. Returns
 * HAL_ERR_GONE if the new targets cannot be created. */
int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height);

/* Sets the rotation, margins and brightness of all later pictures. Before the first call, the
 * picture fills the screen. `display_settings` is copied. */
void renderer_place(struct renderer *renderer, const struct display_settings *display_settings);

/* Sets the number of quality steps below the best quality (quality_lower()) for all later pictures.
 * Does nothing if the step did not change. Returns HAL_ERR_GONE if the new targets cannot be
 * created. */
int renderer_lower(struct renderer *renderer, uint32_t step);

/* Creates the render targets for the objects below the water again if the visible part of the water
 * (renderer->frame.part) has changed. Must be called after frame_begin(). After a failure, `status`
 * contains the reason. */
void renderer_fit_below(struct renderer *renderer);

/* Draws the scene into the default framebuffer. The caller swaps the buffers. */
void renderer_draw(struct renderer *renderer, const struct scene *scene);

/* Copies the default framebuffer to `image`, with the top row first. Must be called before a buffer
 * swap. Returns HAL_OK, or HAL_ERR_IO if `image` is too small or the picture is wider than
 * RENDERER_WIDTH_MAX. */
int renderer_read(struct renderer *renderer, struct hal_image *image);

/* Returns false after OpenGL has reported a lost device or a lack of memory. After that,
 * `status` contains the reason. */
bool renderer_is_alive(struct renderer *renderer);

/* Writes a description such as "OpenGL ES 3.2 llvmpipe, 1280x720, scene 0.75x, floor 0.5x". */
void renderer_describe(const struct renderer *renderer, char *out, size_t size);
