/* test_hid_pose_decoder.c -- what raw reports make of a hand: each manner, and each way to be
 * refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "drivers/hid/hid_pose_decoder.h"
#include "drivers/hid/poi_report.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

static struct clock_sim clock_now;
static struct hid_wire wire;
static struct hid_pose_decoder hand;
static uint64_t now_ms;

static void capture_fish(const char *name, uint16_t vendor, uint16_t product)
{
    struct hid_mapping map;
    wire_load(&wire, &clock_now, name);
    wire.face.identity.vendor = vendor;
    wire.face.identity.product = product;
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), 0);
    now_ms = 1000;
}

static struct hid_raw raw_of(const uint8_t *bytes, uint32_t size)
{
    struct hid_raw raw = { .time_ns = now_ms * MS, .size = size };
    memcpy(raw.bytes, bytes, size < HID_REPORT_MAX ? size : HID_REPORT_MAX);
    return raw;
}

static int send(uint8_t id)
{
    const uint32_t with_id = wire.descriptor.has_report_ids;
    const uint32_t size = (wire.descriptor.report_bits[id] + 7u) / 8u + with_id;
    uint8_t bytes[HID_REPORT_MAX + 1u] = { id };
    memcpy(bytes + with_id, wire.payload[id], size - with_id);
    const struct hid_raw raw = raw_of(bytes, size);
    now_ms += 4;
    return hid_pose_decoder_report(&hand, &raw);
}

static struct poi_sample sample_after(uint64_t ms)
{
    struct poi_sample sample;
    now_ms += ms;
    assert_true(hid_pose_decoder_sample(&hand, now_ms * MS, &sample));
    return sample;
}

static uint32_t pressed(void)
{
    struct button_sample buttons = { 0 };
    hid_pose_decoder_buttons(&hand, &buttons);
    return buttons.pressed;
}

/* ---- Sticks --------------------------------------------------------------------------------- */

static void rest_dualsense(void)
{
    capture_fish("016-ci-dualsense", 0x054c, 0x0ce6);
    wire_put(&wire, 1, USAGE_X, 128);
    wire_put(&wire, 1, USAGE_Y, 128);
    wire_put(&wire, 1, USAGE_Z, 128);
    wire_put(&wire, 1, USAGE_RZ, 128);
    wire_put(&wire, 1, USAGE_HAT, 8);
    assert_true(send(1));
}

static void test_a_stick_pushes_the_hand_and_let_go_it_stays(void **state)
{
    (void)state;
    rest_dualsense();
    const vec3 before = sample_after(100).target.position_m;
    wire_put(&wire, 1, USAGE_X, 255);
    wire_put(&wire, 1, USAGE_Y, 0);
    send(1);
    const vec3 pushed = sample_after(400).target.position_m;
    assert_true(pushed.x > before.x + 0.05f); /* Right, and away. */
    assert_true(pushed.z < before.z - 0.05f);
    wire_put(&wire, 1, USAGE_X, 128);
    wire_put(&wire, 1, USAGE_Y, 128);
    send(1);
    const vec3 stopped = sample_after(800).target.position_m;
    const vec3 later = sample_after(800).target.position_m;
    assert_float_equal(stopped.x, later.x, 1e-4f);
    assert_float_equal(stopped.z, later.z, 1e-4f);
}

static void test_a_worn_stick_near_its_middle_does_not_creep(void **state)
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

/* A port that was plugged in with its stick pushed, or an axis that is no stick at all. */
static void test_a_stick_that_was_never_let_go_moves_nothing(void **state)
{
    (void)state;
    rest_dualsense();
    struct hid_mapping map = hand.map;
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), 0);
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

static void test_a_trigger_dips_and_has_some_play(void **state)
{
    (void)state;
    rest_dualsense();
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-4f);
    wire_put(&wire, 1, USAGE_RY, 126); /* Less than half. */
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-4f);
    wire_put(&wire, 1, USAGE_RY, 130);
    send(1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_DEPTH_M, 1e-4f);
    wire_put(&wire, 1, USAGE_RY, 110); /* A finger that trembles at the point. */
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
    wire_put(&wire, 1, USAGE_RZ, 255); /* Pulled: the far edge rises. */
    send(1);
    assert_true(sample_after(400).target.angles.pitch_rad > 0.9f);
    wire_put(&wire, 1, USAGE_RZ, 128);
    wire_put(&wire, 1, USAGE_Z, 255);
    send(1);
    const struct angles right = sample_after(400).target.angles;
    assert_true(right.roll_rad > 0.9f); /* The right side goes down. */
    assert_float_equal(right.pitch_rad, 0.0f, 5e-3f);
}

