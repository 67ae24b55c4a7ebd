/* test_input_validation.c -- checks which controller poses are accepted as valid. Each limit is
 * tested just inside and just outside. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/game/control/input_pose.h"

static struct input_validation validation;
static struct poi_input hand;

static int set_up(void **state)
{
    (void)state;
    memset(&validation, 0, sizeof validation);
    hand = (struct poi_input){ .link = POI_SOURCE_LIVE, .has_wrist = 1 };
    hand.target.position_m = v3(0.1f, 0.05f, 0.0f);
    return 0;
}

static enum input_status tick(void)
{
    return input_validation_tick(&validation, &hand);
}

static void expect_for(uint32_t ticks, enum input_status verdict)
{
    for (uint32_t i = 0; i < ticks; i++) {
        assert_int_equal(tick(), verdict);
    }
}

/* Checks that the input is lost now, and that it becomes valid again after exactly
 * INPUT_AGREE_TICKS (a quarter of a second) of consistent poses. */
static void expect_lost_and_found(void)
{
    assert_int_equal(validation.verdict, INPUT_LOST);
    expect_for(INPUT_AGREE_TICKS - 1u, INPUT_LOST);
    assert_int_equal(tick(), INPUT_VALID);
    expect_for(50, INPUT_VALID);
}

static void test_a_new_controller_is_valid_immediately(void **state)
{
    (void)state;
    expect_for(500, INPUT_VALID);
}

static void test_an_absent_controller_and_the_bot_are_not_validated(void **state)
{
    (void)state;
    hand.target.position_m.x = NAN;
    hand.link = POI_SOURCE_ABSENT;
    expect_for(5, INPUT_ABSENT);
    hand.link = POI_SOURCE_BOT;
    expect_for(5, INPUT_ABSENT);
}

static void test_a_restored_link_is_lost_until_it_was_valid_for_a_while(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.link = POI_SOURCE_LOST;
    expect_for(300, INPUT_LOST);
    hand.link = POI_SOURCE_LIVE;
    expect_for(INPUT_AGREE_TICKS - 1u, INPUT_LOST);
    assert_int_equal(tick(), INPUT_VALID);
    expect_for(10, INPUT_VALID);
}

/* ---- Numbers outside the valid range -------------------------------------------------------- */

static float *field(uint32_t index)
{
    float *const fields[] = { &hand.target.position_m.x,     &hand.target.position_m.y,
                              &hand.target.position_m.z,     &hand.target.angles.yaw_rad,
                              &hand.target.angles.pitch_rad, &hand.target.angles.roll_rad };
    return fields[index];
}

static void test_a_nan_or_absurd_value_in_any_field_invalidates_the_input(void **state)
{
    const float bad[] = { NAN, -NAN, INFINITY, -INFINITY, 3.4e38f, -3.4e38f, 1001.0f };
    for (uint32_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
            set_up(state);
            expect_for(10, INPUT_VALID);
            const float good = *field(i);
            *field(i) = bad[k];
            expect_for(3, INPUT_LOST);
            *field(i) = good;
            tick();
            expect_for(INPUT_AGREE_TICKS - 2u, INPUT_LOST);
            assert_int_equal(tick(), INPUT_VALID);
        }
    }
}

static void test_one_bad_report_costs_a_quarter_of_a_second(void **state)
{
    (void)state;
    uint32_t lost = 0;
    expect_for(100, INPUT_VALID);
    for (uint32_t i = 0; i < 100; i++) {
        hand.target.position_m.y = i == 0 ? NAN : 0.05f;
        lost += tick() == INPUT_LOST;
    }
    assert_int_equal(lost, INPUT_AGREE_TICKS);
}

/* ---- Jumps of the pose ---------------------------------------------------------------------- */

static void test_a_jump_of_1_m_invalidates_the_input_until_it_stays(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.target.position_m.x += 1.0f;
    tick();
    expect_lost_and_found();
}

/* At 60 frames per second each frame has two ticks, and the kiosk divides the motion of a frame
 * between them. A jump of the controller therefore arrives as two steps of half the size. */
static void test_a_jump_spread_over_two_ticks_invalidates_the_input(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.target.position_m.z -= 0.055f;
    assert_int_equal(tick(), INPUT_VALID);
    hand.target.position_m.z -= 0.055f;
    tick();
    expect_lost_and_found();
}

