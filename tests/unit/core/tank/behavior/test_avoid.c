/* test_avoid.c -- checks the encounters of two fish (head-on, from the side, from behind) and how
 * the fish avoid each other. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/avoid.h"
#include "tests/unit/support/pond.h"

/* Returns a fish that swims at 5 cm/s. Its heading is in degrees: 0 is away from the player, and 90
 * is to the left. */
static struct avoid_party swimmer(float x_cm, float z_cm, float yaw_deg, uint16_t index)
{
    return (struct avoid_party){ .position_m = v3(0.01f * x_cm, -0.06f, 0.01f * z_cm),
                                 .forward =
                                     v3(-f_sin(yaw_deg * F_DEG), 0.0f, -f_cos(yaw_deg * F_DEG)),
                                 .speed_m_s = 0.05f,
                                 .length_m = 0.05f,
                                 .height_m = 0.018f,
                                 .index = index };
}

static void test_fish_on_opposite_courses_turn_to_the_same_side(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 3.0f, 0.0f, 7), b = swimmer(0.0f, -3.0f, 180.0f, 12);
    uint32_t left = 0;
    for (uint32_t second = 0; second < 1000; second++) {
        const struct avoid_pair pair = avoid_meet(&a, &b, 0.01f, pond_params(), 1, second);
        assert_int_equal(pair.a.kind, MEET_HEAD_ON);
        assert_int_equal(pair.b.kind, MEET_HEAD_ON);
        /* Both fish must turn left or both must turn right, each from its own view, so that they
         * separate. */
        assert_true(pair.a.turn == pair.b.turn);
        left += pair.a.turn > 0.0f;
    }
    assert_in_range(left, 440, 560);
}

static void test_both_fish_of_a_pair_get_the_same_random_draw(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 3.0f, 0.0f, 7), b = swimmer(0.0f, -3.0f, 180.0f, 12);
    for (uint32_t second = 0; second < 100; second++) {
        const struct avoid_pair one = avoid_meet(&a, &b, 0.01f, pond_params(), 1, second);
        const struct avoid_pair other = avoid_meet(&b, &a, 0.01f, pond_params(), 1, second);
        assert_true(one.a.turn == other.b.turn);
        assert_true(one.a.rise == other.b.rise);
    }
}

/* Returns `party` in the state in which the fish is after it has followed `advice`. */
static struct avoid_party giving_way(struct avoid_party party, const struct avoid_advice *advice)
{
    struct fish fish = { WAKIN(party.length_m), .position_m = party.position_m };
    avoid_tick(&fish, advice, 1.0f, pond_at(1, 0));
    party.avoiding = fish.avoiding;
    party.avoid_kind = fish.avoid_kind;
    party.avoid_with = fish.avoid_with;
    party.avoid_since = fish.avoid_since;
    return party;
}

static void test_the_second_fish_of_a_pair_turns_to_the_side_of_the_first(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 3.0f, 0.0f, 7), b = swimmer(0.0f, -3.0f, 180.0f, 12);
    uint32_t left = 0;
    for (uint32_t edge = CORE_TICK_HZ; edge < 1000u * CORE_TICK_HZ; edge += CORE_TICK_HZ) {
        /* One fish starts to avoid in the last tick of a second. The other fish starts in the next
         * second or later, and must turn to the side that the first fish has selected at random. */
        const struct avoid_pair first = avoid_meet(&a, &b, 0.01f, pond_params(), 1, edge - 1u);
        const struct avoid_party early = giving_way(a, &first.a);
        const struct avoid_pair then = avoid_meet(&early, &b, 0.01f, pond_params(), 1, edge);
        const struct avoid_pair later = avoid_meet(&b, &early, 0.01f, pond_params(), 1, edge + 40u);
        assert_true(then.b.turn == first.a.turn);
        assert_true(later.a.turn == first.a.turn);
        assert_true(then.a.turn == first.a.turn);
        left += first.a.turn > 0.0f;
    }
    assert_in_range(left, 440, 560);
}

static void test_another_partner_is_another_encounter(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 3.0f, 0.0f, 7), b = swimmer(0.0f, -3.0f, 180.0f, 12),
                             c = swimmer(0.0f, -3.0f, 180.0f, 13);
    const struct avoid_pair first = avoid_meet(&a, &b, 0.01f, pond_params(), 1, 100);
    const struct avoid_party early = giving_way(a, &first.a);
    assert_int_equal(avoid_meet(&early, &b, 0.01f, pond_params(), 1, 150).b.since, 100);
    assert_int_equal(avoid_meet(&early, &c, 0.01f, pond_params(), 1, 150).b.since, 150);
}

