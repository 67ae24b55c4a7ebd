/* test_hid_pose_pointing.c -- tests how the reports of 3D mice, mice and pens are converted to
 * poses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/hid/poi_hid.h"
#include "tests/unit/support/hid_decoder_fixture.h"

/* ---- 3D mice -------------------------------------------------------------------------------- */

static void send_3d_mouse(hid_usage usage, int64_t value)
{
    connect("002-3dconnexion-spacemouse-wireless", 0x256f, 0xc62e);
    assert_true(send(1));
    wire_put(&wire, 1, usage, value);
    send(1);
}

static void test_a_3d_mouse_moves_and_rotates_on_all_axes(void **state)
{
    (void)state;
    send_3d_mouse(USAGE_X, 350);
    assert_true(sample_after(300).target.position_m.x > 0.04f);
    send_3d_mouse(USAGE_Y, 350);
    /* The ring has moved toward the player. */
    assert_true(sample_after(300).target.position_m.z > 0.04f);
    send_3d_mouse(USAGE_Z, 350);
    assert_true(sample_after(300).target.position_m.y < 0.0f); /* The ring has moved down, below the
                                                                  water surface. */
    send_3d_mouse(USAGE_RX, 350);
    assert_true(sample_after(300).target.angles.pitch_rad > 0.9f);
    /* This rotation is about the axis that points toward the player, and raises the right side of
     * the ring. */
    send_3d_mouse(USAGE_RY, 350);
    assert_true(sample_after(300).target.angles.roll_rad < -0.9f);
    send_3d_mouse(USAGE_RZ, 350); /* The rotation is clockwise, seen from above. */
    assert_true(sample_after(300).target.angles.yaw_rad < -0.9f);
}

/* Report descriptor of a SpaceNavigator, a 3D mouse. Report 1 has translations and report 2
 * rotations, both from -350 to 350. Report 3 has buttons. */
static const uint8_t space_navigator[] = {
    0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0xa1, 0x00, 0x85, 0x01, 0x16, 0xa2, 0xfe, 0x26, 0x5e, 0x01,
    0x75, 0x10, 0x95, 0x03, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x81, 0x06, 0xc0, 0xa1, 0x00, 0x85,
    0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x81, 0x06, 0xc0, 0xa1, 0x02, 0x85, 0x03, 0x05, 0x09,
    0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xc0, 0xc0,
};

/* The old 3D mouse declares its axes as relative, although they report deflections. */
static void test_an_old_3d_mouse_sends_translation_and_rotation_separately(void **state)
{
    struct hid_mapping map;
    (void)state;
    wire_begin(&wire, &clock_now, space_navigator, sizeof space_navigator);
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(map.style, HID_STYLE_FLY);
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), 0);
    send(1);
    send(2);
    wire_put(&wire, 1, USAGE_X, -350);
    send(1);
    wire_put(&wire, 2, USAGE_RX, 350);
    send(2); /* The next report 2 (rotation) must not stop the translation that report 1 has
                started. */
    const struct poi_target target = sample_after(400).target;
    assert_true(target.position_m.x < -0.1f);
    assert_true(target.angles.pitch_rad > 0.9f);
    wire_put(&wire, 3, USAGE_BUTTON + 1u, 1);
    send(3);
    assert_int_equal(pressed(), INPUT_START | INPUT_OK);
}

/* ---- Pointers ------------------------------------------------------------------------------- */

static void test_a_mouse_moves_by_its_counts(void **state)
{
    (void)state;
    connect("187-hr-0003-045e-0040-0004", 0x045e, 0x0040);
    assert_true(send(0));
    const vec3 before = sample_after(500).target.position_m;
    wire_put(&wire, 0, USAGE_X, 100);
    wire_put(&wire, 0, USAGE_Y, -50);
    send(0);
    const vec3 after = sample_after(0).target.position_m;
    assert_true(after.x > before.x + 0.01f && after.z < before.z - 0.01f);
    wire_put(&wire, 0, USAGE_X, 0);
    wire_put(&wire, 0, USAGE_Y, 0);
    send(0);
    assert_float_equal(sample_after(500).target.position_m.x, after.x, 1e-5f);
    wire_put(&wire, 0, USAGE_BUTTON + 1u, 1);
    send(0);
    assert_float_equal(sample_after(500).target.position_m.y, DIP_DEPTH_M, 1e-4f);
    wire_put(&wire, 0, USAGE_WHEEL, 2);
    send(0);
    wire_put(&wire, 0, USAGE_WHEEL, 0);
    send(0);
    assert_float_equal(sample_after(500).target.angles.pitch_rad, 2.0f * POINTER_TILT_STEP_RAD,
                       1e-3f);
}

static void send_pen(float x, float y, int in_range, int tip)
{
    wire_put(&wire, 7, USAGE_X, wire_share(&wire, 7, USAGE_X, x));
    wire_put(&wire, 7, USAGE_Y, wire_share(&wire, 7, USAGE_Y, y));
    wire_put(&wire, 7, USAGE_IN_RANGE, in_range);
    wire_put(&wire, 7, USAGE_TIP, tip);
    assert_true(send(7));
}

static void test_a_pen_gives_its_position_and_out_of_range_none(void **state)
{
    struct poi_sample sample;
    (void)state;
    connect("137-dg-huion-h610-if0", 0x256c, 0x006e);
    send_pen(0.0f, 0.0f, 0, 0);
    /* The pen has not been in range yet, so there is no pose. */
    assert_false(hid_pose_decoder_sample(&decoder, now_ms * MS, &sample));
    send_pen(0.25f, 0.5f, 1, 0);
    const vec3 left = sample_after(0).target.position_m;
    send_pen(0.75f, 0.5f, 1, 0);
    const vec3 right = sample_after(0).target.position_m;
    assert_true(left.x < -0.1f && right.x > 0.1f);
    /* Out of range, a pen reports zeros, which are not a position. */
    send_pen(0.0f, 0.0f, 0, 0);
    assert_float_equal(sample_after(100).target.position_m.x, right.x, 1e-4f);
    now_ms += HID_PEN_AWAY_NS / MS;
    /* The pen has been out of range for HID_PEN_AWAY_NS, so there is no pose. */
    assert_false(hid_pose_decoder_sample(&decoder, now_ms * MS, &sample));
    send_pen(0.5f, 0.5f, 1, 1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_DEPTH_M, 1e-3f);
    /* The pen left the range while its tip was pressed. The tip then counts as released. */
    send_pen(0.5f, 0.5f, 0, 1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-3f);
}

static void test_the_tilt_of_a_pen_tilts_the_ring(void **state)
{
    (void)state;
    connect("194-hr-0003-256c-006e-0008", 0x256c, 0x006e);
    wire_put(&wire, 8, USAGE_IN_RANGE, 1);
    assert_true(send(8));
    wire_put(&wire, 8, USAGE_X_TILT, 30);
    wire_put(&wire, 8, USAGE_Y_TILT, 30);
    send(8);
    const struct angles leant = sample_after(300).target.angles;
    assert_true(leant.roll_rad > 0.3f && leant.roll_rad < 0.7f);
    assert_true(leant.pitch_rad > 0.3f && leant.pitch_rad < 0.7f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_3d_mouse_moves_and_rotates_on_all_axes),
        cmocka_unit_test(test_an_old_3d_mouse_sends_translation_and_rotation_separately),
        cmocka_unit_test(test_a_mouse_moves_by_its_counts),
        cmocka_unit_test(test_a_pen_gives_its_position_and_out_of_range_none),
        cmocka_unit_test(test_the_tilt_of_a_pen_tilts_the_ring),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
