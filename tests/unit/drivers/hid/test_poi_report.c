/* test_poi_report.c -- tests the encoded reports of the Kingyo poi against bytes that were computed
 * by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/fmath.h"
#include "core/base/rng.h"
#include "drivers/hid/poi_report.h"

/* The poi is 0.5 m to the left, 5 cm under water and in the middle of the tank's depth. Its far
 * edge is pitched down by pi / 4. */
static const uint8_t dipped[POI_REPORT_SIZE] = {
    1,    200,                          /* Report id and sequence number */
    0x00, 0xc0, 0x9a, 0xf9, 0x00, 0x00, /* Position x, y, z: -16384, -1638, 0 */
    0x00, 0xe0, 0x00, 0x00, 0xff, 0x7f, /* Pitch, yaw and roll: -8192, 0, 32767 */
    0x05,
};

static void test_an_input_report_contains_the_position_and_the_angles(void **state)
{
    (void)state;
    struct poi_report report;
    assert_true(poi_report_decode(dipped, sizeof dipped, &report));
    assert_int_equal(report.sequence, 200);
    assert_int_equal(report.buttons, 5);
    assert_float_equal(report.target.position_m.x, -0.500015f, 1e-6f);
    assert_float_equal(report.target.position_m.y, -0.049989f, 1e-6f);
    assert_float_equal(report.target.position_m.z, 0.0f, 0.0f);
    assert_float_equal(report.target.angles.pitch_rad, -0.25f * F_PI, 1e-4f);
    assert_float_equal(report.target.angles.yaw_rad, 0.0f, 0.0f);
    assert_float_equal(report.target.angles.roll_rad, F_PI, 1e-6f);
}

static void test_a_report_is_unchanged_by_reading_and_writing(void **state)
{
    (void)state;
    struct poi_report report;
    uint8_t bytes[POI_REPORT_SIZE];
    assert_true(poi_report_decode(dipped, sizeof dipped, &report));
    poi_report_encode(&report, bytes);
    assert_memory_equal(bytes, dipped, sizeof dipped);
    for (uint32_t i = 0; i < 5000; i++) {
        uint8_t drawn[POI_REPORT_SIZE] = { POI_REPORT_ID };
        for (uint32_t k = 1; k < POI_REPORT_SIZE; k++) {
            drawn[k] = (uint8_t)rng_u32((struct rng_key){ 1, i, k, RNG_TEST });
        }
        if (poi_report_decode(drawn, sizeof drawn, &report)) {
            poi_report_encode(&report, bytes);
            assert_memory_equal(bytes, drawn, sizeof drawn);
        }
    }
}

static void test_a_report_with_a_wrong_length_id_or_position_mark_is_rejected(void **state)
{
    (void)state;
    const struct poi_report before = { .sequence = 77 };
    struct poi_report report = before;
    uint8_t bytes[POI_REPORT_SIZE + 1] = { 0 };
    memcpy(bytes, dipped, sizeof dipped);
    assert_false(poi_report_decode(bytes, 0, &report));
    assert_false(poi_report_decode(bytes, POI_REPORT_SIZE - 1, &report));
    assert_false(poi_report_decode(bytes, POI_REPORT_SIZE + 1, &report));
    bytes[0] = 2;
    assert_false(poi_report_decode(bytes, POI_REPORT_SIZE, &report));
    bytes[0] = 1;
    for (uint32_t place = 2; place < 14; place += 2) {
        memcpy(bytes, dipped, sizeof dipped);
        bytes[place] = 0x00;
        bytes[place + 1] = 0x80;
        assert_false(poi_report_decode(bytes, POI_REPORT_SIZE, &report));
    }
    assert_memory_equal(&report, &before, sizeof before);
}

static void test_a_pose_is_clamped_and_a_value_that_is_not_finite_is_null(void **state)
{
    (void)state;
    struct poi_report report = { .target.position_m = { 7.0f, -7.0f, 1.0f } };
    struct poi_report read;
    uint8_t bytes[POI_REPORT_SIZE];
    poi_report_encode(&report, bytes);
    assert_true(poi_report_decode(bytes, sizeof bytes, &read));
    assert_float_equal(read.target.position_m.x, 1.0f, 1e-6f);
    assert_float_equal(read.target.position_m.y, -1.0f, 1e-6f);
    report.target.angles.roll_rad = __builtin_nanf("");
    poi_report_encode(&report, bytes);
    assert_false(poi_report_decode(bytes, sizeof bytes, &read));
}