/* The pointer of a mouse may leave the window at one side and enter it at another side. */
static void test_a_pointer_may_jump(void **state)
{
    (void)state;
    hand.has_wrist = 0;
    for (uint32_t i = 0; i < 100; i++) {
        hand.target.position_m.x = i / 7u % 2u ? 0.68f : -0.68f;
        assert_int_equal(tick(), INPUT_VALID);
    }
}

static void test_a_missed_report_is_valid_and_a_larger_jump_is_not(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 40; i++) {
        hand.target.position_m.x += i % 20u == 0 ? 0.05f : i % 20u == 1 ? -0.05f : 0.0f;
        assert_int_equal(tick(), INPUT_VALID);
    }
    hand.target.position_m.x += 0.07f;
    assert_int_equal(tick(), INPUT_LOST);
}

/* Returns 1 if the input stays valid while its position moves at `pace_m_s` for half a second. */
static bool is_valid_at(float pace_m_s)
{
    int believed = 1;
    set_up(NULL);
    for (uint32_t i = 0; i < 60; i++) {
        hand.target.position_m.x += pace_m_s * CORE_TICK_S;
        believed &= tick() == INPUT_VALID;
    }
    return believed;
}

/* Returns 1 if the input stays valid although some frames get no report and the next frame gets
 * two. This happens if a controller sends 60 reports per second to 60 frames per second. */
static bool is_valid_with_uneven_reports(float pace_m_s)
{
    int believed = 1;
    set_up(NULL);
    for (uint32_t i = 0; i < 60; i++) {
        hand.target.position_m.x += i / 2u % 8u == 0   ? 0.0f
                                    : i / 2u % 8u == 1 ? 2.0f * pace_m_s * CORE_TICK_S
                                                       : pace_m_s * CORE_TICK_S;
        believed &= tick() == INPUT_VALID;
    }
    return believed;
}

static void test_a_speed_of_4_m_s_is_valid_and_6_m_s_is_not(void **state)
{
    (void)state;
    assert_true(is_valid_at(3.9f));
    assert_true(is_valid_with_uneven_reports(3.0f));
    assert_true(is_valid_at(-3.9f));
    assert_false(is_valid_at(6.0f));
}

static void test_a_fast_turn_is_valid_and_a_flip_is_not(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 60; i++) {
        hand.target.angles.roll_rad += 25.0f * CORE_TICK_S;
        assert_int_equal(tick(), INPUT_VALID);
    }
    hand.target.angles.roll_rad += 0.55f;
    expect_for(5, INPUT_VALID);
    /* A turn of 0.70 rad (40 degrees) in one tick exceeds the limit. The turn of 0.55 rad before
     * was within the limit. */
    hand.target.angles.roll_rad += 0.70f;
    assert_int_equal(tick(), INPUT_LOST);
    expect_lost_and_found();
    /* Adds ten full turns, which give the same orientation. This must not count as a jump. */
    hand.target.angles.roll_rad += 20.0f * F_TAU;
    assert_int_equal(tick(), INPUT_VALID);
}

static void test_a_pose_that_keeps_jumping_stays_invalid(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    for (uint32_t i = 0; i < 600; i++) {
        hand.target.position_m.x = i / 20u % 2u ? 0.1f : 1.1f;
        assert_int_equal(tick(), INPUT_LOST);
    }
}

/* ---- Unchanged and missing reports ---------------------------------------------------------- */

static void test_an_input_without_reports_is_lost_after_half_a_second(void **state)
{
    (void)state;
    for (hand.age_ticks = 0; hand.age_ticks <= INPUT_SILENT_TICKS; hand.age_ticks++) {
        assert_int_equal(tick(), INPUT_VALID);
    }
    expect_for(100, INPUT_LOST);
    hand.age_ticks = 0;
    expect_for(INPUT_AGREE_TICKS - 1u, INPUT_LOST);
    assert_int_equal(tick(), INPUT_VALID);
    hand.age_ticks = UINT16_MAX;
    assert_int_equal(tick(), INPUT_LOST);
}

