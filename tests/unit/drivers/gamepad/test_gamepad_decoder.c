/* test_gamepad_decoder.c -- tests the conversion of a gamepad's sticks, triggers and motion sensors
 * to a pose of the poi. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/control/input_pose.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/gamepad_sim.h"
#include "tests/unit/support/pointer.h"

static struct gamepad_decoder hand;
static uint64_t now_ms;

static int begin(void **state)
{
    (void)state;
    now_ms = 1000;
    gamepad_decoder_init(&hand, festival_view());
    gamepad_decoder_sample(&hand, now_ms * MS);
    return 0;
}

static struct gamepad_report *report_now(void)
{
    static struct gamepad_report report;
    report = hand.now;
    report.time_ns = now_ms * MS;
    report.has_turn = report.has_weight = 0;
    return &report;
}

static void set_axis(enum gamepad_axis axis, int16_t value)
{
    struct gamepad_report *report = report_now();
    report->axis[axis] = value;
    gamepad_decoder_report(&hand, report);
}

static void set_buttons(uint32_t buttons)
{
    struct gamepad_report *report = report_now();
    report->buttons = buttons;
    gamepad_decoder_report(&hand, report);
}

static struct poi_target after_ms(uint64_t ms)
{
    now_ms += ms;
    return gamepad_decoder_sample(&hand, now_ms * MS).target;
}

static void test_a_worn_stick_at_rest_moves_nothing(void **state)
{
    (void)state;
    const vec3 before = after_ms(0).position_m;
    set_axis(GAMEPAD_LEAD_X, GAMEPAD_DEAD);
    const vec3 after = after_ms(800).position_m;
    assert_true(after.x == before.x && after.z == before.z);
    set_axis(GAMEPAD_LEAD_X, GAMEPAD_DEAD + 2000);
    assert_true(after_ms(800).position_m.x > before.x + 0.001f);
}

/* Some sticks have a square range, so that a diagonal deflection can exceed 1. The ring must
 * nevertheless move at the same speed in every direction. */
static void test_a_diagonal_stick_is_as_fast_as_a_straight_one(void **state)
{
    (void)state;
    set_axis(GAMEPAD_LEAD_X, INT16_MAX);
    set_axis(GAMEPAD_LEAD_Y, INT16_MAX);
    after_ms(300);
    const vec3 speed = hand.fly.speed_m_s;
    assert_true(v3_length(speed) <= STICK_MOTION_AIR_M_S * 1.001f);
    assert_true(speed.x > 0.0f && f_abs(speed.x - speed.z) < 1e-3f);
}

static void test_a_trigger_that_trembles_at_half_travel_dips_once(void **state)
{
    (void)state;
    uint32_t dips = 0;
    int was_down = 0;
    for (uint32_t i = 0; i < 100; i++) {
        set_axis(GAMEPAD_TRIGGER_LEFT, (int16_t)(GAMEPAD_TRIGGER_ON + (i % 2 ? 900 : -900)));
        dips += hand.trigger_down && !was_down;
        was_down = hand.trigger_down;
        after_ms(4);
    }
    assert_int_equal(dips, 1);
    assert_true(after_ms(400).position_m.y < -0.04f);
    set_axis(GAMEPAD_TRIGGER_LEFT, GAMEPAD_TRIGGER_OFF);
    assert_true(after_ms(600).position_m.y > 0.03f);
}

static void test_the_ring_stays_down_while_button_a_or_a_trigger_is_held(void **state)
{
    (void)state;
    set_buttons(GAMEPAD_SOUTH);
    set_axis(GAMEPAD_TRIGGER_RIGHT, INT16_MAX);
    after_ms(500);
    set_buttons(0);
    assert_true(after_ms(600).position_m.y < -0.04f);
    set_axis(GAMEPAD_TRIGGER_RIGHT, 0);
    assert_true(after_ms(600).position_m.y > 0.03f);
}

