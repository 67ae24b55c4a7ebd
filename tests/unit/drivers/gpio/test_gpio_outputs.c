/* test_gpio_outputs.c -- Tests the outputs of the GPIO thread: pulses, lamps and coin lockout. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"
#include "tests/unit/support/gpio_fixture.h"

/* Returns how often output `role` became active. Writes its shortest active time to `shortest_ns`,
 * or UINT64_MAX if it never became inactive again. */
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

static void test_meter_and_dispenser_pulses_run_in_parallel(void **state)
{
    (void)state;
    static struct fixture fixture;
    uint64_t meter_ns, ticket_ns;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_COIN_COUNTER, 3), HAL_OK);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 2), HAL_OK);
    run_until(&fixture, 50);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_COIN_COUNTER, 4), HAL_OK);
    run_until(&fixture, 2000);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_COIN_COUNTER, &meter_ns), 7);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &ticket_ns), 2);
    assert_in_range(meter_ns, 40 * MS, 42 * MS);
    assert_in_range(ticket_ns, 50 * MS, 52 * MS);
    end(&fixture);
}

static void test_pending_pulses_wait_until_an_absent_chip_returns(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 100 * MS, .what = GPIO_SIM_GONE },
        { .time_ns = 1500 * MS, .what = GPIO_SIM_BACK },
    };
    static struct fixture fixture;
    uint64_t shortest_ns;
    PLAY(&fixture, events);
    run_until(&fixture, 200);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 5), HAL_OK);
    run_until(&fixture, 1400);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &shortest_ns), 0);
    run_until(&fixture, 4000);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &shortest_ns), 5);
    end(&fixture);
}

static void test_pulses_wait_until_a_failing_line_switches_on(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    uint64_t shortest_ns;
    PLAY(&fixture, events);
    run_until(&fixture, 100);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    const uint32_t faults = fixture.sum.faults;
    fixture.sim.failing_outputs = gpio_role_bit(GPIO_TICKET);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 3), HAL_OK);
    run_until(&fixture, 1000);
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 3);
    /* The thread retries to set the line, but the failure counts as one fault. */
    assert_int_equal(fixture.sum.faults, faults + 1u);
    assert_string_equal(switches.ops->describe(switches.self),
                        "lines of memory: 12 of 12 lines; no ticket (TICKETS does not switch: "
                        "check the cable and power of its chip)");
    fixture.sim.failing_outputs = 0;
    run_until(&fixture, 2000);
    assert_string_equal(switches.ops->describe(switches.self), "lines of memory: 12 of 12 lines");
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 0);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &shortest_ns), 3);
    assert_in_range(shortest_ns, 50 * MS, 52 * MS);
    fixture.sim.failing_outputs = gpio_role_bit(GPIO_TICKET);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 1), HAL_OK);
    run_until(&fixture, 2500);
    /* The output failed again after a success, which counts as a second fault. */
    assert_int_equal(fixture.sum.faults, faults + 2u);
    end(&fixture);
}

/* The thread requests missing lines again every second. Each request also writes the reasons of all
 * lines again, which must not hide the failing output. */
static void test_a_failing_output_is_reported_beside_a_missing_line(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    char why[HAL_TEXT_SIZE];
    plug_in(&fixture, events, 1);
    fixture.sim.held_by_others = gpio_role_bit(GPIO_COIN);
    begin(&fixture);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    fixture.sim.failing_outputs = gpio_role_bit(GPIO_TICKET);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 1), HAL_OK);
    run_until(&fixture, 3500);
    assert_string_equal(switches.ops->describe(switches.self),
                        "lines of memory: 11 of 12 lines; no coin, ticket (7 is in use by "
                        "'another')");
    gpio_thread_why(&fixture.gpio, GPIO_TICKET, why);
    assert_string_equal(why, "TICKETS does not switch: check the cable and power of its chip");
    end(&fixture);
}

static void test_a_pulse_lasts_until_a_failing_line_switches_off(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    uint64_t shortest_ns;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    const uint32_t faults = fixture.sum.faults;
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 2), HAL_OK);
    run_until(&fixture, 40);
    assert_int_equal(fixture.sim.outputs[GPIO_TICKET], 1);
    fixture.sim.failing_outputs = gpio_role_bit(GPIO_TICKET);
    run_until(&fixture, 1000);
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 2);
    assert_int_equal(fixture.sum.faults, faults + 1u);
    fixture.sim.failing_outputs = 0;
    run_until(&fixture, 2000);
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 0);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &shortest_ns), 2);
    end(&fixture);
}

