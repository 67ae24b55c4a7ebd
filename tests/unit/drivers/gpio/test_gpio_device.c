/* test_gpio_device.c -- tests that each coin, fault and output passes exactly once between the GPIO
 * thread and the frame loop, which run at different rates. The GPIO lines are simulated. Each wait
 * of the thread advances their time at once, instead of taking real time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/sim/gpio_lines_sim.h"

#define MS 1000000ull
#define COINS 3000u
#define CYCLES 20u /* Number of times that the chip is unplugged and plugged in again. */

/* Source of events: coins and presses of START in turn. The chip is removed CYCLES times in total,
 * each time between two coins. */
struct day {
    uint32_t step, coins;
    uint64_t time_ns;
};

static bool next_of_day(void *self, struct gpio_sim_event *out)
{
    struct day *day = self;
    const uint32_t coin = day->step / 4u, edge = day->step % 4u;
    if (coin == COINS) {
        return false;
    }
    day->step++;
    day->time_ns += edge == 0 ? 60 * MS : 30 * MS;
    /* Each coin has four events. Every COINS / CYCLES coins, event 2 removes the chip and event 3
     * brings the chip back 1.5 s later. */
    if (coin % (COINS / CYCLES) == 0 && edge >= 2) {
        day->time_ns += edge == 3 ? 1500 * MS : 0;
        *out = (struct gpio_sim_event){ day->time_ns, edge == 2 ? GPIO_SIM_GONE : GPIO_SIM_BACK, 0,
                                        0 };
        /* The thread searches for the chip once a second, so 2 s later the lines are open again. */
        day->time_ns += edge == 3 ? 2000 * MS : 0;
        return true;
    }
    *out = (struct gpio_sim_event){
        .time_ns = day->time_ns,
        .role = edge < 2 ? GPIO_COIN : GPIO_START,
        .active = edge % 2u == 0,
    };
    return true;
}

static void sleep_ns(long ns)
{
    const struct timespec time = { .tv_nsec = ns };
    nanosleep(&time, NULL);
}

static struct gpio_lines_sim sim;
static struct gpio_thread gpio;

static void start(struct gpio_sim_script script)
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE];
    assert_true(gpio_wire_read("start=S", wires, why));
    assert_true(gpio_wire_read("coin=C", wires, why));
    assert_true(gpio_wire_read("start-lamp=L", wires, why));
    assert_true(gpio_wire_read("coin-counter=M,pulse=10ms/10ms", wires, why));
    gpio_lines_sim_init(&sim, script, 3);
    sim.late_max_ns = 1 * MS;
    assert_int_equal(
        gpio_thread_start(&gpio, gpio_lines_sim_device(&sim), wires, gpio_lines_sim_clock(&sim)),
        HAL_OK);
}

static void test_coins_and_faults_cross_to_the_frame_loop_once_each(void **state)
{
    (void)state;
    static struct day day;
    start((struct gpio_sim_script){ .next = next_of_day, .self = &day });
    const struct hal_buttons buttons = gpio_thread_buttons(&gpio);
    const struct hal_switches switches = gpio_thread_switches(&gpio);
    uint32_t coins = 0, faults = 0, polls = 0, coin_edges = 0, start_edges = 0;
    /* The loop ends at the latest after 20,000 polls, which take at least 10 s. */
    while (coins < COINS && polls < 20000u) {
        struct button_sample sample;
        assert_int_equal(buttons.ops->poll(buttons.self, &sample), HAL_OK);
        switches.ops->set(switches.self, HAL_START_LAMP, polls % 2u == 0);
        assert_true(strlen(buttons.ops->describe(buttons.self)) > 0);
        coins += sample.coin_count[0];
        faults += sample.faults;
        coin_edges += sample.line[INPUT_BUTTON_COUNT].edges;
        start_edges += sample.line[0].edges;
        polls++;
        sleep_ns(polls % 7u ? 500000 : 5000000);
    }
    sleep_ns(50000000);
    struct button_sample last;
    buttons.ops->poll(buttons.self, &last);
    gpio_thread_stop(&gpio);
    assert_int_equal(coins + last.coin_count[0], COINS);
    /* Each loss of the chip counts as one fault. */
    assert_int_equal(faults + last.faults, CYCLES);
    assert_int_equal(coin_edges + last.line[INPUT_BUTTON_COUNT].edges, 2u * COINS);
    assert_int_equal(start_edges + last.line[0].edges, 2u * (COINS - CYCLES));
    assert_int_equal(last.raw, 0);
}

static void test_pending_output_pulses_are_finished_before_the_thread_ends(void **state)
{
    (void)state;
    start((struct gpio_sim_script){ 0 });
    const struct hal_switches switches = gpio_thread_switches(&gpio);
    for (uint32_t i = 0; i < 20; i++) {
        assert_int_equal(switches.ops->pulse(switches.self, HAL_COIN_COUNTER, 1), HAL_OK);
    }
    assert_true(switches.ops->pending(switches.self, HAL_COIN_COUNTER) > 0);
    assert_int_equal(switches.ops->pending(switches.self, HAL_TICKET), 0);
    gpio_thread_stop(&gpio);
    uint32_t pulses = 0;
    assert_in_range(sim.set_count, 40, GPIO_SIM_SETS_MAX);
    for (uint32_t i = 0; i < sim.set_count; i++) {
        pulses += sim.sets[i].role == GPIO_COIN_COUNTER && sim.sets[i].active;
    }
    assert_int_equal(pulses, 20);
    assert_int_equal(sim.outputs[GPIO_COIN_COUNTER], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coins_and_faults_cross_to_the_frame_loop_once_each),
        cmocka_unit_test(test_pending_output_pulses_are_finished_before_the_thread_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
