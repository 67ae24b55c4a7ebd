/* test_rounds.c -- a round is the same alone, among others, and on whichever core; and its figures
 * are those that the stall keeps. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/core.h"
#include "platform/ctl/play/rounds.h"

#define COUNT 5u

static struct round_plan plans[COUNT];
static struct round_result results[COUNT];
static uint32_t order[COUNT], told;

static struct round_plan plan_of(uint32_t seed)
{
    return (struct round_plan){
        .technique = technique_novice, .seed = seed, .fish_count = 60, .round_s = 10
    };
}

static void tell(void *self, uint32_t index)
{
    assert_ptr_equal(self, results);
    assert_int_equal(results[index].code, EXIT_OK);
    order[told++] = index;
}

static enum exit_code play(uint32_t count, uint32_t workers)
{
    const struct rounds rounds = { .plans = plans,
                                   .results = results,
                                   .count = count,
                                   .workers = workers,
                                   .done = tell,
                                   .self = results };
    told = 0;
    return rounds_play(&rounds);
}

static struct round_result alone(struct round_plan plan)
{
    plans[0] = plan;
    assert_int_equal(play(1, 1), EXIT_OK);
    return results[0];
}

static void test_a_round_is_the_same_alone_and_among_others(void **state)
{
    (void)state;
    uint64_t hash[COUNT];
    for (uint32_t i = 0; i < COUNT; i++) {
        hash[i] = alone(plan_of(10u + i)).state_hash;
    }
    for (uint32_t i = 0; i < COUNT; i++) {
        plans[i] = plan_of(10u + i);
    }
    for (uint32_t workers = 1; workers <= 4; workers += 3) {
        assert_int_equal(play(COUNT, workers), EXIT_OK);
        for (uint32_t i = 0; i < COUNT; i++) {
            assert_true(results[i].state_hash == hash[i]);
            assert_true(i == 0 || hash[i] != hash[i - 1]);
        }
    }
}

static void test_each_round_is_told_once(void **state)
{
    (void)state;
    uint32_t seen = 0;
    for (uint32_t i = 0; i < COUNT; i++) {
        plans[i] = plan_of(i);
    }
    assert_int_equal(play(COUNT, 2), EXIT_OK);
    assert_int_equal(told, COUNT);
    for (uint32_t i = 0; i < COUNT; i++) {
        seen |= 1u << order[i];
    }
    assert_int_equal(seen, (1u << COUNT) - 1u);
}

static void test_a_round_is_as_long_as_it_was_told_to_be(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(1);
    plan.grade = 4;
    plan.technique = technique_expert;
    const struct round_result result = alone(plan);
    assert_true(result.length_s >= 10.0 && result.length_s < 13.1); /* Carrying is allowed for. */
    assert_false(result.torn);
}

/* It waits three seconds before each scoop and moves no hair's breadth. */
static void test_a_hand_without_a_tremor_is_not_taken_for_a_stuck_sensor(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(2);
    plan.grade = 4;
    plan.technique.tremor_m = 0.0f;
    plan.technique.reaction_min_s = plan.technique.reaction_max_s = 3.0f;
    assert_true(alone(plan).length_s < 13.1); /* A round waits for a hand that is lost. */
}

static struct technique slapping(void)
{
    struct technique technique = technique_novice;
    technique.dip_m_s = technique.glide_m_s = technique.lift_m_s = 2.0f;
    technique.glide_deg = 90.0f;
    technique.fish_max = 8;
    return technique;
}

/* Slapped through the water all round long, with nobody called out: the paper goes, the round with
 * it, and what is left of the paper agrees. */
static void test_torn_paper_ends_a_festival_and_is_told(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(3);
    plan.grade = 7;
    plan.round_s = 60;
    plan.technique = slapping();
    const struct round_result result = alone(plan);
    assert_true(result.torn);
    assert_true(result.torn_at_s > 0.0 && result.torn_at_s < result.length_s);
    assert_true(result.length_s < 60.0);
    assert_int_equal(result.sheets, 1);
    assert_true(result.scoops > 0);
    assert_true(result.hole_area_mm2 > 100 && result.hole_area_mm2 <= 5027);
}

