/* test_hid_pose_decoder.c -- tests how HID reports of sticks, triggers and buttons are converted to
 * poses, and that invalid reports are rejected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "drivers/hid/poi_report.h"
#include "drivers/hid/poi_hid.h"
#include "tests/unit/support/hid_decoder_fixture.h"

/* ---- Sticks --------------------------------------------------------------------------------- */

static void rest_dualsense(void)
{
    connect("016-ci-dualsense", 0x054c, 0x0ce6);
    wire_put(&wire, 1, USAGE_X, 128);
    wire_put(&wire, 1, USAGE_Y, 128);
    wire_put(&wire, 1, USAGE_Z, 128);
    wire_put(&wire, 1, USAGE_RZ, 128);
    wire_put(&wire, 1, USAGE_HAT, 8);
    assert_true(send(1));
}

static void test_a_deflected_stick_moves_the_poi_and_a_released_one_stops_it(void **state)
{
    (void)state;
    rest_dualsense();
    const vec3 before = sample_after(100).target.position_m;
    wire_put(&wire, 1, USAGE_X, 255);
    wire_put(&wire, 1, USAGE_Y, 0);
    send(1);
    const vec3 pushed = sample_after(400).target.position_m;
    /* The stick is deflected to the right and away from the player. */
    assert_true(pushed.x > before.x + 0.05f);
    assert_true(pushed.z < before.z - 0.05f);
    wire_put(&wire, 1, USAGE_X, 128);
    wire_put(&wire, 1, USAGE_Y, 128);
    send(1);
    const vec3 stopped = sample_after(800).target.position_m;
    const vec3 later = sample_after(800).target.position_m;
    assert_float_equal(stopped.x, later.x, 1e-4f);
    assert_float_equal(stopped.z, later.z, 1e-4f);
}

static void test_a_worn_stick_near_its_center_moves_nothing(void **state)
{
    (void)state;
    rest_dualsense();
    wire_put(&wire, 1, USAGE_X, 128 + 11);
    send(1);
    const vec3 before = sample_after(0).target.position_m;
    const vec3 after = sample_after(900).target.position_m;
    assert_float_equal(before.x, after.x, 1e-6f);
    wire_put(&wire, 1, USAGE_X, 128 + 40);
    send(1);
    assert_true(sample_after(900).target.position_m.x > before.x + 0.01f);
}

/* The device was plugged in while the stick was deflected, or the axis is not that of a stick. The
 * ring must not move until the stick was released. */
static void test_a_stick_that_was_never_released_moves_nothing(void **state)
{
    (void)state;
    rest_dualsense();
    struct hid_mapping map = decoder.map;
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), 0);
    wire_put(&wire, 1, USAGE_X, 255);
    send(1);
    const vec3 before = sample_after(0).target.position_m;
    assert_float_equal(sample_after(900).target.position_m.x, before.x, 1e-6f);
    wire_put(&wire, 1, USAGE_X, 128);
    send(1);
    wire_put(&wire, 1, USAGE_X, 255);
    send(1);
    assert_true(sample_after(900).target.position_m.x > before.x + 0.05f);
}

static void test_a_trigger_dips_with_hysteresis(void **state)
{
    (void)state;
    rest_dualsense();
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-4f);
    /* The trigger is just below its threshold (half of its travel), so the ring must not dip. */
    wire_put(&wire, 1, USAGE_RY, 126);
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-4f);
    wire_put(&wire, 1, USAGE_RY, 130);
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_DEPTH_M, 1e-4f);
    /* The trigger is a little below the threshold again, which does not end the dip yet. */
    wire_put(&wire, 1, USAGE_RY, 110);
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_DEPTH_M, 1e-4f);
    wire_put(&wire, 1, USAGE_RY, 90);
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-4f);
}

static void test_the_right_stick_turns_the_ring(void **state)
{
    (void)state;
    rest_dualsense();
    /* The stick is pulled toward the player, so the far edge of the ring rises. */
    wire_put(&wire, 1, USAGE_RZ, 255);
    send(1);
    assert_true(sample_after(400).target.angles.pitch_rad > 0.9f);
    wire_put(&wire, 1, USAGE_RZ, 128);
    wire_put(&wire, 1, USAGE_Z, 255);
    send(1);
    const struct angles right = sample_after(400).target.angles;
    assert_true(right.roll_rad > 0.9f); /* The right side of the ring is lowered. */
    assert_float_equal(right.pitch_rad, 0.0f, 5e-3f);
}

