/* test_gpio_thread.c -- the reader's rounds over lines of memory: buttons, coins, lamps, pulses,
 * and chips that come and go. Buttons and switches are asked as the frame loop asks them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/buttons_gpio.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/sim/gpio_lines_sim.h"

#define MS 1000000ull

/* clang-format off */
static const char *const cabinet[] = {
    "start=START", "left=LEFT", "test=TEST", "tilt=TILT", "coin=COIN", "coin2=COIN2",
    "coin3=COIN3", "door=DOOR",
    "start-lamp=LAMP", "coin-lockout=LOCK", "ticket=TICKETS,pulse=50ms/30ms",
    "coin-counter=METER,pulse=40ms/60ms",
};
/* clang-format on */

/* A cabinet, its lines, and what the frame loop has had of it. */
struct stand {
    struct gpio_lines_sim sim;
    struct gpio_sim_events script;
    struct buttons_gpio gpio;
    struct button_sample sum; /* `held` is the newest. */
    uint32_t presses;         /* Samples with START pressed. */
};

static void poll(struct stand *stand)
{
    const struct hal_buttons buttons = buttons_gpio_device(&stand->gpio);
    struct button_sample sample;
    assert_int_equal(buttons.ops->poll(buttons.self, &sample), HAL_OK);
    stand->sum.pressed |= sample.pressed;
    stand->sum.held = sample.held;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        stand->sum.coin_count[line] += sample.coin_count[line];
    }
    stand->sum.faults += sample.faults;
    stand->sum.missing = sample.missing;
    stand->presses += (sample.pressed & INPUT_START) != 0;
}

/* Wires up, with nothing asked for yet: what a test wants of the lines it sets behind this. */
static void plug_in(struct stand *stand, const struct gpio_sim_event *events, uint32_t count)
{
    memset(stand, 0, sizeof *stand);
    stand->script = (struct gpio_sim_events){ .events = events, .count = count };
    gpio_lines_sim_init(&stand->sim, gpio_lines_sim_events_script(&stand->script), 1);
}

static void begin(struct stand *stand)
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE];
    for (size_t i = 0; i < sizeof cabinet / sizeof cabinet[0]; i++) {
        assert_true(gpio_wire_read(cabinet[i], wires, why));
    }
    assert_true(gpio_thread_open(&stand->gpio.reader, gpio_lines_sim_device(&stand->sim), wires,
                                 gpio_lines_sim_clock(&stand->sim)) > 0);
}

static void run_until(struct stand *stand, uint64_t time_ms)
{
    while (stand->sim.now_ns < time_ms * MS) {
        gpio_thread_step(&stand->gpio.reader);
        poll(stand);
    }
}

#define PLAY(stand, events) play(stand, events, sizeof(events) / sizeof((events)[0]))
static void play(struct stand *stand, const struct gpio_sim_event *events, uint32_t count)
{
    plug_in(stand, events, count);
    begin(stand);
}

static void end(struct stand *stand)
{
    gpio_thread_close(&stand->gpio.reader);
}

#define LEVEL(ms, which, level) { .time_ns = (ms) * MS, .role = (which), .active = (level) }

static void test_a_bouncing_button_is_pressed_once_and_held_until_it_is_let_go(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_START, 1), LEVEL(101, GPIO_START, 0), LEVEL(102, GPIO_START, 1),
        LEVEL(104, GPIO_START, 0), LEVEL(105, GPIO_START, 1), LEVEL(200, GPIO_START, 0),
        LEVEL(202, GPIO_START, 1), LEVEL(203, GPIO_START, 0),
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 105);
    assert_int_equal(stand.presses, 0);
    run_until(&stand, 112);
    assert_int_equal(stand.presses, 1);
    assert_int_equal(stand.sum.held, INPUT_START);
    run_until(&stand, 400);
    assert_int_equal(stand.presses, 1);
    assert_int_equal(stand.sum.held, 0);
    assert_int_equal(stand.sum.pressed, INPUT_START);
    assert_int_equal(stand.sum.faults, 0);
    end(&stand);
}

