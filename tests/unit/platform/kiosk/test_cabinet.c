/* test_cabinet.c -- Tests the whole kiosk with a simulated GPIO chip. Pulses of coins and buttons
 * must give credits, start a round, advance the coin meter and open the coin slot.
 *
 * In some tests a frame takes three seconds, or the GPIO chip is removed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/null.h"
#include "drivers/sim/gpio_lines_sim.h"
#include "drivers/sim/sensor_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull

static struct rig {
    struct gpio_lines_sim sim;
    struct gpio_sim_events script;
    struct gpio_thread gpio;
    struct sensor_sim sensor;
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
} rig;

#define LEVEL(ms, which, level) { .time_ns = (ms) * MS, .role = (which), .active = (level) }
#define PULSE(ms, which, width_ms) LEVEL(ms, which, 1), LEVEL((ms) + (width_ms), which, 0)

#define OPEN(events) open_fixture(events, sizeof(events) / sizeof((events)[0]))
static void open_fixture(const struct gpio_sim_event *events, uint32_t count)
{
    /* clang-format off */
    static const char *const cabinet[] = {
        "start=S", "coin=C", "service=V", "tilt=T", "start-lamp=L", "coin-lockout=K",
        "coin-counter=M,pulse=30ms/30ms",
    };
    /* clang-format on */
    static const struct kiosk_config config = {
        .core = { .seed = 5, .fish_count = 8, .round_s = 10, .credit_coins = 2 },
    };
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE];
    memset(&rig, 0, sizeof rig);
    for (size_t i = 0; i < sizeof cabinet / sizeof cabinet[0]; i++) {
        assert_true(gpio_wire_read(cabinet[i], wires, why));
    }
    rig.script = (struct gpio_sim_events){ .events = events, .count = count };
    gpio_lines_sim_init(&rig.sim, gpio_lines_sim_events_script(&rig.script), 1);
    rig.hal = null_hal(NULL);
    rig.hal.clock = gpio_lines_sim_clock(&rig.sim);
    gpio_thread_open(&rig.gpio, gpio_lines_sim_device(&rig.sim), wires, rig.hal.clock);
    rig.hal.buttons = gpio_thread_buttons(&rig.gpio);
    rig.hal.switches = gpio_thread_switches(&rig.gpio);
    sensor_sim_init(&rig.sensor, rig.hal.clock, 125);
    rig.hal.poi[0] = sensor_sim_device(&rig.sensor);
    rig.hal.storage = storage_sim_device(&rig.storage);
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), 0);
}

/* Advances the GPIO thread by `ns` nanoseconds of simulated time, then runs one frame. */
static void frame(uint64_t ns)
{
    const uint64_t until_ns = rig.sim.now_ns + ns;
    while (rig.sim.now_ns < until_ns) {
        gpio_thread_step(&rig.gpio);
    }
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
}

static void run_until(uint64_t time_ms)
{
    while (rig.sim.now_ns < time_ms * MS) {
        frame(FRAME_NS);
    }
}

static uint32_t meter_steps(void)
{
    uint32_t steps = 0;
    assert_true(rig.sim.set_count < GPIO_SIM_SETS_MAX);
    for (uint32_t i = 0; i < rig.sim.set_count; i++) {
        steps += rig.sim.sets[i].role == GPIO_COIN_COUNTER && rig.sim.sets[i].active;
    }
    return steps;
}

static void close_kiosk(void)
{
    gpio_thread_close(&rig.gpio);
}

static void test_two_coin_pulses_pay_a_round_and_advance_the_meter(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        PULSE(1000, GPIO_START, 100), /* This START must have no effect, because there is no credit
                                         yet. */
        PULSE(2000, GPIO_COIN, 50),   PULSE(2500, GPIO_COIN, 50),
        PULSE(4000, GPIO_START, 100), PULSE(6000, GPIO_START, 100),
    };
    OPEN(events);
    run_until(1500);
    assert_int_equal(rig.kiosk.scene.phase, PHASE_ATTRACT);
    run_until(2300);
    assert_int_equal(rig.kiosk.scene.credit.units, 1);
    run_until(3000);
    assert_int_equal(rig.kiosk.scene.credit.credits, 1);
    assert_int_equal(meter_steps(), 2);
    run_until(9000);
    assert_int_equal(rig.kiosk.scene.credit.credits, 0);
    assert_int_not_equal(rig.kiosk.scene.phase, PHASE_ATTRACT);
    assert_int_equal(rig.kiosk.faults.buttons, 0);
    close_kiosk();
}

