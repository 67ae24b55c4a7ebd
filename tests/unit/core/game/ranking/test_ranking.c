/* Who stands where, and when a day and a week are over. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/ranking/ranking.h"

#define SOME_DAY 9800u /* In 2026. */

static struct ranking ranking;
static uint32_t last_id;

static int clean(void **state)
{
    (void)state;
    memset(&ranking, 0, sizeof ranking);
    last_id = 0;
    return 0;
}

/* A round of one player; returns its id. */
static uint32_t play(uint32_t caught, uint32_t boot, uint16_t day)
{
    const struct ledger_entry entry = {
        .kind = LEDGER_ROUND,
        .id = ++last_id,
        .boot = boot,
        .day = day,
        .round = { .players = 1, .player[0].caught = caught },
    };
    ranking_note(&ranking, &entry);
    return entry.id;
}

static void pass(enum ledger_kind kind, uint32_t boot, uint16_t day)
{
    const struct ledger_entry entry = {
        .kind = (uint8_t)kind, .id = ++last_id, .boot = boot, .day = day
    };
    ranking_note(&ranking, &entry);
}

static uint32_t best(enum rank_period period)
{
    return ranking.row[MODE_FESTIVAL][period][0].caught;
}

static uint32_t place(enum rank_period period, uint32_t id)
{
    return ranking_place(&ranking, MODE_FESTIVAL, period, id, 0);
}

static void test_more_fish_stand_higher_and_of_equals_the_earlier(void **state)
{
    (void)state;
    const uint32_t three = play(3, 1, 9000), five = play(5, 1, 9000), late = play(3, 1, 9000);
    assert_int_equal(place(RANK_EVER, five), 0);
    assert_int_equal(place(RANK_EVER, three), 1);
    assert_int_equal(place(RANK_EVER, late), 2);
}

static void test_the_eleventh_is_not_on_the_board_and_nobody_with_no_fish_is(void **state)
{
    (void)state;
    const uint32_t worst = play(1, 1, 9000);
    assert_int_equal(place(RANK_DAY, worst), 0);
    for (uint32_t i = 0; i < RANK_ROWS; i++) {
        assert_int_equal(place(RANK_DAY, worst), i);
        play(2, 1, 9000);
    }
    assert_int_equal(place(RANK_DAY, worst), RANK_ROWS);
    clean(NULL);
    assert_int_equal(place(RANK_DAY, play(0, 1, 9000)), RANK_ROWS);
}

static void test_bots_and_rounds_without_a_score_stand_nowhere(void **state)
{
    (void)state;
    struct ledger_entry entry = { .kind = LEDGER_ROUND,
                                  .id = 1,
                                  .round = { .players = 1, .player[0].caught = 9 } };
    entry.round.by_bot = 1;
    ranking_note(&ranking, &entry);
    entry.round.by_bot = 0;
    entry.round.unscored = 1;
    ranking_note(&ranking, &entry);
    assert_int_equal(best(RANK_EVER), 0);
}

static void test_four_players_of_one_round_stand_each_where_they_belong(void **state)
{
    (void)state;
    struct ledger_entry entry = { .kind = LEDGER_ROUND, .id = 7, .round = { .players = 0xf } };
    for (uint32_t seat = 0; seat < POI_MAX; seat++) {
        entry.round.player[seat].caught = 10u + seat;
    }
    entry.round.players = 0xb; /* The third went home. */
    ranking_note(&ranking, &entry);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 3), 0);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 1), 1);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 0), 2);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 2), RANK_ROWS);
}

static void test_a_name_comes_to_every_board_its_round_is_on_and_goes_again(void **state)
{
    (void)state;
    struct ledger_entry name = { .kind = LEDGER_NAME, .boot = 1, .day = 9000, .name = "きんぎょ" };
    name.count = play(4, 1, 9000);
    ranking_note(&ranking, &name);
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        assert_string_equal(ranking.row[0][period][0].name, "きんぎょ");
    }
    memset(name.name, 0, sizeof name.name);
    ranking_note(&ranking, &name);
    assert_string_equal(ranking.row[0][RANK_EVER][0].name, "");
    assert_int_equal(best(RANK_EVER), 4); /* what was caught was caught */
}

static void test_midnight_ends_the_day_and_sunday_night_the_week(void **state)
{
    (void)state;
    uint16_t monday = SOME_DAY;
    while ((monday + 5u) % 7u != 0) {
        monday++;
    }
    play(5, 1, monday);
    play(3, 1, (uint16_t)(monday + 6u));
    assert_int_equal(best(RANK_DAY), 3);
    assert_int_equal(best(RANK_WEEK), 5);
    play(1, 1, (uint16_t)(monday + 7u));
    assert_int_equal(best(RANK_DAY), 1);
    assert_int_equal(best(RANK_WEEK), 1);
    assert_int_equal(best(RANK_EVER), 5);
}