static void test_a_hat_and_the_middle_buttons_are_the_cabinets(void **state)
{
    (void)state;
    static const uint32_t of_direction[] = { INPUT_OK, INPUT_RIGHT, INPUT_RIGHT, INPUT_RIGHT,
                                             INPUT_OK, INPUT_LEFT,  INPUT_LEFT,  INPUT_LEFT };
    rest_dualsense();
    assert_int_equal(pressed(), 0);
    for (uint32_t i = 0; i < 8; i++) {
        wire_put(&wire, 1, USAGE_HAT, i);
        send(1);
        assert_int_equal(pressed(), of_direction[i]);
        send(1);
        assert_int_equal(pressed(), 0); /* Held is not pressed again. */
        wire_put(&wire, 1, USAGE_HAT, 8);
        send(1);
    }
    wire_put(&wire, 1, USAGE_BUTTON + 10u, 1);
    send(1);
    assert_int_equal(pressed(), INPUT_START);
}

static void test_sticks_lead_the_fan_while_its_button_is_down(void **state)
{
    (void)state;
    rest_dualsense();
    assert_false(hid_pose_decoder_fan(&hand, now_ms * MS).present);
    wire_put(&wire, 1, USAGE_BUTTON + 4u, 1); /* Triangle. */
    send(1);
    now_ms += 500;
    const vec3 poi = sample_after(0).target.position_m;
    const struct shade_input fan = hid_pose_decoder_fan(&hand, now_ms * MS);
    assert_true(fan.present);
    wire_put(&wire, 1, USAGE_X, 0);
    send(1);
    assert_float_equal(sample_after(500).target.position_m.x, poi.x, 1e-4f);
    assert_true(hid_pose_decoder_fan(&hand, now_ms * MS).x_m < fan.x_m - 0.05f);
}

/* An arcade stick has four switches, which its maker calls a hat. */
static void test_a_stick_of_switches_pushes_all_the_way(void **state)
{
    (void)state;
    capture_fish("023-ci-xusb-arcadestick", 0x045e, 0x028e);
    wire_put(&wire, 0, USAGE_HAT, 0); /* None: its directions are 1 .. 8. */
    assert_true(send(0));
    const vec3 before = sample_after(300).target.position_m;
    assert_float_equal(before.x, 0.0f, 1e-6f);
    wire_put(&wire, 0, USAGE_HAT, 2); /* Up and right. */
    send(0);
    const vec3 after = sample_after(300).target.position_m;
    assert_true(after.x > 0.08f && after.z < before.z - 0.08f);
    assert_int_equal(pressed(), 0);
    wire_put(&wire, 0, USAGE_HAT, 0);
    wire_put(&wire, 0, USAGE_BUTTON + 1u, 1);
    send(0);
    assert_float_equal(sample_after(700).target.position_m.y, DIP_DEPTH_M, 1e-4f);
}

/* ---- Pucks ---------------------------------------------------------------------------------- */

static void puck(hid_usage usage, int64_t value)
{
    capture_fish("002-3dconnexion-spacemouse-wireless", 0x256f, 0xc62e);
    assert_true(send(1));
    wire_put(&wire, 1, usage, value);
    send(1);
}

static void test_a_puck_goes_all_ways(void **state)
{
    (void)state;
    puck(USAGE_X, 350);
    assert_true(sample_after(300).target.position_m.x > 0.04f);
    puck(USAGE_Y, 350);
    assert_true(sample_after(300).target.position_m.z > 0.04f); /* Toward the player. */
    puck(USAGE_Z, 350);
    assert_true(sample_after(300).target.position_m.y < 0.0f); /* Down. */
    puck(USAGE_RX, 350);
    assert_true(sample_after(300).target.angles.pitch_rad > 0.9f);
    puck(USAGE_RY, 350); /* The right side up: about the axis toward the player. */
    assert_true(sample_after(300).target.angles.roll_rad < -0.9f);
    puck(USAGE_RZ, 350); /* Clockwise from above. */
    assert_true(sample_after(300).target.angles.yaw_rad < -0.9f);
}

