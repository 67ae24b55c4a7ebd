/* test_gpio_coins.c -- tests that the GPIO thread counts every coin and no glitch, even if the
 * kernel, the thread or the frame loop is late. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"
#include "tests/unit/support/gpio_fixture.h"

static void test_a_stalled_frame_loop_loses_no_coin(void **state)
{
    (void)state;
    static struct gpio_sim_event events[80];
    for (uint32_t i = 0; i < 40; i++) {
        events[2 * i] = (struct gpio_sim_event)LEVEL(100 + 60 * i, GPIO_COIN, 1);
        events[2 * i + 1] = (struct gpio_sim_event)LEVEL(125 + 60 * i, GPIO_COIN, 0);
    }
    static struct fixture fixture;
    PLAY(&fixture, events);
    while (fixture.sim.now_ns < 3000 * MS) {
        /* Runs only the GPIO thread. The frame loop does not poll before all coins have passed. */
        gpio_thread_step(&fixture.gpio);
    }
    poll(&fixture);
    assert_int_equal(fixture.sum.coin_count[0], 40);
    assert_int_equal(fixture.sum.faults, 0);
    poll(&fixture);
    assert_int_equal(fixture.sum.coin_count[0], 40);
    end(&fixture);
}

static void test_a_stalled_gpio_thread_loses_no_coin(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(125, GPIO_COIN, 0),
        LEVEL(160, GPIO_COIN, 1),
        LEVEL(185, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 90);
    gpio_lines_sim_pass(&fixture.sim, 2000 * MS);
    run_until(&fixture, 2200);
    assert_int_equal(fixture.sum.coin_count[0], 2);
    assert_int_equal(fixture.sum.faults, 0);
    end(&fixture);
}

/* Two coins in two chutes give overlapping pulses. The pulses of each line must be counted
 * independently. */
static void test_each_coin_line_is_counted_separately(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(110, GPIO_COIN2, 1),
        LEVEL(120, GPIO_COIN3, 1),
        /* This pulse of 8 ms is too short for a coin. Knocks against the coin mechanism cause such
         * pulses. */
        LEVEL(128, GPIO_COIN3, 0),
        LEVEL(150, GPIO_COIN, 0),
        LEVEL(160, GPIO_COIN2, 0),
        LEVEL(300, GPIO_COIN2, 1),
        LEVEL(350, GPIO_COIN2, 0),
        LEVEL(400, GPIO_COIN3, 1),
        LEVEL(440, GPIO_COIN3, 0),
        LEVEL(500, GPIO_COIN3, 1),
        LEVEL(540, GPIO_COIN3, 0),
        LEVEL(600, GPIO_COIN3, 1),
        LEVEL(640, GPIO_COIN3, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 1000);
    assert_int_equal(fixture.sum.coin_count[0], 1);
    assert_int_equal(fixture.sum.coin_count[1], 2);
    assert_int_equal(fixture.sum.coin_count[2], 3);
    assert_int_equal(fixture.sum.faults, 1);
    assert_int_equal(fixture.sum.held, 0); /* Coin lines are not buttons, so no button is held. */
    end(&fixture);
}

static void test_too_long_and_too_short_pulses_are_faults_and_no_coins(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        /* A pulse of 8 ms (a knock) is too short for a coin and counts as a fault. */
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(108, GPIO_COIN, 0),
        LEVEL(200, GPIO_COIN, 1),
        LEVEL(201, GPIO_COIN, 0), /* This glitch of 1 ms is shorter than the debounce period. */
        /* A jam: the coin is stuck for 1.7 s. */
        LEVEL(300, GPIO_COIN, 1),
        LEVEL(2000, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 290);
    assert_int_equal(fixture.sum.faults, 1);
    run_until(&fixture, 600);
    assert_int_equal(fixture.sum.faults, 2);
    run_until(&fixture, 3000);
    assert_int_equal(fixture.sum.faults, 2);
    assert_int_equal(fixture.sum.coin_count[0], 0);
    end(&fixture);
}