static void test_a_noisy_sensor_with_the_same_value_for_a_second_is_frozen(void **state)
{
    (void)state;
    hand.trembles = 1;
    expect_for(INPUT_STUCK_TICKS + 1u, INPUT_VALID);
    expect_for(3000, INPUT_LOST);
    for (uint32_t i = 1; i < INPUT_AGREE_TICKS; i++) {
        hand.target.position_m.x += 1e-5f;
        assert_int_equal(tick(), INPUT_LOST);
    }
    hand.target.position_m.x += 1e-5f;
    assert_int_equal(tick(), INPUT_VALID);
}

static void test_a_noisy_sensor_with_noise_in_its_last_bit_is_not_frozen(void **state)
{
    (void)state;
    hand.trembles = 1;
    for (uint32_t i = 0; i < 1000; i++) {
        hand.target.angles.yaw_rad = i / 100u % 2u ? 1e-30f : 0.0f;
        assert_int_equal(tick(), INPUT_VALID);
    }
}

static void test_a_resting_pointer_stays_valid_for_hours(void **state)
{
    (void)state;
    hand.has_wrist = 0;
    expect_for(2u * 3600u * CORE_TICK_HZ, INPUT_VALID);
}

/* ---- Late reports --------------------------------------------------------------------------- */

static void silence(uint32_t ticks)
{
    for (uint32_t i = 0; i < ticks; i++) {
        hand.age_ticks++;
        assert_int_equal(tick(), INPUT_VALID);
    }
    hand.age_ticks = 0;
}

/* After a delay the kiosk passes on only the newest pose. The flag `has_gap` means that the poses
 * during the delay are unknown. */
static void test_motion_that_the_kiosk_did_not_observe_is_followed_slowly(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.target.position_m.x += 1.2f;
    hand.has_gap = 1;
    assert_int_equal(tick(), INPUT_VALID);
    assert_true(input_validation_blend(&validation) < 0.05f);
    hand.has_gap = 0;
    expect_for(20, INPUT_VALID);
    /* Without `has_gap`, the same motion is too fast for an arm, so the input is lost. */
    hand.target.position_m.x += 1.2f;
    assert_int_equal(tick(), INPUT_LOST);
}

static void test_motion_during_late_reports_is_valid(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    silence(50);
    /* The controller moved by 1.2 m while its reports were late. The motion arrives in two steps,
     * because a frame has two ticks. */
    hand.target.position_m.x += 0.6f;
    assert_int_equal(tick(), INPUT_VALID);
    hand.target.position_m.x += 0.6f;
    expect_for(20, INPUT_VALID);
}

/* After late reports, the poi follows the missed motion at 4/3 of its original speed. The poi
 * therefore reaches the reported pose after three quarters of the duration of the gap. */
static void test_missed_motion_is_followed_in_three_quarters_of_its_time(void **state)
{
    for (uint32_t period = 1; period <= INPUT_SILENT_TICKS; period += period < 13 ? 1u : 7u) {
        float reported_m = 0.0f, poi_m = 0.0f;
        set_up(state);
        for (uint32_t i = 0; i < 4u * period; i++) {
            hand.age_ticks = (uint16_t)(i % period);
            reported_m = hand.age_ticks == 0 ? (float)i : reported_m;
            hand.target.position_m.x = 1e-3f * reported_m;
            assert_int_equal(tick(), INPUT_VALID);
            poi_m += input_validation_blend(&validation) * (reported_m - poi_m);
            if (i >= 2u * period && period > INPUT_LATE_TICKS) {
                const float whole = (float)(3u * period / 4u);
                const float gone = f_min((float)(hand.age_ticks + 1u) / whole, 1.0f);
                assert_float_equal(poi_m, reported_m - (1.0f - gone) * (float)period, 1e-3f);
            } else if (period <= INPUT_LATE_TICKS) {
                assert_true(poi_m == reported_m);
            }
        }
    }
}

static void test_a_long_silence_counts_as_lost_and_not_as_late(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.age_ticks = INPUT_SILENT_TICKS + 1u;
    assert_int_equal(tick(), INPUT_LOST);
    hand.age_ticks = 0;
    expect_lost_and_found();
    assert_true(input_validation_blend(&validation) == 1.0f);
}

static void test_missed_motion_beyond_the_reach_of_an_arm_invalidates_the_input(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    /* In 30 ticks (0.25 s) an arm moves by at most 1 m. This motion of 1.5 m is therefore a
     * fault. */
    silence(30);
    hand.target.position_m.x += 1.5f;
    tick();
    expect_lost_and_found();
}

