/* hands.c -- assigns controllers (poi devices) to the players' slots by drivers/input_mux.h. */
#include <SDL.h>
#include <stdio.h>

#include "board/desktop/parts.h"
#include "drivers/gamepad/gamepads.h"
#include "drivers/input_mux.h"
#include "drivers/pointer/mouse_poi.h"

static struct {
    struct input_mux seats;
    struct mouse_poi mouse;
    struct gamepads gamepads;
    uint8_t has_pointer;
} devices;

static int wants(const struct board_options *options, enum board_poi kind)
{
    return options->poi == BOARD_POI_AUTO || options->poi == kind;
}

/* Makes SDL drop mouse and touch events, because no driver reads them. */
static void ignore_pointers(void)
{
    static const Uint32 types[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                    SDL_MOUSEWHEEL,  SDL_FINGERDOWN,      SDL_FINGERUP,
                                    SDL_FINGERMOTION };
    screen_ignore(types, sizeof types / sizeof types[0]);
}

/* Returns the pointer devices in use, as bits of enum pointer_filter. Mouse and touch screen
 * control the same poi; the device that moved last sets the position. */
static uint32_t pointers(const struct board_options *options)
{
    return (wants(options, BOARD_POI_MOUSE) ? (uint32_t)POINTER_FILTER_MOUSE : 0u) |
           (wants(options, BOARD_POI_TOUCH) ? (uint32_t)POINTER_FILTER_TOUCH : 0u);
}

static void add_pointer(struct hal *hal, const struct board_options *options, uint32_t heeds)
{
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    mouse_poi_init(&devices.mouse, hal->clock, &options->view, width, height, heeds);
    devices.has_pointer = 1;
    const struct input_source mouse = {
        .poi = mouse_poi_device(&devices.mouse),
        .fan = mouse_poi_fan(&devices.mouse),
        .is_there = mouse_poi_is_used,
        .self = &devices.mouse,
        .kind = INPUT_KIND_POINTER,
        .stands_in = 1,
    };
    input_mux_add(&devices.seats, &mouse);
}

/* Excludes the devices of the USB driver from SDL, so that each device has one owner. */
static void bar_pads(void)
{
    struct gamepad_exclusion bar[GAMEPADS_EXCLUSION_MAX] = { 0 };
    gamepads_exclude(&devices.gamepads, bar, usb_exclusions(bar));
}

/* Returns 1 if the game pad is plugged in, otherwise 0. The operator may select USB controllers
 * while the kiosk runs, so the exclusions are updated once in each frame. */
static int pad_is_there(void *self)
{
    if (self == &devices.gamepads.pad[0]) {
        bar_pads();
    }
    return gamepad_poi_is_present(self);
}

/* Adds the game pads. A file in the data folder can contain mappings of game pads that SDL does not
 * know. */
static void add_pads(struct hal *hal, const struct board_options *options)
{
    char database[1100] = "";
    if (options->data_dir) {
        snprintf(database, sizeof database, "%.1024s/gamecontrollerdb.txt", options->data_dir);
    }
    gamepads_init(&devices.gamepads, hal->clock, &options->view);
    bar_pads();
    gamepads_open(&devices.gamepads, database[0] ? database : NULL);
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        const struct input_source pad = {
            .poi = gamepad_poi_device(&devices.gamepads, i),
            .fan = gamepad_poi_fan(&devices.gamepads, i),
            .is_there = pad_is_there,
            .self = &devices.gamepads.pad[i],
            .kind = INPUT_KIND_GAMEPAD,
        };
        input_mux_add(&devices.seats, &pad);
    }
}

static const char *missing_poi(uint8_t poi)
{
    return poi == BOARD_POI_PAD   ? "no pad yet: plug one in; --poi auto plays with the mouse, too"
           : poi == BOARD_POI_USB ? "no USB poi yet: plug one in, or choose a controller in the "
                                    "operator's menu; --poi auto plays with the mouse, too"
                                  : "";
}

void hands_open(struct hal *hal, const struct board_options *options)
{
    const uint32_t heeds = pointers(options);
    devices.has_pointer = 0;
    if (!heeds) {
        ignore_pointers();
    }
    if (options->poi == BOARD_POI_BOT) {
        return;
    }
    input_mux_init(&devices.seats, missing_poi(options->poi));
    usb_add_seats(&devices.seats);
    if (wants(options, BOARD_POI_PAD)) {
        add_pads(hal, options);
    }
    if (heeds) {
        add_pointer(hal, options, heeds);
    }
    hal->seats = input_mux_device(&devices.seats);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i] = input_mux_poi(&devices.seats, i);
        hal->fan[i] = input_mux_fan(&devices.seats, i);
    }
}

void hands_add_buttons(struct buttons_mux *join)
{
    if (devices.gamepads.is_open) {
        buttons_mux_add(join, gamepad_poi_buttons(&devices.gamepads));
    }
    if (devices.has_pointer) {
        buttons_mux_add(join, mouse_poi_buttons(&devices.mouse));
    }
}

void hands_close(void)
{
    gamepads_close(&devices.gamepads);
}
