/* test_rounds.c -- Tests the simulated rounds of `kingyoctl play`. A round must have the same
 * result alone, in parallel and on any CPU, and its statistics must be those of the kiosk. */
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
static uint32_t order[COUNT], reported;

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
    order[reported++] = index;
}

static enum exit_code play(uint32_t count, uint32_t workers)
{
    const struct rounds rounds = { .plans = plans,
                                   .results = results,
                                   .count = count,
                                   .workers = workers,
                                   .done = tell,
                                   .self = results };
    reported = 0;
    return rounds_play(&rounds);
}

static struct round_result alone(struct round_plan plan)
{
    plans[0] = plan;
    assert_int_equal(play(1, 1), EXIT_OK);
    return results[0];
}

static void test_a_round_is_identical_alone_and_in_parallel(void **state)
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

static void test_each_round_is_reported_once(void **state)
{
    (void)state;
    uint32_t seen = 0;
    for (uint32_t i = 0; i < COUNT; i++) {
        plans[i] = plan_of(i);
    }
    assert_int_equal(play(COUNT, 2), EXIT_OK);
    assert_int_equal(reported, COUNT);
    for (uint32_t i = 0; i < COUNT; i++) {
        seen |= 1u << order[i];
    }
    assert_int_equal(seen, (1u << COUNT) - 1u);
}

static void test_a_round_has_the_configured_length(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(1);
    plan.grade = 4;
    plan.technique = technique_expert;
    const struct round_result result = alone(plan);
    /* The round time is 10 s. After its end, a player may still carry a fish to the bowl for up to
     * 3 s. */
    assert_true(result.length_s >= 10.0 && result.length_s < 13.1);
    assert_false(result.torn);
}

/* The bot holds its poi still for three seconds before each scoop. A real sensor with a constant
 * pose counts as stuck, but the pose of a bot must not. */
static void test_a_bot_without_tremor_is_not_a_stuck_sensor(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(2);
    plan.grade = 4;
    plan.technique.tremor_m = 0.0f;
    plan.technique.reaction_min_s = plan.technique.reaction_max_s = 3.0f;
    assert_true(alone(plan).length_s < 13.1); /* If the input counted as lost, the round would pause
                                                 and last longer. */
}

static struct technique slapping(void)
{
    struct technique technique = technique_novice;
    technique.dip_m_s = technique.glide_m_s = technique.lift_m_s = 2.0f;
    technique.glide_deg = 90.0f;
    technique.fish_max = 8;
    return technique;
}

/* In festival mode, slapping the water with the poi is no foul. The bot slaps the water until its
 * paper tears. The tear must end the round and be reported. */
static void test_torn_paper_ends_a_festival_round_and_is_reported(void **state)
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

static void test_a_practice_round_has_statistics_but_no_record(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(4);
    plan.mode = MODE_PRACTICE;
    const struct round_result result = alone(plan);
    assert_true(result.scoops > 0);
    assert_true(result.state_hash != 0);
    assert_true(result.sheets > 0);
}

/* In practice mode each torn paper is replaced, so several papers tear. The bot slaps the water as
 * in the test of the festival round. */
static void
test_a_practice_round_reports_its_first_tear_although_the_paper_is_replaced(void **state)
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

static void test_each_mode_uses_its_own_tank_and_paper(void **state)
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

static void test_a_round_is_played_at_its_level_and_the_championship_has_none(void **state)
{
    (void)state;
    struct round_plan plan = plan_of(6);
    const uint64_t master = alone(plan).state_hash;
    plan.level = LEVEL_EASY;
    assert_int_not_equal(alone(plan).state_hash, master);
    plan.mode = MODE_CHAMPIONSHIP;
    const struct round_result easy = alone(plan);
    plan.level = LEVEL_MASTER;
    assert_int_equal(alone(plan).caught, easy.caught);
    assert_int_equal(alone(plan).scoops, easy.scoops);
}

static void test_a_recording_that_fails_to_start_stops_all_rounds(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < COUNT; i++) {
        plans[i] = plan_of(i);
    }
    plans[0].record = "/dev/null";
    const struct rounds rounds = {
        .plans = plans, .results = results, .count = COUNT, .workers = 1
    };
    assert_int_equal(rounds_play(&rounds), EXIT_IO);
    assert_int_equal(results[0].code, EXIT_IO);
    assert_int_equal(results[0].error, ENOTDIR);
    assert_int_equal(results[COUNT - 1].code, EXIT_NOT_SO);
}

/* ---- Statistics of several rounds ----------------------------------------------------------- */

static void test_quantiles_are_interpolated_between_values(void **state)
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

static void test_all_quantiles_of_one_value_equal_the_value(void **state)
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
        cmocka_unit_test(test_a_round_is_identical_alone_and_in_parallel),
        cmocka_unit_test(test_each_round_is_reported_once),
        cmocka_unit_test(test_a_round_has_the_configured_length),
        cmocka_unit_test(test_a_bot_without_tremor_is_not_a_stuck_sensor),
        cmocka_unit_test(test_torn_paper_ends_a_festival_round_and_is_reported),
        cmocka_unit_test(test_a_practice_round_has_statistics_but_no_record),
        cmocka_unit_test(
            test_a_practice_round_reports_its_first_tear_although_the_paper_is_replaced),
        cmocka_unit_test(test_each_mode_uses_its_own_tank_and_paper),
        cmocka_unit_test(test_a_round_is_played_at_its_level_and_the_championship_has_none),
        cmocka_unit_test(test_a_recording_that_fails_to_start_stops_all_rounds),
        cmocka_unit_test(test_quantiles_are_interpolated_between_values),
        cmocka_unit_test(test_all_quantiles_of_one_value_equal_the_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
