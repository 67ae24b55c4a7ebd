/* test_gpio_edge_filter.c -- tests the filter that combines the edges of a GPIO line with its
 * polled levels. The kernel may report edges late or lose them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"

#define MS 1000000ull
#define PERIOD_NS (3 * MS)

static struct debounce_edge_time change;
/* Time at which the thread reads an edge from the kernel. 0 means that each edge is read when it
 * occurs. */
static uint64_t taken_ns;

static bool edge(struct gpio_edge_filter *input, uint64_t time_ms, bool active,
                 uint32_t lost_before)
{
    const struct gpio_edge gpio_edge = {
        .time_ns = time_ms * MS,
        .active = active,
        .lost_before = lost_before,
        .taken_ns = taken_ns ? taken_ns : time_ms * MS,
    };
    return gpio_edge_filter_edge(input, &gpio_edge, &change);
}

static bool level(struct gpio_edge_filter *input, uint64_t now_ms, bool active)
{
    return gpio_edge_filter_level(input, now_ms * MS, active, &change);
}

static void assert_change(uint64_t time_ms, bool active)
{
    assert_int_equal(change.time_ns, time_ms * MS);
    assert_int_equal(change.active, active);
}

static void test_an_edge_is_a_change_when_the_level_confirms_it(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    assert_false(level(&input, 102, true));
    assert_true(level(&input, 103, true));
    assert_change(100, true);
    assert_false(edge(&input, 150, false, 0));
    assert_true(level(&input, 153, false));
    assert_change(150, false);
    assert_int_equal(input.blinks + input.lost, 0);
}

static void test_glitches_at_any_distance_are_no_pulse(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    for (uint64_t time_ms = 100; time_ms < 300; time_ms += 25) {
        assert_false(edge(&input, time_ms, false, 0));
        assert_false(level(&input, time_ms + 1, false));
    }
    assert_int_equal(input.blinks, 8);
    assert_int_equal(input.lost, 0);
    assert_int_equal(gpio_edge_filter_known_ns(&input, 301 * MS), 301 * MS);
}

static void test_two_glitches_that_are_read_late_are_no_pulse(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    /* The edges occurred at 100 and 125 ms, but the thread reads both at 130 ms. */
    taken_ns = 130 * MS;
    assert_false(edge(&input, 100, false, 0));
    assert_false(edge(&input, 125, false, 0));
    assert_false(level(&input, 130, false));
    assert_int_equal(input.doubtful, 1);
    /* The edges at 200 and 201 ms are too close together for a pulse, so they must be counted
     * neither as doubtful nor as late. */
    taken_ns = 260 * MS;
    assert_false(edge(&input, 200, false, 0));
    assert_false(edge(&input, 201, false, 0));
    taken_ns = 0;
    assert_false(level(&input, 400, false));
    assert_int_equal(input.doubtful + input.late, 1);
    assert_false(input.debounce.stable);
}

static void test_a_pulse_that_ended_before_its_edges_were_reported_is_a_pulse(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    /* The polls read a high level before the edges of the pulse are reported. */
    assert_false(level(&input, 102, true));
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 112, true));
    taken_ns = 118 * MS;
    /* The edge at 100 ms is reported when the pulse has already ended, so it is reported with a low
     * level. */
    assert_false(edge(&input, 100, false, 0));
    /* The kernel did not record the time of the falling edge. The edge therefore gets the time at
     * which the rising edge was read, 118 ms. */
    assert_true(edge(&input, 118, false, 0));
    taken_ns = 0;
    assert_change(100, true);
    assert_true(level(&input, 122, false));
    assert_change(118, false);
    assert_int_equal(input.late, 1);
    assert_int_equal(input.lost + input.doubtful, 0);
}

static void test_a_pulse_ends_at_the_level_that_was_read_before_its_edges(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 102, true));
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 117, false));
    /* The pulse ends at 117 ms, because the line was read as low then, although the falling edge
     * has the later time 170 ms. */
    assert_true(edge(&input, 100, false, 0));
    assert_change(100, true);
    assert_true(edge(&input, 170, false, 0));
    assert_change(117, false);
    assert_int_equal(input.lost + input.doubtful, 0);
}

static void test_one_level_read_during_a_glitch_proves_no_pulse(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    /* The poll at 100 ms reads a high level, because it falls into the first of two glitches. */
    assert_false(level(&input, 100, true));
    taken_ns = 130 * MS;
    assert_false(edge(&input, 100, false, 0));
    assert_false(edge(&input, 125, false, 0));
    taken_ns = 0;
    assert_false(level(&input, 131, false));
    assert_false(level(&input, 200, false));
    assert_int_equal(input.late, 0);
    assert_int_equal(input.doubtful, 1);
}

static void test_a_pulse_in_the_level_without_edges_is_counted_as_lost(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 102, true));
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 112, false));
    /* The edges of the pulse may still arrive, so they are not counted as lost yet. */
    assert_int_equal(input.lost, 0);
    assert_false(edge(&input, 500, true, 0));
    assert_int_equal(input.lost, 1);
}

static void test_an_edge_older_than_an_accepted_level_changes_nothing(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    level(&input, 102, true);
    level(&input, 112, true);
    assert_true(level(&input, 122, true));
    assert_change(102, true);
    /* The edge at 100 ms began the pulse that the polls have already detected. This edge is
     * reported late, with a low level, and must not end the pulse. */
    assert_false(edge(&input, 100, false, 0));
    assert_true(input.debounce.stable);
    assert_false(edge(&input, 160, false, 0));
    assert_true(level(&input, 163, false));
    assert_change(160, false);
    assert_int_equal(input.lost, 1);
}

