/* test_ranking.c -- checks the order of scores on the leaderboards, and when the leaderboards of a
 * day and a week are cleared. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/ranking/ranking.h"
#include "core/game/rules.h"

#define SOME_DAY 9800u /* A day in October 2026, as a number of days since 2000-01-01. */

static struct ranking ranking;
static uint32_t last_id;

static int clean(void **state)
{
    (void)state;
    memset(&ranking, 0, sizeof ranking);
    last_id = 0;
    return 0;
}

/* Adds the ledger entry of a round with one player. `boot` is the number of the kiosk's start.
 * Returns the id of the entry. */
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

static void test_scores_are_ordered_by_fish_and_then_by_time(void **state)
{
    (void)state;
    const uint32_t three = play(3, 1, 9000), five = play(5, 1, 9000), late = play(3, 1, 9000);
    assert_int_equal(place(RANK_EVER, five), 0);
    assert_int_equal(place(RANK_EVER, three), 1);
    assert_int_equal(place(RANK_EVER, late), 2);
}

static void test_rank_eleven_and_scores_without_fish_are_not_on_the_leaderboard(void **state)
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

static void test_bots_and_unscored_rounds_are_not_ranked(void **state)
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

static void test_four_players_of_one_round_are_ranked_separately(void **state)
{
    (void)state;
    struct ledger_entry entry = { .kind = LEDGER_ROUND, .id = 7, .round = { .players = 0xf } };
    for (uint32_t slot = 0; slot < POI_MAX; slot++) {
        entry.round.player[slot].caught = 10u + slot;
    }
    entry.round.players = 0xb; /* Bits 0, 1 and 3 are set, because player 2 did not take part until
                                  the end. */
    ranking_note(&ranking, &entry);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 3), 0);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 1), 1);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 0), 2);
    assert_int_equal(ranking_place(&ranking, 0, RANK_DAY, 7, 2), RANK_ROWS);
}

static void test_a_name_is_set_and_removed_on_every_leaderboard_of_its_round(void **state)
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
    /* The 4 fish that were caught on the day before still count for all time. */
    assert_int_equal(best(RANK_EVER), 4);
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

static void test_any_entry_of_a_new_day_starts_that_day(void **state)
{
    (void)state;
    play(5, 1, 9000);
    pass(LEDGER_HEALTH, 1, 9001);
    assert_int_equal(best(RANK_DAY), 0);
}

static void test_a_clock_set_back_over_midnight_removes_no_score(void **state)
{
    (void)state;
    play(5, 1, 9000);
    play(3, 1, 8999);
    assert_int_equal(best(RANK_DAY), 5);
    play(4, 1, 9000);
    assert_int_equal(best(RANK_DAY), 5);
}

static void test_a_wrong_date_affects_the_leaderboard_only_while_it_lasts(void **state)
{
    (void)state;
    play(5, 1, 9000);
    /* Day 30000 is in the year 2082, so the clock must be wrong. */
    play(3, 1, 30000);
    assert_int_equal(best(RANK_DAY), 3);
    play(2, 1, 9000);
    assert_int_equal(best(RANK_DAY), 2);
    play(1, 1, 9001);
    assert_int_equal(best(RANK_DAY), 1);
}

static void test_a_day_without_a_clock_lasts_until_the_next_start(void **state)
{
    (void)state;
    play(5, 1, 0);
    play(3, 1, 0);
    assert_int_equal(best(RANK_DAY), 5);
    pass(LEDGER_BOOT, 2, 0);
    /* At start 2 the kiosk has no clock, so it may be another day. The score of start 1 is
     * nevertheless kept until a round is played after start 2. */
    assert_int_equal(best(RANK_DAY), 5);
    play(2, 2, 0);
    assert_int_equal(best(RANK_DAY), 2);
    assert_int_equal(best(RANK_WEEK), 5);
}

static void test_a_week_without_a_clock_has_seven_starts(void **state)
{
    (void)state;
    for (uint32_t boot = 1; boot <= 7; boot++) {
        play(20u - boot, boot, 0);
    }
    /* Without a clock, each start counts as a day, and seven starts count as a week. The seventh
     * start began a new week, in which 13 fish are the best score. */
    assert_int_equal(best(RANK_WEEK), 13);
    for (uint32_t boot = 8; boot <= 13; boot++) {
        play(1, boot, 0);
        assert_int_equal(best(RANK_WEEK), 13);
    }
    play(1, 14, 0);
    assert_int_equal(best(RANK_WEEK), 1);
}