static void test_any_entry_tells_that_a_new_day_has_begun(void **state)
{
    (void)state;
    play(5, 1, 9000);
    pass(LEDGER_HEALTH, 1, 9001);
    assert_int_equal(best(RANK_DAY), 0);
}

static void test_a_clock_that_is_set_back_over_midnight_takes_nobody_off(void **state)
{
    (void)state;
    play(5, 1, 9000);
    play(3, 1, 8999);
    assert_int_equal(best(RANK_DAY), 5);
    play(4, 1, 9000);
    assert_int_equal(best(RANK_DAY), 5);
}

static void test_a_wild_date_holds_the_board_no_longer_than_it_is_told(void **state)
{
    (void)state;
    play(5, 1, 9000);
    play(3, 1, 30000); /* 2082 */
    assert_int_equal(best(RANK_DAY), 3);
    play(2, 1, 9000);
    assert_int_equal(best(RANK_DAY), 2);
    play(1, 1, 9001);
    assert_int_equal(best(RANK_DAY), 1);
}

static void test_without_a_clock_a_day_is_as_long_as_the_kiosk_runs(void **state)
{
    (void)state;
    play(5, 1, 0);
    play(3, 1, 0);
    assert_int_equal(best(RANK_DAY), 5);
    pass(LEDGER_BOOT, 2, 0);
    assert_int_equal(best(RANK_DAY), 5); /* nobody has played today yet */
    play(2, 2, 0);
    assert_int_equal(best(RANK_DAY), 2);
    assert_int_equal(best(RANK_WEEK), 5);
}

static void test_without_a_clock_seven_starts_are_a_week(void **state)
{
    (void)state;
    for (uint32_t boot = 1; boot <= 7; boot++) {
        play(20u - boot, boot, 0);
    }
    assert_int_equal(best(RANK_WEEK), 13); /* The seventh start after none began another. */
    for (uint32_t boot = 8; boot <= 13; boot++) {
        play(1, boot, 0);
        assert_int_equal(best(RANK_WEEK), 13);
    }
    play(1, 14, 0);
    assert_int_equal(best(RANK_WEEK), 1);
}

static void test_a_clock_that_is_set_a_minute_after_the_start_ends_no_day(void **state)
{
    (void)state;
    play(5, 1, 9000);
    pass(LEDGER_BOOT, 2, 0); /* No battery: the date comes from the network. */
    pass(LEDGER_COINS, 2, 0);
    pass(LEDGER_COINS, 2, 9000);
    assert_int_equal(best(RANK_DAY), 5);
}

static void test_what_was_played_before_the_clock_was_set_is_of_that_day(void **state)
{
    (void)state;
    play(5, 1, 9000);
    play(4, 2, 0);
    play(3, 2, 9001);
    assert_int_equal(best(RANK_DAY), 4);
    play(2, 3, 0); /* Another start without one: nothing says that it is the same day. */
    assert_int_equal(best(RANK_DAY), 2);
    assert_int_equal(best(RANK_EVER), 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_more_fish_stand_higher_and_of_equals_the_earlier, clean),
        cmocka_unit_test_setup(test_the_eleventh_is_not_on_the_board_and_nobody_with_no_fish_is,
                               clean),
        cmocka_unit_test_setup(test_bots_and_rounds_without_a_score_stand_nowhere, clean),
        cmocka_unit_test_setup(test_four_players_of_one_round_stand_each_where_they_belong, clean),
        cmocka_unit_test_setup(test_a_name_comes_to_every_board_its_round_is_on_and_goes_again,
                               clean),
        cmocka_unit_test_setup(test_midnight_ends_the_day_and_sunday_night_the_week, clean),
        cmocka_unit_test_setup(test_any_entry_tells_that_a_new_day_has_begun, clean),
        cmocka_unit_test_setup(test_a_clock_that_is_set_back_over_midnight_takes_nobody_off, clean),
        cmocka_unit_test_setup(test_a_wild_date_holds_the_board_no_longer_than_it_is_told, clean),
        cmocka_unit_test_setup(test_without_a_clock_a_day_is_as_long_as_the_kiosk_runs, clean),
        cmocka_unit_test_setup(test_without_a_clock_seven_starts_are_a_week, clean),
        cmocka_unit_test_setup(test_a_clock_that_is_set_a_minute_after_the_start_ends_no_day,
                               clean),
        cmocka_unit_test_setup(test_what_was_played_before_the_clock_was_set_is_of_that_day, clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