static void test_the_right_stick_tilts_in_proportion_and_without_a_jump(void **state)
{
    (void)state;
    /* The right stick is fully deflected away from the player. */
    set_axis(GAMEPAD_TILT_Y, INT16_MIN);
    const float at_once = after_ms(8).angles.pitch_rad;
    const float then = after_ms(500).angles.pitch_rad;
    assert_true(at_once < 0.2f * GAMEPAD_TILT_RAD);
    assert_true(f_abs(then - GAMEPAD_TILT_RAD) < 0.01f);
    set_axis(GAMEPAD_TILT_Y, 0);
    assert_true(f_abs(after_ms(500).angles.pitch_rad) < 0.01f);
    set_axis(GAMEPAD_TILT_X, INT16_MAX);
    assert_true(f_abs(after_ms(500).angles.roll_rad - GAMEPAD_TILT_RAD) < 0.01f);
}

static void test_gamepad_buttons_map_to_the_cabinet_buttons(void **state)
{
    (void)state;
    struct button_sample buttons;
    set_buttons(GAMEPAD_START | GAMEPAD_BACK);
    set_buttons(GAMEPAD_LEFT | GAMEPAD_EAST);
    set_buttons(GAMEPAD_RIGHT | 0x80000000u);
    gamepad_decoder_buttons(&hand, &buttons);
    assert_int_equal(buttons.pressed,
                     INPUT_START | INPUT_LANGUAGE | INPUT_LEFT | INPUT_OK | INPUT_RIGHT);
    assert_int_equal(buttons.held, INPUT_RIGHT);
    set_buttons(GAMEPAD_RIGHT);
    gamepad_decoder_buttons(&hand, &buttons);
    assert_int_equal(buttons.pressed, 0);
}

static void test_the_shoulder_button_moves_the_fan_and_the_poi_waits(void **state)
{
    (void)state;
    assert_false(stick_motion_fan(&hand.fly, now_ms * MS).present);
    set_buttons(GAMEPAD_SHOULDER_LEFT);
    const vec3 before = after_ms(500).position_m;
    set_axis(GAMEPAD_LEAD_X, INT16_MAX);
    const vec3 after = after_ms(300).position_m;
    const struct shade_input fan = stick_motion_fan(&hand.fly, now_ms * MS);
    assert_true(fan.present);
    assert_true(fan.x_m > 0.05f);
    assert_true(f_abs(after.x - before.x) < 0.001f);
}

/* ---- Motion sensors ------------------------------------------------------------------------- */

static void weigh(vec3 up)
{
    struct gamepad_report *report = report_now();
    report->has_weight = 1;
    report->weight_m_s2 = v3_scale(up, 9.81f);
    gamepad_decoder_report(&hand, report);
}

static void turn(vec3 rate_rad_s)
{
    struct gamepad_report *report = report_now();
    report->has_turn = 1;
    report->turn_rad_s = rate_rad_s;
    gamepad_decoder_report(&hand, report);
}

/* Returns the direction that the accelerometer of a gamepad at rest with this pitch and roll
 * measures, as a unit vector. Players usually hold a gamepad at a pitch of 40 degrees. */
static vec3 as_held(float pitch_rad, float roll_rad)
{
    const struct basis axes =
        vec_basis_from_angles((struct angles){ .pitch_rad = pitch_rad, .roll_rad = roll_rad });
    return vec_basis_to_body(&axes, v3(0.0f, 1.0f, 0.0f));
}

static void test_any_rest_orientation_of_the_gamepad_is_level(void **state)
{
    (void)state;
    weigh(as_held(40.0f * F_DEG, -10.0f * F_DEG));
    const struct angles angles = after_ms(300).angles;
    assert_true(f_abs(angles.pitch_rad) < 0.01f && f_abs(angles.roll_rad) < 0.01f);
}

/* A rotation of the gamepad must tilt the ring at once, because the gyroscope measures it. The tilt
 * must not drift during a dip, because the accelerometer corrects it. */
