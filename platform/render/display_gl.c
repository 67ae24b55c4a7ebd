/* display_gl.c -- manages the window, the OpenGL context and the window events. renderer.c draws
 * the picture. */
#include "platform/render/display_gl.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/base/panic.h"
#include "core/game/lab/lab_layout.h"
#include "platform/os/clock.h"
#include "platform/render/screen.h"

#define WINDOW_WIDTH 1280
#define WINDOW_HEIGHT 720
/* Interval in ns between two checks whether a screen was plugged in or unplugged. One check takes
 * 40 microseconds. */
#define CONNECTOR_PERIOD_NS 1000000000ull
#define CONNECTOR_READS 2u
/* Number of frames that are drawn before the growth lab or the album is captured as a picture.
 * During these frames, the renderer finishes painting the fish at full resolution. */
#define PAINT_DRAWS 20u

static int display_gl_fail(struct display_gl *display, const char *what, const char *why)
{
    CORE_ASSERT(what && why);
    snprintf(display->text, sizeof display->text, "no picture: %s: %s", what, why);
    return HAL_ERR_GONE;
}

static void on_broken(void *context)
{
    struct display_gl *const display = context;
    display_gl_fail(display, "screen", "the connection to the X server broke");
    display->lost = true;
    if (!display->broken && display->on_lost) {
        display->broken = true;
        display->on_lost(display->on_lost_context);
    }
    display->broken = true;
}