static void test_the_hat_and_the_middle_buttons_are_cabinet_buttons(void **state)
{
    (void)state;
    static const uint32_t of_direction[] = {
        INPUT_OK | INPUT_UP,   INPUT_RIGHT, INPUT_RIGHT, INPUT_RIGHT,
        INPUT_OK | INPUT_DOWN, INPUT_LEFT,  INPUT_LEFT,  INPUT_LEFT
    };
    rest_dualsense();
    assert_int_equal(pressed(), 0);
    for (uint32_t i = 0; i < 8; i++) {
        wire_put(&wire, 1, USAGE_HAT, i);
        send(1);
        assert_int_equal(pressed(), of_direction[i]);
        send(1);
        /* The hat is still held, so there is no second press. */
        assert_int_equal(pressed(), 0);
        wire_put(&wire, 1, USAGE_HAT, 8);
        send(1);
    }
    wire_put(&wire, 1, USAGE_BUTTON + 10u, 1);
    send(1);
    assert_int_equal(pressed(), INPUT_START);
}

static void test_sticks_move_the_fan_while_its_button_is_held(void **state)
{
    (void)state;
    rest_dualsense();
    assert_false(hid_pose_decoder_fan(&decoder, now_ms * MS).present);
    wire_put(&wire, 1, USAGE_BUTTON + 4u, 1); /* Button 4 of the gamepad is TRIANGLE. */
    send(1);
    now_ms += 500;
    const vec3 poi = sample_after(0).target.position_m;
    const struct shade_input fan = hid_pose_decoder_fan(&decoder, now_ms * MS);
    assert_true(fan.present);
    wire_put(&wire, 1, USAGE_X, 0);
    send(1);
    assert_float_equal(sample_after(500).target.position_m.x, poi.x, 1e-4f);
    assert_true(hid_pose_decoder_fan(&decoder, now_ms * MS).x_m < fan.x_m - 0.05f);
}

/* The four switches of an arcade stick are declared as a hat switch. */
static void test_an_arcade_stick_gives_full_deflection(void **state)
{
    (void)state;
    connect("023-ci-xusb-arcadestick", 0x045e, 0x028e);
    /* The directions of this hat are 1 to 8, so 0 means that it is released. */
    wire_put(&wire, 0, USAGE_HAT, 0);
    assert_true(send(0));
    const vec3 before = sample_after(300).target.position_m;
    assert_float_equal(before.x, 0.0f, 1e-6f);
    wire_put(&wire, 0, USAGE_HAT, 2); /* Direction 2 of this hat is up and right. */
    send(0);
    const vec3 after = sample_after(300).target.position_m;
    assert_true(after.x > 0.08f && after.z < before.z - 0.08f);
    assert_int_equal(pressed(), 0);
    wire_put(&wire, 0, USAGE_HAT, 0);
    wire_put(&wire, 0, USAGE_BUTTON + 1u, 1);
    send(0);
    assert_float_equal(sample_after(700).target.position_m.y, DIP_DEPTH_M, 1e-4f);
}

/* ---- Invalid reports ------------------------------------------------------------------------ */

static void test_an_invalid_report_is_rejected_and_changes_nothing(void **state)
{
    uint8_t bytes[HID_REPORT_MAX] = { 1 };
    struct hid_raw raw;
    (void)state;
    rest_dualsense();
    const vec3 before = sample_after(400).target.position_m;
    const uint32_t refused = decoder.refused_count;
    memset(bytes + 1, 0xff, sizeof bytes - 1);
    raw = raw_of(bytes, 0);
    /* The report is empty. */
    assert_false(hid_pose_decoder_report(&decoder, &raw));
    raw = raw_of(bytes, 63);
    /* The report lacks one of its 64 bytes. */
    assert_false(hid_pose_decoder_report(&decoder, &raw));
    bytes[0] = 77;
    raw = raw_of(bytes, 64);
    /* The descriptor has no report with this id. */
    assert_false(hid_pose_decoder_report(&decoder, &raw));
    raw.size = HID_REPORT_MAX + 1u;
    assert_false(hid_pose_decoder_report(&decoder, &raw)); /* The report is too long. */
    assert_int_equal(decoder.refused_count, refused + 4u);
    const vec3 after = sample_after(400).target.position_m;
    assert_float_equal(before.x, after.x, 1e-6f);
    assert_float_equal(before.y, after.y, 1e-6f);
}