/* A SpaceNavigator's way: places in report 1, turns in report 2, and both called relative. */
static void test_an_old_puck_says_its_ways_and_its_turns_apart(void **state)
{
    static const uint8_t descriptor[] = {
        0x05, 0x01, 0x09, 0x08, 0xa1, 0x01,                         /* Multi-axis Controller */
        0xa1, 0x00, 0x85, 0x01, 0x16, 0xa2, 0xfe, 0x26, 0x5e, 0x01, /* id 1, -350 .. 350 */
        0x75, 0x10, 0x95, 0x03, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x81, 0x06,
        0xc0, 0xa1, 0x00, 0x85, 0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x81,
        0x06, 0xc0, 0xa1, 0x02, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02,
        0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xc0, 0xc0, /* id 3: buttons */
    };
    struct hid_mapping map;
    (void)state;
    wire_begin(&wire, &clock_now, descriptor, sizeof descriptor);
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(map.style, HID_STYLE_FLY);
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), 0);
    send(1);
    send(2);
    wire_put(&wire, 1, USAGE_X, -350);
    send(1);
    wire_put(&wire, 2, USAGE_RX, 350);
    send(2); /* And the way goes on. */
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
    capture_fish("187-hr-0003-045e-0040-0004", 0x045e, 0x0040);
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

static void pen(float x, float y, int in_range, int tip)
{
    wire_put(&wire, 7, USAGE_X, wire_share(&wire, 7, USAGE_X, x));
    wire_put(&wire, 7, USAGE_Y, wire_share(&wire, 7, USAGE_Y, y));
    wire_put(&wire, 7, USAGE_IN_RANGE, in_range);
    wire_put(&wire, 7, USAGE_TIP, tip);
    assert_true(send(7));
}

static void test_a_pen_is_where_it_is_and_away_it_says_nothing(void **state)
{
    struct poi_sample sample;
    (void)state;
    capture_fish("137-dg-huion-h610-if0", 0x256c, 0x006e);
    pen(0.0f, 0.0f, 0, 0);
    assert_false(hid_pose_decoder_sample(&hand, now_ms * MS, &sample)); /* It was never in range. */
    pen(0.25f, 0.5f, 1, 0);
    const vec3 left = sample_after(0).target.position_m;
    pen(0.75f, 0.5f, 1, 0);
    const vec3 right = sample_after(0).target.position_m;
    assert_true(left.x < -0.1f && right.x > 0.1f);
    pen(0.0f, 0.0f, 0, 0); /* Lifted: those zeros are no place. */
    assert_float_equal(sample_after(100).target.position_m.x, right.x, 1e-4f);
    now_ms += HID_PEN_AWAY_NS / MS;
    assert_false(hid_pose_decoder_sample(&hand, now_ms * MS, &sample)); /* Put aside. */
    pen(0.5f, 0.5f, 1, 1);
    assert_float_equal(sample_after(600).target.position_m.y, DIP_DEPTH_M, 1e-3f);
    pen(0.5f, 0.5f, 0, 1); /* Pulled away with its tip down, it is up. */
    assert_float_equal(sample_after(600).target.position_m.y, DIP_HOVER_M, 1e-3f);
}

static void test_a_pen_that_leans_tilts_the_ring(void **state)
{
    (void)state;
    capture_fish("194-hr-0003-256c-006e-0008", 0x256c, 0x006e);
    wire_put(&wire, 8, USAGE_IN_RANGE, 1);
    assert_true(send(8));
    wire_put(&wire, 8, USAGE_X_TILT, 30);
    wire_put(&wire, 8, USAGE_Y_TILT, 30);
    send(8);
    const struct angles leant = sample_after(300).target.angles;
    assert_true(leant.roll_rad > 0.3f && leant.roll_rad < 0.7f);
    assert_true(leant.pitch_rad > 0.3f && leant.pitch_rad < 0.7f);
}

/* ---- Our own poi ---------------------------------------------------------------------------- */

static void take_up_own(void)
{
    struct hid_mapping map;
    wire_begin(&wire, &clock_now, poi_descriptor, POI_DESCRIPTOR_SIZE);
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), 0);
    now_ms = 1000;
}

static int say_own(struct poi_report report, uint64_t ms)
{
    uint8_t bytes[POI_REPORT_SIZE];
    now_ms += ms;
    poi_report_encode(&report, bytes);
    const struct hid_raw raw = raw_of(bytes, sizeof bytes);
    return hid_pose_decoder_report(&hand, &raw);
}

static struct poi_report own_at(float x_m, uint8_t sequence, uint8_t buttons)
{
    return (struct poi_report){ .target.position_m = { x_m, 0.1f, 0.0f },
                                .buttons = buttons,
                                .sequence = sequence };
}

