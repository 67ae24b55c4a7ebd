/* display_gl.h -- the display of a real kiosk: an SDL2 window with an OpenGL ES 3.0 context.
 *
 * The caller owns `struct display_gl` (about 1.6 MiB, so it must be static), fills `config` and
 * sets all other fields to zero. open() creates all OpenGL objects, so that drawing a frame
 * allocates no memory in this program's code. Mouse and key events stay in SDL's queue for the
 * drivers that read them. */
#pragma once

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/hal.h"
#include "platform/render/screen.h"
#include "platform/render/quality.h"
#include "platform/render/renderer.h"
#include "platform/thermal.h"

/* Configuration of the display. Zero means the default value of a field. */
struct display_gl_config {
    /* Window size in points. 0 means 1280x720, or the whole screen if `full_screen` is true. */
    uint32_t width, height;
    bool full_screen;
    bool off_screen; /* True to use SDL's offscreen driver, which needs no window system. */
    /* True to draw only when a picture is captured. Callers set this field only together with
     * `off_screen`. */
    bool on_demand;
    const char *title; /* Window title. Null means "Kingyo". */
    /* Width of the underwater scene's picture in pixels, divided by the width of the screen in
     * pixels, [0.25, 2]. The same ratio applies to the height. 0 means that the renderer chooses
     * the ratio (quality.h). */
    float scene_scale;
    /* Number of multisampling samples. 0 means that the renderer chooses the number. */
    uint32_t samples;
    /* Library of the species that users have drawn, as in struct renderer_config. Null means no
     * library. */
    const struct library *library;
    /* Directory in which the kernel lists the display connectors. Null means /sys/class/drm. */
    const char *sockets;
};

struct display_gl {
    struct display_gl_config config;
    SDL_Window *window;
    SDL_GLContext context;
    struct renderer renderer;
    /* Scene that was shown last. capture() draws this scene again, because a buffer swap destroys
     * the drawn picture. */
    struct scene shown;
    /* Rotation, margins and brightness of the picture. These settings are kept when a lost screen
     * is replaced. */
    struct display_settings display_settings;
    bool has_shown, full_screen, is_placed;
    /* True after the screen was lost. The display then shows nothing until open() restarts the
     * display. */
    bool lost;
    /* True after the connection to an X server broke. No later call may use the connection. */
    bool broken;
    /* True if SDL draws directly on the graphics card because no window system runs. */
    bool is_bare;
    /* True after the first frame of the game, which may have found no screen. */
    bool has_frames;
    uint32_t warm_ups; /* Number of artificial pictures that were drawn (renderer_warm_up()). */
    struct connectors plugged; /* Connectors that had a screen when the display was opened. */
    /* Time of the last read of the connectors, in ns of the monotonic clock. */
    uint64_t connectors_read_ns;
    /* Number of consecutive reads in which the connectors with a screen differed from `plugged`. */
    uint8_t changed_reads;
    void (*on_lost)(void *context);
    void *on_lost_context;
    struct governor governor;
    struct thermal thermal;
    /* Value of the counter `thermal.measured_count` (number of temperature measurements) when
     * the governor last received a temperature. */
    uint32_t heat_count;
    /* True while the quality governor (quality.h) chooses the picture's quality. */
    bool is_governed;
    char text[HAL_TEXT_SIZE];
};

struct hal_display display_gl_device(struct display_gl *display);

/* Registers `hook`, which is called with `context` when the connection to the X server breaks. A
 * null `hook` means that no function is called. The call comes from inside the SDL or OpenGL
 * function that detected the break. Without this module's error handler (screen_guard_x11()), Xlib
 * would end the process there. The next poll() also reports `lost`. After the break, this process
 * cannot connect to the X server again.
 *
 * In contrast, an unplugged screen or a reset of the graphics driver causes HAL_ERR_GONE. A later
 * open() succeeds when the screen is available again. */
void display_gl_on_lost(struct display_gl *display, void (*hook)(void *context), void *context);
