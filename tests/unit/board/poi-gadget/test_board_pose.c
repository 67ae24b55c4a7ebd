/* test_board_pose.c -- tests that the pose in the board's report equals the true pose. The readings
 * of the simulated sensors are computed from the true pose. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/sensor_twin.h"

#define DT_S 0.004f

static struct poi_config config;

static int fresh(void **state)
{
    (void)state;
    poi_config_init(&config);
    config.ahead_s = 0.0f;
    sensor_twin_calibrate(&config);
    return 0;
}

static void test_a_fused_pose_is_correct_for_every_mounting_of_the_chip(void **state)
{
    (void)state;
    static const char *const ways[] = { "imu_axes = +x +y +z", "imu_axes = +x +z -y",
                                        "imu_axes = -x +y -z", "imu_axes = +y +z +x",
                                        "imu_axes = -z -y -x", "imu_axes = +z +x +y" };
    const struct poi_report hand = {
        .target = { .position_m = { -0.2f, 0.05f, 0.1f }, .angles = { 0.0f, -0.6f, 0.4f } },
        .buttons = POI_BUTTON_OK,
    };
    for (size_t w = 0; w < sizeof ways / sizeof ways[0]; w++) {
        const char *why = "";
        struct board_pose pose;
        struct readings readings;
        struct poi_report out = { 0 };
        assert_int_equal(poi_config_line(&config, ways[w], &why), 1);
        struct sensor_twin twin = { .config = &config, .fuses = 1 };
        board_pose_init(&pose, &config);
        for (uint32_t n = 0; n < 3; n++) {
            sensor_twin_step(&twin, &hand, DT_S, &readings);
            board_pose_step(&pose, &readings, DT_S, &out);
        }
        assert_int_equal(pose.wires, DRAW_WIRES_OK);
        assert_float_equal(out.target.angles.pitch_rad, -0.6f, 1e-3f);
        assert_float_equal(out.target.angles.roll_rad, 0.4f, 1e-3f);
        assert_float_equal(out.target.angles.yaw_rad, 0.0f, 1e-3f);
        assert_true(v3_length(v3_sub(out.target.position_m, hand.target.position_m)) < 0.001f);
        assert_int_equal(out.buttons, POI_BUTTON_OK);
    }
}

struct errors {
    float rest_m, rest_speed_m_s; /* Errors of position and speed while the poi is at rest. */
    float moving_m, turn_rad;
};

/* Runs a minute of simulated scoops. Returns the largest differences between the reported and the
 * true pose. */
static struct errors scoop_for_a_minute(uint8_t fuses, float noise_steps, vec3 bias)
{
    struct errors worst = { 0 };
    struct scoop scoop = { 0 };
    struct sensor_twin twin = {
        .config = &config, .fuses = fuses, .noise_steps = noise_steps, .gyro_bias_rad_s = bias
    };
    struct board_pose pose;
    struct poi_report hand = { 0 }, out = { 0 }, before = { 0 };
    board_pose_init(&pose, &config);
    for (uint32_t n = 0; n < 15000; n++) {
        struct readings readings;
        sensor_twin_scoop(&scoop, DT_S, &hand);
        sensor_twin_step(&twin, &hand, DT_S, &readings);
        board_pose_step(&pose, &readings, DT_S, &out);
        const float off_m = v3_length(v3_sub(out.target.position_m, hand.target.position_m));
        /* The first stroke of the simulation has no start pose, so the poi rests at the stroke's
         * target for 0.9 s (225 steps). The filters need the first 25 steps to settle. */
        const int rests = n < 225;
        if (rests && n > 25) {
            const vec3 step_m = v3_sub(out.target.position_m, before.target.position_m);
            worst.rest_m = f_max(worst.rest_m, off_m);
            worst.rest_speed_m_s = f_max(worst.rest_speed_m_s, v3_length(step_m) / DT_S);
        }
        worst.moving_m = f_max(worst.moving_m, off_m);
        worst.turn_rad = f_max(worst.turn_rad,
                               f_abs(out.target.angles.pitch_rad - hand.target.angles.pitch_rad));
        worst.turn_rad =
            f_max(worst.turn_rad, f_abs(out.target.angles.roll_rad - hand.target.angles.roll_rad));
        before = out;
    }
    print_message("# chip that %s: at rest %.2f mm and %.1f mm/s, in a scoop %.1f mm, %.1f deg\n",
                  fuses ? "fuses" : "does not", (double)(worst.rest_m * 1000.0f),
                  (double)(worst.rest_speed_m_s * 1000.0f), (double)(worst.moving_m * 1000.0f),
                  (double)(worst.turn_rad / F_DEG));
    return worst;
}

