/* test_day.c -- tests the visitors, the queue and the report of a simulated day (make bench-day). A
 * fake kiosk replaces the real one: it plays no rounds and returns fixed catches. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "platform/os/exit_code.h"
#include "tests/bench/day/report.h"

#define MANY 2000u
#define VISITORS 200u
#define S_PER_HOUR 3600.0

/* A fake kiosk, whose rounds take `round_s` seconds and give each person `caught` fish. */
static struct fake_kiosk {
    double round_s;
    uint32_t caught;
    uint32_t rounds, persons, persons_most;
    uint8_t level; /* Level of the last round. */
    bool fails;
} fake;

static struct day day;

static bool fake_play(void *self, const struct visitor *const *group, uint32_t count, uint8_t level,
                      struct day_round *out)
{
    struct fake_kiosk *kiosk = self;
    kiosk->rounds++;
    kiosk->persons += count;
    kiosk->persons_most = count > kiosk->persons_most ? count : kiosk->persons_most;
    kiosk->level = level;
    for (uint32_t i = 0; i < count; i++) {
        /* Nobody may play at a harder level than the chosen one. */
        assert_true(group[i]->level <= level);
        /* Nobody who still waits joined the queue earlier. */
        for (uint32_t k = 0; k < day.queue_length; k++) {
            assert_true(day.visitors[day.queue[k]].joined_s >= group[i]->joined_s);
        }
        out->caught[i] = kiosk->caught;
    }
    out->took_s = kiosk->round_s;
    return !kiosk->fails;
}

static bool fake_idle(void *self, double seconds)
{
    (void)self;
    assert_true(seconds > 0.0);
    return true;
}

/* Simulates a day at the fake kiosk with rounds of `round_s` seconds and `caught` fish for each
 * person. */
static void play_day(const struct day_options *options, double round_s, uint32_t caught)
{
    fake = (struct fake_kiosk){ .round_s = round_s, .caught = caught };
    day_init(&day, options,
             (struct day_kiosk){ .play = fake_play, .idle = fake_idle, .self = &fake });
    assert_true(day_run(&day));
}

static const struct day_options usual = {
    .price = 1,
    .round_s = 60,
    .level = LEVEL_NORMAL,
    .bowls = 1,
    .visitors = VISITORS,
    .seed = 3,
    .hours = 8,
    .goal = 90,
};

/* ---- Visitors -------------------------------------------------------------------------------- */

static struct visitor first[MANY], second[MANY];

static void test_visitors_depend_only_on_the_seed(void **state)
{
    (void)state;
    struct visitor_day what = { .hours = 8.0, .level = LEVEL_NORMAL, .seed = 1 };
    visitors_draw(first, MANY, &what);
    visitors_draw(second, MANY, &what);
    assert_memory_equal(first, second, sizeof first);
    what.seed = 2;
    visitors_draw(second, MANY, &what);
    assert_memory_not_equal(first, second, sizeof first);
}

static void test_each_kind_has_its_share(void **state)
{
    (void)state;
    const struct visitor_day what = { .hours = 8.0, .level = LEVEL_NORMAL, .seed = 1 };
    double sum = 0.0;
    visitors_draw(first, MANY, &what);
    for (uint32_t kind = 0; kind < visitor_kind_count; kind++) {
        uint32_t count = 0;
        for (uint32_t i = 0; i < MANY; i++) {
            count += first[i].kind == kind;
        }
        assert_float_equal((double)count / MANY, visitor_kinds[kind].share, 0.03);
        sum += visitor_kinds[kind].share;
    }
    assert_float_equal(sum, 1.0, 1e-9);
}

static void test_visitors_come_in_order_and_most_in_the_evening(void **state)
{
    (void)state;
    const struct visitor_day what = { .hours = 8.0, .level = LEVEL_NORMAL, .seed = 1 };
    uint32_t early = 0, evening = 0;
    visitors_draw(first, MANY, &what);
    for (uint32_t i = 0; i < MANY; i++) {
        const double hour = first[i].arrival_s / S_PER_HOUR;
        assert_true(hour >= 0.0 && hour < 8.0);
        assert_true(i == 0 || first[i].arrival_s >= first[i - 1u].arrival_s);
        early += hour < 2.0;
        evening += hour >= 4.5 && hour < 6.5;
    }
    assert_true(evening > 2u * early);
}