/* If the chip is removed during a pulse, the pulse counts as done and is not repeated. Otherwise
 * the dispenser could give the ticket twice. */
static void test_a_pulse_cut_by_the_loss_of_its_line_is_not_repeated(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 41 * MS, .what = GPIO_SIM_GONE },
        { .time_ns = 42 * MS, .what = GPIO_SIM_BACK },
    };
    static struct fixture fixture;
    uint64_t shortest_ns;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 2), HAL_OK);
    run_until(&fixture, 35);
    assert_int_equal(fixture.sim.outputs[GPIO_TICKET], 1);
    gpio_lines_sim_pass(&fixture.sim, 10 * MS);
    run_until(&fixture, 2000);
    assert_int_equal(fixture.gpio.total.lost_chips, 1);
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 0);
    assert_int_equal(count_pulses(&fixture.sim, GPIO_TICKET, &shortest_ns), 2);
    end(&fixture);
}

static void test_lamps_are_set_and_unwired_outputs_return_absent(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 1);
    run_until(&fixture, 30);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&fixture, 60);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    fixture.gpio.wires[GPIO_TICKET].wired = 0;
    assert_int_equal(switches.ops->pulse(switches.self, HAL_TICKET, 1), HAL_ERR_ABSENT);
    fixture.gpio.wires[GPIO_START_LAMP].wired = 0;
    assert_int_equal(switches.ops->set(switches.self, HAL_START_LAMP, 1), HAL_ERR_ABSENT);
    end(&fixture);
}

static void test_coins_are_locked_out_until_the_lockout_is_released(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        { .time_ns = 1000 * MS, .what = GPIO_SIM_GONE },
        { .time_ns = 1500 * MS, .what = GPIO_SIM_BACK },
    };
    static struct fixture fixture;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    run_until(&fixture, 500);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    /* The line was requested with the initial level 1 (locked), so the thread needed no call to set
     * the level. */
    assert_int_equal(fixture.sim.set_count, 0);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&fixture, 900);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    /* The chip came back with the initial level (locked), so the thread must set the requested
     * level (0) again. */
    run_until(&fixture, 4000);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    assert_int_equal(fixture.sim.set_count, 2);
    end(&fixture);
}

static void test_closing_the_gpio_thread_locks_coins_out(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    switches.ops->set(switches.self, HAL_START_LAMP, 1);
    run_until(&fixture, 100);
    end(&fixture);
    assert_int_equal(fixture.sim.outputs[GPIO_START_LAMP], 0);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 1);
}

static void test_the_lines_of_a_killed_process_stay_locked(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = { LEVEL(9000, GPIO_START, 1) };
    static struct fixture fixture;
    PLAY(&fixture, events);
    const struct hal_switches switches = gpio_thread_switches(&fixture.gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0);
    run_until(&fixture, 100);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    const struct gpio_lines lines = gpio_lines_sim_device(&fixture.sim);
    /* When a process is killed, the kernel closes its lines without a further write. The idle level
     * of the line must then lock the coin slot. */
    lines.ops->close(lines.self);
    assert_int_equal(fixture.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    assert_int_equal(fixture.sim.outputs[GPIO_START_LAMP], 0);
    end(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_meter_and_dispenser_pulses_run_in_parallel),
        cmocka_unit_test(test_pending_pulses_wait_until_an_absent_chip_returns),
        cmocka_unit_test(test_pulses_wait_until_a_failing_line_switches_on),
        cmocka_unit_test(test_a_failing_output_is_reported_beside_a_missing_line),
        cmocka_unit_test(test_a_pulse_lasts_until_a_failing_line_switches_off),
        cmocka_unit_test(test_a_pulse_cut_by_the_loss_of_its_line_is_not_repeated),
        cmocka_unit_test(test_lamps_are_set_and_unwired_outputs_return_absent),
        cmocka_unit_test(test_coins_are_locked_out_until_the_lockout_is_released),
        cmocka_unit_test(test_closing_the_gpio_thread_locks_coins_out),
        cmocka_unit_test(test_the_lines_of_a_killed_process_stay_locked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
