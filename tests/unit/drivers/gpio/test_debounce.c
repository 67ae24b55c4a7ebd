/* test_debounce.c -- a level counts when it has stood, and is dated back to when it began. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_signal.h"

#define MS 1000000ull

static struct debounce_edge_time turn;

static void test_a_bouncing_contact_turns_once_at_its_last_bounce(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    static const uint64_t edges_ms[] = { 100, 101, 103, 104, 106 };
    for (size_t i = 0; i < sizeof edges_ms / sizeof edges_ms[0]; i++) {
        assert_false(gpio_debounce_edge(&debounce, edges_ms[i] * MS, i % 2 == 0, &turn));
    }
    assert_false(gpio_debounce_settle(&debounce, 111 * MS - 1, &turn));
    assert_true(gpio_debounce_settle(&debounce, 111 * MS, &turn));
    assert_int_equal(turn.time_ns, 106 * MS);
    assert_true(turn.active);
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &turn));
}

static void test_a_spark_shorter_than_the_period_turns_nothing(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    assert_false(gpio_debounce_edge(&debounce, 100 * MS, true, &turn));
    assert_false(gpio_debounce_edge(&debounce, 105 * MS - 1, false, &turn));
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &turn));
    assert_int_equal(gpio_debounce_due_ns(&debounce), UINT64_MAX);
}

static void test_edges_that_are_read_long_after_they_came_keep_their_times(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, false, 0);
    assert_false(gpio_debounce_edge(&debounce, 100 * MS, true, &turn));
    assert_true(gpio_debounce_edge(&debounce, 125 * MS, false, &turn));
    assert_int_equal(turn.time_ns, 100 * MS);
    assert_true(turn.active);
    assert_true(gpio_debounce_settle(&debounce, 5000 * MS, &turn));
    assert_int_equal(turn.time_ns, 125 * MS);
    assert_false(turn.active);
}

static void test_without_a_period_every_edge_turns_at_once(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(0, false, 0);
    assert_true(gpio_debounce_edge(&debounce, 7, true, &turn));
    assert_true(turn.active);
    assert_true(gpio_debounce_edge(&debounce, 8, false, &turn));
    assert_false(turn.active);
    assert_false(gpio_debounce_edge(&debounce, 9, false, &turn));
}

static void test_a_line_that_is_active_from_the_start_turns_only_when_it_leaves(void **state)
{
    (void)state;
    struct debounce debounce = gpio_debounce_begin(5 * MS, true, 0);
    assert_false(gpio_debounce_settle(&debounce, 900 * MS, &turn));
    gpio_debounce_edge(&debounce, 901 * MS, false, &turn);
    assert_int_equal(gpio_debounce_due_ns(&debounce), 906 * MS);
    assert_true(gpio_debounce_settle(&debounce, 906 * MS, &turn));
    assert_false(turn.active);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bouncing_contact_turns_once_at_its_last_bounce),
        cmocka_unit_test(test_a_spark_shorter_than_the_period_turns_nothing),
        cmocka_unit_test(test_edges_that_are_read_long_after_they_came_keep_their_times),
        cmocka_unit_test(test_without_a_period_every_edge_turns_at_once),
        cmocka_unit_test(test_a_line_that_is_active_from_the_start_turns_only_when_it_leaves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
