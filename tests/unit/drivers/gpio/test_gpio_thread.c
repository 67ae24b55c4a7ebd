/* test_gpio_thread.c -- tests the GPIO thread with simulated lines: buttons, coins, lamps, pulses,
 * and chips that are removed and come back. The test polls through the same interface as the frame
 * loop. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"
#include "tests/unit/support/gpio_fixture.h"

static void test_a_bouncing_button_is_pressed_once_and_held_until_released(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_START, 1), LEVEL(101, GPIO_START, 0), LEVEL(102, GPIO_START, 1),
        LEVEL(104, GPIO_START, 0), LEVEL(105, GPIO_START, 1), LEVEL(200, GPIO_START, 0),
        LEVEL(202, GPIO_START, 1), LEVEL(203, GPIO_START, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 105);
    assert_int_equal(fixture.presses, 0);
    run_until(&fixture, 112);
    assert_int_equal(fixture.presses, 1);
    assert_int_equal(fixture.sum.held, INPUT_START);
    run_until(&fixture, 400);
    assert_int_equal(fixture.presses, 1);
    assert_int_equal(fixture.sum.held, 0);
    assert_int_equal(fixture.sum.pressed, INPUT_START);
    assert_int_equal(fixture.sum.faults, 0);
    end(&fixture);
}

static void test_each_line_is_reported_as_its_button(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_LEFT, 1), LEVEL(110, GPIO_TEST, 1), LEVEL(120, GPIO_TILT, 1),
        LEVEL(125, GPIO_TILT, 0), LEVEL(130, GPIO_DOOR, 1),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 400);
    assert_int_equal(fixture.sum.pressed, INPUT_LEFT | INPUT_TEST | INPUT_TILT | INPUT_DOOR);
    assert_int_equal(fixture.sum.held, INPUT_LEFT | INPUT_TEST | INPUT_DOOR);
    end(&fixture);
}

static void test_a_door_that_is_open_at_the_start_is_held_and_not_pressed(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(500, GPIO_DOOR, 0) };
    static struct fixture fixture;
    plug_in(&fixture, events, 1);
    fixture.sim.lines[GPIO_DOOR].level = 1;
    begin(&fixture);
    run_until(&fixture, 200);
    assert_int_equal(fixture.sum.held, INPUT_DOOR);
    run_until(&fixture, 600);
    assert_int_equal(fixture.sum.held, 0);
    assert_int_equal(fixture.sum.pressed, 0);
    end(&fixture);
}

static void test_edges_that_the_queue_dropped_are_faults_and_the_level_is_correct(void **state)
{
    (void)state;
    for (uint8_t numbered = 0; numbered < 2; numbered++) {
        static struct gpio_sim_event events[41];
        /* The 41st edge is a press, so the button is held at the end. */
        for (uint32_t i = 0; i < 41; i++) {
            events[i] = (struct gpio_sim_event)LEVEL(100 + i, GPIO_START, i % 2 == 0);
        }
        static struct fixture fixture;
        plug_in(&fixture, events, 41);
        fixture.sim.queue_size = 16;
        fixture.sim.is_numbered = numbered;
        begin(&fixture);
        run_until(&fixture, 70);
        gpio_lines_sim_pass(&fixture.sim, 500 * MS);
        run_until(&fixture, 900);
        assert_int_equal(fixture.sim.dropped, 25);
        assert_int_equal(fixture.sum.held, INPUT_START);
        assert_int_equal(fixture.presses, 1);
        /* If the kernel numbers its edges, all 25 missing edges are counted. Without numbers, the
         * filter detects only one missing edge, by the changed level. */
        assert_int_equal(fixture.sum.faults, numbered ? 25 : 1);
        end(&fixture);
    }
}

static void test_no_level_is_accepted_while_edges_are_unread(void **state)
{
    (void)state;
    static struct gpio_sim_event events[66];
    /* START bounces 63 times, so one place is left in the kernel's queue of 64 edges. */
    for (uint32_t i = 0; i < 63; i++) {
        events[i] = (struct gpio_sim_event)LEVEL(100 + i, GPIO_START, i % 2 == 0);
    }
    events[63] = (struct gpio_sim_event)LEVEL(200, GPIO_COIN, 1); /* A glitch. */
    events[64] = (struct gpio_sim_event)LEVEL(201, GPIO_COIN, 0);
    events[65] = (struct gpio_sim_event)LEVEL(390, GPIO_COIN, 1); /* A coin. */
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 70);
    gpio_lines_sim_pass(&fixture.sim, 400 * MS - fixture.sim.now_ns);
    run_until(&fixture, 430);
    assert_int_equal(fixture.sum.faults, 0);
    end(&fixture);
}