static void test_practice_has_figures_though_it_leaves_no_record(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(4);
    plan.mode = MODE_PRACTICE;
    const struct round_result result = alone(plan);
    assert_true(result.scoops > 0);
    assert_true(result.state_hash != 0);
    assert_true(result.sheets > 0);
}

/* The same slaps as in the festival: the first sheet goes, and others after it. */
static void test_practice_tells_its_first_tear_though_the_paper_is_renewed(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(3);
    plan.mode = MODE_PRACTICE;
    plan.grade = 7;
    plan.round_s = 60;
    plan.technique = slapping();
    const struct round_result result = alone(plan);
    assert_true(result.torn);
    assert_true(result.sheets > 2);
    assert_true(result.torn_at_s > 0.0 && result.torn_at_s < 30.0);
}

static void test_a_mode_is_played_in_its_own_tank_with_its_own_paper(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(5);
    plan.mode = MODE_CHAMPIONSHIP;
    const uint64_t championship = alone(plan).state_hash;
    plan.grade = 5;
    assert_true(alone(plan).state_hash == championship);
    plan.grade = 6;
    assert_true(alone(plan).state_hash != championship);
    plan = plan_of(5);
    const uint64_t festival = alone(plan).state_hash;
    plan.grade = 6;
    assert_true(alone(plan).state_hash == festival);
    assert_true(festival != championship);
}

static void test_a_recording_that_cannot_begin_stops_the_others(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < COUNT; i++) {
        plans[i] = plan_of(i);
    }
    plans[0].record = "/dev/null/round.kgr";
    const struct rounds rounds = {
        .plans = plans, .results = results, .count = COUNT, .workers = 1
    };
    assert_int_equal(rounds_play(&rounds), EXIT_IO);
    assert_int_equal(results[0].code, EXIT_IO);
    assert_int_equal(results[0].error, ENOTDIR);
    assert_int_equal(results[COUNT - 1].code, EXIT_NOT_SO);
}

/* ---- Figures of many ------------------------------------------------------------------------ */

static void test_quantiles_fall_between_values_in_proportion(void **state)
{
    (void)state;
    uint32_t values[] = { 9, 1, 5, 7, 3 }, even[] = { 4, 1, 3, 2 };
    struct summary found = rounds_summary(values, 5);
    assert_true(found.median >= 5.0 && found.median <= 5.0);
    assert_true(found.p90 > 8.19 && found.p90 < 8.21);
    assert_int_equal(found.max, 9);
    found = rounds_summary(even, 4);
    assert_true(found.median >= 2.5 && found.median <= 2.5);
    assert_true(found.p90 > 3.69 && found.p90 < 3.71);
}

static void test_one_value_is_all_its_quantiles(void **state)
{
    (void)state;
    uint32_t value = 42;
    const struct summary found = rounds_summary(&value, 1);
    assert_true(found.median >= 42.0 && found.p90 <= 42.0);
    assert_int_equal(found.max, 42);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_round_is_the_same_alone_and_among_others),
        cmocka_unit_test(test_each_round_is_told_once),
        cmocka_unit_test(test_a_round_is_as_long_as_it_was_told_to_be),
        cmocka_unit_test(test_a_hand_without_a_tremor_is_not_taken_for_a_stuck_sensor),
        cmocka_unit_test(test_torn_paper_ends_a_festival_and_is_told),
        cmocka_unit_test(test_practice_has_figures_though_it_leaves_no_record),
        cmocka_unit_test(test_practice_tells_its_first_tear_though_the_paper_is_renewed),
        cmocka_unit_test(test_a_mode_is_played_in_its_own_tank_with_its_own_paper),
        cmocka_unit_test(test_a_recording_that_cannot_begin_stops_the_others),
        cmocka_unit_test(test_quantiles_fall_between_values_in_proportion),
        cmocka_unit_test(test_one_value_is_all_its_quantiles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
