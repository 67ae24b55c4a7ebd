/* board.c -- the desktop: a window, a mouse for a poi, keys for buttons, what sound and disk
 * there is.
 *
 * The one place that knows every driver, and the one home of their state. */
#include "platform/board.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "drivers/buttons_keyboard.h"
#include "drivers/null.h"
#include "drivers/poi_mouse.h"
#include "platform/audio.h"
#include "platform/clock.h"
#include "platform/render/display_gl.h"
#include "platform/storage.h"
#include "platform/watchdog.h"

static struct {
    struct display_gl display;
    struct poi_mouse mouse;
    struct buttons_keyboard keyboard;
    struct audio audio;
    struct storage storage;
    struct watchdog watchdog;
    char display_text[HAL_TEXT_SIZE];
} devices;

static void ignore_events(const Uint32 *types, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        SDL_EventState(types[i], SDL_IGNORE);
    }
}

/* Events that no driver takes would fill SDL's queue over a long day, and a full queue drops what
 * comes next: the click that closes the window. */
static void ignore_foreign_events(void)
{
    static const Uint32 foreign[] = {
        SDL_FINGERDOWN,       SDL_FINGERUP,          SDL_FINGERMOTION,    SDL_DOLLARGESTURE,
        SDL_DOLLARRECORD,     SDL_MULTIGESTURE,      SDL_CLIPBOARDUPDATE, SDL_DROPFILE,
        SDL_DROPTEXT,         SDL_DROPBEGIN,         SDL_DROPCOMPLETE,    SDL_DISPLAYEVENT,
        SDL_AUDIODEVICEADDED, SDL_AUDIODEVICEREMOVED, SDL_SYSWMEVENT,     SDL_LOCALECHANGED,
        SDL_RENDER_TARGETS_RESET, SDL_RENDER_DEVICE_RESET,
    };
    ignore_events(foreign, sizeof foreign / sizeof foreign[0]);
}

/* In the bot's stall nobody takes what the mouse says. */
static void ignore_mouse_events(void)
{
    static const Uint32 mouse[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                    SDL_MOUSEWHEEL };
    ignore_events(mouse, sizeof mouse / sizeof mouse[0]);
}

static void open_display(struct hal *hal, const struct board_options *options)
{
    struct display_gl *display = &devices.display;
    display->config = (struct display_gl_config){
        .width = options->width,
        .height = options->height,
        .full_screen = options->full_screen != 0,
        .off_screen = options->off_screen != 0,
        .title = "Kingyo",
        .shelf = options->shelf,
    };
    display_gl_on_lost(display, options->on_display_lost, options->on_display_lost_self);
    hal->display = display_gl_device(display);
    if (hal->display.ops->open(display) != HAL_OK) {
        snprintf(devices.display_text, sizeof devices.display_text, "%.*s",
                 (int)sizeof devices.display_text - 1, hal->display.ops->describe(display));
        hal->display = null_display(devices.display_text);
        return;
    }
    ignore_foreign_events();
}

static const char *missing_poi(uint8_t poi)
{
    switch (poi) {
    case BOARD_POI_USB:
        return "no USB poi: this build has no driver for one; the mouse plays instead";
    case BOARD_POI_PAD:
        return "no pad: this build has no driver for one; the mouse plays instead";
    default:
        return NULL;
    }
}

static void open_hands(struct hal *hal, const struct board_options *options)
{
    if (options->off_screen) {
        return;
    }
    hal->buttons = buttons_keyboard_device(&devices.keyboard); /* Whoever plays, Esc must quit. */
    if (options->poi == BOARD_POI_BOT) {
        ignore_mouse_events();
        return;
    }
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    poi_mouse_init(&devices.mouse, hal->clock, &options->view, width, height);
    hal->poi[0] = poi_mouse_device(&devices.mouse);
    hal->shade[0] = poi_mouse_fan(&devices.mouse);
    hal->poi[1] = null_poi(missing_poi(options->poi));
}

/* Both say in describe() what is missing, and then do nothing: a null driver could not say more. */
static void open_sound_and_store(struct hal *hal, const struct board_options *options)
{
    if (!options->mute) {
        hal->audio = audio_device(&devices.audio);
        hal->audio.ops->open(hal->audio.self);
    }
    if (options->data_dir) {
        devices.storage.dir = options->data_dir;
        hal->storage = storage_device(&devices.storage);
        hal->storage.ops->open(hal->storage.self);
    } else {
        hal->storage = null_storage("no store: HOME is not set; --data DIR keeps the scores");
    }
}

static void open_watchdog(struct hal *hal)
{
    const char *usec = getenv("WATCHDOG_USEC");
    if (watchdog_init(&devices.watchdog, hal->clock, getenv("NOTIFY_SOCKET"),
                      usec ? strtoull(usec, NULL, 10) : 0) == HAL_OK) {
        hal->watchdog = watchdog_device(&devices.watchdog);
    }
}

void board_open(struct hal *hal, const struct board_options *options)
{
    *hal = null_hal();
    hal->clock = clock_device();
    open_display(hal, options);
    open_hands(hal, options);
    open_sound_and_store(hal, options);
    open_watchdog(hal);
}

/* A kernel without a graphics card has no /dev/dri/card*: then SDL need not be asked, which
 * would make the libraries under it complain on standard error. */
static int has_graphics_card(void)
{
    char path[32];
    for (int i = 0; i < 16; i++) {
        snprintf(path, sizeof path, "/dev/dri/card%d", i);
        if (access(path, F_OK) == 0) {
            return 1;
        }
    }
    return 0;
}

static int is_set(const char *name)
{
    const char *value = getenv(name);
    return value && value[0];
}

int board_has_screen(char *why, size_t why_size)
{
    const int has_windows = is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
    if (!has_windows && !is_set("SDL_VIDEODRIVER") && !has_graphics_card()) {
        snprintf(why, why_size, "neither DISPLAY nor WAYLAND_DISPLAY is set, and there is no "
                                "graphics card");
        return 0;
    }
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        snprintf(why, why_size, "%s (SDL: %s)",
                 has_windows ? "the display does not answer" : "no screen is plugged in",
                 SDL_GetError());
        return 0;
    }
    const char *driver = SDL_GetCurrentVideoDriver();
    const int shows = driver && strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0;
    if (!shows) {
        snprintf(why, why_size, "%s (SDL fell back to '%s')",
                 has_windows ? "the display does not answer" : "no screen is plugged in",
                 driver ? driver : "nothing");
    }
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return shows;
}
