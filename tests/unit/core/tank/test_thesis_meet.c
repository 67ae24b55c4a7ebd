/* test_thesis_meet.c -- checks how two fish avoid each other (section 3.4 of the 2013 thesis): the
 * three kinds of encounter, the turns and the repulsion. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/behavior/avoid.h"
#include "tests/unit/support/thesis.h"

/* Returns a fish with a heading and a pitch in degrees. Heading 0 is toward -z, and 90 is to the
 * left. */
static struct avoid_party party(float x_cm, float z_cm, float yaw_deg, float pitch_deg,
                                uint16_t index)
{
    const float flat = f_cos(pitch_deg * F_DEG);
    return (struct avoid_party){
        .position_m = { 0.01f * x_cm, -0.10f, 0.01f * z_cm },
        .forward = { -f_sin(yaw_deg * F_DEG) * flat, f_sin(pitch_deg * F_DEG),
                     -f_cos(yaw_deg * F_DEG) * flat },
        .speed_m_s = 0.0525f,
        .length_m = 0.05f,
        .height_m = 0.02f,
        .index = index,
    };
}

static struct avoid_pair meet(const struct avoid_party *a, const struct avoid_party *b,
                              uint32_t tick)
{
    return avoid_meet(a, b, 0.015f, thesis_params(), 1, tick);
}

/* Returns the kind of encounter of the two fish a and b. Fish a swims toward -z, and fish b has the
 * heading `yaw_deg`. */
static uint8_t kind_at(float yaw_deg, float a_pitch_deg, float b_pitch_deg)
{
    const struct avoid_party a = party(0.0f, 6.0f, 0.0f, a_pitch_deg, 1);
    struct avoid_party b = party(0.0f, 0.0f, yaw_deg, b_pitch_deg, 2);
    b.speed_m_s = 0.02f;
    return meet(&a, &b, 0).a.kind;
}

static void test_3_4_the_angle_of_the_headings_gives_the_class(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float s = (float)side;
        assert_int_equal(kind_at(0.0f, 0.0f, 0.0f), MEET_REAR_END);
        assert_int_equal(kind_at(19.9f * s, 0.0f, 0.0f), MEET_REAR_END);
        assert_int_equal(kind_at(20.1f * s, 0.0f, 0.0f), MEET_SIDE);
        assert_int_equal(kind_at(159.9f * s, 0.0f, 0.0f), MEET_SIDE);
        assert_int_equal(kind_at(160.1f * s, 0.0f, 0.0f), MEET_HEAD_ON);
        assert_int_equal(kind_at(180.0f * s, 0.0f, 0.0f), MEET_HEAD_ON);
    }
}

/* Equation 3.4 uses the angle in space. If a gulping fish with a pitch of 45 degrees met another
 * fish nose to nose, the fish would then count as hit from the side. The code therefore uses the
 * angle seen from above. */
static void test_eq_3_4_uses_the_horizontal_plane(void **state)
{
    (void)state;
    assert_int_equal(kind_at(180.0f, 45.0f, 0.0f), MEET_HEAD_ON);
    assert_int_equal(kind_at(180.0f, 45.0f, 45.0f), MEET_HEAD_ON);
    assert_int_equal(kind_at(0.0f, 45.0f, -30.0f), MEET_REAR_END);
}

/* The angle must never be NaN. Rounding can make the argument of arccos larger than 1, and a
 * vertical fish has no heading. */
static void test_eq_3_4_never_gives_a_nan_angle(void **state)
{
    (void)state;
    for (float yaw_deg = 0.0f; yaw_deg < 360.0f; yaw_deg += 0.7f) {
        const float x_cm = 6.0f * f_sin(yaw_deg * F_DEG), z_cm = 6.0f * f_cos(yaw_deg * F_DEG);
        const struct avoid_party a = party(x_cm, z_cm, yaw_deg, 0.0f, 1);
        struct avoid_party b = party(0.0f, 0.0f, yaw_deg, 0.0f, 2);
        b.speed_m_s = 0.02f;
        assert_int_equal(meet(&a, &b, 0).a.kind, MEET_REAR_END);
        b = party(0.0f, 0.0f, yaw_deg, 90.0f, 2);
        const struct avoid_advice advice = meet(&a, &b, 0).a;
        assert_in_range(advice.kind, MEET_HEAD_ON, MEET_SIDE);
        assert_true(f_abs(advice.turn) <= 1.0f);
    }
}

/* By the angle alone, fish side by side would count as a rear-end encounter, and fish that have
 * passed each other as head-on. Only fish that approach each other may count. */
