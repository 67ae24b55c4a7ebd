/* hands.c -- assigns poi devices to the slots (drivers/seats.h). */
#include <SDL.h>
#include <stdio.h>

#include "board/desktop/parts.h"
#include "drivers/poi_mouse.h"
#include "drivers/poi_pad.h"
#include "drivers/seats.h"

static struct {
    struct seats seats;
    struct poi_mouse mouse;
    struct pads pads;
    uint8_t has_pointer;
} devices;

static int wants(const struct board_options *options, enum board_poi kind)
{
    return options->poi == BOARD_POI_AUTO || options->poi == kind;
}

/* Ignores mouse and touch events if no driver reads them. */
static void ignore_pointers(void)
{
    static const Uint32 types[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                    SDL_MOUSEWHEEL,  SDL_FINGERDOWN,      SDL_FINGERUP,
                                    SDL_FINGERMOTION };
    screen_ignore(types, sizeof types / sizeof types[0]);
}

/* Returns the pointer devices in use. Mouse and touch control the same poi; the device moved last
 * counts. */
static uint32_t pointers(const struct board_options *options)
{
    return (wants(options, BOARD_POI_MOUSE) ? (uint32_t)POINTER_HEEDS_MOUSE : 0u) |
           (wants(options, BOARD_POI_TOUCH) ? (uint32_t)POINTER_HEEDS_FINGERS : 0u);
}

static void add_pointer(struct hal *hal, const struct board_options *options, uint32_t heeds)
{
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    poi_mouse_init(&devices.mouse, hal->clock, &options->view, width, height, heeds);
    devices.has_pointer = 1;
    const struct seat_source mouse = {
        .poi = poi_mouse_device(&devices.mouse),
        .fan = poi_mouse_fan(&devices.mouse),
        .is_there = poi_mouse_is_used,
        .self = &devices.mouse,
        .kind = SEAT_POINTER,
        .stands_in = 1,
    };
    seats_add(&devices.seats, &mouse);
}

/* Excludes USB devices from SDL, so that each device has one owner. */
static void bar_pads(void)
{
    struct pad_bar bar[PADS_BAR_MAX] = { 0 };
    pads_bar(&devices.pads, bar, usb_bars(bar));
}

/* Returns 1 if the gamepad is connected. The operator may choose controllers while the kiosk runs,
 * so that the choice is checked once a frame. */
static int pad_is_there(void *self)
{
    if (self == &devices.pads.pad[0]) {
        bar_pads();
    }
    return pads_is_there(self);
}

/* Adds the gamepads. Unknown gamepads can be described in a file in the data folder. */
static void add_pads(struct hal *hal, const struct board_options *options)
{
    char database[1100] = "";
    if (options->data_dir) {
        snprintf(database, sizeof database, "%.1024s/gamecontrollerdb.txt", options->data_dir);
    }
    pads_init(&devices.pads, hal->clock, &options->view);
    bar_pads();
    pads_open(&devices.pads, database[0] ? database : NULL);
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        const struct seat_source pad = {
            .poi = pads_poi(&devices.pads, i),
            .fan = pads_fan(&devices.pads, i),
            .is_there = pad_is_there,
            .self = &devices.pads.pad[i],
            .kind = SEAT_PAD,
        };
        seats_add(&devices.seats, &pad);
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
    seats_init(&devices.seats, missing_poi(options->poi));
    usb_add_seats(&devices.seats);
    if (wants(options, BOARD_POI_PAD)) {
        add_pads(hal, options);
    }
    if (heeds) {
        add_pointer(hal, options, heeds);
    }
    hal->seats = seats_device(&devices.seats);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i] = seats_poi(&devices.seats, i);
        hal->shade[i] = seats_fan(&devices.seats, i);
    }
}

void hands_add_buttons(struct buttons_join *join)
{
    if (devices.pads.is_open) {
        buttons_join_add(join, pads_buttons(&devices.pads));
    }
    if (devices.has_pointer) {
        buttons_join_add(join, poi_mouse_buttons(&devices.mouse));
    }
}

void hands_close(void)
{
    pads_close(&devices.pads);
}