static void test_bytes_after_a_complete_report_are_ignored(void **state)
{
    uint8_t bytes[80] = { 1 };
    (void)state;
    rest_dualsense();
    memcpy(bytes + 1, wire.payload[1], 63);
    const struct hid_raw raw = raw_of(bytes, sizeof bytes);
    assert_true(hid_pose_decoder_report(&decoder, &raw));
}

static void test_an_invalid_mapping_is_rejected(void **state)
{
    (void)state;
    rest_dualsense();
    struct hid_mapping map = decoder.map;
    map.binding[0].bit_size = 0;
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), -1);
    map = (struct hid_mapping){ 0 };
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), -1);
}

static uint8_t any_byte(uint32_t report, uint32_t index)
{
    return (uint8_t)rng_u32((struct rng_key){ 5, report, index, RNG_TEST });
}

static void test_random_bytes_give_finite_poses(void **state)
{
    static const char *const names[] = { "016-ci-dualsense", "137-dg-huion-h610-if0",
                                         "187-hr-0003-045e-0040-0004",
                                         "002-3dconnexion-spacemouse-wireless" };
    (void)state;
    for (uint32_t device = 0; device < sizeof names / sizeof names[0]; device++) {
        connect(names[device], 0x054c, 0x0ce6);
        const uint8_t first = decoder.map.binding[0].report_id;
        for (uint32_t i = 0; i < 5000; i++) {
            uint8_t bytes[HID_REPORT_MAX] = { first };
            struct poi_sample sample;
            for (uint32_t j = first ? 1u : 0u; j < 64; j++) {
                bytes[j] = any_byte(i, j);
            }
            now_ms += any_byte(i, 99) % 40u;
            const struct hid_raw raw = raw_of(bytes, 1u + any_byte(i, 98) % 80u);
            hid_pose_decoder_report(&decoder, &raw);
            if (hid_pose_decoder_sample(&decoder, now_ms * MS, &sample)) {
                assert_true(v3_is_finite(sample.target.position_m));
                /* Random reports must not move the ring far away. The tank is less than 1 m
                 * wide. */
                assert_true(v3_length(sample.target.position_m) < 5.0f);
                assert_true(f_is_finite(sample.target.angles.pitch_rad));
                assert_true(f_abs(sample.target.angles.roll_rad) < 4.0f);
            }
            const struct shade_input fan = hid_pose_decoder_fan(&decoder, now_ms * MS);
            assert_true(f_is_finite(fan.x_m) && f_is_finite(fan.z_m));
        }
        assert_true(decoder.refused_count > 0 && decoder.refused_count < 5000);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_deflected_stick_moves_the_poi_and_a_released_one_stops_it),
        cmocka_unit_test(test_a_worn_stick_near_its_center_moves_nothing),
        cmocka_unit_test(test_a_stick_that_was_never_released_moves_nothing),
        cmocka_unit_test(test_a_trigger_dips_with_hysteresis),
        cmocka_unit_test(test_the_right_stick_turns_the_ring),
        cmocka_unit_test(test_the_hat_and_the_middle_buttons_are_cabinet_buttons),
        cmocka_unit_test(test_sticks_move_the_fan_while_its_button_is_held),
        cmocka_unit_test(test_an_arcade_stick_gives_full_deflection),
        cmocka_unit_test(test_an_invalid_report_is_rejected_and_changes_nothing),
        cmocka_unit_test(test_bytes_after_a_complete_report_are_ignored),
        cmocka_unit_test(test_an_invalid_mapping_is_rejected),
        cmocka_unit_test(test_random_bytes_give_finite_poses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
