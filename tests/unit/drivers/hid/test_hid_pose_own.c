/* test_hid_pose_own.c -- tests how the reports of a Kingyo poi are converted to poses and
 * buttons. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/hid/poi_report.h"
#include "tests/unit/support/hid_decoder_fixture.h"

static void connect_own_poi(void)
{
    struct hid_mapping map;
    wire_begin(&wire, &clock_now, poi_descriptor, POI_DESCRIPTOR_SIZE);
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), 0);
    now_ms = 1000;
}

static int send_own(struct poi_report report, uint64_t ms)
{
    uint8_t bytes[POI_REPORT_SIZE];
    now_ms += ms;
    poi_report_encode(&report, bytes);
    const struct hid_raw raw = raw_of(bytes, sizeof bytes);
    return hid_pose_decoder_report(&decoder, &raw);
}

static struct poi_report own_at(float x_m, uint8_t sequence, uint8_t buttons)
{
    return (struct poi_report){ .target.position_m = { x_m, 0.1f, 0.0f },
                                .buttons = buttons,
                                .sequence = sequence };
}

static void test_a_kingyo_poi_has_the_pose_and_time_of_its_report(void **state)
{
    (void)state;
    connect_own_poi();
    const struct poi_report report = {
        .target = { .position_m = { -0.25f, -0.04f, 0.125f },
                    .angles = { .yaw_rad = 0.5f, .pitch_rad = -0.25f, .roll_rad = 1.0f } },
        .sequence = 9,
    };
    assert_true(send_own(report, 0));
    const uint64_t report_ns = now_ms * MS;
    /* The sample is returned later than the report arrived, but the time stamp of the sample is the
     * arrival time of the report. */
    const struct poi_sample sample = sample_after(70);
    assert_int_equal(sample.time_ns, report_ns);
    assert_true(sample.has_wrist);
    assert_float_equal(sample.target.position_m.x, -0.25f, 4e-5f);
    assert_float_equal(sample.target.position_m.y, -0.04f, 4e-5f);
    assert_float_equal(sample.target.position_m.z, 0.125f, 4e-5f);
    assert_float_equal(sample.target.angles.yaw_rad, 0.5f, 1e-4f);
    assert_float_equal(sample.target.angles.pitch_rad, -0.25f, 1e-4f);
    assert_float_equal(sample.target.angles.roll_rad, 1.0f, 1e-4f);
}

static void test_missing_reports_are_counted_and_duplicates_are_dropped(void **state)
{
    (void)state;
    connect_own_poi();
    assert_true(send_own(own_at(0.0f, 254, 0), 4));
    assert_true(send_own(own_at(0.1f, 255, 0), 4));
    /* The sequence number wraps around to this value, so no report is missing. */
    assert_true(send_own(own_at(0.2f, 0, 0), 4));
    assert_int_equal(decoder.gap_count, 0);
    assert_false(send_own(own_at(0.3f, 0, 0), 4));
    assert_int_equal(decoder.refused_count, 1);
    assert_float_equal(sample_after(0).target.position_m.x, 0.2f, 4e-5f);
    assert_true(send_own(own_at(0.3f, 4, 0), 4));
    assert_int_equal(decoder.gap_count, 3);
}

static void test_the_keys_of_a_kingyo_poi_are_cabinet_buttons(void **state)
{
    (void)state;
    connect_own_poi();
    send_own(own_at(0.0f, 1, 0), 4);
    send_own(own_at(0.0f, 2, POI_BUTTON_START), 4);
    assert_int_equal(pressed(), INPUT_START);
    send_own(own_at(0.0f, 3, POI_BUTTON_LEFT | POI_BUTTON_OK), 4);
    assert_int_equal(pressed(), INPUT_LEFT | INPUT_OK);
    send_own(own_at(0.0f, 4, POI_BUTTON_RIGHT | POI_BUTTON_OK), 4);
    assert_int_equal(pressed(), INPUT_RIGHT);
}

static void test_the_poi_waits_while_the_fan_key_is_held(void **state)
{
    uint8_t sequence = 0;
    (void)state;
    connect_own_poi();
    send_own(own_at(0.0f, sequence++, 0), 4);
    /* The player moves the controller by half a metre while the fan key is held. The poi must stay
     * in place, and the fan must move. */
    for (uint32_t i = 0; i < 200; i++) {
        send_own(own_at(0.0025f * (float)i, sequence++, POI_BUTTON_FAN), 4);
    }
    assert_float_equal(sample_after(0).target.position_m.x, 0.0f, 1e-3f);
    assert_float_equal(hid_pose_decoder_fan(&decoder, now_ms * MS).x_m, 0.5f, 5e-3f);
    float before_m = 0.0f;
    /* After the key is released, the poi must return to the controller's position without a
     * jump. */
    for (uint32_t i = 0; i < 150; i++) {
        send_own(own_at(0.5f, sequence++, 0), 4);
        const float at_m = sample_after(0).target.position_m.x;
        assert_true(at_m >= before_m && at_m - before_m < 0.02f);
        before_m = at_m;
    }
    assert_float_equal(before_m, 0.5f, 1e-3f);
    assert_false(hid_pose_decoder_fan(&decoder, now_ms * MS).present);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_kingyo_poi_has_the_pose_and_time_of_its_report),
        cmocka_unit_test(test_missing_reports_are_counted_and_duplicates_are_dropped),
        cmocka_unit_test(test_the_keys_of_a_kingyo_poi_are_cabinet_buttons),
        cmocka_unit_test(test_the_poi_waits_while_the_fan_key_is_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
