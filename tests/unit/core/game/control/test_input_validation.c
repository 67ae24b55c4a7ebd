/* test_input_validation.c -- which hands are believed, each limit on both sides. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/game/control/input_validation.h"

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

/* Lost now; then a quarter of a second of what agrees brings it back, and not a tick less. */
static void expect_lost_and_found(void)
{
    assert_int_equal(validation.verdict, INPUT_LOST);
    expect_for(INPUT_AGREE_TICKS - 1u, INPUT_LOST);
    assert_int_equal(tick(), INPUT_VALID);
    expect_for(50, INPUT_VALID);
}

static void test_a_fresh_hand_is_believed_at_once(void **state)
{
    (void)state;
    expect_for(500, INPUT_VALID);
}

static void test_no_controller_and_the_bot_are_not_judged(void **state)
{
    (void)state;
    hand.target.position_m.x = NAN;
    hand.link = POI_SOURCE_ABSENT;
    expect_for(5, INPUT_ABSENT);
    hand.link = POI_SOURCE_BOT;
    expect_for(5, INPUT_ABSENT);
}

static void test_a_link_that_went_is_lost_until_it_has_been_back_for_a_while(void **state)
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

/* ---- Numbers -------------------------------------------------------------------------------- */

static float *field(uint32_t index)
{
    float *const fields[] = { &hand.target.position_m.x,     &hand.target.position_m.y,
                              &hand.target.position_m.z,     &hand.target.angles.yaw_rad,
                              &hand.target.angles.pitch_rad, &hand.target.angles.roll_rad };
    return fields[index];
}

static void test_a_number_that_is_none_or_absurd_in_any_field_loses_the_hand(void **state)
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

/* ---- Leaps ---------------------------------------------------------------------------------- */

static void test_a_metres_jump_loses_the_hand_and_it_is_found_where_it_stays(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.target.position_m.x += 1.0f;
    tick();
    expect_lost_and_found();
}

/* The frame loop spreads a frame's way over its two ticks. */
static void test_a_jump_that_a_frame_spreads_over_two_ticks_is_one_too(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.target.position_m.z -= 0.055f;
    assert_int_equal(tick(), INPUT_VALID);
    hand.target.position_m.z -= 0.055f;
    tick();
    expect_lost_and_found();
}

/* It leaves the window at one side and comes back at the other. */
static void test_a_pointer_may_leap(void **state)
{
    (void)state;
    hand.has_wrist = 0;
    for (uint32_t i = 0; i < 100; i++) {
        hand.target.position_m.x = i / 7u % 2u ? 0.68f : -0.68f;
        assert_int_equal(tick(), INPUT_VALID);
    }
}

static void test_a_missed_report_is_believed_and_a_hands_breadth_is_not(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 40; i++) {
        hand.target.position_m.x += i % 20u == 0 ? 0.05f : i % 20u == 1 ? -0.05f : 0.0f;
        assert_int_equal(tick(), INPUT_VALID);
    }
    hand.target.position_m.x += 0.07f;
    assert_int_equal(tick(), INPUT_LOST);
}

/* Metres a tick, and whether a hand that goes so for half a second is believed. */
static int believed_at(float pace_m_s)
{
    int believed = 1;
    set_up(NULL);
    for (uint32_t i = 0; i < 60; i++) {
        hand.target.position_m.x += pace_m_s * CORE_TICK_S;
        believed &= tick() == INPUT_VALID;
    }
    return believed;
}

/* 60 reports a second meet 60 frames a second: one frame hears none, the next hears two. */
static int believed_unevenly_at(float pace_m_s)
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

static void test_an_arm_is_believed_at_four_metres_a_second_and_not_at_six(void **state)
{
    (void)state;
    assert_true(believed_at(3.9f));
    assert_true(believed_unevenly_at(3.0f));
    assert_true(believed_at(-3.9f));
    assert_false(believed_at(6.0f));
}

static void test_a_quick_turn_is_believed_and_a_flip_is_not(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 60; i++) {
        hand.target.angles.roll_rad += 25.0f * CORE_TICK_S;
        assert_int_equal(tick(), INPUT_VALID);
    }
    hand.target.angles.roll_rad += 0.55f;
    expect_for(5, INPUT_VALID);
    hand.target.angles.roll_rad += 0.70f; /* 40 degrees. */
    assert_int_equal(tick(), INPUT_LOST);
    expect_lost_and_found();
    hand.target.angles.roll_rad += 20.0f * F_TAU; /* The same direction. */
    assert_int_equal(tick(), INPUT_VALID);
}

static void test_a_hand_that_leaps_again_and_again_is_never_believed(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    for (uint32_t i = 0; i < 600; i++) {
        hand.target.position_m.x = i / 20u % 2u ? 0.1f : 1.1f;
        assert_int_equal(tick(), INPUT_LOST);
    }
}

/* ---- Freezing and silence ------------------------------------------------------------------- */

static void test_a_hand_is_silent_after_half_a_second(void **state)
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

static void test_a_trembling_sensor_that_says_the_same_for_a_second_is_frozen(void **state)
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

