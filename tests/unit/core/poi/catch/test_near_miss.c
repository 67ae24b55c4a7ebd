/* test_near_miss.c -- checks which events are announced as near misses, and how often. */
#include "tests/unit/support/poi_fixture.h"

#include "core/poi/catch/near_miss.h"

static struct poi poi;
static struct tank tank;
static struct near_miss miss;

static int setup(void **state)
{
    (void)state;
    memset(&miss, 0, sizeof miss);
    memset(&tank, 0, sizeof tank);
    poi_init(&poi, 6, v3(0.0f, -0.04f, 0.0f), 1);
    tank.fish_count = 2;
    tank.fish[0] = (struct fish){ .gait = GAIT_SWIM, .position_m = v3(0.3f, -0.05f, 0.0f) };
    tank.fish[1] = (struct fish){ .gait = GAIT_SWIM, .position_m = v3(0.01f, -0.02f, 0.0f) };
    return 0;
}

/* Lets fish 1 swim over the immersed paper at tick 600, and then lifts the poi at `lift_tick`,
 * when the fish is `side_m` from the ring's centre. Returns whether a near miss is announced. */
static bool is_announced(uint32_t lift_tick, float side_m)
{
    poi.is_in = true;
    poi.splash_m_s = 0.0f;
    tank.fish[1].position_m.x = 0.01f;
    assert_false(near_miss_tick(&miss, &poi, &tank, 0, 600));
    tank.fish[1].position_m.x = side_m;
    assert_false(near_miss_tick(&miss, &poi, &tank, 0, lift_tick - 1u));
    poi.is_in = false;
    poi.splash_m_s = -0.2f;
    return near_miss_tick(&miss, &poi, &tank, 0, lift_tick);
}

static void test_a_fish_that_escaped_over_the_rim_is_a_near_miss(void **state)
{
    (void)state;
    assert_true(is_announced(620, poi_outer_radius_m(&poi) + NEAR_MISS_RIM_M - 0.001f));
    assert_int_equal(miss.tick, 620);
}

static void test_a_fish_that_is_far_away_is_no_near_miss(void **state)
{
    (void)state;
    assert_false(is_announced(620, poi_outer_radius_m(&poi) + NEAR_MISS_RIM_M + 0.001f));
}

static void test_a_fish_that_left_early_is_no_near_miss(void **state)
{
    (void)state;
    assert_false(is_announced(600 + NEAR_MISS_LIFT_TICKS + 1u, 0.05f));
}

static void test_a_fish_that_was_never_over_the_paper_is_no_near_miss(void **state)
{
    (void)state;
    tank.fish_count = 1;
    tank.fish[0].position_m.x = 0.05f; /* The fish swims beside the ring. */
    assert_false(is_announced(620, 0.05f));
}

static void test_a_lift_with_a_fish_on_the_paper_is_no_near_miss(void **state)
{
    (void)state;
    poi.carried_count = 1;
    assert_false(is_announced(620, 0.05f));
    poi.carried_count = 0;
    tank.fish[1].gait = GAIT_HELD; /* Another poi has lifted the fish. */
    assert_false(near_miss_tick(&miss, &poi, &tank, 0, 621));
}

static void test_a_fish_that_slipped_off_is_a_near_miss_but_not_too_often(void **state)
{
    (void)state;
    tank.fish_count = 0;
    assert_false(near_miss_tick(&miss, &poi, &tank, 0, 100));
    assert_true(near_miss_tick(&miss, &poi, &tank, 1, 101));
    assert_false(near_miss_tick(&miss, &poi, &tank, 1, 100 + NEAR_MISS_APART_TICKS));
    assert_true(near_miss_tick(&miss, &poi, &tank, 2, 101 + NEAR_MISS_APART_TICKS));
}

#define TEST(name) cmocka_unit_test_setup(name, setup)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_a_fish_that_escaped_over_the_rim_is_a_near_miss),
        TEST(test_a_fish_that_is_far_away_is_no_near_miss),
        TEST(test_a_fish_that_left_early_is_no_near_miss),
        TEST(test_a_fish_that_was_never_over_the_paper_is_no_near_miss),
        TEST(test_a_lift_with_a_fish_on_the_paper_is_no_near_miss),
        TEST(test_a_fish_that_slipped_off_is_a_near_miss_but_not_too_often),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