static void test_3_4_only_fish_that_approach_meet(void **state)
{
    (void)state;
    const struct avoid_party a = party(0.0f, 0.0f, 0.0f, 0.0f, 1);
    const struct avoid_party passed = party(1.5f, 2.0f, 180.0f, 0.0f, 2);
    const struct avoid_party beside = party(2.0f, 0.0f, 0.0f, 0.0f, 2);
    struct avoid_party faster = party(0.0f, -6.0f, 0.0f, 0.0f, 2);
    faster.speed_m_s = 0.06f;
    assert_int_equal(meet(&a, &passed, 0).a.kind, MEET_NONE);
    assert_int_equal(meet(&a, &beside, 0).a.kind, MEET_NONE);
    assert_int_equal(meet(&a, &faster, 0).a.kind, MEET_NONE);
}

static void test_3_4_head_on_fish_both_turn_left_or_both_right_equally_often(void **state)
{
    (void)state;
    const struct avoid_party a = party(0.0f, 3.5f, 0.0f, 0.0f, 7);
    const struct avoid_party b = party(0.0f, -3.5f, 180.0f, 0.0f, 3);
    uint32_t left = 0;
    for (uint32_t tick = 0; tick < 4000; tick++) {
        const struct avoid_pair ab = meet(&a, &b, tick), ba = meet(&b, &a, tick);
        /* Both fish must turn left or both must turn right, each from its own view. */
        assert_true(ab.a.turn == ab.b.turn && f_abs(ab.a.turn) == 1.0f);
        /* The order of the two fish in the arguments must not change the result. */
        assert_true(ba.a.turn == ab.a.turn);
        left += ab.a.turn > 0.0f;
    }
    assert_in_range(left, 1880, 2120);
}

/* In the thesis, a fish that is hit from the side always "turns left", which leads toward the other
 * fish in half of the cases. In the code, it must turn away from the side on which it is hit. */
static void check_side(float struck_yaw_deg, float behind, float away)
{
    const struct avoid_party a = party(0.0f, 5.0f, 0.0f, 0.0f, 1);
    struct avoid_party b = party(0.0f, 0.0f, struck_yaw_deg, 0.0f, 2);
    b.speed_m_s = 0.02f;
    uint32_t sensible = 0;
    for (uint32_t tick = 0; tick < 4000; tick++) {
        const struct avoid_pair pair = meet(&a, &b, tick);
        assert_true(f_abs(pair.a.turn) == 1.0f && pair.b.turn != 0.0f);
        /* The turns of both fish must match, because both are derived from one random number. */
        assert_int_equal(pair.a.turn == behind, pair.b.turn * away > 0.0f);
        sensible += pair.a.turn == behind;
    }
    assert_in_range(sensible, 3540, 3660);
}

static void test_3_4_the_fish_that_hits_from_the_side_passes_behind_in_90_percent(void **state)
{
    (void)state;
    /* The struck fish swims to the left and is hit on its left side. The other fish must turn
     * right, so that it passes behind the struck fish. */
    check_side(90.0f, -1.0f, -1.0f);
    /* The mirror image of this case must give the mirrored turns. */
    check_side(-90.0f, 1.0f, 1.0f);
}

static void test_3_4_the_fish_that_faces_the_other_more_is_the_one_that_hits(void **state)
{
    (void)state;
    const struct avoid_party a = party(0.0f, 5.0f, 0.0f, 0.0f, 1);
    const struct avoid_party b = party(4.0f, 1.0f, 90.0f, 0.0f, 2);
    /* The two fish face each other in the same way, so the fish with the lower index must count as
     * the one that hits. The order of the arguments must not matter. */
    for (uint32_t tick = 0; tick < 200; tick++) {
        const struct avoid_pair ab = meet(&a, &b, tick), ba = meet(&b, &a, tick);
        assert_true(ab.a.turn == ba.b.turn && ab.b.turn == ba.a.turn);
    }
}

/* In the thesis, the follower is the fish that "gets nearer by its own next move alone". The speeds
 * do not matter. */
static void test_3_4_only_the_follower_turns_left_or_right_equally_often(void **state)
{
    (void)state;
    const struct avoid_party a = party(0.0f, 6.0f, 0.0f, 0.0f, 9);
    struct avoid_party b = party(0.0f, 0.0f, 12.0f, 0.0f, 2);
    b.speed_m_s = 0.02f;
    uint32_t left = 0;
    for (uint32_t tick = 0; tick < 4000; tick++) {
        const struct avoid_pair pair = meet(&a, &b, tick);
        assert_int_equal(pair.b.kind, MEET_NONE);
        assert_true(f_abs(pair.a.turn) == 1.0f);
        left += pair.a.turn > 0.0f;
    }
    assert_in_range(left, 1880, 2120);
}

