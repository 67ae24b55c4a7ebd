/* rehearsal.c -- any board, with nobody there: its display off screen, and devices that we move.
 *
 * Shared by every board; it is wiring, so it lives here and not in the demonstration that uses
 * it. */
#include "platform/board.h"

#include "core/input.h"
#include "drivers/buttons_sim.h"
#include "drivers/clock_sim.h"
#include "drivers/null.h"

#define PRESS_NS 200000000ull /* As long as a finger stays. */

static struct clock_sim rehearsal_clock;
static struct buttons_sim rehearsal_buttons;
static struct button_event rehearsal_press[2];

void board_open_rehearsal(struct hal *hal, const struct board_options *options, uint64_t start_ns)
{
    struct board_options quiet = *options;
    quiet.poi = BOARD_POI_BOT;
    quiet.off_screen = 1;
    quiet.full_screen = 0;
    quiet.mute = 1;
    quiet.data_dir = NULL;
    board_open(hal, &quiet);
    const struct hal_display display = hal->display;
    *hal = null_hal();
    hal->display = display;
    rehearsal_clock = (struct clock_sim){ 0 };
    hal->clock = clock_sim_device(&rehearsal_clock);
    rehearsal_press[0] = (struct button_event){ .time_ns = start_ns, .pressed = INPUT_START };
    rehearsal_press[1] =
        (struct button_event){ .time_ns = start_ns + PRESS_NS, .released = INPUT_START };
    rehearsal_buttons = (struct buttons_sim){
        .clock = hal->clock,
        .events = rehearsal_press,
        .event_count = sizeof rehearsal_press / sizeof rehearsal_press[0],
    };
    hal->buttons = buttons_sim_device(&rehearsal_buttons);
}

void board_rehearsal_advance(uint64_t ns)
{
    rehearsal_clock.now_ns += ns;
}