static void test_default_level_is_that_of_visitors_who_choose_none(void **state)
{
    (void)state;
    struct visitor_day what = { .hours = 8.0, .level = LEVEL_NORMAL, .seed = 1 };
    uint32_t normal = 0;
    visitors_draw(first, MANY, &what);
    what.level = LEVEL_EASY;
    visitors_draw(second, MANY, &what);
    for (uint32_t i = 0; i < MANY; i++) {
        normal += first[i].level == LEVEL_NORMAL;
        const uint8_t expected = first[i].level == LEVEL_NORMAL ? LEVEL_EASY : first[i].level;
        assert_int_equal(second[i].level, expected);
    }
    assert_in_range(normal, MANY / 2u, MANY - 1u);
}

/* Returns how many of the visitors play again, after they caught `caught` fish at the price
 * `price`. */
static uint32_t count_again(uint32_t caught, uint32_t price, uint32_t plays)
{
    const struct visitor_day what = { .hours = 8.0, .level = LEVEL_NORMAL, .seed = 1 };
    uint32_t count = 0;
    visitors_draw(first, MANY, &what);
    for (uint32_t i = 0; i < MANY; i++) {
        first[i].plays = plays;
        first[i].caught_last = caught;
        count += visitor_plays_again(&first[i], price);
    }
    return count;
}

static void test_second_plays_depend_on_catch_and_price(void **state)
{
    (void)state;
    assert_in_range(count_again(1, 1, 1), MANY / 3u, MANY / 2u);
    assert_true(count_again(1, 1, 1) > count_again(0, 1, 1));
    assert_true(count_again(1, 1, 1) > count_again(1, 3, 1));
    assert_true(count_again(1, 0, 1) > count_again(1, 1, 1));
    assert_int_equal(count_again(1, 0, VISITOR_PLAYS_MAX), 0);
}

/* ---- Queue ----------------------------------------------------------------------------------- */

static void test_every_visitor_plays_leaves_or_declines(void **state)
{
    (void)state;
    play_day(&usual, 100.0, 1);
    const struct day_sums all = report_sums(&day, REPORT_ALL, REPORT_ALL);
    assert_int_equal(all.visitors, VISITORS);
    assert_int_equal(all.declined + all.left + all.played, VISITORS);
    assert_int_equal(all.declined, 0);
    assert_true(all.left > 0 && all.played > all.left);
    assert_int_equal(all.plays, fake.persons);
    assert_int_equal(all.caught, fake.persons);
    assert_int_equal(fake.persons_most, 1);
    assert_true(day.queue_longest > 2);
    for (uint32_t i = 0; i < VISITORS; i++) {
        const struct visitor *visitor = &day.visitors[i];
        assert_true(visitor->wait_s >= 0.0 && visitor->wait_s <= visitor->patience_s);
        assert_true((visitor->plays > 0) == (visitor->fate == VISITOR_PLAYED));
    }
}

static void test_person_who_plays_again_waits_at_the_end_of_the_queue(void **state)
{
    (void)state;
    play_day(&usual, 100.0, 1); /* fake_play() checks the order of the queue. */
    uint32_t again = 0;
    for (uint32_t i = 0; i < VISITORS; i++) {
        const struct visitor *visitor = &day.visitors[i];
        if (visitor->plays > 1u) {
            again++;
            assert_true(visitor->joined_s >= visitor->arrival_s + visitor->wait_s + fake.round_s);
        }
    }
    assert_true(again > 0);
}

static void test_more_bowls_shorten_the_queue(void **state)
{
    (void)state;
    struct day_options wide = usual;
    play_day(&usual, 100.0, 1);
    const uint32_t left = report_sums(&day, REPORT_ALL, REPORT_ALL).left;
    wide.bowls = 4;
    play_day(&wide, 100.0, 1);
    assert_true(report_sums(&day, REPORT_ALL, REPORT_ALL).left < left / 4u);
    assert_int_equal(fake.persons_most, 4);
    assert_true(fake.rounds < fake.persons);
}

static void test_group_plays_the_easiest_level_of_its_persons(void **state)
{
    (void)state;
    struct day_options wide = usual;
    wide.bowls = 4;
    /* During this day, fake_play() checks each group. */
    play_day(&wide, 100.0, 1);
    assert_true(day.rounds[LEVEL_EASY] > 0 && day.rounds[LEVEL_NORMAL] > 0);
    assert_int_equal(day.rounds[LEVEL_EASY] + day.rounds[LEVEL_NORMAL] + day.rounds[LEVEL_MASTER],
                     fake.rounds);
}

