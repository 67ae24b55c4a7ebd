/* test_hid_learn.c -- tests how a mapping is learned from motions that a user demonstrates with
 * real controllers. After the learning, the poi must move in the demonstrated directions. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "drivers/hid/hid_learn.h"
#include "drivers/hid/poi_hid.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

/* A device and the fields of its report that the simulated user moves. */
struct demo_device {
    const char *name;
    hid_usage x, z, dip;
    int report_id;  /* Id of the report that contains the fields x, z and dip. */
    uint8_t manner; /* Kind of binding (enum hid_binding) that the learning must find for the
                       axes. */
    uint8_t reports_in_range;
    /* 1 if the device is held rotated by 180 degrees, so that its left is the user's right. */
    int8_t turned;
};

static struct clock_sim clock_now;
static struct hid_wire wire;
static struct hid_learn learn;
static uint64_t now_ms;

static uint32_t any(uint32_t what)
{
    return rng_u32((struct rng_key){ 11, (uint32_t)now_ms, what, RNG_TEST });
}

static struct hid_raw raw_now(uint8_t id)
{
    const uint32_t with_id = wire.descriptor.has_report_ids;
    struct hid_raw raw = { .time_ns = now_ms * MS };
    raw.size = (wire.descriptor.report_bits[id] + 7u) / 8u + with_id;
    raw.bytes[0] = id;
    memcpy(raw.bytes + with_id, wire.payload[id], raw.size - with_id);
    return raw;
}

static void send(uint8_t id)
{
    const struct hid_raw raw = raw_now(id);
    hid_learn_report(&learn, &raw);
    now_ms += 8;
}

/* Writes the position of an axis, as a fraction of its range. Adds a random error of at most one
 * step, except for a device that reports displacements. */
static void put_axis(const struct demo_device *demo_device, hid_usage usage, float share)
{
    const struct hid_field_location spot =
        hid_mapping_auto_find(&wire.descriptor, 0, demo_device->report_id, 1, usage);
    assert_non_null(spot.group);
    const float low = (float)spot.group->logical_min, high = (float)spot.group->logical_max;
    const float at = low + (demo_device->turned ? 1.0f - share : share) * (high - low);
    const float trembling =
        demo_device->manner == HID_BINDING_STEP ? 0.0f : (float)(any(usage) % 3u) - 1.0f;
    wire_put(&wire, demo_device->report_id, usage, (int64_t)f_clamp(at + trembling, low, high));
}

/* Sends one report. A mouse reports displacements, so its motion is reduced to small steps. All
 * other devices report positions. */
static void send_motion(const struct demo_device *demo_device, float x, float z, int dips)
{
    const int steps = demo_device->manner == HID_BINDING_STEP;
    put_axis(demo_device, demo_device->x, steps ? 0.5f + 0.12f * (x - 0.5f) : x);
    put_axis(demo_device, demo_device->z, steps ? 0.5f + 0.12f * (z - 0.5f) : z);
    wire_put(&wire, demo_device->report_id, demo_device->dip, dips);
    if (demo_device->reports_in_range) {
        wire_put(&wire, demo_device->report_id, USAGE_IN_RANGE, 1);
    }
    send((uint8_t)demo_device->report_id);
}

/* Simulates a user who moves the device to (x, z) at a realistic speed. A device that does not
 * report positions then returns to its middle. Finally the user requests the next step of the
 * learning. */
static void show(const struct demo_device *demo_device, float x, float z, int dips)
{
    for (uint32_t i = 1; i <= 40; i++) {
        const float share = (float)(i < 20 ? i : 20u) / 20.0f;
        send_motion(demo_device, 0.5f + share * (x - 0.5f), 0.5f + share * (z - 0.5f), dips);
    }
    assert_true(hid_learn_progress(&learn) > 200);
    for (uint32_t i = 0; demo_device->manner != HID_BINDING_POSITION && i < 10; i++) {
        send_motion(demo_device, 0.5f, 0.5f, 0);
    }
    hid_learn_next(&learn);
}