/* In figure 3.6 of the thesis, both fish of a pair dive near the surface, and both rise elsewhere.
 * This does not separate them. In the code, the upper fish must rise and the lower fish must
 * dive. */
static void test_3_4_the_upper_fish_rises_and_the_lower_dives_after_0_5_s_of_yaw(void **state)
{
    (void)state;
    const struct avoid_party a = party(0.0f, 3.5f, 0.0f, 0.0f, 1);
    struct avoid_party b = party(0.0f, -3.5f, 180.0f, 0.0f, 2);
    b.position_m.y -= 0.005f;
    const struct avoid_pair pair = meet(&a, &b, 0);
    const struct avoid_advice *advice[] = { &pair.a, &pair.b };
    for (uint32_t i = 0; i < 2; i++) {
        struct fish fish = { .length_m = 0.05f,
                             .height_m = 0.02f,
                             .width_m = 0.01f,
                             .position_m = i == 0 ? a.position_m : b.position_m };
        float yaw_s = 0.0f;
        for (; fish.avoiding != AVOID_PITCH && yaw_s < 2.0f; yaw_s += CORE_TICK_S) {
            avoid_tick(&fish, advice[i], 1.0f, thesis_at(1, 0));
        }
        assert_float_equal(yaw_s, 0.5f, 2.5f * CORE_TICK_S);
        assert_true(fish.avoid_turn == (i == 0 ? 1.0f : -1.0f));
    }
    assert_true(pair.a.rise == 1.0f && pair.b.rise == -1.0f);
}

static float pitch_way(float y_m, int8_t rise)
{
    struct fish fish = { .length_m = 0.05f,
                         .height_m = 0.02f,
                         .position_m = { 0.0f, y_m, 0.0f },
                         .avoiding = AVOID_YAW };
    const struct avoid_advice advice = { MEET_SIDE, rise, 2, 7, 0.1f, 1.0f };
    avoid_tick(&fish, &advice, 1.0f, thesis_at(1, 0));
    assert_int_equal(fish.avoiding, AVOID_PITCH);
    return fish.avoid_turn;
}

/* A fish counts as near the surface (or the floor) if its distance from it is less than the height
 * of its body. */
static void test_3_4_a_fish_near_the_surface_dives_and_one_near_the_floor_rises(void **state)
{
    (void)state;
    assert_true(pitch_way(-0.019f, 1) < 0.0f);
    assert_true(pitch_way(-0.021f, 1) > 0.0f);
    assert_true(pitch_way(-0.181f, -1) > 0.0f);
    assert_true(pitch_way(-0.179f, -1) < 0.0f);
}

/* The thesis gives no formula for the repulsion. The code uses 2.25 cm/s for fish that touch, which
 * is the difference between 7.5 and 5.25 cm/s in section 3.3. The repulsion falls to 0 at a gap of
 * 1 cm. */
static void test_3_4_repulsion_fills_the_headroom_of_3_3_within_1_cm(void **state)
{
    (void)state;
    assert_float_equal(avoid_repulsion_m_s(0.0f, 0.05f), 0.075f - 0.0525f, 1e-6f);
    assert_float_equal(avoid_repulsion_m_s(0.005f, 0.05f), 0.25f * 0.0225f, 1e-6f);
    assert_float_equal(avoid_repulsion_m_s(0.01f, 0.05f), 0.0f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_3_4_the_angle_of_the_headings_gives_the_class),
        cmocka_unit_test(test_eq_3_4_uses_the_horizontal_plane),
        cmocka_unit_test(test_eq_3_4_never_gives_a_nan_angle),
        cmocka_unit_test(test_3_4_only_fish_that_approach_meet),
        cmocka_unit_test(test_3_4_head_on_fish_both_turn_left_or_both_right_equally_often),
        cmocka_unit_test(test_3_4_the_fish_that_hits_from_the_side_passes_behind_in_90_percent),
        cmocka_unit_test(test_3_4_the_fish_that_faces_the_other_more_is_the_one_that_hits),
        cmocka_unit_test(test_3_4_only_the_follower_turns_left_or_right_equally_often),
        cmocka_unit_test(test_3_4_the_upper_fish_rises_and_the_lower_dives_after_0_5_s_of_yaw),
        cmocka_unit_test(test_3_4_a_fish_near_the_surface_dives_and_one_near_the_floor_rises),
        cmocka_unit_test(test_3_4_repulsion_fills_the_headroom_of_3_3_within_1_cm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
