/* test_debounce.c -- Tests that the debouncer reports a level after it has been stable for a
 * period, with the time at which the level began. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"

#define MS 1000000ull

static struct debounce_edge_time change;

static void test_a_bouncing_contact_gives_one_change_at_its_last_bounce(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    static const uint64_t edges_ms[] = { 100, 101, 103, 104, 106 };
    for (size_t i = 0; i < sizeof edges_ms / sizeof edges_ms[0]; i++) {
        assert_false(gpio_debounce_edge(&debounce, edges_ms[i] * MS, i % 2 == 0, &change));
    }
    assert_false(gpio_debounce_settle(&debounce, 111 * MS - 1, &change));
    assert_true(gpio_debounce_settle(&debounce, 111 * MS, &change));
    assert_int_equal(change.time_ns, 106 * MS);
    assert_true(change.active);
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &change));
}

static void test_a_glitch_shorter_than_the_period_gives_no_change(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    assert_false(gpio_debounce_edge(&debounce, 100 * MS, true, &change));
    assert_false(gpio_debounce_edge(&debounce, 105 * MS - 1, false, &change));
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &change));
    assert_int_equal(gpio_debounce_due_ns(&debounce), UINT64_MAX);
}

static void test_edges_that_are_read_late_keep_their_time_stamps(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    assert_false(gpio_debounce_edge(&debounce, 100 * MS, true, &change));
    assert_true(gpio_debounce_edge(&debounce, 125 * MS, false, &change));
    assert_int_equal(change.time_ns, 100 * MS);
    assert_true(change.active);
    assert_true(gpio_debounce_settle(&debounce, 5000 * MS, &change));
    assert_int_equal(change.time_ns, 125 * MS);
    assert_false(change.active);
}

static void test_with_a_period_of_zero_every_edge_is_a_change(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(0, false, 0);
    assert_true(gpio_debounce_edge(&debounce, 7, true, &change));
    assert_true(change.active);
    assert_true(gpio_debounce_edge(&debounce, 8, false, &change));
    assert_false(change.active);
    assert_false(gpio_debounce_edge(&debounce, 9, false, &change));
}

static void test_a_line_that_is_active_at_the_start_first_changes_to_inactive(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, true, 0);
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &change));
    gpio_debounce_edge(&debounce, 901 * MS, false, &change);
    assert_int_equal(gpio_debounce_due_ns(&debounce), 906 * MS);
    assert_true(gpio_debounce_settle(&debounce, 906 * MS, &change));
    assert_false(change.active);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bouncing_contact_gives_one_change_at_its_last_bounce),
        cmocka_unit_test(test_a_glitch_shorter_than_the_period_gives_no_change),
        cmocka_unit_test(test_edges_that_are_read_late_keep_their_time_stamps),
        cmocka_unit_test(test_with_a_period_of_zero_every_edge_is_a_change),
        cmocka_unit_test(test_a_line_that_is_active_at_the_start_first_changes_to_inactive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