static void test_each_line_is_its_button(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_LEFT, 1), LEVEL(110, GPIO_TEST, 1), LEVEL(120, GPIO_TILT, 1),
        LEVEL(125, GPIO_TILT, 0), LEVEL(130, GPIO_DOOR, 1),
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 400);
    assert_int_equal(stand.sum.pressed, INPUT_LEFT | INPUT_TEST | INPUT_TILT | INPUT_DOOR);
    assert_int_equal(stand.sum.held, INPUT_LEFT | INPUT_TEST | INPUT_DOOR);
    end(&stand);
}

static void test_a_door_that_stands_open_at_the_start_is_held_and_not_pressed(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(500, GPIO_DOOR, 0) };
    static struct stand stand;
    plug_in(&stand, events, 1);
    stand.sim.lines[GPIO_DOOR].level = 1;
    begin(&stand);
    run_until(&stand, 200);
    assert_int_equal(stand.sum.held, INPUT_DOOR);
    run_until(&stand, 600);
    assert_int_equal(stand.sum.held, 0);
    assert_int_equal(stand.sum.pressed, 0);
    end(&stand);
}

static void test_a_frame_loop_that_stands_still_loses_no_coin(void **state)
{
    (void)state;
    static struct gpio_sim_event events[80];
    for (uint32_t i = 0; i < 40; i++) {
        events[2 * i] = (struct gpio_sim_event)LEVEL(100 + 60 * i, GPIO_COIN, 1);
        events[2 * i + 1] = (struct gpio_sim_event)LEVEL(125 + 60 * i, GPIO_COIN, 0);
    }
    static struct stand stand;
    PLAY(&stand, events);
    while (stand.sim.now_ns < 3000 * MS) {
        gpio_thread_step(&stand.gpio.reader); /* And nobody polls. */
    }
    poll(&stand);
    assert_int_equal(stand.sum.coin_count[0], 40);
    assert_int_equal(stand.sum.faults, 0);
    poll(&stand);
    assert_int_equal(stand.sum.coin_count[0], 40);
    end(&stand);
}

static void test_a_reader_that_is_not_run_for_a_while_loses_no_coin(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(125, GPIO_COIN, 0),
        LEVEL(160, GPIO_COIN, 1),
        LEVEL(185, GPIO_COIN, 0),
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 90);
    gpio_lines_sim_pass(&stand.sim, 2000 * MS);
    run_until(&stand, 2200);
    assert_int_equal(stand.sum.coin_count[0], 2);
    assert_int_equal(stand.sum.faults, 0);
    end(&stand);
}

/* Pulses that overlap, as two coins in two chutes make them: each line has a judge of its own. */
static void test_each_coin_line_is_counted_apart(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),  LEVEL(110, GPIO_COIN2, 1), LEVEL(120, GPIO_COIN3, 1),
        LEVEL(128, GPIO_COIN3, 0), /* A knock. */
        LEVEL(150, GPIO_COIN, 0),  LEVEL(160, GPIO_COIN2, 0), LEVEL(300, GPIO_COIN2, 1),
        LEVEL(350, GPIO_COIN2, 0), LEVEL(400, GPIO_COIN3, 1), LEVEL(440, GPIO_COIN3, 0),
        LEVEL(500, GPIO_COIN3, 1), LEVEL(540, GPIO_COIN3, 0), LEVEL(600, GPIO_COIN3, 1),
        LEVEL(640, GPIO_COIN3, 0),
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 1000);
    assert_int_equal(stand.sum.coin_count[0], 1);
    assert_int_equal(stand.sum.coin_count[1], 2);
    assert_int_equal(stand.sum.coin_count[2], 3);
    assert_int_equal(stand.sum.faults, 1);
    assert_int_equal(stand.sum.held, 0); /* None of them is a button. */
    end(&stand);
}

static void test_coins_that_stick_and_knocks_are_faults_and_no_coins(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1), LEVEL(108, GPIO_COIN, 0),  /* A knock. */
        LEVEL(200, GPIO_COIN, 1), LEVEL(201, GPIO_COIN, 0),  /* A spark, below any notice. */
        LEVEL(300, GPIO_COIN, 1), LEVEL(2000, GPIO_COIN, 0), /* It sticks. */
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 290);
    assert_int_equal(stand.sum.faults, 1);
    run_until(&stand, 600);
    assert_int_equal(stand.sum.faults, 2);
    run_until(&stand, 3000);
    assert_int_equal(stand.sum.faults, 2);
    assert_int_equal(stand.sum.coin_count[0], 0);
    end(&stand);
}