static void test_blinks_within_a_bounce_are_no_doubtful_pair(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    taken_ns = 200 * MS;
    assert_false(edge(&input, 100, true, 0));
    /* This second rising edge shows that the contact bounced when it closed. */
    assert_false(edge(&input, 101, true, 0));
    /* This rising edge shows that the contact bounced when it opened. */
    assert_true(edge(&input, 140, true, 0));
    assert_change(101, true);
    assert_false(edge(&input, 141, false, 0));
    taken_ns = 0;
    assert_true(level(&input, 200, false));
    assert_change(141, false);
    assert_int_equal(input.doubtful, 0);
}

static void test_a_pulse_whose_first_edge_is_read_late_keeps_its_width(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 99, false));
    assert_false(edge(&input, 100, true, 0));
    /* The poll at 101 ms still returns the old level, low. The pulse must begin at 100 ms all the
     * same. */
    assert_false(level(&input, 101, false));
    assert_true(edge(&input, 120, false, 0));
    assert_change(100, true);
    assert_true(level(&input, 126, false));
    assert_change(120, false);
}

static void test_bounces_that_are_merged_into_one_edge_do_not_change_the_level(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    /* The contact opened and closed again, and the kernel merged both changes into one rising
     * edge. */
    assert_false(edge(&input, 102, true, 0));
    assert_true(edge(&input, 140, false, 0));
    assert_change(102, true);
    assert_true(level(&input, 143, false));
    assert_change(140, false);
}

static void test_lost_numbered_edges_are_counted_and_the_others_accepted(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    assert_true(level(&input, 110, true));
    /* The edge has the same level as the edge before. This is possible because 6 edges were lost in
     * between, so the edge does not count as a change. */
    assert_false(edge(&input, 200, true, 6));
    assert_int_equal(input.lost, 6);
    assert_false(level(&input, 300, true));
    assert_false(edge(&input, 400, false, 2));
    assert_true(level(&input, 403, false));
    assert_change(400, false);
    assert_int_equal(input.lost, 8);
}

static void test_a_level_without_an_edge_is_accepted_after_the_timeout(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 100, true));
    assert_int_equal(gpio_edge_filter_due_ns(&input), 120 * MS);
    /* The high level is not accepted before 120 ms, because its edge may still arrive. */
    assert_false(level(&input, 119, true));
    assert_int_equal(gpio_edge_filter_known_ns(&input, 119 * MS), 100 * MS);
    assert_true(level(&input, 120, true));
    assert_int_equal(input.lost, 1);
    assert_change(100, true);
    /* The high level was accepted at 120 ms, so an edge with an earlier time must change
     * nothing. */
    assert_false(edge(&input, 99, true, 0));
    assert_false(level(&input, 200, true));
    assert_int_equal(input.lost, 1);
}

static void test_a_level_that_is_read_before_its_edge_counts_no_loss(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 100, true));
    assert_false(edge(&input, 99, true, 0));
    assert_true(level(&input, 102, true));
    assert_change(99, true);
    assert_int_equal(input.lost, 0);
}

static void test_changes_are_known_up_to_the_first_unconfirmed_level(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_int_equal(gpio_edge_filter_known_ns(&input, 50 * MS), 50 * MS);
    edge(&input, 100, true, 0);
    assert_int_equal(gpio_edge_filter_known_ns(&input, 101 * MS), 100 * MS);
    assert_true(level(&input, 103, true));
    assert_int_equal(gpio_edge_filter_known_ns(&input, 103 * MS), 103 * MS);
    level(&input, 200, false);
    assert_int_equal(gpio_edge_filter_known_ns(&input, 210 * MS), 200 * MS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_edge_is_a_change_when_the_level_confirms_it),
        cmocka_unit_test(test_glitches_at_any_distance_are_no_pulse),
        cmocka_unit_test(test_two_glitches_that_are_read_late_are_no_pulse),
        cmocka_unit_test(test_a_pulse_that_ended_before_its_edges_were_reported_is_a_pulse),
        cmocka_unit_test(test_a_pulse_ends_at_the_level_that_was_read_before_its_edges),
        cmocka_unit_test(test_one_level_read_during_a_glitch_proves_no_pulse),
        cmocka_unit_test(test_a_pulse_in_the_level_without_edges_is_counted_as_lost),
        cmocka_unit_test(test_an_edge_older_than_an_accepted_level_changes_nothing),
        cmocka_unit_test(test_blinks_within_a_bounce_are_no_doubtful_pair),
        cmocka_unit_test(test_a_pulse_whose_first_edge_is_read_late_keeps_its_width),
        cmocka_unit_test(test_bounces_that_are_merged_into_one_edge_do_not_change_the_level),
        cmocka_unit_test(test_lost_numbered_edges_are_counted_and_the_others_accepted),
        cmocka_unit_test(test_a_level_without_an_edge_is_accepted_after_the_timeout),
        cmocka_unit_test(test_a_level_that_is_read_before_its_edge_counts_no_loss),
        cmocka_unit_test(test_changes_are_known_up_to_the_first_unconfirmed_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