static void test_a_clock_set_a_minute_after_the_start_ends_no_day(void **state)
{
    (void)state;
    play(5, 1, 9000);
    /* The kiosk starts without a date and gets the date from the network later. It is still the
     * same day, so the leaderboard must not be cleared. */
    pass(LEDGER_BOOT, 2, 0);
    pass(LEDGER_COINS, 2, 0);
    pass(LEDGER_COINS, 2, 9000);
    assert_int_equal(best(RANK_DAY), 5);
}

static void test_a_round_before_the_clock_was_set_belongs_to_that_day(void **state)
{
    (void)state;
    play(5, 1, 9000);
    play(4, 2, 0);
    play(3, 2, 9001);
    assert_int_equal(best(RANK_DAY), 4);
    /* At start 3 the kiosk has no clock, so it may be another day than at start 2. */
    play(2, 3, 0);
    assert_int_equal(best(RANK_DAY), 2);
    assert_int_equal(best(RANK_EVER), 5);
}

static void test_each_level_of_a_mode_has_its_own_leaderboard(void **state)
{
    (void)state;
    for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
        const struct ledger_entry entry = {
            .kind = LEDGER_ROUND,
            .id = ++last_id,
            .round = { .level = level, .players = 1, .player[0].caught = 5u + level }
        };
        ranking_note(&ranking, &entry);
    }
    for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
        const uint32_t board = ranking_board(MODE_FESTIVAL, level);
        for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
            assert_int_equal(ranking.row[board][period][0].caught, 5u + level);
            assert_int_equal(ranking.row[board][period][1].caught, 0);
        }
    }
    /* A new day must clear the leaderboard of the day at each level. */
    pass(LEDGER_BOOT, 2, 9001);
    assert_int_equal(ranking.row[ranking_board(MODE_FESTIVAL, LEVEL_EASY)][RANK_DAY][0].caught, 0);
}

static void test_every_scored_mode_has_a_leaderboard_at_each_of_its_levels(void **state)
{
    (void)state;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        assert_int_equal(ranking_board(mode, LEVEL_MASTER), mode);
        for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
            const struct rank_board board = ranking_board_at(ranking_board(mode, level));
            const bool is_own = rules_of(mode)->keeps_score && rules_of(mode)->has_levels;
            assert_int_equal(board.mode, mode);
            assert_int_equal(board.level, is_own ? level : LEVEL_MASTER);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_scores_are_ordered_by_fish_and_then_by_time, clean),
        cmocka_unit_test_setup(test_rank_eleven_and_scores_without_fish_are_not_on_the_leaderboard,
                               clean),
        cmocka_unit_test_setup(test_bots_and_unscored_rounds_are_not_ranked, clean),
        cmocka_unit_test_setup(test_four_players_of_one_round_are_ranked_separately, clean),
        cmocka_unit_test_setup(test_a_name_is_set_and_removed_on_every_leaderboard_of_its_round,
                               clean),
        cmocka_unit_test_setup(test_midnight_ends_the_day_and_sunday_night_the_week, clean),
        cmocka_unit_test_setup(test_any_entry_of_a_new_day_starts_that_day, clean),
        cmocka_unit_test_setup(test_a_clock_set_back_over_midnight_removes_no_score, clean),
        cmocka_unit_test_setup(test_a_wrong_date_affects_the_leaderboard_only_while_it_lasts,
                               clean),
        cmocka_unit_test_setup(test_a_day_without_a_clock_lasts_until_the_next_start, clean),
        cmocka_unit_test_setup(test_a_week_without_a_clock_has_seven_starts, clean),
        cmocka_unit_test_setup(test_a_clock_set_a_minute_after_the_start_ends_no_day, clean),
        cmocka_unit_test_setup(test_a_round_before_the_clock_was_set_belongs_to_that_day, clean),
        cmocka_unit_test_setup(test_each_level_of_a_mode_has_its_own_leaderboard, clean),
        cmocka_unit_test_setup(test_every_scored_mode_has_a_leaderboard_at_each_of_its_levels,
                               clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