static void test_an_output_report_contains_six_forces_and_three_levels(void **state)
{
    (void)state;
    const struct poi_force force = {
        .force_n = { -10.0f, 20.0f, 0.0f },
        .torque_n_m = { 4.0f, -4.0f, 1.0f },
        .drag = 1.0f,
        .slap = 0.5f,
    };
    const uint8_t expected[POI_FORCE_SIZE] = {
        2,    9,                            /* Report id and sequence number */
        0x00, 0xc0, 0xff, 0x7f, 0x00, 0x00, /* Force: -16384 (exact: -16383.5), 32767, 0 */
        0xff, 0x7f, 0x01, 0x80, 0x00, 0x20, /* Torque: 32767, -32767, 8192 (exact: 8191.75) */
        255,  128,  0,                      /* Drag, slap and tear */
    };
    uint8_t bytes[POI_FORCE_SIZE];
    poi_force_encode(&force, 9, bytes);
    assert_memory_equal(bytes, expected, sizeof expected);
}

static void test_forces_are_symmetric_and_exact_to_half_a_step(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 5000; i++) {
        const struct rng_key key = { 2, i, 0, RNG_TEST };
        const float n = rng_range(key, -POI_FORCE_N_MAX, POI_FORCE_N_MAX);
        const struct poi_force there = { .force_n = { n, -n, 0.0f } };
        struct poi_force back;
        uint8_t bytes[POI_FORCE_SIZE], sequence = 0;
        poi_force_encode(&there, (uint8_t)i, bytes);
        assert_true(poi_force_decode(bytes, sizeof bytes, &back, &sequence));
        assert_int_equal(sequence, (uint8_t)i);
        assert_float_equal(back.force_n.x, -back.force_n.y, 0.0f);
        assert_float_equal(back.force_n.x, n, 0.501f * POI_FORCE_N_MAX / 32767.0f);
    }
}

static void test_a_force_is_clamped_and_a_force_that_is_not_finite_is_zero(void **state)
{
    (void)state;
    const struct poi_force wild = {
        .force_n = { 1e30f, -1e30f, __builtin_nanf("") },
        .torque_n_m = { __builtin_inff(), -__builtin_inff(), 5.0f },
        .drag = 9.0f,
        .slap = -1.0f,
        .tear = __builtin_nanf(""),
    };
    struct poi_force back;
    uint8_t bytes[POI_FORCE_SIZE];
    poi_force_encode(&wild, 0, bytes);
    assert_true(poi_force_decode(bytes, sizeof bytes, &back, NULL));
    assert_float_equal(back.force_n.x, POI_FORCE_N_MAX, 1e-4f);
    assert_float_equal(back.force_n.y, -POI_FORCE_N_MAX, 1e-4f);
    assert_float_equal(back.force_n.z, 0.0f, 0.0f);
    assert_float_equal(v3_length(back.torque_n_m), POI_TORQUE_N_M_MAX, 1e-4f);
    assert_float_equal(back.drag, 1.0f, 0.0f);
    assert_float_equal(back.slap + back.tear, 0.0f, 0.0f);
    assert_false(poi_force_decode(bytes, POI_FORCE_SIZE - 1, &back, NULL));
    bytes[0] = 1;
    assert_false(poi_force_decode(bytes, POI_FORCE_SIZE, &back, NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_input_report_contains_the_position_and_the_angles),
        cmocka_unit_test(test_a_report_is_unchanged_by_reading_and_writing),
        cmocka_unit_test(test_a_report_with_a_wrong_length_id_or_position_mark_is_rejected),
        cmocka_unit_test(test_a_pose_is_clamped_and_a_value_that_is_not_finite_is_null),
        cmocka_unit_test(test_an_output_report_contains_six_forces_and_three_levels),
        cmocka_unit_test(test_forces_are_symmetric_and_exact_to_half_a_step),
        cmocka_unit_test(test_a_force_is_clamped_and_a_force_that_is_not_finite_is_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