static void test_the_fish_that_hits_from_the_side_passes_behind_in_90_percent(void **state)
{
    (void)state;
    /* Fish a swims toward -z into the left side of fish b, which swims slowly toward -x. */
    const struct avoid_party a = swimmer(0.0f, 3.5f, 0.0f, 1);
    struct avoid_party b = swimmer(0.0f, 0.0f, 90.0f, 2);
    b.speed_m_s = 0.01f;
    uint32_t behind = 0, clear = 0;
    for (uint32_t second = 0; second < 2000; second++) {
        const struct avoid_pair pair = avoid_meet(&a, &b, 0.005f, pond_params(), 1, second);
        assert_int_equal(pair.a.kind, MEET_SIDE);
        /* Fish a turns right, so that it passes behind fish b. */
        behind += pair.a.turn < 0.0f;
        /* Fish b is hit on its left side, so it turns right. */
        clear += pair.b.turn < 0.0f;
    }
    assert_in_range(behind, 1720, 1880);
    /* Both fish must use the same random number, so fish a passes behind if and only if fish b
     * turns right. */
    assert_int_equal(behind, clear);
}

static void test_only_the_follower_avoids_the_fish_ahead(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 5.5f, 0.0f, 1);
    struct avoid_party b = swimmer(0.0f, 0.0f, 10.0f, 2);
    b.speed_m_s = 0.01f;
    const struct avoid_pair pair = avoid_meet(&a, &b, 0.005f, pond_params(), 1, 0);
    assert_int_equal(pair.a.kind, MEET_REAR_END);
    assert_true(pair.a.turn != 0.0f);
    assert_int_equal(pair.b.kind, MEET_NONE);
    assert_true(pair.brake_a < 1.0f);
    assert_true(pair.brake_b == 1.0f);
}

static void test_fish_that_separate_or_pass_clear_do_not_meet(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, -3.0f, 0.0f, 1), b = swimmer(0.0f, 3.0f, 180.0f, 2);
    assert_int_equal(avoid_meet(&a, &b, 0.005f, pond_params(), 1, 0).a.kind, MEET_NONE);
    const struct avoid_party c = swimmer(0.0f, 3.0f, 0.0f, 1), d = swimmer(4.0f, -3.0f, 180.0f, 2);
    assert_int_equal(avoid_meet(&c, &d, 0.02f, pond_params(), 1, 0).a.kind, MEET_NONE);
    const struct avoid_party e = swimmer(0.0f, 0.0f, 0.0f, 1), f = swimmer(1.5f, 0.1f, 2.0f, 2);
    /* Fish f is beside fish e and not ahead of it, so neither of the two has to react. */
    assert_int_equal(avoid_meet(&e, &f, 0.005f, pond_params(), 1, 0).a.kind, MEET_NONE);
}

static void test_the_class_changes_at_twenty_degrees(void **state)
{
    (void)state;
    const struct avoid_party a = swimmer(0.0f, 3.0f, 0.0f, 1);
    struct avoid_party b = swimmer(0.0f, -1.0f, 161.0f, 2);
    assert_int_equal(avoid_meet(&a, &b, 0.005f, pond_params(), 1, 0).a.kind, MEET_HEAD_ON);
    b = swimmer(0.0f, -1.0f, 159.0f, 2);
    assert_int_equal(avoid_meet(&a, &b, 0.005f, pond_params(), 1, 0).a.kind, MEET_SIDE);
}

static void test_pitch_follows_half_a_second_of_yaw(void **state)
{
    (void)state;
    struct fish fish = { WAKIN(0.05f), .position_m = { 0.0f, -0.06f, 0.0f }, .brake = 1.0f };
    const struct avoid_advice advice = { MEET_SIDE, -1, 2, 7, 0.1f, 1.0f };
    uint32_t yaw = 0;
    while (fish.avoiding != AVOID_PITCH && yaw < 200) {
        avoid_tick(&fish, &advice, 0.5f, pond_at(1, 0));
        yaw += fish.avoiding == AVOID_YAW;
    }
    assert_in_range(yaw, CORE_TICK_HZ / 2u - 2u, CORE_TICK_HZ / 2u + 2u);
    assert_true(fish.heading_rad > 0.2f); /* The fish turns left, as avoid_meet() has advised. */
    assert_true(fish.avoid_turn < 0.0f);
    assert_float_equal(fish.brake, 0.5f, 1e-6f);
}

