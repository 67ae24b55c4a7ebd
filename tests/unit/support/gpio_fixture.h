/* gpio_fixture.h -- test fixture of the GPIO thread, which reads simulated lines. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GPIO_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_GPIO_FIXTURE_H

#include <string.h>

#include "drivers/gpio/gpio_thread.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/sim/gpio_lines_sim.h"

#define MS 1000000ull

/* clang-format off */
/* Wiring of the cabinet: the role of each GPIO line and the name of the line. */
static const char *const cabinet[] = {
    "start=START", "left=LEFT", "test=TEST", "tilt=TILT", "coin=COIN", "coin2=COIN2",
    "coin3=COIN3", "door=DOOR",
    "start-lamp=LAMP", "coin-lockout=LOCK", "ticket=TICKETS,pulse=50ms/30ms",
    "coin-counter=METER,pulse=40ms/60ms",
};
/* clang-format on */

/* A cabinet with simulated GPIO lines, and the sum of all button samples that were polled. */
struct fixture {
    struct gpio_lines_sim sim;
    struct gpio_sim_events script;
    struct gpio_thread gpio;
    /* Sum of all samples. Only `held` is the value of the newest sample. */
    struct button_sample sum;
    uint32_t presses; /* Number of samples in which START was pressed. */
};

/* Polls the buttons as the frame loop does and adds the sample to the sum. */
static inline void poll(struct fixture *fixture)
{
    const struct hal_buttons buttons = gpio_thread_buttons(&fixture->gpio);
    struct button_sample sample;
    assert_int_equal(buttons.ops->poll(buttons.self, &sample), HAL_OK);
    fixture->sum.pressed |= sample.pressed;
    fixture->sum.held = sample.held;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        fixture->sum.coin_count[line] += sample.coin_count[line];
    }
    fixture->sum.faults += sample.faults;
    fixture->sum.missing = sample.missing;
    fixture->presses += (sample.pressed & INPUT_START) != 0;
}

/* Creates the simulated lines without reading them yet, so that a test can change the lines before
 * begin(). */
static inline void plug_in(struct fixture *fixture, const struct gpio_sim_event *events,
                           uint32_t count)
{
    memset(fixture, 0, sizeof *fixture);
    fixture->script = (struct gpio_sim_events){ .events = events, .count = count };
    gpio_lines_sim_init(&fixture->sim, gpio_lines_sim_events_script(&fixture->script), 1);
}

/* Assigns the lines to their roles and starts to read the lines. */
static inline void begin(struct fixture *fixture)
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE];
    for (size_t i = 0; i < sizeof cabinet / sizeof cabinet[0]; i++) {
        assert_true(gpio_wire_read(cabinet[i], wires, why));
    }
    assert_true(gpio_thread_open(&fixture->gpio, gpio_lines_sim_device(&fixture->sim), wires,
                                 gpio_lines_sim_clock(&fixture->sim)) > 0);
}

/* Alternates steps of the thread and polls until the simulated time is `time_ms`. */
static inline void run_until(struct fixture *fixture, uint64_t time_ms)
{
    while (fixture->sim.now_ns < time_ms * MS) {
        gpio_thread_step(&fixture->gpio);
        poll(fixture);
    }
}

#define PLAY(fixture, events) play(fixture, events, sizeof(events) / sizeof((events)[0]))

/* Creates the simulated lines with the script `events`, and starts to read the lines. */
static inline void play(struct fixture *fixture, const struct gpio_sim_event *events,
                        uint32_t count)
{
    plug_in(fixture, events, count);
    begin(fixture);
}

/* Closes the lines. */
static inline void end(struct fixture *fixture)
{
    gpio_thread_close(&fixture->gpio);
}

#define LEVEL(ms, which, level) { .time_ns = (ms) * MS, .role = (which), .active = (level) }

#endif