static void test_gamepad_rotation_tilts_the_ring_without_drift(void **state)
{
    (void)state;
    weigh(as_held(40.0f * F_DEG, 0.0f));
    after_ms(100);
    set_buttons(GAMEPAD_SOUTH);
    after_ms(500);
    /* The right side of the gamepad turns down at 2 rad/s during the following 250 ms. */
    turn(v3(0.0f, 0.0f, -2.0f));
    after_ms(250);
    /* The gamepad is at rest from here on. Its gyroscope still reports a bias of 0.02 rad/s, about
     * one degree per second. */
    turn(v3(0.0f, 0.0f, 0.02f));
    const float at_once = after_ms(200).angles.roll_rad;
    assert_true(at_once > 0.30f && at_once < 0.50f);
    const vec3 up = hand.tilt.up;
    /* The dip lasts 20 s. During this time the gyroscope's bias must not turn the ring. */
    for (uint32_t i = 0; i < 2000; i++) {
        turn(v3(0.0f, 0.0f, 0.02f));
        weigh(up);
        after_ms(10);
    }
    assert_true(f_abs(after_ms(10).angles.roll_rad - at_once) < 0.05f);
    set_buttons(0);
    /* While the ring hovers above the water, the current orientation slowly becomes the new rest
     * orientation. */
    for (uint32_t i = 0; i < 2000; i++) {
        weigh(up);
        after_ms(10);
    }
    assert_true(f_abs(after_ms(10).angles.roll_rad) < 0.01f);
}

static void test_the_level_button_sets_the_rest_orientation(void **state)
{
    (void)state;
    weigh(as_held(20.0f * F_DEG, 0.0f));
    after_ms(100);
    turn(v3(2.0f, 0.0f, 0.0f));
    after_ms(250);
    turn(v3(0.0f, 0.0f, 0.0f));
    assert_true(after_ms(200).angles.pitch_rad > 0.3f);
    set_buttons(GAMEPAD_WEST);
    assert_true(f_abs(after_ms(300).angles.pitch_rad) < 0.02f);
}

/* ---- The simulated gamepad ------------------------------------------------------------------ */

#define SCRIPT 1000u
static struct gamepad_report script[SCRIPT];
static struct clock_sim clock_state;
static struct gamepad_sim sim;
static struct hal_poi poi;

static int begin_sim(void **state)
{
    (void)state;
    clock_state = (struct clock_sim){ .now_ns = 1000 * MS };
    gamepad_sim_init(&sim, sim_clock_device(&clock_state), festival_view());
    /* The script has 250 reports per second, which move the ring around and dip it. */
    for (uint32_t i = 0; i < SCRIPT; i++) {
        script[i] = (struct gamepad_report){ .time_ns = (1000 + 4 * (uint64_t)i) * MS };
        script[i].axis[GAMEPAD_LEAD_X] = (int16_t)(32767.0f * f_sin((float)i * 0.02f));
        script[i].axis[GAMEPAD_LEAD_Y] = (int16_t)(32767.0f * f_cos((float)i * 0.03f));
        script[i].buttons = i % 300 < 150 ? (uint32_t)GAMEPAD_SOUTH : 0u;
    }
    sim.reports = script;
    sim.feed.count = SCRIPT;
    poi = gamepad_sim_devices(&sim).poi;
    return poi.ops->open(poi.self);
}

/* Polls for `ms` milliseconds, once every `frame_ms`. Checks that each sample is a possible motion
 * after the previous one. Returns the number of samples. */
static uint32_t play_ms(uint64_t ms, uint64_t frame_ms)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    static struct poi_sample last;
    uint32_t count = 0;
    last = (struct poi_sample){ 0 };
    for (uint64_t gone_ms = 0; gone_ms < ms; gone_ms += frame_ms) {
        clock_state.now_ns += frame_ms * MS;
        const int taken = poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
        for (int i = 0; i < taken; i++) {
            assert_true(input_pose_is_finite(&samples[i].target));
            assert_true(samples[i].time_ns >= last.time_ns);
            const float dt_s = (float)(samples[i].time_ns - last.time_ns) * 1e-9f;
            assert_false(last.time_ns > 0 && dt_s > 0.001f &&
                         input_pose_is_jump(&last.target, &samples[i].target, dt_s, 0));
            last = samples[i];
            count++;
        }
    }
    return count;
}

static void test_there_is_one_sample_per_tick_at_every_frame_rate(void **state)
{
    (void)state;
    for (uint64_t frame_ms = 8; frame_ms <= 400; frame_ms += 56) {
        begin_sim(state);
        const uint32_t count = play_ms(3200, frame_ms);
        const uint32_t ticks = 3200u * CORE_TICK_HZ / 1000u;
        /* Because of rounding, each frame may give one sample less than it has ticks. */
        assert_true(count + 3200u / frame_ms >= ticks);
    }
}