/* Releases all resources, so that the next open() after HAL_ERR_GONE creates them again. */
static void display_gl_release(struct display_gl *display)
{
    if (display->context && !display->broken) {
        renderer_close(&display->renderer);
        SDL_GL_DeleteContext(display->context);
    }
    if (display->window && !display->broken) {
        SDL_DestroyWindow(display->window);
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    display->context = NULL;
    display->window = NULL;
    display->has_shown = false;
}

static uint64_t display_gl_now_ns(void)
{
    const struct hal_clock clock = clock_device();
    return clock.ops->now_ns(clock.self);
}

static int create_window(struct display_gl *display)
{
    const struct display_gl_config *const config = &display->config;
    const int width = config->width ? (int)config->width : WINDOW_WIDTH;
    const int height = config->height ? (int)config->height : WINDOW_HEIGHT;
    Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    if (config->full_screen && !config->off_screen) {
        flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    }
    if (config->off_screen) {
        SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
    }
    screen_card_prefer();
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        return display_gl_fail(display, "SDL video cannot start", SDL_GetError());
    }
    /* SDL may choose a video driver without a visible picture ("offscreen" or "dummy"), for example
     * if the window system has stopped. Such a driver is accepted only if `off_screen` or the
     * environment variable SDL_VIDEODRIVER requests it. */
    const char *driver = SDL_GetCurrentVideoDriver();
    if (!display->config.off_screen && !SDL_getenv("SDL_VIDEODRIVER") && driver &&
        (strcmp(driver, "offscreen") == 0 || strcmp(driver, "dummy") == 0)) {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        return display_gl_fail(display, "no screen is available",
                               "SDL offers only a video driver without a picture");
    }
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    display->window =
        SDL_CreateWindow(config->title ? config->title : "Kingyo", SDL_WINDOWPOS_CENTERED,
                         SDL_WINDOWPOS_CENTERED, width, height, flags);
    if (!display->window) {
        const int error = display_gl_fail(display, "SDL cannot open a window", SDL_GetError());
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        return error;
    }
    if (!config->off_screen) {
        /* An off-screen picture has exactly the requested size, without the minimum size of a
         * window. */
        SDL_SetWindowMinimumSize(display->window, HAL_WINDOW_WIDTH_MIN, HAL_WINDOW_HEIGHT_MIN);
    }
    display->full_screen = (flags & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    return HAL_OK;
}

/* Draws the next artificial picture. Returns true on success. */
static bool draw_warm_up(struct display_gl *display)
{
    return renderer_warm_up(&display->renderer, &display->shown, display->warm_ups++) == HAL_OK;
}

static int create_context(struct display_gl *display)
{
    display->context = SDL_GL_CreateContext(display->window);
    if (!display->context) {
        return display_gl_fail(display, "no OpenGL ES 3.0 context", SDL_GetError());
    }
    if (SDL_GL_SetSwapInterval(display->config.off_screen ? 0 : 1) != 0) {
        SDL_ClearError(); /* Some drivers do not support a swap interval. For these drivers, the
                             frame loop limits the frame rate. */
    }
    int width = 0;
    int height = 0;
    SDL_GL_GetDrawableSize(display->window, &width, &height);
    const struct renderer_config wanted = {
        .width = (uint32_t)width,
        .height = (uint32_t)height,
        .scene_scale = display->config.scene_scale,
        .samples = display->config.samples,
        .library = display->config.library,
    };
    bool is_good = renderer_open(&display->renderer, &wanted) == HAL_OK;
    /* A single picture needs only few of the programs. */
    display->warm_ups = display->config.off_screen ? RENDERER_WARM_UPS : 0;
    /* The watchdog waits long for the first frame, but not for later frames. If the game already
     * runs, each of the next frames draws one artificial picture. */
    while (is_good && !display->has_frames && display->warm_ups < RENDERER_WARM_UPS) {
        is_good = draw_warm_up(display);
    }
    if (!is_good) {
        return display_gl_fail(display, "renderer", display->renderer.status.text);
    }
    if (display->is_placed) {
        renderer_place(&display->renderer, &display->display_settings);
    }
    return HAL_OK;
}

/* Reports the frame time and the temperature to the quality governor, which may lower or raise the
 * picture's quality. Called after each frame. */
static int report_to_governor(struct display_gl *display, const struct scene *scene)
{
    const uint32_t measured = atomic_load(&display->thermal.measured_count);
    if (!display->is_governed || display->renderer.transform.light <= 0.0f) {
        /* The picture is black during the configured night hours. A black picture costs nothing to
         * draw, so its frame time would mislead the quality governor. */
        return HAL_OK;
    }
    if (measured != display->heat_count) {
        display->heat_count = measured;
        quality_governor_set_temperature(&display->governor,
                                         atomic_load(&display->thermal.margin_mdeg));
    }
    const bool may_refine = scene->phase == PHASE_ATTRACT || scene->phase == PHASE_MENU;
    const uint32_t step =
        quality_governor_frame(&display->governor, display_gl_now_ns(), may_refine);
    if (step == display->renderer.step) {
        return HAL_OK;
    }
    if (renderer_lower(&display->renderer, step) != HAL_OK) {
        return display_gl_fail(display, "quality", display->renderer.status.text);
    }
    renderer_describe(&display->renderer, display->text, sizeof display->text);
    return HAL_OK;
}

static int display_open(void *self)
{
    struct display_gl *const display = self;
    display_gl_release(display);
    display->lost = display->broken = false;
    const char *const env = SDL_getenv("SDL_VIDEODRIVER");
    display->is_bare = !display->config.off_screen && env && strcasecmp(env, "kmsdrm") == 0;
    display->plugged = screen_connectors(display->config.sockets);
    display->connectors_read_ns = display_gl_now_ns();
    display->changed_reads = 0;
    if (display->is_bare && display->plugged.count > 0 && display->plugged.connected == 0) {
        /* The function returns before it initializes SDL, because SDL takes long to detect that no
         * screen is connected. */
        display->lost = true;
        return display_gl_fail(display, "screen",
                               "no screen is connected; the kiosk checks once a second");
    }
    int error = create_window(display);
    if (error == HAL_OK) {
        screen_guard_x11(display->window, on_broken, display);
        error = create_context(display);
    }
    if (error != HAL_OK) {
        display_gl_release(display);
        display->lost = true;
        return error;
    }
    const char *driver = SDL_GetCurrentVideoDriver();
    display->is_bare = driver && strcasecmp(driver, "kmsdrm") == 0;
    renderer_describe(&display->renderer, display->text, sizeof display->text);
    /* The quality governor does not run in two cases: for off-screen pictures, which must be
     * identical on every machine, and if the configuration sets the scene scale or the samples,
     * because these values must not change. */
    const struct display_gl_config *const config = &display->config;
    SDL_DisplayMode mode = { 0 };
    display->is_governed =
        !config->off_screen && config->scene_scale <= 0.0f && config->samples == 0;
    if (display->is_governed) {
        SDL_GetCurrentDisplayMode(SDL_GetWindowDisplayIndex(display->window), &mode);
        quality_governor_begin(&display->governor,
                               mode.refresh_rate > 0 ? (uint32_t)mode.refresh_rate : 0);
        thermal_start(&display->thermal);
    }
    return HAL_OK;
}

/* Closes the display if the set of connectors with a screen has changed, because drawing on an
 * absent screen could block. The change must persist in CONNECTOR_READS consecutive reads,
 * because the contacts of a plug close and open several times while the plug is pushed in. */
static void watch_plugs(struct display_gl *display)
{
    const uint64_t now = display_gl_now_ns();
    if (!display->is_bare || now - display->connectors_read_ns < CONNECTOR_PERIOD_NS) {
        return;
    }
    display->connectors_read_ns = now;
    const struct connectors plugged = screen_connectors(display->config.sockets);
    const bool is_other = plugged.count > 0 && plugged.which != display->plugged.which;
    display->changed_reads = (uint8_t)(is_other ? display->changed_reads + 1u : 0u);
    if (display->changed_reads >= CONNECTOR_READS) {
        display_gl_release(display);
        display_gl_fail(display, "screen",
                        plugged.connected ? "a different screen was connected"
                                          : "the screen was unplugged");
        display->lost = true;
    }
}

/* Removes SDL's window and quit events from SDL's queue. All other events stay in the queue for the
 * drivers of other devices. */
static int display_poll(void *self, struct display_events *out)
{
    struct display_gl *const display = self;
    *out = (struct display_events){ 0 };
    if (!display->lost && display->window) {
        watch_plugs(display);
    }
    if (display->lost || !display->window) {
        out->lost = display->broken;
        return HAL_ERR_GONE;
    }
    SDL_PumpEvents();
    SDL_Event event;
    while (SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_QUIT, SDL_QUIT) > 0) {
        out->quit = 1;
    }
    while (SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_WINDOWEVENT, SDL_WINDOWEVENT) > 0) {
        if (event.window.event == SDL_WINDOWEVENT_CLOSE) {
            out->quit = 1;
        }
    }
    const struct display_transform *const drawn = &display->renderer.transform;
    out->upright = drawn->width < POINTER_UPRIGHT_ASPECT * drawn->height;
    /* `broken` is read after SDL_PumpEvents(), because this call may detect that the connection to
     * the X server broke. */
    out->lost = display->broken;
    return display->lost ? HAL_ERR_GONE : HAL_OK;
}