static void test_our_own_poi_is_where_its_report_says_at_its_time(void **state)
{
    (void)state;
    take_up_own();
    const struct poi_report said = {
        .target = { .position_m = { -0.25f, -0.04f, 0.125f },
                    .angles = { .yaw_rad = 0.5f, .pitch_rad = -0.25f, .roll_rad = 1.0f } },
        .sequence = 9,
    };
    assert_true(say_own(said, 0));
    const uint64_t report_ns = now_ms * MS;
    const struct poi_sample sample = sample_after(70); /* Asked later, it is of its report. */
    assert_int_equal(sample.time_ns, report_ns);
    assert_true(sample.has_wrist);
    assert_float_equal(sample.target.position_m.x, -0.25f, 4e-5f);
    assert_float_equal(sample.target.position_m.y, -0.04f, 4e-5f);
    assert_float_equal(sample.target.position_m.z, 0.125f, 4e-5f);
    assert_float_equal(sample.target.angles.yaw_rad, 0.5f, 1e-4f);
    assert_float_equal(sample.target.angles.pitch_rad, -0.25f, 1e-4f);
    assert_float_equal(sample.target.angles.roll_rad, 1.0f, 1e-4f);
}

static void test_reports_that_are_missing_are_counted_and_one_that_comes_twice_is_one(void **state)
{
    (void)state;
    take_up_own();
    assert_true(say_own(own_at(0.0f, 254, 0), 4));
    assert_true(say_own(own_at(0.1f, 255, 0), 4));
    assert_true(say_own(own_at(0.2f, 0, 0), 4)); /* Round, and none is missing. */
    assert_int_equal(hand.gap_count, 0);
    assert_false(say_own(own_at(0.3f, 0, 0), 4));
    assert_int_equal(hand.refused_count, 1);
    assert_float_equal(sample_after(0).target.position_m.x, 0.2f, 4e-5f);
    assert_true(say_own(own_at(0.3f, 4, 0), 4));
    assert_int_equal(hand.gap_count, 3);
}

static void test_its_keys_are_the_cabinets(void **state)
{
    (void)state;
    take_up_own();
    say_own(own_at(0.0f, 1, 0), 4);
    say_own(own_at(0.0f, 2, POI_BUTTON_START), 4);
    assert_int_equal(pressed(), INPUT_START);
    say_own(own_at(0.0f, 3, POI_BUTTON_LEFT | POI_BUTTON_OK), 4);
    assert_int_equal(pressed(), INPUT_LEFT | INPUT_OK);
    say_own(own_at(0.0f, 4, POI_BUTTON_RIGHT | POI_BUTTON_OK), 4);
    assert_int_equal(pressed(), INPUT_RIGHT);
}

static void test_while_its_fan_key_is_down_the_poi_waits(void **state)
{
    uint8_t sequence = 0;
    (void)state;
    take_up_own();
    say_own(own_at(0.0f, sequence++, 0), 4);
    for (uint32_t i = 0; i < 200; i++) { /* The hand goes half a metre, the poi does not. */
        say_own(own_at(0.0025f * (float)i, sequence++, POI_BUTTON_FAN), 4);
    }
    assert_float_equal(sample_after(0).target.position_m.x, 0.0f, 1e-3f);
    assert_float_equal(hid_pose_decoder_fan(&hand, now_ms * MS).x_m, 0.5f, 5e-3f);
    float before_m = 0.0f;
    for (uint32_t i = 0; i < 150; i++) { /* Let go, it comes back without a leap. */
        say_own(own_at(0.5f, sequence++, 0), 4);
        const float at_m = sample_after(0).target.position_m.x;
        assert_true(at_m >= before_m && at_m - before_m < 0.02f);
        before_m = at_m;
    }
    assert_float_equal(before_m, 0.5f, 1e-3f);
    assert_false(hid_pose_decoder_fan(&hand, now_ms * MS).present);
}

/* ---- What is no report ---------------------------------------------------------------------- */

static void test_whatever_else_comes_is_refused_and_changes_nothing(void **state)
{
    uint8_t bytes[HID_REPORT_MAX] = { 1 };
    struct hid_raw raw;
    (void)state;
    rest_dualsense();
    const vec3 before = sample_after(400).target.position_m;
    const uint32_t refused = hand.refused_count;
    memset(bytes + 1, 0xff, sizeof bytes - 1);
    raw = raw_of(bytes, 0);
    assert_false(hid_pose_decoder_report(&hand, &raw)); /* Empty. */
    raw = raw_of(bytes, 63);
    assert_false(hid_pose_decoder_report(&hand, &raw)); /* A byte short of 64. */
    bytes[0] = 77;
    raw = raw_of(bytes, 64);
    assert_false(hid_pose_decoder_report(&hand, &raw)); /* Of an id that nobody declared. */
    raw.size = HID_REPORT_MAX + 1u;
    assert_false(hid_pose_decoder_report(&hand, &raw)); /* Longer than any buffer. */
    assert_int_equal(hand.refused_count, refused + 4u);
    const vec3 after = sample_after(400).target.position_m;
    assert_float_equal(before.x, after.x, 1e-6f);
    assert_float_equal(before.y, after.y, 1e-6f);
}

