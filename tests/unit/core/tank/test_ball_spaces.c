/* test_ball_spaces.c -- shows why the personal space of a fish is a box and not a ball (section 3.4
 * of the 2013 thesis). With balls, two fish avoid each other even if they would pass several
 * centimetres apart. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/tank.h"

static struct tank tank;

/* Lets two fish swim toward each other for four seconds, on courses that are `aside_m` apart.
 * Returns 1 if one of them gives way. */
static int gives_way(float aside_m, uint8_t ball_spaces)
{
    struct tank_config config = tank_config_of(TANK_PRESET_THESIS);
    struct tank_stage stages[2] = {
        { .position_m = { -0.10f, -0.08f, 0.0f }, .angles = { -0.5f * F_PI, 0.0f, 0.0f } },
        { .position_m = { 0.10f, -0.08f, aside_m }, .angles = { 0.5f * F_PI, 0.0f, 0.0f } },
    };
    stages[0].gait = stages[1].gait = GAIT_SWIM;
    stages[0].speed_m_s = stages[1].speed_m_s = 0.0525f;
    stages[0].stamina = stages[1].stamina = 1.0f;
    config.fish_count = 2;
    config.ball_spaces = ball_spaces;
    assert_true(tank_open(&tank, &config));
    tank_stage_all(&tank, stages, 2);
    for (uint32_t tick = 0; tick < 4u * CORE_TICK_HZ; tick++) {
        tank_tick(&tank, tick, NULL, 0);
        if (tank.fish[0].avoiding != AVOID_NONE || tank.fish[1].avoiding != AVOID_NONE) {
            return 1;
        }
    }
    return 0;
}

/* By section 3.4 of the thesis, the box of the personal space is 3 cm wide. The boxes of two fish
 * therefore overlap if the courses are 2.5 cm apart, and do not overlap at 3.5 cm. */
static void test_fish_with_box_spaces_avoid_a_course_2_5_cm_aside(void **state)
{
    (void)state;
    assert_true(gives_way(0.025f, 0));
    assert_false(gives_way(0.035f, 0));
}

/* The ball around a box of 7 x 4 x 3 cm has a diameter of 8.6 cm. With such balls, fish on courses
 * 3.5 cm apart avoid each other. */
static void test_fish_with_ball_spaces_avoid_a_course_that_would_be_clear(void **state)
{
    (void)state;
    assert_true(gives_way(0.035f, 1));
    assert_true(gives_way(0.060f, 1));
    assert_false(gives_way(0.090f, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_with_box_spaces_avoid_a_course_2_5_cm_aside),
        cmocka_unit_test(test_fish_with_ball_spaces_avoid_a_course_that_would_be_clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
