/* test_goals.c -- tests whether the benchmark of simulated players (make bench-players) detects a
 * missed target. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/ctl/play/rounds.h"
#include "tests/bench/players/goals.h"

#define ROUNDS 10u

static uint32_t caught[5][ROUNDS], sorted[ROUNDS];

/* Returns the score of a player who alternately catches `few` and `few` + 1 fish in a round. */
static struct score score_of(uint32_t row, const char *player, uint32_t few)
{
    for (uint32_t i = 0; i < ROUNDS; i++) {
        caught[row][i] = few + i % 2u;
    }
    return goals_score(player, caught[row], sorted, ROUNDS);
}

static void test_score_has_mean_median_and_share_of_empty_rounds(void **state)
{
    (void)state;
    const struct score score = score_of(0, "child", 0);
    assert_float_equal(score.mean, 0.5, 1e-9);
    assert_float_equal(score.median, 0.5, 1e-9);
    assert_float_equal(score.empty_share, 0.5, 1e-9);
    /* The function must not sort the catches themselves, so they are still in the order of the
     * seeds. */
    assert_int_equal(caught[0][1], 1);
    assert_int_equal(caught[0][2], 0);
}

static void test_each_missed_target_is_counted(void **state)
{
    (void)state;
    const struct score low = score_of(0, "child", 0), high = score_of(1, "child", 3);
    /* The score misses two targets: the median, and the number of rounds without a fish. */
    assert_int_equal(goals_check(&low, 1, ROUNDS, LEVEL_EASY), 2);
    assert_int_equal(goals_check(&high, 1, ROUNDS, LEVEL_EASY), 0);
    assert_int_equal(goals_check(&low, 1, ROUNDS, LEVEL_MASTER), 0);
}

static void test_tilt_is_compared_with_the_careful_player(void **state)
{
    (void)state;
    const struct score worse[] = { score_of(0, "careful", 7), score_of(1, "careful-tilt", 5) };
    assert_int_equal(goals_check(worse, 2, ROUNDS, LEVEL_EASY), 1);
    assert_int_equal(goals_check(worse, 2, ROUNDS, LEVEL_MASTER), 1);
    const struct score equal[] = { score_of(0, "careful", 7), score_of(1, "careful-tilt", 7) };
    assert_int_equal(goals_check(equal, 2, ROUNDS, LEVEL_EASY), 0);
    assert_int_equal(goals_check(equal, 2, ROUNDS, LEVEL_MASTER), 1);
}

static void test_means_must_increase_with_the_skill(void **state)
{
    (void)state;
    const struct score rising[] = { score_of(0, "careful", 7), score_of(1, "expert-bot", 9) };
    assert_int_equal(goals_check(rising, 2, ROUNDS, LEVEL_MASTER), 0);
    const struct score level[] = { score_of(0, "careful", 7), score_of(1, "expert-bot", 7) };
    assert_int_equal(goals_check(level, 2, ROUNDS, LEVEL_MASTER), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_score_has_mean_median_and_share_of_empty_rounds),
        cmocka_unit_test(test_each_missed_target_is_counted),
        cmocka_unit_test(test_tilt_is_compared_with_the_careful_player),
        cmocka_unit_test(test_means_must_increase_with_the_skill),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