static void test_failed_kiosk_ends_the_day(void **state)
{
    (void)state;
    fake = (struct fake_kiosk){ .round_s = 60.0, .fails = true };
    day_init(&day, &usual,
             (struct day_kiosk){ .play = fake_play, .idle = fake_idle, .self = &fake });
    assert_false(day_run(&day));
    assert_int_equal(fake.rounds, 1);
}

/* ---- Goal and advice ------------------------------------------------------------------------- */

static void test_goal_counts_all_visitors(void **state)
{
    (void)state;
    play_day(&usual, 10.0, 1);
    assert_true(report_is_goal_met(&day));
    play_day(&usual, 10.0, 0);
    assert_false(report_is_goal_met(&day));
    /* Every visitor who plays catches a fish, but many visitors leave the queue. */
    play_day(&usual, 200.0, 1);
    assert_false(report_is_goal_met(&day));
}

static void test_advice_names_the_largest_loss(void **state)
{
    (void)state;
    struct day_options options = usual;
    play_day(&options, 10.0, 0);
    assert_non_null(strstr(report_advice(&day), "LEVEL"));
    options.level = LEVEL_EASY;
    play_day(&options, 10.0, 0);
    assert_non_null(strstr(report_advice(&day), "lengthen ROUND"));
    play_day(&options, 200.0, 1);
    assert_non_null(strstr(report_advice(&day), "PLAYERS"));
    options.bowls = 4;
    play_day(&options, 2000.0, 1);
    assert_non_null(strstr(report_advice(&day), "second kiosk"));
    options.price = 7;
    play_day(&options, 10.0, 1);
    assert_non_null(strstr(report_advice(&day), "lower PRICE"));
}

static void test_advice_is_about_the_queue_if_queue_and_catches_lose_the_same(void **state)
{
    (void)state;
    play_day(&usual, 10.0, 1);
    for (uint32_t i = 0; i < 6u; i++) {
        day.visitors[i].fate = i < 3u ? VISITOR_LEFT : VISITOR_PLAYED;
        day.visitors[i].caught = 0;
    }
    const struct day_sums all = report_sums(&day, REPORT_ALL, REPORT_ALL);
    assert_int_equal(all.left, all.played - all.with_fish);
    assert_non_null(strstr(report_advice(&day), "PLAYERS"));
}

static void test_nobody_plays_at_a_price_that_nobody_pays(void **state)
{
    (void)state;
    struct day_options options = usual;
    options.price = 20;
    play_day(&options, 60.0, 1);
    assert_int_equal(report_sums(&day, REPORT_ALL, REPORT_ALL).declined, VISITORS);
    assert_int_equal(fake.rounds, 0);
}

static void test_wrong_accounts_are_found(void **state)
{
    (void)state;
    play_day(&usual, 10.0, 2);
    struct day_money money = { .units = fake.rounds,
                               .paid_plays = fake.rounds,
                               .caught = 2u * fake.persons };
    assert_true(report_is_money_right(&day, &money));
    assert_int_equal(report_print(&day, &money), EXIT_OK);
    money.units++;
    assert_false(report_is_money_right(&day, &money));
    assert_int_equal(report_print(&day, &money), EXIT_NOT_SO);
    money.units--;
    money.refunds = 1;
    assert_false(report_is_money_right(&day, &money));
    money.refunds = 0;
    money.caught--;
    assert_false(report_is_money_right(&day, &money));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_visitors_depend_only_on_the_seed),
        cmocka_unit_test(test_each_kind_has_its_share),
        cmocka_unit_test(test_visitors_come_in_order_and_most_in_the_evening),
        cmocka_unit_test(test_default_level_is_that_of_visitors_who_choose_none),
        cmocka_unit_test(test_second_plays_depend_on_catch_and_price),
        cmocka_unit_test(test_every_visitor_plays_leaves_or_declines),
        cmocka_unit_test(test_person_who_plays_again_waits_at_the_end_of_the_queue),
        cmocka_unit_test(test_more_bowls_shorten_the_queue),
        cmocka_unit_test(test_group_plays_the_easiest_level_of_its_persons),
        cmocka_unit_test(test_failed_kiosk_ends_the_day),
        cmocka_unit_test(test_goal_counts_all_visitors),
        cmocka_unit_test(test_advice_names_the_largest_loss),
        cmocka_unit_test(test_advice_is_about_the_queue_if_queue_and_catches_lose_the_same),
        cmocka_unit_test(test_nobody_plays_at_a_price_that_nobody_pays),
        cmocka_unit_test(test_wrong_accounts_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