static void test_scoops_with_sensor_fusion_are_reported_within_1_cm(void **state)
{
    (void)state;
    const struct errors worst = scoop_for_a_minute(1, 1.5f, v3(0, 0, 0));
    assert_true(worst.rest_m < 0.0005f);
    assert_true(worst.rest_speed_m_s < 0.03f);
    /* The filter delays the position, so the reported position lags behind the true one during a
     * scoop at 0.5 m/s. */
    assert_true(worst.moving_m < 0.010f);
    assert_true(worst.turn_rad < 0.5f * F_DEG);
}

static void test_scoops_with_a_cheap_chip_are_reported_within_5_degrees(void **state)
{
    (void)state;
    const struct errors worst = scoop_for_a_minute(0, 1.5f, v3(0.005f, -0.005f, 0.005f));
    assert_true(worst.rest_m < 0.001f);
    assert_true(worst.moving_m < 0.015f);
    assert_true(worst.turn_rad < 5.0f * F_DEG);
}

static void test_a_torn_wire_gives_no_position_until_it_is_repaired(void **state)
{
    (void)state;
    const struct poi_report hand = { .target.position_m = { 0.1f, 0.0f, 0.05f } };
    struct sensor_twin twin = { .config = &config, .fuses = 1 };
    struct board_pose pose;
    struct readings readings;
    struct poi_report out = { 0 };
    uint8_t bytes[POI_REPORT_SIZE];
    board_pose_init(&pose, &config);
    sensor_twin_step(&twin, &hand, DT_S, &readings);
    const float whole = readings.wire[1];
    /* Simulates a torn draw wire of the position sensor. The spring of the sensor winds the wire up
     * completely, so its length is 0. */
    readings.wire[1] = 0.0f;
    board_pose_step(&pose, &readings, DT_S, &out);
    poi_report_encode(&out, bytes);
    /* The report has no position, so the decoder rejects it. */
    assert_false(poi_report_decode(bytes, sizeof bytes, &out));
    readings.wire[1] = whole;
    board_pose_step(&pose, &readings, DT_S, &out);
    assert_true(v3_length(v3_sub(out.target.position_m, hand.target.position_m)) < 0.001f);
}

static void test_a_simulated_scoop_dips_tips_and_stays_over_the_tank(void **state)
{
    (void)state;
    struct scoop scoop = { 0 };
    struct poi_report hand = { 0 }, before = { 0 };
    uint32_t dips = 0, tips = 0, starts = 0;
    for (uint32_t n = 0; n < 15000; n++) {
        sensor_twin_scoop(&scoop, DT_S, &hand);
        const vec3 at_m = hand.target.position_m, was_m = before.target.position_m;
        dips += was_m.y > -0.01f && at_m.y <= -0.01f;
        tips += before.target.angles.roll_rad < 0.9f && hand.target.angles.roll_rad >= 0.9f;
        starts += (hand.buttons & ~before.buttons & POI_BUTTON_START) != 0;
        /* At this roll angle, the poi is being emptied, so it must be over the opening of the first
         * bowl. */
        if (hand.target.angles.roll_rad > 0.9f) {
            assert_true(v3_length(v3_sub(v3(at_m.x, 0, at_m.z), v3(0.335f, 0, 0.185f))) < 0.08f);
            assert_true(at_m.y > 0.04f && at_m.y < 0.10f);
        }
        assert_true(f_abs(at_m.x) < 0.38f && f_abs(at_m.z) < 0.23f);
        assert_true(at_m.y > -0.08f && at_m.y < 0.2f);
        /* A human arm does not move faster than 2 m/s (core/game/control/input_pose.h). */
        if (n > 0) {
            assert_true(v3_length(v3_sub(at_m, was_m)) / DT_S < 2.0f);
        }
        before = hand;
    }
    assert_true(dips >= 9 && tips + 1 >= dips);
    assert_true(starts >= dips);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_a_fused_pose_is_correct_for_every_mounting_of_the_chip, fresh),
        cmocka_unit_test_setup(test_scoops_with_sensor_fusion_are_reported_within_1_cm, fresh),
        cmocka_unit_test_setup(test_scoops_with_a_cheap_chip_are_reported_within_5_degrees, fresh),
        cmocka_unit_test_setup(test_a_torn_wire_gives_no_position_until_it_is_repaired, fresh),
        cmocka_unit_test(test_a_simulated_scoop_dips_tips_and_stays_over_the_tank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
