/* device.h -- the input device of a simulated player. It converts the player's commands to raw
 * reports, which pass through the real decoder of the device (drivers/sim).
 *
 * A mouse, a finger and a gamepad report once per frame, and Kingyo's poi controller twice. The
 * speed and the acceleration of the simulated hand are limited. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_DEVICE_H
#define KINGYO_TESTS_BENCH_PLAYERS_DEVICE_H

#include "drivers/hid/poi_hid.h"
#include "drivers/sim/gamepad_sim.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/hid_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "tests/bench/players/sim_player.h"

/* Largest number of reports or finger events in one frame. */
#define DEVICE_REPORTS_MAX 4u

struct device {
    const struct habits *habits;
    struct clock_sim *clock;
    struct view view;
    uint32_t seed;
    uint32_t report_count;          /* Number of reports sent so far. */
    float x_px, y_px;               /* Position on the screen to which the hand points, in
                                       pixels. */
    float pace_x_px_s, pace_y_px_s; /* Velocity of the hand on the screen, in pixels per second. */
    float notches;                  /* Sum of the notches by which the wheel was turned so far. */
    /* `finger_down` is true while the first finger touches the screen. `dips` is true while the
     * second finger touches the screen. */
    bool finger_down, dips;
    float height_m, climb_m_s; /* Height and vertical speed of a physical poi. */
    float pitch_rad, roll_rad; /* Angles of a physical poi. */

    struct pointer_report pointer_reports[DEVICE_REPORTS_MAX];
    struct touch_event touch_events[DEVICE_REPORTS_MAX];
    struct gamepad_report gamepad_reports[DEVICE_REPORTS_MAX];
    struct pointer_sim pointer;
    struct gamepad_sim gamepad;
    struct hid_port_sim port;
    struct poi_hid poi;
};

/* Initializes the input device that `habits->device` selects. The struct keeps the pointers
 * `habits` and `clock`, so both must stay valid. */
void device_init(struct device *device, const struct habits *habits, struct clock_sim *clock,
                 const struct view *view, uint32_t seed);

/* Returns the poi driver that reads this device, for struct hal. */
struct hal_poi device_poi(struct device *device);

/* Advances the clock by one frame and sends the reports of the frame. */
void device_frame(struct device *device, const struct player_command *command);

#endif