static void test_avoidance_pitch_stays_between_floor_and_surface(void **state)
{
    (void)state;
    struct fish fish = { WAKIN(0.05f), .position_m = { 0.0f, -0.115f, 0.0f } };
    struct avoid_advice advice = { MEET_SIDE, -1, 2, 7, 0.1f, 1.0f };
    fish.avoiding = AVOID_YAW;
    avoid_tick(&fish, &advice, 1.0f, pond_at(1, 0));
    assert_int_equal(fish.avoiding, AVOID_PITCH);
    assert_true(fish.avoid_turn > 0.0f);
    fish =
        (struct fish){ WAKIN(0.05f), .position_m = { 0.0f, -0.012f, 0.0f }, .avoiding = AVOID_YAW };
    advice.rise = 1.0f;
    avoid_tick(&fish, &advice, 1.0f, pond_at(1, 0));
    assert_true(fish.avoid_turn < 0.0f);
}

static void test_a_fish_soon_clears_a_finished_encounter(void **state)
{
    (void)state;
    struct fish fish = { WAKIN(0.05f), .avoiding = AVOID_YAW, .avoid_left_s = 0.5f };
    const struct avoid_advice none = { 0 };
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 4u; tick++) {
        avoid_tick(&fish, &none, 1.0f, pond_at(1, 0));
    }
    assert_int_equal(fish.avoiding, AVOID_NONE);
    assert_float_equal(fish.heading_rad, 0.0f, 1e-6f);
}

static void test_depth_is_held_for_half_a_second_after_a_climb_and_not_after_a_turn(void **state)
{
    (void)state;
    struct fish fish = { WAKIN(0.05f), .position_m = { 0.0f, -0.06f, 0.0f }, .brake = 1.0f };
    const struct avoid_advice advice = { MEET_SIDE, -1, 2, 7, 0.1f, 1.0f }, none = { 0 };
    fish.depth_goal_m = -0.03f;
    avoid_tick(&fish, &advice, 1.0f, pond_at(1, 0));
    /* The path becomes clear after the first tick. The fish must then stop the avoidance and no
     * longer hold its depth. */
    while (fish.avoiding != AVOID_NONE) {
        avoid_tick(&fish, &none, 1.0f, pond_at(1, 0));
        assert_false(avoid_holds_depth(&fish));
    }
    while (fish.avoiding != AVOID_PITCH) {
        avoid_tick(&fish, &advice, 1.0f, pond_at(1, 0));
    }
    while (fish.avoiding != AVOID_NONE) {
        avoid_tick(&fish, &none, 1.0f, pond_at(1, 0));
    }
    uint32_t after = 0;
    while (avoid_holds_depth(&fish) && after < 1000) {
        avoid_tick(&fish, &none, 1.0f, pond_at(1, 0));
        after++;
    }
    assert_in_range(after, CORE_TICK_HZ / 2u - 1u, CORE_TICK_HZ / 2u + 1u);
    /* Avoidance by pitch must not change the depth to which the fish returns later. */
    assert_float_equal(fish.depth_goal_m, -0.03f, 0.0f);
}

static void test_repulsion_is_2_25_cm_a_second_at_touch_and_gone_at_1_cm(void **state)
{
    (void)state;
    assert_float_equal(avoid_repulsion_m_s(0.0f, 0.05f), 0.0225f, 1e-6f);
    assert_float_equal(avoid_repulsion_m_s(-0.01f, 0.05f), 0.0225f, 1e-6f);
    assert_float_equal(avoid_repulsion_m_s(0.01f, 0.05f), 0.0f, 1e-6f);
    assert_true(avoid_repulsion_m_s(0.004f, 0.05f) > avoid_repulsion_m_s(0.006f, 0.05f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_on_opposite_courses_turn_to_the_same_side),
        cmocka_unit_test(test_both_fish_of_a_pair_get_the_same_random_draw),
        cmocka_unit_test(test_the_second_fish_of_a_pair_turns_to_the_side_of_the_first),
        cmocka_unit_test(test_another_partner_is_another_encounter),
        cmocka_unit_test(test_the_fish_that_hits_from_the_side_passes_behind_in_90_percent),
        cmocka_unit_test(test_only_the_follower_avoids_the_fish_ahead),
        cmocka_unit_test(test_fish_that_separate_or_pass_clear_do_not_meet),
        cmocka_unit_test(test_the_class_changes_at_twenty_degrees),
        cmocka_unit_test(test_pitch_follows_half_a_second_of_yaw),
        cmocka_unit_test(test_avoidance_pitch_stays_between_floor_and_surface),
        cmocka_unit_test(test_a_fish_soon_clears_a_finished_encounter),
        cmocka_unit_test(test_depth_is_held_for_half_a_second_after_a_climb_and_not_after_a_turn),
        cmocka_unit_test(test_repulsion_is_2_25_cm_a_second_at_touch_and_gone_at_1_cm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
