/* display_gl.h -- the display of a real stall: an SDL2 window with an OpenGL ES 3.0 context.
 *
 * The caller owns `struct display_gl` (about 1.4 MiB: keep it static), fills `config` and leaves
 * the rest zero. All OpenGL objects are made in open(); a frame allocates nothing in our code.
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

/* Zero is a sensible value of every field. */
struct display_gl_config {
    uint32_t width, height; /* Of the window, in points; 0: 1280x720, or all when full. */
    bool full_screen;
    bool off_screen;   /* No window system at all: SDL's offscreen driver. */
    bool on_demand;    /* Draws nothing until a picture is captured; for `off_screen`. */
    const char *title; /* 0: "Kingyo". */
    float scene_scale; /* [0.25, 2]; 0: by renderer (quality.h). */
    uint32_t samples;  /* Multisampling; 0: by renderer. */
    const struct shelf *shelf; /* As renderer_config's. */
    const char *sockets; /* Where the kernel tells of screens; 0: /sys/class/drm. */
};

struct display_gl {
    struct display_gl_config config;
    SDL_Window *window;
    SDL_GLContext context;
    struct renderer renderer;
    struct scene shown; /* What capture() draws again: the back buffer is gone after a swap. */
    struct showing showing; /* How it lies on the screen; also on the next one. */
    bool has_shown, full_screen, is_placed;
    bool lost;   /* It shows nothing any more; open() begins anew. */
    bool broken; /* The connection to an X server broke; nothing may touch it again. */
    bool is_bare; /* No window system: SDL draws on the card itself. */
    struct connectors plugged; /* As they were when it was opened, ... */
    uint64_t looked_ns;        /* ... and when they were looked at last. */
    uint8_t changed_looks;     /* Looks in a row at which they were others. */
    void (*on_lost)(void *context);
    void *on_lost_context;
    struct governor governor;
    struct thermal thermal;
    uint32_t heat_looks; /* Of the thermal thread's, those that the governor heard of. */
    bool is_governed;    /* The picture's quality is ours to choose. */
    char text[HAL_TEXT_SIZE];
};

struct hal_display display_gl_device(struct display_gl *display);

/* A screen that is pulled out of the card, or of which the driver has reset, is HAL_ERR_GONE, and
 * found again by open(). An X server that goes is the end.
 *
 * Calls `hook` at the moment when an X11 connection breaks, from inside whichever SDL or OpenGL
 * call noticed. Without our handler Xlib would end the process there. The next poll() says `lost`
 * too. */
void display_gl_on_lost(struct display_gl *display, void (*hook)(void *context), void *context);

#endif