static void test_the_path_is_equal_at_every_frame_rate(void **state)
{
    (void)state;
    play_ms(3200, 8);
    const vec3 fine = sim.track.decoder.fly.place_m;
    begin_sim(state);
    play_ms(3200, 200);
    const vec3 coarse = sim.track.decoder.fly.place_m;
    assert_true(v3_length(v3_sub(fine, coarse)) < 0.005f);
}

static void test_random_input_gives_finite_poses(void **state)
{
    (void)state;
    sim.feed.random_from = 100;
    sim.feed.random_to = 900;
    sim.feed.jump_at = 50;
    sim.feed.double_every = 3;
    play_ms(5000, 16);
    assert_int_equal(sim.feed.next, SCRIPT);
}

static void test_a_burst_of_reports_after_a_pause_loses_no_press(void **state)
{
    (void)state;
    struct button_sample buttons;
    const struct hal_buttons device = gamepad_sim_devices(&sim).buttons;
    for (uint32_t i = 100; i < SCRIPT; i += 100) {
        script[i].buttons |= GAMEPAD_START;
    }
    sim.feed.silent_from_ns = 1000 * MS;
    sim.feed.silent_to_ns = 4900 * MS;
    uint32_t edges = 0;
    for (uint32_t i = 0; i < 500; i++) {
        play_ms(10, 10);
        device.ops->poll(device.self, &buttons);
        edges += (buttons.pressed & INPUT_START) != 0;
    }
    /* Nine presses between two polls count as one press. */
    assert_int_equal(edges, 1);
    assert_int_equal(sim.feed.next, SCRIPT);
}

/* Unplugs the gamepad at each of its 1,000 reports. Each time the loss must be reported, and the
 * gamepad must work again after it is plugged in. */
static void test_the_gamepad_can_be_unplugged_at_any_report(void **state)
{
    (void)state;
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    for (uint32_t at = 0; at < SCRIPT; at++) {
        begin_sim(state);
        sim.feed.unplug_at = at;
        sim.feed.replug_ns = clock_state.now_ns + (4 * (uint64_t)at + 100) * MS;
        int result = 0;
        for (uint32_t i = 0; i < SCRIPT && result >= 0; i++) {
            clock_state.now_ns += 16 * MS;
            result = poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
        }
        assert_int_equal(result, HAL_ERR_GONE);
        assert_int_equal(sim.feed.next, at);
        assert_int_equal(poi.ops->open(poi.self), HAL_ERR_GONE);
        clock_state.now_ns = sim.feed.replug_ns;
        assert_int_equal(poi.ops->open(poi.self), HAL_OK);
        assert_true(poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_a_worn_stick_at_rest_moves_nothing, begin),
        cmocka_unit_test_setup(test_a_diagonal_stick_is_as_fast_as_a_straight_one, begin),
        cmocka_unit_test_setup(test_a_trigger_that_trembles_at_half_travel_dips_once, begin),
        cmocka_unit_test_setup(test_the_ring_stays_down_while_button_a_or_a_trigger_is_held, begin),
        cmocka_unit_test_setup(test_the_right_stick_tilts_in_proportion_and_without_a_jump, begin),
        cmocka_unit_test_setup(test_gamepad_buttons_map_to_the_cabinet_buttons, begin),
        cmocka_unit_test_setup(test_the_shoulder_button_moves_the_fan_and_the_poi_waits, begin),
        cmocka_unit_test_setup(test_any_rest_orientation_of_the_gamepad_is_level, begin),
        cmocka_unit_test_setup(test_gamepad_rotation_tilts_the_ring_without_drift, begin),
        cmocka_unit_test_setup(test_the_level_button_sets_the_rest_orientation, begin),
        cmocka_unit_test_setup(test_there_is_one_sample_per_tick_at_every_frame_rate, begin_sim),
        cmocka_unit_test_setup(test_the_path_is_equal_at_every_frame_rate, begin_sim),
        cmocka_unit_test_setup(test_random_input_gives_finite_poses, begin_sim),
        cmocka_unit_test_setup(test_a_burst_of_reports_after_a_pause_loses_no_press, begin_sim),
        cmocka_unit_test_setup(test_the_gamepad_can_be_unplugged_at_any_report, begin_sim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