static void test_unused_motion_of_a_late_report_does_not_raise_a_later_limit(void **state)
{
    (void)state;
    hand.has_wrist = 1;
    expect_for(10, INPUT_VALID);
    silence(59);
    expect_for(120, INPUT_VALID);
    hand.target.position_m.x += 0.5f;
    assert_int_equal(tick(), INPUT_LOST);
}

/* ---- Random bits ---------------------------------------------------------------------------- */

static void test_random_bits_give_a_status_and_valid_poses_are_finite(void **state)
{
    (void)state;
    uint32_t seen[3] = { 0 };
    for (uint32_t i = 0; i < 400000; i++) {
        uint32_t words[8];
        for (uint32_t k = 0; k < 8; k++) {
            words[k] = rng_u32((struct rng_key){ 3, i / 40u, k, RNG_TEST });
        }
        /* Keeps the random bits for up to 40 ticks. Otherwise no input would ever become valid. */
        if (i % 40u == 0 || words[0] % 5u == 0) {
            memcpy(&hand.target, words, sizeof hand.target);
            float *one = field(words[7] % 6u);
            *one = words[6] % 3u ? 0.1f : *one;
            if (words[6] % 2u) {
                hand.target = (struct poi_target){ .position_m = { 0.1f, *one, 0.0f } };
            }
        }
        hand.link = (uint8_t)(words[6] % 7u < 5u ? POI_SOURCE_LIVE : words[7] % 4u);
        hand.trembles = (uint8_t)(words[5] >> 31);
        hand.has_wrist = (uint8_t)(words[4] >> 31);
        hand.age_ticks = (uint16_t)(words[3] % 3u ? 0u : words[2]);
        const enum input_status verdict = tick();
        seen[verdict]++;
        if (verdict == INPUT_VALID) {
            assert_int_equal(hand.link, POI_SOURCE_LIVE);
            assert_true(v3_is_finite(hand.target.position_m));
            assert_true(f_abs(hand.target.angles.yaw_rad) <= INPUT_ANGLE_RAD_MAX);
        }
        assert_true(f_is_finite(validation.excess_m) && f_is_finite(validation.spin));
    }
    for (uint32_t i = 0; i < 3; i++) {
        assert_true(seen[i] > 0);
    }
}

#define TEST(name) cmocka_unit_test_setup(name, set_up)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_a_new_controller_is_valid_immediately),
        TEST(test_an_absent_controller_and_the_bot_are_not_validated),
        TEST(test_a_restored_link_is_lost_until_it_was_valid_for_a_while),
        TEST(test_a_nan_or_absurd_value_in_any_field_invalidates_the_input),
        TEST(test_one_bad_report_costs_a_quarter_of_a_second),
        TEST(test_a_jump_of_1_m_invalidates_the_input_until_it_stays),
        TEST(test_a_jump_spread_over_two_ticks_invalidates_the_input),
        TEST(test_a_pointer_may_jump),
        TEST(test_a_missed_report_is_valid_and_a_larger_jump_is_not),
        TEST(test_a_speed_of_4_m_s_is_valid_and_6_m_s_is_not),
        TEST(test_a_fast_turn_is_valid_and_a_flip_is_not),
        TEST(test_a_pose_that_keeps_jumping_stays_invalid),
        TEST(test_an_input_without_reports_is_lost_after_half_a_second),
        TEST(test_a_noisy_sensor_with_the_same_value_for_a_second_is_frozen),
        TEST(test_a_noisy_sensor_with_noise_in_its_last_bit_is_not_frozen),
        TEST(test_a_resting_pointer_stays_valid_for_hours),
        TEST(test_motion_that_the_kiosk_did_not_observe_is_followed_slowly),
        TEST(test_motion_during_late_reports_is_valid),
        TEST(test_missed_motion_is_followed_in_three_quarters_of_its_time),
        TEST(test_a_long_silence_counts_as_lost_and_not_as_late),
        TEST(test_missed_motion_beyond_the_reach_of_an_arm_invalidates_the_input),
        TEST(test_unused_motion_of_a_late_report_does_not_raise_a_later_limit),
        TEST(test_random_bits_give_a_status_and_valid_poses_are_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
