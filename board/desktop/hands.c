/* hands.c -- who holds the pois: what can be one takes a seat (drivers/seats.h). */
#include <SDL.h>

#include "board/desktop/parts.h"
#include "drivers/poi_mouse.h"
#include "drivers/seats.h"

static struct {
    struct seats seats;
    struct poi_mouse mouse;
} devices;

/* In the bot's stall nobody takes what the mouse says. */
static void ignore_mouse_events(void)
{
    static const Uint32 mouse[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                    SDL_MOUSEWHEEL };
    screen_ignore(mouse, sizeof mouse / sizeof mouse[0]);
}

static void add_mouse(struct hal *hal, const struct board_options *options)
{
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    poi_mouse_init(&devices.mouse, hal->clock, &options->view, width, height);
    const struct seat_source mouse = {
        .poi = poi_mouse_device(&devices.mouse),
        .fan = poi_mouse_fan(&devices.mouse),
        .kind = SEAT_POINTER,
    };
    seats_add(&devices.seats, &mouse);
}

void hands_open(struct hal *hal, const struct board_options *options)
{
    if (options->poi == BOARD_POI_BOT) {
        ignore_mouse_events();
        return;
    }
    seats_init(&devices.seats, "");
    add_mouse(hal, options);
    hal->seats = seats_device(&devices.seats);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i] = seats_poi(&devices.seats, i);
        hal->shade[i] = seats_fan(&devices.seats, i);
    }
}
