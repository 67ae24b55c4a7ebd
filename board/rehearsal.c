/* rehearsal.c -- opens the devices for a demonstration (rehearsal) on any board. The picture is
 * drawn off screen, and all other devices are simulated. The file is in the board folder because it
 * connects drivers. */
#include "platform/board.h"

#include "core/input.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"

#define PRESS_NS 200000000ull /* Duration of a simulated button press. */

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
    *hal = null_hal(NULL);
    hal->display = display;
    rehearsal_clock = (struct clock_sim){ 0 };
    hal->clock = sim_clock_device(&rehearsal_clock);
    rehearsal_press[0] = (struct button_event){ .time_ns = start_ns, .pressed = INPUT_START };
    rehearsal_press[1] =
        (struct button_event){ .time_ns = start_ns + PRESS_NS, .released = INPUT_START };
    rehearsal_buttons = (struct buttons_sim){
        .clock = hal->clock,
        .events = rehearsal_press,
        .event_count = sizeof rehearsal_press / sizeof rehearsal_press[0],
    };
    hal->buttons = sim_buttons_device(&rehearsal_buttons);
}

void board_rehearsal_advance(uint64_t ns)
{
    rehearsal_clock.now_ns += ns;
}