static void test_a_coin_whose_edges_the_kernel_reads_late_is_a_coin(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(120, GPIO_COIN, 0),
    };
    static struct stand stand;
    plug_in(&stand, events, 2);
    stand.sim.late_min_ns = stand.sim.late_max_ns = 18 * MS;
    begin(&stand);
    run_until(&stand, 400);
    assert_int_equal(stand.sum.coin_count[0], 1);
    end(&stand);
    plug_in(&stand, events, 2);
    stand.sim.late_min_ns = stand.sim.late_max_ns = 70 * MS; /* Long after it was over. */
    begin(&stand);
    run_until(&stand, 400);
    assert_int_equal(stand.sum.coin_count[0], 1);
    end(&stand);
}

static void test_two_sparks_are_a_fault_and_no_coin_where_the_reader_was_not_run(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 100 * MS, .what = GPIO_SIM_SPARK, .role = GPIO_COIN },
        { .time_ns = 125 * MS, .what = GPIO_SIM_SPARK, .role = GPIO_COIN },
    };
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 90);
    gpio_lines_sim_pass(&stand.sim, 130 * MS - stand.sim.now_ns);
    run_until(&stand, 600);
    assert_int_equal(stand.sum.coin_count[0], 0);
    assert_int_equal(stand.sum.faults, 1);
    end(&stand);
}

/* The coins of tests/vm/guest/cabinet.sh: pulses of 40 to 60 ms, 40 or 50 between. */
#define CABINET_COINS 200u
static uint64_t cabinet_coins(struct gpio_sim_event events[2 * CABINET_COINS])
{
    uint64_t time_ms = 100;
    for (uint32_t left = CABINET_COINS, i = 0; left > 0; left--) {
        events[i++] = (struct gpio_sim_event)LEVEL(time_ms, GPIO_COIN, 1);
        time_ms += 40 + left % 3 * 10;
        events[i++] = (struct gpio_sim_event)LEVEL(time_ms, GPIO_COIN, 0);
        time_ms += 40 + left % 2 * 10;
    }
    return time_ms;
}

/* Linux on an emulated machine of two processors: now and then the one that has the interrupt's
 * thread stands still for longer than a pulse lasts, while the other goes on. Edges then come late,
 * all with the level of later, and what was masked is dated when the mask went. */
static void test_200_coins_of_a_kernel_that_comes_late_with_the_wrong_level_are_200(void **state)
{
    (void)state;
    static struct gpio_sim_event events[2 * CABINET_COINS];
    static const uint64_t late_ms[] = { 0, 12, 0, 45, 30, 0, 70, 0, 55, 3, 95, 0, 0 };
    static struct stand stand;
    const uint64_t end_ms = cabinet_coins(events);
    uint32_t at = 0;
    PLAY(&stand, events);
    while (stand.sim.now_ns < (end_ms + 300) * MS) {
        stand.sim.late_min_ns = stand.sim.late_max_ns = late_ms[at++ / 7 % 13] * MS + 100000;
        gpio_thread_step(&stand.gpio.reader);
        poll(&stand);
    }
    assert_int_equal(stand.sum.coin_count[0], CABINET_COINS);
    assert_true(stand.gpio.reader.inputs[GPIO_COIN].blinks > 0);
    end(&stand);
}

static void test_a_coin_that_neither_kernel_nor_reader_saw_is_a_fault(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(140, GPIO_COIN, 0),
    };
    static struct stand stand;
    PLAY(&stand, events);
    stand.sim.late_min_ns = stand.sim.late_max_ns = 45 * MS;
    run_until(&stand, 95);
    gpio_lines_sim_pass(&stand.sim, 150 * MS - stand.sim.now_ns);
    run_until(&stand, 600);
    assert_int_equal(stand.sum.coin_count[0], 0);
    assert_int_equal(stand.sum.faults, 1);
    end(&stand);
}

