/* screen.c -- opens the window or the full screen, and detects whether there is a screen. */
#include <SDL.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "board/desktop/parts.h"
#include "core/base/panic.h"
#include "drivers/null.h"
#include "platform/render/display_gl.h"
#include "platform/render/screen.h"

static struct {
    struct display_gl display;
    char text[HAL_TEXT_SIZE];
} devices;

void screen_ignore(const uint32_t *types, size_t count)
{
    CORE_ASSERT(types);
    for (size_t i = 0; i < count; i++) {
        SDL_EventState(types[i], SDL_IGNORE);
    }
}

void screen_open(struct hal *hal, const struct board_options *options)
{
    /* clang-format off */
    static const Uint32 foreign[] = {
        SDL_DOLLARGESTURE,    SDL_DOLLARRECORD,       SDL_MULTIGESTURE,   SDL_CLIPBOARDUPDATE,
        SDL_DROPFILE,         SDL_DROPTEXT,           SDL_DROPBEGIN,      SDL_DROPCOMPLETE,
        SDL_DISPLAYEVENT,     SDL_AUDIODEVICEADDED,   SDL_AUDIODEVICEREMOVED, SDL_SYSWMEVENT,
        SDL_LOCALECHANGED,    SDL_RENDER_TARGETS_RESET, SDL_RENDER_DEVICE_RESET,
    };
    /* clang-format on */
    CORE_ASSERT(hal && options);
    struct display_gl *display = &devices.display;
    display->config = (struct display_gl_config){
        .width = options->width,
        .height = options->height,
        .scene_scale = 0.01f * (float)options->detail,
        .full_screen = options->full_screen != 0,
        .off_screen = options->off_screen != 0,
        .on_demand = options->on_demand != 0,
        .title = "Kingyo",
        .library = options->library,
    };
    display_gl_on_lost(display, options->on_display_lost, options->on_display_lost_self);
    hal->display = display_gl_device(display);
    /* The event subsystem is started separately, because SDL's event queue must outlive a display
     * that is lost and opened again. */
    SDL_InitSubSystem(SDL_INIT_EVENTS);
    /* SDL drops events that no driver reads. Such events would fill SDL's queue during a long day.
     * A full queue drops later events, for example the click that closes the window. */
    screen_ignore(foreign, sizeof foreign / sizeof foreign[0]);
    if (hal->display.ops->open(display) != HAL_OK && !options->waits_for_screen) {
        snprintf(devices.text, sizeof devices.text, "%.*s", (int)sizeof devices.text - 1,
                 hal->display.ops->describe(display));
        hal->display = null_hal(devices.text).display;
    }
}

/* Returns true if the kernel has a graphics card (/dev/dri/card*). Without a graphics
 * card SDL is not called, because its libraries would write errors to standard error. */
static bool has_graphics_card(void)
{
    char path[32];
    for (int i = 0; i < 16; i++) {
        snprintf(path, sizeof path, "/dev/dri/card%d", i);
        if (access(path, F_OK) == 0) {
            return true;
        }
    }
    return false;
}

static bool is_variable_set(const char *name)
{
    const char *value = getenv(name);
    return value && value[0];
}

bool board_has_screen(char *why, size_t why_size)
{
    const bool has_windows = is_variable_set("DISPLAY") || is_variable_set("WAYLAND_DISPLAY");
    if (!has_windows && !is_variable_set("SDL_VIDEODRIVER") && !has_graphics_card()) {
        snprintf(why, why_size,
                 "neither DISPLAY nor WAYLAND_DISPLAY is set, and there is no "
                 "graphics card");
        return false;
    }
    screen_card_prefer();
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        snprintf(why, why_size, "%s (SDL: %s)",
                 has_windows ? "the display does not respond" : "no screen is plugged in",
                 SDL_GetError());
        return false;
    }
    const char *driver = SDL_GetCurrentVideoDriver();
    const bool shows = driver && strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0;
    if (!shows) {
        snprintf(why, why_size, "%s (SDL fell back to '%s')",
                 has_windows ? "the display does not respond" : "no screen is plugged in",
                 driver ? driver : "nothing");
    }
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return shows;
}