static void test_a_coin_whose_edges_the_kernel_reports_late_is_counted(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(120, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    plug_in(&fixture, events, 2);
    fixture.sim.late_min_ns = fixture.sim.late_max_ns = 18 * MS;
    begin(&fixture);
    run_until(&fixture, 400);
    assert_int_equal(fixture.sum.coin_count[0], 1);
    end(&fixture);
    plug_in(&fixture, events, 2);
    /* The kernel reports each edge 70 ms late, which is longer than the pulse of 20 ms. */
    fixture.sim.late_min_ns = fixture.sim.late_max_ns = 70 * MS;
    begin(&fixture);
    run_until(&fixture, 400);
    assert_int_equal(fixture.sum.coin_count[0], 1);
    end(&fixture);
}

static void test_two_glitches_during_a_thread_stall_are_a_fault_and_no_coin(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 100 * MS, .what = GPIO_SIM_SPARK, .role = GPIO_COIN },
        { .time_ns = 125 * MS, .what = GPIO_SIM_SPARK, .role = GPIO_COIN },
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    run_until(&fixture, 90);
    gpio_lines_sim_pass(&fixture.sim, 130 * MS - fixture.sim.now_ns);
    run_until(&fixture, 600);
    assert_int_equal(fixture.sum.coin_count[0], 0);
    assert_int_equal(fixture.sum.faults, 1);
    end(&fixture);
}

/* Coin pulses of tests/vm/guest/cabinet.sh: 40 to 60 ms wide, with pauses of 40 or 50 ms. */
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

/* Simulates Linux on an emulated machine with two processors. The processor that handles interrupts
 * is sometimes stopped for longer than a pulse, while the other processor runs. The kernel then
 * reports edges late and with the level of a later time. An edge that occurred while interrupts
 * were masked gets the time at which they were unmasked. */
static void test_200_coins_are_counted_when_edges_are_late_and_have_the_wrong_level(void **state)
{
    (void)state;
    static struct gpio_sim_event events[2 * CABINET_COINS];
    static const uint64_t late_ms[] = { 0, 12, 0, 45, 30, 0, 70, 0, 55, 3, 95, 0, 0 };
    static struct fixture fixture;
    const uint64_t end_ms = cabinet_coins(events);
    uint32_t at = 0;
    PLAY(&fixture, events);
    while (fixture.sim.now_ns < (end_ms + 300) * MS) {
        fixture.sim.late_min_ns = fixture.sim.late_max_ns = late_ms[at++ / 7 % 13] * MS + 100000;
        gpio_thread_step(&fixture.gpio);
        poll(&fixture);
    }
    assert_int_equal(fixture.sum.coin_count[0], CABINET_COINS);
    assert_true(fixture.gpio.inputs[GPIO_COIN].blinks > 0);
    end(&fixture);
}

static void test_a_coin_that_neither_kernel_nor_thread_saw_is_a_fault(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(140, GPIO_COIN, 0),
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    fixture.sim.late_min_ns = fixture.sim.late_max_ns = 45 * MS;
    run_until(&fixture, 95);
    gpio_lines_sim_pass(&fixture.sim, 150 * MS - fixture.sim.now_ns);
    run_until(&fixture, 600);
    assert_int_equal(fixture.sum.coin_count[0], 0);
    assert_int_equal(fixture.sum.faults, 1);
    end(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_stalled_frame_loop_loses_no_coin),
        cmocka_unit_test(test_a_stalled_gpio_thread_loses_no_coin),
        cmocka_unit_test(test_each_coin_line_is_counted_separately),
        cmocka_unit_test(test_too_long_and_too_short_pulses_are_faults_and_no_coins),
        cmocka_unit_test(test_a_coin_whose_edges_the_kernel_reports_late_is_counted),
        cmocka_unit_test(test_two_glitches_during_a_thread_stall_are_a_fault_and_no_coin),
        cmocka_unit_test(test_200_coins_are_counted_when_edges_are_late_and_have_the_wrong_level),
        cmocka_unit_test(test_a_coin_that_neither_kernel_nor_thread_saw_is_a_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