static void test_edges_that_the_queue_dropped_are_faults_and_the_level_is_right(void **state)
{
    (void)state;
    for (uint8_t numbered = 0; numbered < 2; numbered++) {
        static struct gpio_sim_event events[41];
        for (uint32_t i = 0; i < 41; i++) { /* It ends pressed. */
            events[i] = (struct gpio_sim_event)LEVEL(100 + i, GPIO_START, i % 2 == 0);
        }
        static struct stand stand;
        plug_in(&stand, events, 41);
        stand.sim.queue_size = 16;
        stand.sim.is_numbered = numbered;
        begin(&stand);
        run_until(&stand, 70);
        gpio_lines_sim_pass(&stand.sim, 500 * MS);
        run_until(&stand, 900);
        assert_int_equal(stand.sim.dropped, 25);
        assert_int_equal(stand.sum.held, INPUT_START);
        assert_int_equal(stand.presses, 1);
        /* Unnumbered, the level alone tells that there was one; numbered, all are known. */
        assert_int_equal(stand.sum.faults, numbered ? 25 : 1);
        end(&stand);
    }
}

static void test_nothing_settles_while_edges_are_still_to_be_taken(void **state)
{
    (void)state;
    static struct gpio_sim_event events[66];
    for (uint32_t i = 0; i < 63; i++) { /* START chatters: of 64 edges one place is left. */
        events[i] = (struct gpio_sim_event)LEVEL(100 + i, GPIO_START, i % 2 == 0);
    }
    events[63] = (struct gpio_sim_event)LEVEL(200, GPIO_COIN, 1); /* A spark ... */
    events[64] = (struct gpio_sim_event)LEVEL(201, GPIO_COIN, 0);
    events[65] = (struct gpio_sim_event)LEVEL(390, GPIO_COIN, 1); /* ... and now a coin. */
    static struct stand stand;
    PLAY(&stand, events);
    run_until(&stand, 70);
    gpio_lines_sim_pass(&stand.sim, 400 * MS - stand.sim.now_ns);
    run_until(&stand, 430);
    assert_int_equal(stand.sum.faults, 0);
    end(&stand);
}

static void test_a_chip_that_goes_is_one_fault_and_is_found_again(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_START, 1),  { .time_ns = 300 * MS, .what = GPIO_SIM_GONE },
        LEVEL(1000, GPIO_START, 0), { .time_ns = 4000 * MS, .what = GPIO_SIM_BACK },
        LEVEL(6000, GPIO_START, 1), LEVEL(6100, GPIO_COIN, 1),
        LEVEL(6150, GPIO_COIN, 0),
    };
    static struct stand stand;
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    assert_int_equal(switches.ops->set(switches.self, HAL_START_LAMP, 1), HAL_OK);
    run_until(&stand, 250);
    assert_int_equal(stand.sum.held, INPUT_START);
    assert_int_equal(stand.sim.outputs[GPIO_START_LAMP], 1);
    run_until(&stand, 400);
    assert_int_equal(stand.sum.held, 0);
    assert_int_equal(stand.sum.faults, 1);
    run_until(&stand, 3900);
    const uint32_t opened = stand.sim.open_count;
    assert_in_range(opened, 4, 6); /* Once a second, not once a round. */
    run_until(&stand, 5100);
    assert_int_equal(stand.sim.outputs[GPIO_START_LAMP], 1); /* As it was wanted. */
    run_until(&stand, 7000);
    assert_int_equal(stand.presses, 2);
    assert_int_equal(stand.sum.coin_count[0], 1);
    assert_int_equal(stand.sum.faults, 1);
    end(&stand);
}

static void test_each_line_that_is_missing_is_named_and_is_a_fault(void **state)
{
    (void)state;
    static struct stand stand;
    plug_in(&stand, NULL, 0);
    stand.sim.held_by_others = 1u << GPIO_START | 1u << GPIO_COIN | 1u << GPIO_START_LAMP;
    begin(&stand);
    const struct hal_buttons buttons = buttons_gpio_device(&stand.gpio);
    assert_non_null(
        strstr(buttons.ops->describe(buttons.self), "9 of 12 lines; no start, coin, start-lamp ("));
    run_until(&stand, 500);
    assert_int_equal(stand.sum.missing, INPUT_START | HAL_MISSING_COIN);
    assert_int_equal(stand.sum.faults, 3);
    end(&stand);
}