static int follow_size(struct display_gl *display)
{
    int width = 0;
    int height = 0;
    SDL_GL_GetDrawableSize(display->window, &width, &height);
    if ((SDL_GetWindowFlags(display->window) & SDL_WINDOW_MINIMIZED) || width <= 0 || height <= 0) {
        /* The window is minimized or empty and has no area to draw on, which is not an error. */
        return HAL_ERR_BUSY;
    }
    const struct renderer_config *const drawn = &display->renderer.config;
    if (drawn->width == (uint32_t)width && drawn->height == (uint32_t)height) {
        return HAL_OK;
    }
    if (renderer_resize(&display->renderer, (uint32_t)width, (uint32_t)height) != HAL_OK) {
        return display_gl_fail(display, "resize", display->renderer.status.text);
    }
    renderer_describe(&display->renderer, display->text, sizeof display->text);
    return HAL_OK;
}

static int display_present(void *self, const struct scene *scene)
{
    struct display_gl *const display = self;
    display->has_frames = true;
    if (display->lost || !display->context) {
        return HAL_ERR_GONE;
    }
    const int error = follow_size(display);
    if (error != HAL_OK) {
        return error;
    }
    if (display->warm_ups < RENDERER_WARM_UPS && !draw_warm_up(display)) {
        display->lost = true;
        return display_gl_fail(display, "frame", display->renderer.status.text);
    }
    display->shown = *scene;
    display->has_shown = true;
    if (display->config.on_demand) {
        ui_screens_notice(&display->renderer.ui.memory, scene);
        return HAL_OK;
    }
    renderer_draw(&display->renderer, scene);
    SDL_GL_SwapWindow(display->window);
    if (!display->lost && !renderer_is_alive(&display->renderer)) {
        display_gl_fail(display, "frame", display->renderer.status.text);
        display->lost = true;
    }
    if (!display->lost && report_to_governor(display, scene) != HAL_OK) {
        display->lost = true;
    }
    return display->lost ? HAL_ERR_GONE : HAL_OK;
}

static void display_set_transform(void *self, const struct display_settings *display_settings)
{
    struct display_gl *const display = self;
    display->display_settings = *display_settings;
    display->is_placed = true;
    if (display->context && !display->lost) {
        renderer_place(&display->renderer, display_settings);
    }
}

static int display_toggle_full_screen(void *self)
{
    struct display_gl *const display = self;
    if (display->lost || !display->window) {
        return HAL_ERR_GONE;
    }
    const Uint32 mode = display->full_screen ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP;
    if (SDL_SetWindowFullscreen(display->window, mode) != 0) {
        return HAL_ERR_IO;
    }
    display->full_screen = !display->full_screen;
    return HAL_OK;
}

static int display_capture(void *self, struct hal_image *image)
{
    struct display_gl *const display = self;
    if (display->lost || !display->context) {
        return HAL_ERR_GONE;
    }
    if (!display->has_shown) {
        return HAL_ERR_IO;
    }
    /* If pictures are drawn only on demand, the growth lab or the album is drawn PAINT_DRAWS times.
     * After these draws, the fish textures are painted at full resolution. */
    const uint8_t phase = display->shown.phase;
    const bool paints = display->config.on_demand && (phase == PHASE_LAB || phase == PHASE_ALBUM);
    for (uint32_t i = 0; i < (paints ? PAINT_DRAWS : 1u); i++) {
        renderer_draw(&display->renderer, &display->shown);
    }
    return renderer_read(&display->renderer, image);
}

static void display_close(void *self)
{
    struct display_gl *const display = self;
    thermal_stop(&display->thermal);
    display_gl_release(display);
}

static const char *display_describe(void *self)
{
    const struct display_gl *const display = self;
    return display->text[0] ? display->text : "no picture: not opened";
}

struct hal_display display_gl_device(struct display_gl *display)
{
    CORE_ASSERT(display);
    static const struct hal_display_ops ops = {
        .open = display_open,
        .poll = display_poll,
        .present = display_present,
        .set_transform = display_set_transform,
        .toggle_full_screen = display_toggle_full_screen,
        .capture = display_capture,
        .close = display_close,
        .describe = display_describe,
    };
    return (struct hal_display){ .ops = &ops, .self = display };
}

void display_gl_on_lost(struct display_gl *display, void (*hook)(void *context), void *context)
{
    display->on_lost = hook;
    display->on_lost_context = context;
}
