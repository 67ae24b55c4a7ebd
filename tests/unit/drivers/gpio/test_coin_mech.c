/* test_coin_mech.c -- tests which pulses of a coin line are counted as coins, and which are counted
 * as faults. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"

#define MS 1000000ull
#define MIN_NS (15 * MS)
#define MAX_NS (250 * MS)

static struct coin_mech idle_mech(void)
{
    return gpio_coin_begin(MIN_NS, MAX_NS, false, 0);
}

static void pulse(struct coin_mech *mech, uint64_t begin_ns, uint64_t width_ns)
{
    gpio_coin_edge(mech, begin_ns, true);
    gpio_coin_edge(mech, begin_ns + width_ns, false);
}

static void assert_counts(const struct coin_mech *mech, uint32_t coins, uint32_t too_short,
                          uint32_t stuck, uint32_t cut)
{
    assert_int_equal(mech->coins, coins);
    assert_int_equal(mech->too_short, too_short);
    assert_int_equal(mech->stuck, stuck);
    assert_int_equal(mech->cut, cut);
    assert_int_equal(gpio_coin_faults(mech), too_short + stuck + cut);
}

static void test_a_pulse_is_a_coin_if_its_width_is_within_the_limits(void **state)
{
    (void)state;
    static const struct {
        uint64_t width_ns;
        uint32_t coins, too_short, stuck;
    } widths[] = {
        { MIN_NS - 1, 0, 1, 0 }, { MIN_NS, 1, 0, 0 }, { 25 * MS, 1, 0, 0 },
        { 100 * MS, 1, 0, 0 },   { MAX_NS, 1, 0, 0 }, { MAX_NS + 1, 0, 0, 1 },
        { 900 * MS, 0, 0, 1 },
    };
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
        struct coin_mech mech = idle_mech();
        pulse(&mech, 1000 * MS, widths[i].width_ns);
        gpio_coin_settle(&mech, 9000 * MS);
        assert_counts(&mech, widths[i].coins, widths[i].too_short, widths[i].stuck, 0);
    }
}

static void test_a_coin_is_counted_after_the_gap_that_follows_it(void **state)
{
    (void)state;
    struct coin_mech mech = idle_mech();
    pulse(&mech, 1000 * MS, 50 * MS);
    assert_int_equal(gpio_coin_due_ns(&mech), 1050 * MS + COIN_GAP_NS);
    gpio_coin_settle(&mech, 1050 * MS + COIN_GAP_NS - 1);
    assert_counts(&mech, 0, 0, 0, 0);
    gpio_coin_settle(&mech, 1050 * MS + COIN_GAP_NS);
    assert_counts(&mech, 1, 0, 0, 0);
    gpio_coin_settle(&mech, 9000 * MS);
    assert_counts(&mech, 1, 0, 0, 0);
}

static void test_a_pulse_that_is_interrupted_by_a_bounce_is_one_coin(void **state)
{
    (void)state;
    struct coin_mech mech = idle_mech();
    pulse(&mech, 1000 * MS, 20 * MS);
    pulse(&mech, 1020 * MS + COIN_GAP_NS - 1, 20 * MS);
    gpio_coin_settle(&mech, 9000 * MS);
    assert_counts(&mech, 1, 0, 0, 0);
}

static void test_the_width_of_an_interrupted_pulse_includes_all_parts(void **state)
{
    (void)state;
    struct coin_mech mech = idle_mech();
    pulse(&mech, 1000 * MS, 10 * MS);
    pulse(&mech, 1015 * MS, 10 * MS);
    gpio_coin_settle(&mech, 9000 * MS);
    assert_counts(&mech, 1, 0, 0, 0);
    assert_int_equal(mech.width_ns, 25 * MS);
}

static void test_each_pulse_of_a_multi_pulse_coin_is_counted(void **state)
{
    (void)state;
    struct coin_mech mech = idle_mech();
    for (uint32_t i = 0; i < 10; i++) {
        pulse(&mech, (1000 + 50 * i) * MS, 25 * MS);
    }
    gpio_coin_settle(&mech, 9000 * MS);
    assert_counts(&mech, 10, 0, 0, 0);
}

static void test_a_stuck_coin_is_reported_once_and_while_it_is_stuck(void **state)
{
    (void)state;
    struct coin_mech mech = idle_mech();
    gpio_coin_edge(&mech, 1000 * MS, true);
    gpio_coin_settle(&mech, 1250 * MS);
    assert_counts(&mech, 0, 0, 0, 0);
    gpio_coin_settle(&mech, 1250 * MS + 1);
    assert_counts(&mech, 0, 0, 1, 0);
    gpio_coin_settle(&mech, 60000 * MS);
    gpio_coin_edge(&mech, 61000 * MS, false);
    /* The coin that was stuck falls now, and its contact bounces. The bounces must count neither as
     * a coin nor as a fault. */
    gpio_coin_edge(&mech, 61005 * MS, true);
    gpio_coin_edge(&mech, 61030 * MS, false);
    gpio_coin_settle(&mech, 62000 * MS);
    assert_counts(&mech, 0, 0, 1, 0);
    pulse(&mech, 63000 * MS, 50 * MS); /* The next coin is counted as usual. */
    gpio_coin_settle(&mech, 64000 * MS);
    assert_counts(&mech, 1, 0, 1, 0);
}

