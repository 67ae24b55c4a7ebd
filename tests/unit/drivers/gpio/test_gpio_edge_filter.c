/* test_gpio_edge_filter.c -- what is believed of a line whose kernel is late, and of one that
 * lost. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_signal.h"

#define MS 1000000ull
#define PERIOD_NS (3 * MS)

static struct debounce_edge_time turn;
static uint64_t taken_ns; /* Of edges; 0: as soon as they came. */

static bool edge(struct gpio_edge_filter *input, uint64_t time_ms, bool active,
                 uint32_t lost_before)
{
    const struct gpio_edge gpio_edge = {
        .time_ns = time_ms * MS,
        .active = active,
        .lost_before = lost_before,
        .taken_ns = taken_ns ? taken_ns : time_ms * MS,
    };
    return gpio_edge_filter_edge(input, &gpio_edge, &turn);
}

static bool level(struct gpio_edge_filter *input, uint64_t now_ms, bool active)
{
    return gpio_edge_filter_level(input, now_ms * MS, active, &turn);
}

static void assert_turn(uint64_t time_ms, bool active)
{
    assert_int_equal(turn.time_ns, time_ms * MS);
    assert_int_equal(turn.active, active);
}

static void test_edges_of_the_right_direction_turn_when_the_level_says_so_too(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    assert_false(level(&input, 102, true));
    assert_true(level(&input, 103, true));
    assert_turn(100, true);
    assert_false(edge(&input, 150, false, 0));
    assert_true(level(&input, 153, false));
    assert_turn(150, false);
    assert_int_equal(input.blinks + input.lost, 0);
}

static void test_sparks_are_no_pulse_however_far_apart(void **state)
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

static void test_two_sparks_are_no_pulse_however_late_the_reader_comes(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    taken_ns = 130 * MS; /* The kernel told each at once; the reader was not run. */
    assert_false(edge(&input, 100, false, 0));
    assert_false(edge(&input, 125, false, 0));
    assert_false(level(&input, 130, false));
    assert_int_equal(input.doubtful, 1);
    taken_ns = 160 * MS; /* Nor if the second is dated just when the first was taken. */
    assert_false(edge(&input, 200, false, 0));
    taken_ns = 0;
    assert_false(edge(&input, 201, false, 0));
    assert_false(level(&input, 400, false));
    assert_int_equal(input.doubtful + input.late, 1);
    assert_false(input.debounce.stable);
}

static void test_a_pulse_that_was_over_before_the_kernel_looked_is_a_pulse(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 102, true)); /* It is seen, but not told, ... */
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 112, true));
    taken_ns = 118 * MS;
    assert_false(edge(&input, 100, false, 0)); /* ... and told when it is over: */
    assert_true(edge(&input, 118, false, 0));  /* its masked end is dated just then. */
    taken_ns = 0;
    assert_turn(100, true);
    assert_true(level(&input, 122, false));
    assert_turn(118, false);
    assert_int_equal(input.late, 1);
    assert_int_equal(input.lost + input.doubtful, 0);
}

static void test_a_pulse_that_was_seen_to_end_before_it_was_told_has_that_end(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 102, true));
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 117, false));
    assert_true(edge(&input, 100, false, 0)); /* Told at 170. */
    assert_turn(100, true);
    assert_true(edge(&input, 170, false, 0));
    assert_turn(117, false);
    assert_int_equal(input.lost + input.doubtful, 0);
}

static void test_one_look_at_a_spark_is_no_proof(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 100, true)); /* By chance, just then. */
    taken_ns = 130 * MS;
    assert_false(edge(&input, 100, false, 0));
    assert_false(edge(&input, 125, false, 0));
    taken_ns = 0;
    assert_false(level(&input, 131, false));
    assert_false(level(&input, 200, false));
    assert_int_equal(input.late, 0);
    assert_int_equal(input.doubtful, 1);
}

static void test_a_pulse_that_was_seen_and_never_told_is_a_loss(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 102, true));
    assert_false(level(&input, 107, true));
    assert_false(level(&input, 112, false));
    assert_int_equal(input.lost, 0); /* It may still be told. */
    assert_false(edge(&input, 500, true, 0));
    assert_int_equal(input.lost, 1);
}

static void test_news_from_before_a_level_that_was_believed_changes_nothing(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    level(&input, 102, true);
    level(&input, 112, true);
    assert_true(level(&input, 122, true));
    assert_turn(102, true);
    assert_false(edge(&input, 100, false, 0)); /* The edge that was missing, read as it is over. */
    assert_true(input.debounce.stable);
    assert_false(edge(&input, 160, false, 0));
    assert_true(level(&input, 163, false));
    assert_turn(160, false);
    assert_int_equal(input.lost, 1);
}

