/* test_riders_leave.c -- how fish leave a poi: over the ring, by tilt, by a flop, by swimming. */
#include "tests/unit/support/poi_stand.h"

static struct stand stand;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return stand_lift(&stand, grade, seed, off_x_m, 0.0f);
}

static void test_tipped_over_the_tank_a_fish_slides_off_and_swims_on(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 3, 0.0f);
    stand_turn(&stand, 0.0f, 55.0f * F_DEG, 0.3f);
    stand_wait(&stand, 1.0f);
    assert_int_equal(stand.poi.carried_count, 0);
    assert_int_equal(stand.landed, 0);
    assert_true(stand.tank.fish[fish].position_m.y < 0.0f);
    assert_true(stand.tank.fish[fish].position_m.x > 0.0f); /* Off the lowered right side. */
}

static void test_a_slight_tilt_keeps_the_fish_behind_the_ring(void **state)
{
    (void)state;
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        lifted(4, seed, 0.0f);
        stand_turn(&stand, 0.0f, 24.0f * F_DEG, 0.5f);
        stand_wait(&stand, 1.0f);
        kept += stand.poi.carried_count;
    }
    assert_in_range(kept, 17, 20);
}

static void test_near_the_rim_a_fish_may_flop_out_and_in_the_middle_it_hardly_does(void **state)
{
    (void)state;
    uint32_t rim = 0, middle = 0;
    for (uint32_t seed = 0; seed < 40; seed++) {
        stand_lift(&stand, 4, seed, 0.0f, -0.5f * F_PI);
        stand_wait(&stand, 2.0f);
        middle += stand.poi.carried_count;
        stand_lift(&stand, 4, seed, 0.034f, -0.5f * F_PI); /* Nose out over the ring. */
        stand_wait(&stand, 2.0f);
        rim += stand.poi.carried_count;
    }
    assert_true(middle >= 38);
    assert_in_range(rim, 20, middle - 1u);
}

/* How many of 20 a hand with a wrist still has that tilts them so for a second over its bowl. */
static uint32_t kept_at(float tilt_rad)
{
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        stand_init(&stand, 4, seed);
        stand_dip(&stand);
        stand_fish(&stand, v3(0.0f, -0.045f, 0.005f), 0.045f); /* Calm. */
        stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.18f);
        stand.has_wrist = 1;
        stand_move(&stand, v3(0.26f, 0.08f, 0.15f), 0.3f);
        stand_turn(&stand, 0.0f, tilt_rad, 0.3f);
        stand_wait(&stand, 1.0f);
        kept += stand.poi.carried_count;
    }
    return kept;
}

static void test_with_a_wrist_nothing_tips_by_itself_until_it_is_steep(void **state)
{
    (void)state;
    const uint32_t level = kept_at(0.0f), slight = kept_at(30.0f * F_DEG);
    const uint32_t steep = kept_at(48.0f * F_DEG);
    print_message("over the bowl for a second: level %u of 20 stay, at 30 degrees %u, at 48 %u\n",
                  level, slight, steep);
    assert_int_equal(level, 20);
    assert_true(slight >= 17);
    assert_true(steep <= 1);
    assert_true(stand.landed == 1); /* And there it falls into the bowl. */
}

/* How many of 24 a lift of that speed brings up. */
static uint32_t lifted_of_24(int is_wild, float lift_m_s)
{
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 24; seed++) {
        stand_init(&stand, 5, seed);
        stand_dip(&stand);
        const uint32_t index = stand_fish(&stand, v3(0.0f, -0.045f, 0.0f), 0.045f);
        struct fish *fish = &stand.tank.fish[index];
        fish->angles.yaw_rad = (float)seed;
        fish->alarm = is_wild ? 1.0f : 0.0f;
        fish->stamina = is_wild ? 1.0f : 0.5f;
        stand_move(&stand, v3(0.0f, -0.03f, 0.0f), 0.1f);
        stand_move(&stand, v3(0.0f, 0.05f, 0.0f), lift_m_s);
        stand_wait(&stand, 0.2f);
        kept += stand.poi.carried_count;
    }
    return kept;
}

static void test_a_slow_lift_loses_wild_fish_over_the_edge_and_keeps_calm_ones(void **state)
{
    (void)state;
    const uint32_t wild = lifted_of_24(1, 0.025f), calm = lifted_of_24(0, 0.025f);
    const uint32_t brisk = lifted_of_24(1, 0.12f);
    print_message("at 25 mm/s %u of 24 wild and %u calm ones come up, at 120 mm/s %u wild ones\n",
                  wild, calm, brisk);
    assert_true(wild <= 4);
    assert_true(calm >= 20);
    assert_true(brisk >= 22);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tipped_over_the_tank_a_fish_slides_off_and_swims_on),
        cmocka_unit_test(test_a_slight_tilt_keeps_the_fish_behind_the_ring),
        cmocka_unit_test(test_near_the_rim_a_fish_may_flop_out_and_in_the_middle_it_hardly_does),
        cmocka_unit_test(test_with_a_wrist_nothing_tips_by_itself_until_it_is_steep),
        cmocka_unit_test(test_a_slow_lift_loses_wild_fish_over_the_edge_and_keeps_calm_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
