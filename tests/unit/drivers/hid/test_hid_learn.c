/* test_hid_learn.c -- controllers of real descriptors are learned by being shown, by somebody whose
 * hands are not quite still; what was learned leads the hand the ways that were shown. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "drivers/hid/hid_learn.h"
#include "drivers/hid/hid_pose_decoder.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

/* How a device is led by who shows it: by these fields. */
struct leads {
    const char *name;
    hid_usage x, z, dip;
    int report_id;  /* Of all three. */
    uint8_t manner; /* What the axes ought to be learned as. */
    uint8_t says_in_range;
    int8_t turned; /* 1: it lies the other way round, so that "left" is to its right. */
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

/* A share of an axis' range, and a step or two beside it. */
static void put_axis(const struct leads *leads, hid_usage usage, float share)
{
    const struct hid_field_location spot =
        hid_mapping_auto_find(&wire.descriptor, 0, leads->report_id, 1, usage);
    assert_non_null(spot.group);
    const float low = (float)spot.group->logical_min, high = (float)spot.group->logical_max;
    const float at = low + (leads->turned ? 1.0f - share : share) * (high - low);
    const float trembling =
        leads->manner == HID_BINDING_STEP ? 0.0f : (float)(any(usage) % 3u) - 1.0f;
    wire_put(&wire, leads->report_id, usage, (int64_t)f_clamp(at + trembling, low, high));
}

/* Mice give ways, of which two thirds of a range are one; everything else gives places. */
static void lead(const struct leads *leads, float x, float z, int dips)
{
    const int steps = leads->manner == HID_BINDING_STEP;
    put_axis(leads, leads->x, steps ? 0.5f + 0.12f * (x - 0.5f) : x);
    put_axis(leads, leads->z, steps ? 0.5f + 0.12f * (z - 0.5f) : z);
    wire_put(&wire, leads->report_id, leads->dip, dips);
    if (leads->says_in_range) {
        wire_put(&wire, leads->report_id, USAGE_IN_RANGE, 1);
    }
    send((uint8_t)leads->report_id);
}

/* There and, with a stick, back: as long as a hand takes. */
static void show(const struct leads *leads, float x, float z, int dips)
{
    for (uint32_t i = 1; i <= 40; i++) {
        const float share = (float)(i < 20 ? i : 20u) / 20.0f;
        lead(leads, 0.5f + share * (x - 0.5f), 0.5f + share * (z - 0.5f), dips);
    }
    assert_true(hid_learn_progress(&learn) > 200);
    for (uint32_t i = 0; leads->manner != HID_BINDING_POSITION && i < 10; i++) {
        lead(leads, 0.5f, 0.5f, 0);
    }
    hid_learn_next(&learn);
}

static void teach(const struct leads *leads)
{
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    assert_int_equal(learn.step, LEARN_REST);
    for (uint32_t i = 0; i < 150; i++) {
        lead(leads, 0.5f, 0.5f, 0);
    }
    assert_int_equal(hid_learn_progress(&learn), 255);
    hid_learn_next(&learn);
    assert_int_equal(learn.step, LEARN_LEFT);
    show(leads, 0.05f, 0.5f, 0);
    assert_int_equal(learn.step, LEARN_RIGHT);
    show(leads, 0.95f, 0.5f, 0);
    assert_int_equal(learn.step, LEARN_FAR);
    show(leads, 0.5f, 0.05f, 0);
    assert_int_equal(learn.step, LEARN_NEAR);
    show(leads, 0.5f, 0.95f, 0);
    assert_int_equal(learn.step, LEARN_DIP);
    show(leads, 0.5f, 0.5f, 1);
}

/* ---- What was learned leads ----------------------------------------------------------------- */

static vec3 led(struct hid_pose_decoder *hand, const struct leads *leads, float x, float z,
                int dips)
{
    struct poi_sample sample;
    for (uint32_t i = 0; i < 60; i++) {
        lead(leads, x, z, dips);
        const struct hid_raw raw = raw_now((uint8_t)leads->report_id);
        assert_true(hid_pose_decoder_report(hand, &raw));
    }
    assert_true(hid_pose_decoder_sample(hand, now_ms * MS, &sample));
    return sample.target.position_m;
}

static void hold_leading(const struct leads *leads)
{
    struct hid_pose_decoder hand;
    assert_int_equal(hid_pose_decoder_init(&hand, &wire.face, &learn.map, stall_view()), 0);
    const vec3 middle = led(&hand, leads, 0.5f, 0.5f, 0);
    assert_true(led(&hand, leads, 0.1f, 0.5f, 0).x < middle.x - 0.05f);
    assert_true(led(&hand, leads, 0.95f, 0.5f, 0).x > middle.x - 0.05f);
    const vec3 there = led(&hand, leads, 0.5f, 0.5f, 0);
    assert_true(led(&hand, leads, 0.5f, 0.1f, 0).z < there.z - 0.03f);
    assert_true(led(&hand, leads, 0.5f, 0.95f, 0).z > there.z - 0.05f);
    assert_float_equal(led(&hand, leads, 0.5f, 0.5f, 0).y, DIP_HOVER_M, 1e-3f);
    assert_float_equal(led(&hand, leads, 0.5f, 0.5f, 1).y, DIP_DEPTH_M, 1e-3f);
}

/* What is on the wire already. */
static void learns_this(const struct leads *leads)
{
    teach(leads);
    if (learn.step != LEARN_TRY) {
        fail_msg("%s was not learned", leads->name);
    }
    assert_int_equal(learn.map.source, HID_MAPPING_LEARNED);
    assert_int_equal(learn.map.binding[0].manner, leads->manner);
    assert_true(hid_mapping_is_sound(&learn.map, &wire.descriptor));
    hold_leading(leads);
}

static void learns(const struct leads *leads)
{
    wire_load(&wire, &clock_now, leads->name);
    learns_this(leads);
}

static const struct leads devices[] = {
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

static void test_real_devices_are_learned(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        learns(&devices[i]);
    }
}

static void test_one_that_lies_the_other_way_round_is_learned_as_it_lies(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        struct leads turned = devices[i];
        turned.turned = 1;
        learns(&turned);
    }
}