static void test_blinks_within_a_bounce_are_no_pair_however_late(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    taken_ns = 200 * MS;
    assert_false(edge(&input, 100, true, 0));
    assert_false(edge(&input, 101, true, 0)); /* It bounced as it closed ... */
    assert_true(edge(&input, 140, true, 0));  /* ... and as it opened. */
    assert_turn(101, true);
    assert_false(edge(&input, 141, false, 0));
    taken_ns = 0;
    assert_true(level(&input, 200, false));
    assert_turn(141, false);
    assert_int_equal(input.doubtful, 0);
}

static void test_a_pulse_that_was_read_late_in_its_time_keeps_its_width(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 99, false));
    assert_false(edge(&input, 100, true, 0)); /* Comes at 106. */
    assert_false(level(&input, 101, false));  /* And here the level knew nothing of it. */
    assert_true(edge(&input, 120, false, 0));
    assert_turn(100, true);
    assert_true(level(&input, 126, false));
    assert_turn(120, false);
}

static void test_bounces_that_are_read_as_one_leave_the_line_where_it_is(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    assert_false(edge(&input, 102, true, 0)); /* Open and closed again, read as closed. */
    assert_true(edge(&input, 140, false, 0));
    assert_turn(102, true);
    assert_true(level(&input, 143, false));
    assert_turn(140, false);
}

static void test_numbered_edges_that_were_lost_are_counted_and_the_rest_is_believed(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(edge(&input, 100, true, 0));
    assert_true(level(&input, 110, true));
    assert_false(edge(&input, 200, true, 6)); /* As it stands already: nothing turns, no blink. */
    assert_int_equal(input.lost, 6);
    assert_false(level(&input, 300, true));
    assert_false(edge(&input, 400, false, 2));
    assert_true(level(&input, 403, false));
    assert_turn(400, false);
    assert_int_equal(input.lost, 8);
}

static void test_a_level_that_no_edge_told_of_is_believed_after_a_while(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 100, true));
    assert_int_equal(gpio_edge_filter_due_ns(&input), 120 * MS);
    assert_false(level(&input, 119, true)); /* Its edge may be under way. */
    assert_int_equal(gpio_edge_filter_known_ns(&input, 119 * MS), 100 * MS);
    assert_true(level(&input, 120, true));
    assert_int_equal(input.lost, 1);
    assert_turn(100, true);
    assert_false(edge(&input, 99, true, 0)); /* Here it comes, and changes nothing any more. */
    assert_false(level(&input, 200, true));
    assert_int_equal(input.lost, 1);
}

static void test_a_level_read_before_its_edge_came_mends_nothing(void **state)
{
    (void)state;
    struct gpio_edge_filter input = gpio_edge_filter_begin(PERIOD_NS, false, 0);
    assert_false(level(&input, 100, true));
    assert_false(edge(&input, 99, true, 0));
    assert_true(level(&input, 102, true));
    assert_turn(99, true);
    assert_int_equal(input.lost, 0);
}

static void test_turns_are_known_up_to_where_something_still_has_to_stand(void **state)
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
        cmocka_unit_test(test_edges_of_the_right_direction_turn_when_the_level_says_so_too),
        cmocka_unit_test(test_sparks_are_no_pulse_however_far_apart),
        cmocka_unit_test(test_two_sparks_are_no_pulse_however_late_the_reader_comes),
        cmocka_unit_test(test_a_pulse_that_was_over_before_the_kernel_looked_is_a_pulse),
        cmocka_unit_test(test_a_pulse_that_was_seen_to_end_before_it_was_told_has_that_end),
        cmocka_unit_test(test_one_look_at_a_spark_is_no_proof),
        cmocka_unit_test(test_a_pulse_that_was_seen_and_never_told_is_a_loss),
        cmocka_unit_test(test_news_from_before_a_level_that_was_believed_changes_nothing),
        cmocka_unit_test(test_blinks_within_a_bounce_are_no_pair_however_late),
        cmocka_unit_test(test_a_pulse_that_was_read_late_in_its_time_keeps_its_width),
        cmocka_unit_test(test_bounces_that_are_read_as_one_leave_the_line_where_it_is),
        cmocka_unit_test(test_numbered_edges_that_were_lost_are_counted_and_the_rest_is_believed),
        cmocka_unit_test(test_a_level_that_no_edge_told_of_is_believed_after_a_while),
        cmocka_unit_test(test_a_level_read_before_its_edge_came_mends_nothing),
        cmocka_unit_test(test_turns_are_known_up_to_where_something_still_has_to_stand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