static void test_a_line_that_another_holds_is_told_and_had_when_it_is_let_go(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(150, GPIO_COIN, 0),
        LEVEL(2500, GPIO_COIN, 1),
        LEVEL(2550, GPIO_COIN, 0),
    };
    static struct stand stand;
    char why[HAL_TEXT_SIZE];
    plug_in(&stand, events, 4);
    stand.sim.held_by_others = 1u << GPIO_COIN;
    begin(&stand);
    const struct hal_buttons buttons = buttons_gpio_device(&stand.gpio);
    assert_string_equal(buttons.ops->describe(buttons.self),
                        "lines of memory: 11 of 12 lines; no coin (7 is held by 'another')");
    buttons_gpio_why(&stand.gpio, GPIO_COIN, why);
    assert_string_equal(why, "7 is held by 'another'");
    buttons_gpio_why(&stand.gpio, GPIO_START, why);
    assert_string_equal(why, "");
    run_until(&stand, 500);
    assert_int_equal(stand.sum.coin_count[0], 0);
    assert_int_equal(stand.sum.missing, HAL_MISSING_COIN);
    assert_int_equal(stand.sum.faults, 1); /* However often it is asked for again. */
    stand.sim.held_by_others = 0;
    run_until(&stand, 3000);
    assert_int_equal(stand.sum.coin_count[0], 1);
    assert_int_equal(stand.sum.missing, 0);
    assert_int_equal(stand.sum.faults, 1);
    assert_string_equal(buttons.ops->describe(buttons.self), "lines of memory: 12 of 12 lines");
    end(&stand);
}

/* How often `role` went active, and the shortest that it stayed so. */
static uint32_t count_pulses(const struct gpio_lines_sim *sim, uint8_t role, uint64_t *shortest_ns)
{
    uint32_t count = 0;
    uint64_t begin_ns = 0;
    *shortest_ns = UINT64_MAX;
    assert_true(sim->set_count < GPIO_SIM_SETS_MAX);
    for (uint32_t i = 0; i < sim->set_count; i++) {
        const struct gpio_sim_set *set = &sim->sets[i];
        if (set->role == role && set->active) {
            count++;
            begin_ns = set->time_ns;
        } else if (set->role == role && set->time_ns - begin_ns < *shortest_ns) {
            *shortest_ns = set->time_ns - begin_ns;
        }
    }
    return count;
}

static void test_meters_and_dispensers_get_their_pulses_side_by_side(void **state)
{
    (void)state;
    static struct stand stand;
    uint64_t meter_ns, ticket_ns;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_COIN_COUNTER, 3), HAL_OK);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 2), HAL_OK);
    run_until(&stand, 50);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_COIN_COUNTER, 4), HAL_OK);
    run_until(&stand, 2000);
    assert_int_equal(count_pulses(&stand.sim, GPIO_COIN_COUNTER, &meter_ns), 7);
    assert_int_equal(count_pulses(&stand.sim, GPIO_TICKET, &ticket_ns), 2);
    assert_in_range(meter_ns, 40 * MS, 42 * MS);
    assert_in_range(ticket_ns, 50 * MS, 52 * MS);
    end(&stand);
}

static void test_pulses_that_are_owed_wait_for_a_chip_that_is_away(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 100 * MS, .what = GPIO_SIM_GONE },
        { .time_ns = 1500 * MS, .what = GPIO_SIM_BACK },
    };
    static struct stand stand;
    uint64_t shortest_ns;
    PLAY(&stand, events);
    run_until(&stand, 200);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 5), HAL_OK);
    run_until(&stand, 1400);
    assert_int_equal(count_pulses(&stand.sim, GPIO_TICKET, &shortest_ns), 0);
    run_until(&stand, 4000);
    assert_int_equal(count_pulses(&stand.sim, GPIO_TICKET, &shortest_ns), 5);
    end(&stand);
}