static void teach(const struct demo_device *demo_device)
{
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    assert_int_equal(learn.step, LEARN_REST);
    for (uint32_t i = 0; i < 150; i++) {
        send_motion(demo_device, 0.5f, 0.5f, 0);
    }
    assert_int_equal(hid_learn_progress(&learn), 255);
    hid_learn_next(&learn);
    assert_int_equal(learn.step, LEARN_LEFT);
    show(demo_device, 0.05f, 0.5f, 0);
    assert_int_equal(learn.step, LEARN_RIGHT);
    show(demo_device, 0.95f, 0.5f, 0);
    assert_int_equal(learn.step, LEARN_FAR);
    show(demo_device, 0.5f, 0.05f, 0);
    assert_int_equal(learn.step, LEARN_NEAR);
    show(demo_device, 0.5f, 0.95f, 0);
    assert_int_equal(learn.step, LEARN_DIP);
    show(demo_device, 0.5f, 0.5f, 1);
}

/* ---- Learned mappings ----------------------------------------------------------------------- */

static vec3 motion_of(struct hid_pose_decoder *hand, const struct demo_device *demo_device, float x,
                      float z, int dips)
{
    struct poi_sample sample;
    for (uint32_t i = 0; i < 60; i++) {
        send_motion(demo_device, x, z, dips);
        const struct hid_raw raw = raw_now((uint8_t)demo_device->report_id);
        assert_true(hid_pose_decoder_report(hand, &raw));
    }
    assert_true(hid_pose_decoder_sample(hand, now_ms * MS, &sample));
    return sample.target.position_m;
}

static void hold_pose(const struct demo_device *demo_device)
{
    struct hid_pose_decoder hand;
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &learn.map, festival_view()), 0);
    const vec3 middle = motion_of(&hand, demo_device, 0.5f, 0.5f, 0);
    assert_true(motion_of(&hand, demo_device, 0.1f, 0.5f, 0).x < middle.x - 0.05f);
    assert_true(motion_of(&hand, demo_device, 0.95f, 0.5f, 0).x > middle.x - 0.05f);
    const vec3 there = motion_of(&hand, demo_device, 0.5f, 0.5f, 0);
    assert_true(motion_of(&hand, demo_device, 0.5f, 0.1f, 0).z < there.z - 0.03f);
    assert_true(motion_of(&hand, demo_device, 0.5f, 0.95f, 0).z > there.z - 0.05f);
    assert_float_equal(motion_of(&hand, demo_device, 0.5f, 0.5f, 0).y, DIP_HOVER_M, 1e-3f);
    assert_float_equal(motion_of(&hand, demo_device, 0.5f, 0.5f, 1).y, DIP_DEPTH_M, 1e-3f);
}

/* Demonstrates the motions of a device. Checks the learned mapping, and the poses that the mapping
 * gives. */
static void learns_this(const struct demo_device *demo_device)
{
    teach(demo_device);
    if (learn.step != LEARN_TRY) {
        fail_msg("%s was not learned", demo_device->name);
    }
    assert_int_equal(learn.map.source, HID_MAPPING_LEARNED);
    assert_int_equal(learn.map.binding[0].manner, demo_device->manner);
    assert_true(hid_mapping_is_sound(&learn.map, &wire.descriptor));
    hold_pose(demo_device);
}

static void learns(const struct demo_device *demo_device)
{
    wire_load(&wire, &clock_now, demo_device->name);
    learns_this(demo_device);
}