static void test_a_sensor_that_is_covered_at_the_start_counts_no_coin(void **state)
{
    (void)state;
    struct coin_mech mech = gpio_coin_begin(MIN_NS, MAX_NS, true, 1000 * MS);
    gpio_coin_edge(&mech, 1050 * MS, false);
    gpio_coin_settle(&mech, 2000 * MS);
    assert_counts(&mech, 0, 0, 0, 0);
    pulse(&mech, 3000 * MS, 50 * MS);
    gpio_coin_settle(&mech, 4000 * MS);
    assert_counts(&mech, 1, 0, 0, 0);
}

static void test_a_lost_line_keeps_a_finished_coin_and_rejects_an_unfinished_one(void **state)
{
    (void)state;
    struct coin_mech fell = idle_mech(), falls = idle_mech(), none = idle_mech();
    pulse(&fell, 1000 * MS, 50 * MS);
    gpio_coin_lose(&fell);
    assert_counts(&fell, 1, 0, 0, 0);
    gpio_coin_edge(&falls, 1000 * MS, true);
    gpio_coin_lose(&falls);
    assert_counts(&falls, 0, 0, 0, 1);
    gpio_coin_lose(&none);
    assert_counts(&none, 0, 0, 0, 0);
    gpio_coin_settle(&fell, 9000 * MS);
    assert_counts(&fell, 1, 0, 0, 0);
    /* The next coin is counted, because the unfinished pulse was discarded. */
    pulse(&falls, 3000 * MS, 50 * MS);
    gpio_coin_settle(&falls, 9000 * MS);
    assert_counts(&falls, 1, 0, 0, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_pulse_is_a_coin_if_its_width_is_within_the_limits),
        cmocka_unit_test(test_a_coin_is_counted_after_the_gap_that_follows_it),
        cmocka_unit_test(test_a_pulse_that_is_interrupted_by_a_bounce_is_one_coin),
        cmocka_unit_test(test_the_width_of_an_interrupted_pulse_includes_all_parts),
        cmocka_unit_test(test_each_pulse_of_a_multi_pulse_coin_is_counted),
        cmocka_unit_test(test_a_stuck_coin_is_reported_once_and_while_it_is_stuck),
        cmocka_unit_test(test_a_sensor_that_is_covered_at_the_start_counts_no_coin),
        cmocka_unit_test(test_a_lost_line_keeps_a_finished_coin_and_rejects_an_unfinished_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