static void test_axes_of_32_bits_are_learned_to_their_ends(void **state)
{
    static const struct leads wide = { "a joystick of 0 .. 2^32 - 1",
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
    assert_int_equal(learn.offered.source, HID_MAPPING_AUTO); /* It is played as it is, too. */
    learn.map = learn.offered;
    hold_leading(&wide);
}

/* A pad's report counts, and its clock runs: none of that is an axis. */
static void test_what_counts_or_trembles_at_rest_is_no_axis(void **state)
{
    static const struct leads *leads = &devices[2];
    (void)state;
    wire_load(&wire, &clock_now, leads->name);
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t step = LEARN_REST; step <= LEARN_DIP; step++) {
        for (uint32_t i = 0; i < 150; i++) {
            const float there = i > 100 ? 1.0f : 0.5f;
            wire_put_bits(&wire, 1, 48, 8, (int64_t)i);              /* A sequence number. */
            wire_put_bits(&wire, 1, 216, 32, (int64_t)now_ms * 333); /* A clock. */
            wire_put_bits(&wire, 1, 120, 16, (int64_t)any(3));       /* A gyroscope. */
            lead(leads,
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

static void test_the_buttons_that_were_not_shown_stay_what_they_were(void **state)
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

/* ---- What cannot be learned ----------------------------------------------------------------- */

static void test_nothing_shown_is_nothing_learned(void **state)
{
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t step = LEARN_REST; step <= LEARN_DIP; step++) {
        assert_int_equal(learn.step, step);
        for (uint32_t i = 0; i < 50; i++) {
            lead(&devices[2], 0.5f, 0.5f, 0);
        }
        assert_true(step == LEARN_REST || hid_learn_progress(&learn) < 40);
        hid_learn_next(&learn);
    }
    assert_int_equal(learn.step, LEARN_FAILED);
    hid_learn_next(&learn); /* Further than that it does not go. */
    assert_int_equal(learn.step, LEARN_FAILED);
}

static void test_the_same_way_twice_is_no_axis(void **state)
{
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    now_ms = 1000;
    hid_learn_begin(&learn, &wire.face);
    for (uint32_t i = 0; i < 150; i++) {
        lead(&devices[2], 0.5f, 0.5f, 0);
    }
    hid_learn_next(&learn);
    show(&devices[2], 0.05f, 0.5f, 0);
    show(&devices[2], 0.05f, 0.5f, 0); /* Left again, when right was asked for. */
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
    wire_load(&wire, &clock_now, "207-hr-libinput-issue366-0003-046d-4082-0"); /* And a mouse. */
    hid_learn_begin(&learn, &wire.face);
    assert_int_equal(learn.step, LEARN_FAILED);
}

static void test_reports_that_are_none_teach_nothing(void **state)
{
    struct hid_raw raw = { .size = 0 };
    (void)state;
    wire_load(&wire, &clock_now, devices[2].name);
    hid_learn_begin(&learn, &wire.face);
    hid_learn_report(&learn, &raw);
    raw.size = 12;
    raw.bytes[0] = 1;
    hid_learn_report(&learn, &raw); /* Short. */
    raw.size = HID_REPORT_MAX + 9u;
    hid_learn_report(&learn, &raw);
    raw.size = 64;
    raw.bytes[0] = 9;
    hid_learn_report(&learn, &raw); /* Of no declared id. */
    assert_int_equal(learn.report_count, 0);
    assert_int_equal(hid_learn_progress(&learn), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_real_devices_are_learned),
        cmocka_unit_test(test_one_that_lies_the_other_way_round_is_learned_as_it_lies),
        cmocka_unit_test(test_axes_of_32_bits_are_learned_to_their_ends),
        cmocka_unit_test(test_what_counts_or_trembles_at_rest_is_no_axis),
        cmocka_unit_test(test_the_buttons_that_were_not_shown_stay_what_they_were),
        cmocka_unit_test(test_nothing_shown_is_nothing_learned),
        cmocka_unit_test(test_the_same_way_twice_is_no_axis),
        cmocka_unit_test(test_a_keyboard_is_never_learned),
        cmocka_unit_test(test_reports_that_are_none_teach_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
