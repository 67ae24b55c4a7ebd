/* test_tank_meetings.c -- Tests the count of encounters, in which fish avoid each other. Each
 * encounter must be counted once, when it begins. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/behavior/avoid.h"
#include "platform/ctl/tank/overlap.h"
#include "tests/unit/support/thesis.h"

static struct tank_meetings meetings;

static struct tank_stage swimmer(float x_cm, float z_cm, float yaw_deg)
{
    return (struct tank_stage){
        .position_m = { 0.01f * x_cm, -0.13f, 0.01f * z_cm },
        .angles = { .yaw_rad = yaw_deg * F_DEG },
        .speed_m_s = 0.048f,
        .stamina = 0.60f,
        .gait = GAIT_SWIM,
    };
}

static void watch_stage(const struct tank_stage *stages, uint32_t count, uint32_t seed)
{
    struct tank *tank = thesis_stage(stages, count, seed);
    meetings = (struct tank_meetings){ 0 };
    for (uint32_t tick = 0; tick < 4u * CORE_TICK_HZ; tick++) {
        tank_tick(tank, tick, NULL, 0);
        tank_meetings_update(&meetings, tank, 1);
    }
}

static void test_one_encounter_is_counted_once_in_its_class(void **state)
{
    (void)state;
    const struct tank_stage head_on[] = { swimmer(0.0f, 6.0f, 0.0f), swimmer(0.0f, -6.0f, 180.0f) };
    const struct tank_stage side[] = { swimmer(0.0f, 7.0f, 0.0f), swimmer(4.5f, 0.0f, 90.0f) };
    struct tank_stage rear_end[] = { swimmer(0.0f, 12.0f, 0.0f), swimmer(0.0f, 2.0f, 0.0f) };
    rear_end[0].gait = GAIT_BURST;
    rear_end[0].speed_m_s = 0.138f;
    for (uint32_t seed = 1; seed <= 10; seed++) {
        watch_stage(head_on, 2, seed);
        assert_int_equal(meetings.head_on, 1);
        assert_int_equal(meetings.side + meetings.rear_end, 0);
        assert_int_equal(meetings.by_yaw, 2); /* Each of the two fish avoids the other by yaw. */
        assert_int_equal(meetings.by_pitch, 0);
        watch_stage(side, 2, seed);
        assert_int_equal(meetings.side, 1);
        assert_int_equal(meetings.head_on + meetings.rear_end, 0);
        watch_stage(rear_end, 2, seed);
        assert_int_equal(meetings.rear_end, 1);
        assert_int_equal(meetings.head_on + meetings.side, 0);
        assert_in_range(meetings.by_yaw, 1, 2); /* Only the rear fish avoids the other one, once or
                                                   twice. */
    }
}

static void test_a_fish_without_an_encounter_is_not_counted(void **state)
{
    (void)state;
    const struct tank_stage apart[] = { swimmer(-20.0f, 6.0f, 0.0f), swimmer(20.0f, 6.0f, 0.0f) };
    watch_stage(apart, 2, 1);
    assert_int_equal(meetings.head_on + meetings.side + meetings.rear_end, 0);
    assert_int_equal(meetings.by_yaw + meetings.by_pitch, 0);
}

static void give_way(struct fish *fish, fish_index with)
{
    fish->avoiding = AVOID_YAW;
    fish->avoid_with = with;
    fish->avoid_kind = MEET_HEAD_ON;
}

static void test_a_pair_is_counted_again_only_after_it_separated(void **state)
{
    (void)state;
    const struct tank_stage near[] = { swimmer(0.0f, 3.0f, 0.0f), swimmer(0.0f, -3.0f, 180.0f) };
    struct tank *tank = thesis_stage(near, 2, 1);
    meetings = (struct tank_meetings){ 0 };
    for (uint32_t turn = 0; turn < 3; turn++) { /* Three turns without a separation are one
                                                   encounter. */
        give_way(&tank->fish[turn % 2u], (fish_index)(1u - turn % 2u));
        tank_meetings_update(&meetings, tank, 1);
        tank->fish[turn % 2u].avoiding = AVOID_NONE;
        tank_meetings_update(&meetings, tank, 1);
    }
    assert_int_equal(meetings.head_on, 1);
    assert_int_equal(meetings.by_yaw, 3);
    const vec3 here = tank->fish[0].position_m;
    /* The centres are moved to a distance of 8 cm. Fish count as separated from 7 cm on, so the
     * encounter ends after half a second. */
    tank->fish[0].position_m.z += 0.02f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u - TANK_MEETINGS_SAMPLE_TICKS; tick++) {
        assert_int_equal(meetings.open_count, 1);
        tank_meetings_update(&meetings, tank, 1);
    }
    for (uint32_t tick = 0; tick < 2u * TANK_MEETINGS_SAMPLE_TICKS; tick++) {
        tank_meetings_update(&meetings, tank, 1);
    }
    assert_int_equal(meetings.open_count, 0);
    tank->fish[0].position_m = here;
    give_way(&tank->fish[0], 1);
    tank_meetings_update(&meetings, tank, 1);
    assert_int_equal(meetings.head_on, 2);
}

/* The update is called only every 24 ticks. The encounter must still end after half a second (60
 * ticks) of separation. */
static void test_a_pair_observed_at_intervals_separates_after_the_timeout(void **state)
{
    (void)state;
    const struct tank_stage near[] = { swimmer(0.0f, 3.0f, 0.0f), swimmer(0.0f, -3.0f, 180.0f) };
    struct tank *tank = thesis_stage(near, 2, 1);
    meetings = (struct tank_meetings){ 0 };
    give_way(&tank->fish[0], 1);
    tank_meetings_update(&meetings, tank, 24);
    tank_meetings_update(&meetings, tank, 24);
    assert_int_equal(meetings.head_on, 1);
    tank->fish[0].position_m.z += 0.02f;
    tank_meetings_update(&meetings, tank, 24);
    tank_meetings_update(&meetings, tank, 24);
    assert_int_equal(meetings.open_count, 1); /* The fish have been separated for 48 of the 60 ticks
                                                 after which an encounter ends. */
    tank_meetings_update(&meetings, tank, 24);
    assert_int_equal(meetings.open_count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_encounter_is_counted_once_in_its_class),
        cmocka_unit_test(test_a_fish_without_an_encounter_is_not_counted),
        cmocka_unit_test(test_a_pair_is_counted_again_only_after_it_separated),
        cmocka_unit_test(test_a_pair_observed_at_intervals_separates_after_the_timeout),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
