/* display_gl.h -- the display of a real kiosk: an SDL2 window with an OpenGL ES 3.0 context.
 *
 * The caller owns `struct display_gl` (about 1.4 MiB: keep it static), fills `config` and leaves
 * the rest zero. open() makes all OpenGL objects, so that a frame allocates nothing in our code.
 * Mouse and key events stay in SDL's queue for the drivers that read them. */
#ifndef KINGYO_PLATFORM_RENDER_DISPLAY_GL_H
#define KINGYO_PLATFORM_RENDER_DISPLAY_GL_H

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#include "platform/hal.h"
#include "platform/render/connectors.h"
#include "platform/render/governor.h"
#include "platform/render/renderer.h"
#include "platform/thermal.h"

/* Configuration of the display. Zero is a valid value of every field. */
struct display_gl_config {
    uint32_t width, height; /* Window size in points; 0: 1280x720, or the whole screen if
                               full_screen. */
    bool full_screen;
    bool off_screen;   /* Uses SDL's offscreen driver, without a window system. */
    bool on_demand;    /* Draws nothing until a picture is captured; for `off_screen`. */
    const char *title; /* Window title; null: "Kingyo". */
    float scene_scale; /* Scene pixels per screen pixel and axis, [0.25, 2]; 0: chosen by renderer
                          (quality.h). */
    uint32_t samples;  /* Multisampling; 0: chosen by renderer. */
    const struct library *library; /* Makers' species, as in struct renderer_config. */
    const char *sockets;           /* Directory of the kernel's connectors; null: /sys/class/drm. */
};

struct display_gl {
    struct display_gl_config config;
    SDL_Window *window;
    SDL_GLContext context;
    struct renderer renderer;
    struct scene shown; /* Last scene shown. capture() draws it again because a swap destroys the
                           back buffer. */
    struct display_settings display_settings; /* Display geometry, also for the next screen. */
    bool has_shown, full_screen, is_placed;
    bool lost;    /* The display shows nothing any more. open() starts it again. */
    bool broken;  /* The connection to an X server broke. No further call may use it. */
    bool is_bare; /* No window system: SDL draws on the card itself. */
    struct connectors plugged; /* Connectors at the time of opening. */
    uint64_t looked_ns;        /* Time of the last read of the connectors. */
    uint8_t changed_looks;     /* Consecutive reads in which the connectors differed from
                                  `plugged`. */
    void (*on_lost)(void *context);
    void *on_lost_context;
    struct governor governor;
    struct thermal thermal;
    uint32_t heat_looks; /* Number of the thermal thread's measurements that the governor has
                            received. */
    bool is_governed;    /* The governor chooses the picture's quality. */
    char text[HAL_TEXT_SIZE];
};

struct hal_display display_gl_device(struct display_gl *display);

/* Registers `hook`, which is called when an X11 connection breaks, from inside the SDL or OpenGL
 * call that detected it. Without our handler Xlib ends the process there. The next poll() also
 * reports `lost`, and an X server that is gone cannot be opened again.
 *
 * A screen that is unplugged, or whose driver has reset, causes HAL_ERR_GONE instead. open() finds
 * it again. */
void display_gl_on_lost(struct display_gl *display, void (*hook)(void *context), void *context);

#endif