static void test_coins_inserted_during_a_three_second_frame_are_counted(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        PULSE(1000, GPIO_COIN, 25), PULSE(1100, GPIO_COIN, 25), PULSE(1200, GPIO_COIN, 25),
        PULSE(1300, GPIO_COIN, 25), PULSE(1400, GPIO_COIN, 25), PULSE(1500, GPIO_COIN, 25),
    };
    OPEN(events);
    run_until(500);
    frame(3000 * MS);
    run_until(5000);
    assert_int_equal(rig.kiosk.scene.credit.credits, 3);
    assert_int_equal(rig.kiosk.scene.credit.units, 0);
    assert_int_equal(meter_steps(), 6);
    close_kiosk();
}

static void test_a_removed_gpio_chip_loses_no_credit_and_reconnects(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        PULSE(1000, GPIO_COIN, 50),
        PULSE(1500, GPIO_COIN, 50),
        PULSE(1800, GPIO_COIN, 50),
        { .time_ns = 1852 * MS, .what = GPIO_SIM_GONE }, /* The chip is removed 2 ms after the pulse
                                                            of the third coin, which must still be
                                                            counted. */
        { .time_ns = 4000 * MS, .what = GPIO_SIM_BACK },
        PULSE(6000, GPIO_COIN, 50),
        LEVEL(7000, GPIO_COIN, 1),
        { .time_ns = 7030 * MS, .what = GPIO_SIM_GONE }, /* The chip is removed during this coin
                                                            pulse, so the coin cannot be
                                                            counted. */
    };
    OPEN(events);
    run_until(3500);
    assert_int_equal(rig.kiosk.scene.credit.credits, 1);
    assert_int_equal(rig.kiosk.scene.credit.units, 1);
    assert_int_equal(rig.kiosk.faults.buttons, 1);
    run_until(6500);
    assert_int_equal(rig.kiosk.scene.credit.credits, 2);
    assert_int_equal(rig.kiosk.faults.buttons, 1);
    run_until(8000);
    assert_int_equal(rig.kiosk.scene.credit.credits, 2);
    assert_int_equal(rig.kiosk.faults.buttons, 1 + 2); /* One interrupted coin pulse and two
                                                          removals of the chip are three faults. */
    close_kiosk();
}

static void test_tilting_the_cabinet_locks_the_coin_slot_temporarily(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        PULSE(1000, GPIO_TILT, 4),
        PULSE(5000, GPIO_SERVICE, 100),
    };
    OPEN(events);
    assert_int_equal(rig.sim.outputs[GPIO_COIN_LOCKOUT], 1); /* The coin slot is locked until the
                                                                first frame. */
    run_until(900);
    assert_int_equal(rig.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    run_until(1200);
    assert_int_equal(rig.sim.outputs[GPIO_COIN_LOCKOUT], 1);
    run_until(4900);
    assert_int_equal(rig.sim.outputs[GPIO_COIN_LOCKOUT], 0);
    run_until(5500);
    assert_int_equal(rig.kiosk.scene.credit.credits, 1);
    assert_int_equal(meter_steps(), 0);
    close_kiosk();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_two_coin_pulses_pay_a_round_and_advance_the_meter),
        cmocka_unit_test(test_coins_inserted_during_a_three_second_frame_are_counted),
        cmocka_unit_test(test_a_removed_gpio_chip_loses_no_credit_and_reconnects),
        cmocka_unit_test(test_tilting_the_cabinet_locks_the_coin_slot_temporarily),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