static void test_lamps_follow_and_what_is_not_wired_says_so(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct stand stand;
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 1);
    run_until(&stand, 30);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&stand, 60);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    stand.gpio.reader.wires[GPIO_TICKET].wired = 0;
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 1), HAL_ERR_ABSENT);
    stand.gpio.reader.wires[GPIO_START_LAMP].wired = 0;
    assert_int_equal(switches.ops->set(switches.self, HAL_START_LAMP, 1), HAL_ERR_ABSENT);
    end(&stand);
}

static void test_coins_are_locked_out_until_somebody_lets_them_in(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 1000 * MS, .what = GPIO_SIM_GONE },
        { .time_ns = 1500 * MS, .what = GPIO_SIM_BACK },
    };
    static struct stand stand;
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    run_until(&stand, 500);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    assert_int_equal(stand.sim.set_count, 0); /* Never was it open for a moment. */
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&stand, 900);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    run_until(&stand, 4000); /* The chip came back locked, and opens as is still wanted. */
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    assert_int_equal(stand.sim.set_count, 2);
    end(&stand);
}

static void test_a_cabinet_that_closes_locks_coins_out(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct stand stand;
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    switches.ops->set(switches.self, HAL_START_LAMP, 1);
    run_until(&stand, 100);
    end(&stand);
    assert_int_equal(stand.sim.outputs[GPIO_START_LAMP], 0);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 1);
}

static void test_the_lines_of_a_kiosk_that_is_killed_rest_locked(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct stand stand;
    PLAY(&stand, events);
    const struct hal_switches switches = buttons_gpio_switches(&stand.gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&stand, 100);
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    const struct gpio_lines lines = gpio_lines_sim_device(&stand.sim);
    lines.ops->close(lines.self); /* As the kernel does it: nobody has a last word. */
    assert_int_equal(stand.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    assert_int_equal(stand.sim.outputs[GPIO_START_LAMP], 0);
    end(&stand);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bouncing_button_is_pressed_once_and_held_until_it_is_let_go),
        cmocka_unit_test(test_each_line_is_its_button),
        cmocka_unit_test(test_a_door_that_stands_open_at_the_start_is_held_and_not_pressed),
        cmocka_unit_test(test_a_frame_loop_that_stands_still_loses_no_coin),
        cmocka_unit_test(test_a_reader_that_is_not_run_for_a_while_loses_no_coin),
        cmocka_unit_test(test_each_coin_line_is_counted_apart),
        cmocka_unit_test(test_coins_that_stick_and_knocks_are_faults_and_no_coins),
        cmocka_unit_test(test_a_coin_whose_edges_the_kernel_reads_late_is_a_coin),
        cmocka_unit_test(test_two_sparks_are_a_fault_and_no_coin_where_the_reader_was_not_run),
        cmocka_unit_test(test_200_coins_of_a_kernel_that_comes_late_with_the_wrong_level_are_200),
        cmocka_unit_test(test_a_coin_that_neither_kernel_nor_reader_saw_is_a_fault),
        cmocka_unit_test(test_edges_that_the_queue_dropped_are_faults_and_the_level_is_right),
        cmocka_unit_test(test_nothing_settles_while_edges_are_still_to_be_taken),
        cmocka_unit_test(test_a_chip_that_goes_is_one_fault_and_is_found_again),
        cmocka_unit_test(test_each_line_that_is_missing_is_named_and_is_a_fault),
        cmocka_unit_test(test_a_line_that_another_holds_is_told_and_had_when_it_is_let_go),
        cmocka_unit_test(test_meters_and_dispensers_get_their_pulses_side_by_side),
        cmocka_unit_test(test_pulses_that_are_owed_wait_for_a_chip_that_is_away),
        cmocka_unit_test(test_lamps_follow_and_what_is_not_wired_says_so),
        cmocka_unit_test(test_coins_are_locked_out_until_somebody_lets_them_in),
        cmocka_unit_test(test_a_cabinet_that_closes_locks_coins_out),
        cmocka_unit_test(test_the_lines_of_a_kiosk_that_is_killed_rest_locked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