static void test_a_trembling_sensor_that_trembles_in_its_last_bit_lives(void **state)
{
    (void)state;
    hand.trembles = 1;
    for (uint32_t i = 0; i < 1000; i++) {
        hand.target.angles.yaw_rad = i / 100u % 2u ? 1e-30f : 0.0f;
        assert_int_equal(tick(), INPUT_VALID);
    }
}

static void test_a_pointer_may_rest_for_hours(void **state)
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

static void test_a_hand_that_went_on_while_it_was_late_is_believed(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    silence(50);
    hand.target.position_m.x += 0.6f; /* In two ticks, as a frame spreads it. */
    assert_int_equal(tick(), INPUT_VALID);
    hand.target.position_m.x += 0.6f;
    expect_for(20, INPUT_VALID);
}

/* So that the poi goes it at the pace of the hand. */
static void test_the_way_of_a_late_hand_is_gone_in_three_quarters_of_its_time(void **state)
{
    for (uint32_t period = 1; period <= INPUT_SILENT_TICKS; period += period < 13 ? 1u : 7u) {
        float said_m = 0.0f, poi_m = 0.0f;
        set_up(state);
        for (uint32_t i = 0; i < 4u * period; i++) {
            hand.age_ticks = (uint16_t)(i % period);
            said_m = hand.age_ticks == 0 ? (float)i : said_m;
            hand.target.position_m.x = 1e-3f * said_m;
            assert_int_equal(tick(), INPUT_VALID);
            poi_m += input_validation_blend(&validation) * (said_m - poi_m);
            if (i >= 2u * period && period > INPUT_LATE_TICKS) {
                const float whole = (float)(3u * period / 4u);
                const float gone = f_min((float)(hand.age_ticks + 1u) / whole, 1.0f);
                assert_float_equal(poi_m, said_m - (1.0f - gone) * (float)period, 1e-3f);
            } else if (period <= INPUT_LATE_TICKS) {
                assert_true(poi_m == said_m);
            }
        }
    }
}

static void test_who_was_silent_for_too_long_is_not_late_but_lost(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    hand.age_ticks = INPUT_SILENT_TICKS + 1u;
    assert_int_equal(tick(), INPUT_LOST);
    hand.age_ticks = 0;
    expect_lost_and_found();
    assert_true(input_validation_blend(&validation) == 1.0f);
}

static void test_a_late_hand_that_went_farther_than_an_arm_is_lost(void **state)
{
    (void)state;
    expect_for(10, INPUT_VALID);
    silence(30); /* A quarter of a second: a metre at most. */
    hand.target.position_m.x += 1.5f;
    tick();
    expect_lost_and_found();
}

static void test_what_a_late_hand_might_have_gone_is_no_credit_for_later(void **state)
{
    (void)state;
    hand.has_wrist = 1;
    expect_for(10, INPUT_VALID);
    silence(59);
    expect_for(120, INPUT_VALID);
    hand.target.position_m.x += 0.5f;
    assert_int_equal(tick(), INPUT_LOST);
}

/* ---- Any bits ------------------------------------------------------------------------------- */

static void test_any_bits_give_a_verdict_and_what_is_believed_is_readable(void **state)
{
    (void)state;
    uint32_t seen[3] = { 0 };
    for (uint32_t i = 0; i < 400000; i++) {
        uint32_t words[8];
        for (uint32_t k = 0; k < 8; k++) {
            words[k] = rng_u32((struct rng_key){ 3, i / 40u, k, RNG_TEST });
        }
        if (i % 40u == 0 || words[0] % 5u == 0) { /* Held for a while, else nothing is believed. */
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
        TEST(test_a_fresh_hand_is_believed_at_once),
        TEST(test_no_controller_and_the_bot_are_not_judged),
        TEST(test_a_link_that_went_is_lost_until_it_has_been_back_for_a_while),
        TEST(test_a_number_that_is_none_or_absurd_in_any_field_loses_the_hand),
        TEST(test_one_bad_report_costs_a_quarter_of_a_second),
        TEST(test_a_metres_jump_loses_the_hand_and_it_is_found_where_it_stays),
        TEST(test_a_jump_that_a_frame_spreads_over_two_ticks_is_one_too),
        TEST(test_a_pointer_may_leap),
        TEST(test_a_missed_report_is_believed_and_a_hands_breadth_is_not),
        TEST(test_an_arm_is_believed_at_four_metres_a_second_and_not_at_six),
        TEST(test_a_quick_turn_is_believed_and_a_flip_is_not),
        TEST(test_a_hand_that_leaps_again_and_again_is_never_believed),
        TEST(test_a_hand_is_silent_after_half_a_second),
        TEST(test_a_trembling_sensor_that_says_the_same_for_a_second_is_frozen),
        TEST(test_a_trembling_sensor_that_trembles_in_its_last_bit_lives),
        TEST(test_a_pointer_may_rest_for_hours),
        TEST(test_a_hand_that_went_on_while_it_was_late_is_believed),
        TEST(test_the_way_of_a_late_hand_is_gone_in_three_quarters_of_its_time),
        TEST(test_who_was_silent_for_too_long_is_not_late_but_lost),
        TEST(test_a_late_hand_that_went_farther_than_an_arm_is_lost),
        TEST(test_what_a_late_hand_might_have_gone_is_no_credit_for_later),
        TEST(test_any_bits_give_a_verdict_and_what_is_believed_is_readable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