static void test_a_chip_that_disappears_is_one_fault_and_is_reopened(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_START, 1),  { .time_ns = 300 * MS, .what = GPIO_SIM_GONE },
        LEVEL(1000, GPIO_START, 0), { .time_ns = 4000 * MS, .what = GPIO_SIM_BACK },
        LEVEL(6000, GPIO_START, 1), LEVEL(6100, GPIO_COIN, 1),
        LEVEL(6150, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    assert_int_equal(switches.ops->set(switches.self, HAL_START_LAMP, 1), HAL_OK);
    run_until(&fixture, 250);
    assert_int_equal(fixture.sum.held, INPUT_START);
    assert_int_equal(fixture.sim.outputs[GPIO_START_LAMP], 1);
    run_until(&fixture, 400);
    assert_int_equal(fixture.sum.held, 0);
    assert_int_equal(fixture.sum.faults, 1);
    run_until(&fixture, 3900);
    const uint32_t opened = fixture.sim.open_count;
    /* The thread retries once per second instead of in every step. */
    assert_in_range(opened, 4, 6);
    run_until(&fixture, 5100);
    /* The chip came back, and the lamp was set again. */
    assert_int_equal(fixture.sim.outputs[GPIO_START_LAMP], 1);
    run_until(&fixture, 7000);
    assert_int_equal(fixture.presses, 2);
    assert_int_equal(fixture.sum.coin_count[0], 1);
    assert_int_equal(fixture.sum.faults, 1);
    end(&fixture);
}

/* The backend may detect the loss of a chip while it reads a level or sets an output. The lines
 * must count as missing at once, because the thread requests only missing lines again. */
static void test_the_lines_of_a_lost_chip_are_missing_at_once(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { { .time_ns = 300 * MS,
                                                      .what = GPIO_SIM_GONE } };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 200);
    assert_int_equal(fixture.sum.missing, 0);
    gpio_lines_sim_pass(&fixture.sim, 200 * MS);
    gpio_thread_lose(&fixture.gpio);
    poll(&fixture);
    assert_int_equal(fixture.sum.missing & (INPUT_START | INPUT_DOOR | HAL_MISSING_COIN),
                     INPUT_START | INPUT_DOOR | HAL_MISSING_COIN);
    assert_int_equal(fixture.sum.faults, 1);
    end(&fixture);
}

/* The thread reads all levels regularly, so that an edge that the kernel does not report changes
 * the button a little later. */
static void test_a_level_without_an_edge_is_detected(void **state)
{
    (void)state;
    static struct fixture fixture;
    plug_in(&fixture, NULL, 0);
    begin(&fixture);
    run_until(&fixture, 200);
    fixture.sim.lines[GPIO_DOOR].level = 1;
    run_until(&fixture, 500);
    assert_int_equal(fixture.sum.held, INPUT_DOOR);
    end(&fixture);
}

static void test_each_missing_line_is_named_and_counted_as_a_fault(void **state)
{
    (void)state;
    static struct fixture fixture;
    plug_in(&fixture, NULL, 0);
    fixture.sim.held_by_others = 1u << GPIO_START | 1u << GPIO_COIN | 1u << GPIO_START_LAMP;
    begin(&fixture);
    const struct hal_buttons buttons = gpio_thread_buttons(&fixture.gpio);
    assert_non_null(
        strstr(buttons.ops->describe(buttons.self), "9 of 12 lines; no start, coin, start-lamp ("));
    run_until(&fixture, 500);
    assert_int_equal(fixture.sum.missing, INPUT_START | HAL_MISSING_COIN);
    assert_int_equal(fixture.sum.faults, 3);
    end(&fixture);
}

static void test_a_busy_line_is_reported_and_requested_again_when_it_is_free(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(150, GPIO_COIN, 0),
        LEVEL(2500, GPIO_COIN, 1),
        LEVEL(2550, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    char why[HAL_TEXT_SIZE];
    plug_in(&fixture, events, 4);
    fixture.sim.held_by_others = 1u << GPIO_COIN;
    begin(&fixture);
    const struct hal_buttons buttons = gpio_thread_buttons(&fixture.gpio);
    assert_string_equal(buttons.ops->describe(buttons.self),
                        "lines of memory: 11 of 12 lines; no coin (7 is in use by 'another')");
    gpio_thread_why(&fixture.gpio, GPIO_COIN, why);
    assert_string_equal(why, "7 is in use by 'another'");
    gpio_thread_why(&fixture.gpio, GPIO_START, why);
    assert_string_equal(why, "");
    run_until(&fixture, 500);
    assert_int_equal(fixture.sum.coin_count[0], 0);
    assert_int_equal(fixture.sum.missing, HAL_MISSING_COIN);
    /* Retries do not count as faults. */
    assert_int_equal(fixture.sum.faults, 1);
    fixture.sim.held_by_others = 0;
    run_until(&fixture, 3000);
    assert_int_equal(fixture.sum.coin_count[0], 1);
    assert_int_equal(fixture.sum.missing, 0);
    assert_int_equal(fixture.sum.faults, 1);
    assert_string_equal(buttons.ops->describe(buttons.self), "lines of memory: 12 of 12 lines");
    end(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bouncing_button_is_pressed_once_and_held_until_released),
        cmocka_unit_test(test_each_line_is_reported_as_its_button),
        cmocka_unit_test(test_a_door_that_is_open_at_the_start_is_held_and_not_pressed),
        cmocka_unit_test(test_edges_that_the_queue_dropped_are_faults_and_the_level_is_correct),
        cmocka_unit_test(test_no_level_is_accepted_while_edges_are_unread),
        cmocka_unit_test(test_a_chip_that_disappears_is_one_fault_and_is_reopened),
        cmocka_unit_test(test_the_lines_of_a_lost_chip_are_missing_at_once),
        cmocka_unit_test(test_a_level_without_an_edge_is_detected),
        cmocka_unit_test(test_each_missing_line_is_named_and_counted_as_a_fault),
        cmocka_unit_test(test_a_busy_line_is_reported_and_requested_again_when_it_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