static void test_bytes_behind_a_whole_report_are_passed_over(void **state)
{
    uint8_t bytes[80] = { 1 };
    (void)state;
    rest_dualsense();
    memcpy(bytes + 1, wire.payload[1], 63);
    const struct hid_raw raw = raw_of(bytes, sizeof bytes);
    assert_true(hid_pose_decoder_report(&hand, &raw));
}

static void test_a_map_that_is_not_sound_makes_no_hand(void **state)
{
    (void)state;
    rest_dualsense();
    struct hid_mapping map = hand.map;
    map.binding[0].bit_size = 0;
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), -1);
    map = (struct hid_mapping){ 0 };
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &map, stall_view()), -1);
}

static uint8_t any_byte(uint32_t report, uint32_t index)
{
    return (uint8_t)rng_u32((struct rng_key){ 5, report, index, RNG_TEST });
}

static void test_any_bytes_leave_a_finite_hand(void **state)
{
    static const char *const names[] = { "016-ci-dualsense", "137-dg-huion-h610-if0",
                                         "187-hr-0003-045e-0040-0004",
                                         "002-3dconnexion-spacemouse-wireless" };
    (void)state;
    for (uint32_t device = 0; device < sizeof names / sizeof names[0]; device++) {
        capture_fish(names[device], 0x054c, 0x0ce6);
        const uint8_t first = hand.map.binding[0].report_id;
        for (uint32_t i = 0; i < 5000; i++) {
            uint8_t bytes[HID_REPORT_MAX] = { first };
            struct poi_sample sample;
            for (uint32_t j = first ? 1u : 0u; j < 64; j++) {
                bytes[j] = any_byte(i, j);
            }
            now_ms += any_byte(i, 99) % 40u;
            const struct hid_raw raw = raw_of(bytes, 1u + any_byte(i, 98) % 80u);
            hid_pose_decoder_report(&hand, &raw);
            if (hid_pose_decoder_sample(&hand, now_ms * MS, &sample)) {
                assert_true(v3_is_finite(sample.target.position_m));
                assert_true(v3_length(sample.target.position_m) < 5.0f); /* A view's end. */
                assert_true(f_is_finite(sample.target.angles.pitch_rad));
                assert_true(f_abs(sample.target.angles.roll_rad) < 4.0f);
            }
            const struct shade_input fan = hid_pose_decoder_fan(&hand, now_ms * MS);
            assert_true(f_is_finite(fan.x_m) && f_is_finite(fan.z_m));
        }
        assert_true(hand.refused_count > 0 && hand.refused_count < hand.report_count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_stick_pushes_the_hand_and_let_go_it_stays),
        cmocka_unit_test(test_a_worn_stick_near_its_middle_does_not_creep),
        cmocka_unit_test(test_a_stick_that_was_never_let_go_moves_nothing),
        cmocka_unit_test(test_a_trigger_dips_and_has_some_play),
        cmocka_unit_test(test_the_right_stick_turns_the_ring),
        cmocka_unit_test(test_a_hat_and_the_middle_buttons_are_the_cabinets),
        cmocka_unit_test(test_sticks_lead_the_fan_while_its_button_is_down),
        cmocka_unit_test(test_a_stick_of_switches_pushes_all_the_way),
        cmocka_unit_test(test_a_puck_goes_all_ways),
        cmocka_unit_test(test_an_old_puck_says_its_ways_and_its_turns_apart),
        cmocka_unit_test(test_a_mouse_moves_by_its_counts),
        cmocka_unit_test(test_a_pen_is_where_it_is_and_away_it_says_nothing),
        cmocka_unit_test(test_a_pen_that_leans_tilts_the_ring),
        cmocka_unit_test(test_our_own_poi_is_where_its_report_says_at_its_time),
        cmocka_unit_test(test_reports_that_are_missing_are_counted_and_one_that_comes_twice_is_one),
        cmocka_unit_test(test_its_keys_are_the_cabinets),
        cmocka_unit_test(test_while_its_fan_key_is_down_the_poi_waits),
        cmocka_unit_test(test_whatever_else_comes_is_refused_and_changes_nothing),
        cmocka_unit_test(test_bytes_behind_a_whole_report_are_passed_over),
        cmocka_unit_test(test_a_map_that_is_not_sound_makes_no_hand),
        cmocka_unit_test(test_any_bytes_leave_a_finite_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