static const struct demo_device devices[] = {
    { "006-blaze-joypad", USAGE_X, USAGE_Y, USAGE_BUTTON + 3u, 1, HID_BINDING_RATE, 0, 0 },
    { "010-8bitdo-sn30pro-bt-dinput", USAGE_Z, USAGE_RZ, USAGE_BUTTON + 7u, 3, HID_BINDING_RATE, 0,
      0 },
    { "016-ci-dualsense", USAGE_X, USAGE_Y, USAGE_BUTTON + 2u, 1, HID_BINDING_RATE, 0, 0 },
    { "033-ci-xboxone-model-1708-bluetooth", USAGE_X, USAGE_Y, USAGE_BUTTON + 1u, 1,
      HID_BINDING_RATE, 0, 0 },
    { "203-hr-libinput-issue201-0003-06a3-0c2d-0", USAGE_X, USAGE_Y, USAGE_BUTTON + 1u, 0,
      HID_BINDING_RATE, 0, 0 },
    { "137-dg-huion-h610-if0", USAGE_X, USAGE_Y, USAGE_TIP, 7, HID_BINDING_POSITION, 0, 0 },
    { "194-hr-0003-256c-006e-0008", USAGE_X, USAGE_Y, USAGE_TIP, 8, HID_BINDING_POSITION, 1, 0 },
    { "187-hr-0003-045e-0040-0004", USAGE_X, USAGE_Y, USAGE_BUTTON + 1u, 0, HID_BINDING_STEP, 0,
      0 },
    { "011-dell-413c-301a-mouse", USAGE_X, USAGE_Y, USAGE_BUTTON + 2u, 0, HID_BINDING_STEP, 0, 0 },
};

static void test_mappings_of_real_devices_are_learned(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        learns(&devices[i]);
    }
}

static void test_a_rotated_device_is_learned_in_its_orientation(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        struct demo_device turned = devices[i];
        turned.turned = 1;
        learns(&turned);
    }
}

static void test_axes_of_32_bits_are_learned_over_their_full_range(void **state)
{
    static const struct demo_device wide = { "a joystick of 0 .. 2^32 - 1",
                                             USAGE_X,
                                             USAGE_Y,
                                             USAGE_BUTTON + 1u,
                                             0,
                                             HID_BINDING_RATE,
                                             0,
                                             0 };
    static const uint8_t bytes[] = {
        0x05, 1,    0x09, 4,    0xa1, 1,    0x09, 0x30, 0x09, 0x31, 0x15, 0,    0x27,
        0xff, 0xff, 0xff, 0xff, 0x75, 32,   0x95, 2,    0x81, 2,    0x05, 9,    0x19,
        1,    0x29, 8,    0x25, 1,    0x75, 1,    0x95, 8,    0x81, 2,    0xc0,
    };
    (void)state;
    wire_begin(&wire, &clock_now, bytes, sizeof bytes);
    learns_this(&wide);
    assert_true(learn.map.binding[0].full > INT32_MAX);
    /* The automatic mapping of the same device must work too. */
    assert_int_equal(learn.offered.source, HID_MAPPING_AUTO);
    learn.map = learn.offered;
    hold_pose(&wide);
}

/* A gamepad's report contains a counter, a clock and a gyroscope, which change even at rest. None
 * of them may be learned as an axis. */
static void test_fields_that_change_at_rest_are_no_axes(void **state)
{
    static const struct demo_device *demo_device = &devices[2];
    (void)state;
    wire_load(&wire, &clock_now, demo_device->name);
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t step = LEARN_REST; step <= LEARN_DIP; step++) {
        for (uint32_t i = 0; i < 150; i++) {
            const float there = i > 100 ? 1.0f : 0.5f;
            /* The sequence number of the report changes even at rest. */
            wire_put_bits(&wire, 1, 48, 8, (int64_t)i);
            wire_put_bits(&wire, 1, 216, 32, (int64_t)now_ms * 333); /* The clock of the gamepad
                                                                        changes even at rest. */
            wire_put_bits(&wire, 1, 120, 16, (int64_t)any(3));       /* The gyroscope. */
            send_motion(demo_device,
                        step == LEARN_LEFT    ? 1.0f - there
                        : step == LEARN_RIGHT ? there
                                              : 0.5f,
                        step == LEARN_FAR    ? 1.0f - there
                        : step == LEARN_NEAR ? there
                                             : 0.5f,
                        step == LEARN_DIP && i > 100);
        }
        hid_learn_next(&learn);
    }
    assert_int_equal(learn.step, LEARN_TRY);
    assert_int_equal(learn.map.binding[0].bit_offset, 0);
    assert_int_equal(learn.map.binding[1].bit_offset, 8);
    assert_int_equal(learn.map.binding[2].bit_offset, 61);
}

static void test_buttons_that_were_not_demonstrated_keep_their_bindings(void **state)
{
    (void)state;
    learns(&devices[2]);
    uint32_t starts = 0, hats = 0;
    for (uint32_t i = 0; i < learn.map.count; i++) {
        starts += learn.map.binding[i].role == HID_ROLE_START;
        hats += learn.map.binding[i].role == HID_ROLE_HAT;
    }
    assert_int_equal(starts, 1);
    assert_int_equal(hats, 1);
}

/* ---- Failed learning ------------------------------------------------------------------------ */

static void test_without_a_motion_nothing_is_learned(void **state)
{
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t step = LEARN_REST; step <= LEARN_DIP; step++) {
        assert_int_equal(learn.step, step);
        for (uint32_t i = 0; i < 50; i++) {
            send_motion(&devices[2], 0.5f, 0.5f, 0);
        }
        assert_true(step == LEARN_REST || hid_learn_progress(&learn) < 40);
        hid_learn_next(&learn);
    }
    assert_int_equal(learn.step, LEARN_FAILED);
    /* The learning has failed, so this request for the next step has no effect. */
    hid_learn_next(&learn);
    assert_int_equal(learn.step, LEARN_FAILED);
}

static void test_the_same_direction_twice_is_no_axis(void **state)
{
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t i = 0; i < 150; i++) {
        send_motion(&devices[2], 0.5f, 0.5f, 0);
    }
    hid_learn_next(&learn);
    show(&devices[2], 0.05f, 0.5f, 0);
    /* The user moves the device to the left again, although the right was requested. */
    show(&devices[2], 0.05f, 0.5f, 0);
    show(&devices[2], 0.5f, 0.05f, 0);
    show(&devices[2], 0.5f, 0.95f, 0);
    show(&devices[2], 0.5f, 0.5f, 1);
    assert_int_equal(learn.step, LEARN_FAILED);
}

static void test_a_keyboard_is_never_learned(void **state)
{
    (void)state;
    wire_load(&wire, &clock_now, "041-hd-kye-0458-0138-1");
    hid_learn_begin(&learn, &wire.face);
    assert_int_equal(learn.step, LEARN_FAILED);
    /* This device combines a keyboard with a mouse, and no keyboard can be learned. */
    wire_load(&wire, &clock_now, "207-hr-libinput-issue366-0003-046d-4082-0");
    hid_learn_begin(&learn, &wire.face);
    assert_int_equal(learn.step, LEARN_FAILED);
}

static void test_invalid_reports_are_ignored(void **state)
{
    struct hid_raw raw = { .size = 0 };
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    hid_learn_begin(&learn, &wire.face);
    hid_learn_report(&learn, &raw);
    raw.size = 12;
    raw.bytes[0] = 1;
    /* Report 1 has 64 bytes by its descriptor, so 12 bytes are too few. */
    hid_learn_report(&learn, &raw);
    raw.size = HID_REPORT_MAX + 9u;
    hid_learn_report(&learn, &raw);
    raw.size = 64;
    raw.bytes[0] = 9;
    /* The descriptor has no report with this id. */
    hid_learn_report(&learn, &raw);
    assert_int_equal(learn.report_count, 0);
    assert_int_equal(hid_learn_progress(&learn), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mappings_of_real_devices_are_learned),
        cmocka_unit_test(test_a_rotated_device_is_learned_in_its_orientation),
        cmocka_unit_test(test_axes_of_32_bits_are_learned_over_their_full_range),
        cmocka_unit_test(test_fields_that_change_at_rest_are_no_axes),
        cmocka_unit_test(test_buttons_that_were_not_demonstrated_keep_their_bindings),
        cmocka_unit_test(test_without_a_motion_nothing_is_learned),
        cmocka_unit_test(test_the_same_direction_twice_is_no_axis),
        cmocka_unit_test(test_a_keyboard_is_never_learned),
        cmocka_unit_test(test_invalid_reports_are_ignored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
