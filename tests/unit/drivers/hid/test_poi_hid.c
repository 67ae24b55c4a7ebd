/* test_poi_hid.c -- tests a poi of one player slot with a faulty connection: unplugging after any
 * report, invalid reports, silence and duplicates. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/control/controller.h"
#include "drivers/hid/poi_report.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

#define REPORT_NS 4000000ull /* 250 reports per second is the slowest rate of a USB gadget. */
#define FRAME_REPORTS 4u

static struct fixture {
    struct clock_sim clock;
    struct hid_wire wire;
    struct poi_hid poi;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t report_count;
} fixture;

static void begin(void)
{
    memset(&fixture, 0, sizeof fixture);
    fixture.clock.now_ns = 1000000000ull;
    wire_begin(&fixture.wire, &fixture.clock, poi_descriptor, POI_DESCRIPTOR_SIZE);
    poi_hid_init(&fixture.poi, &fixture.wire.port.port, sim_clock_device(&fixture.clock),
                 (struct hid_mapper){ 0 }, festival_view());
}

/* Sends the next pose on a circle above the water. Each pose is 1 mm from the one before. */
static void send_next(void)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const float angle = 0.01f * (float)fixture.report_count;
    const struct poi_report report = {
        .target.position_m = { 0.1f * f_sin(angle), 0.06f, 0.1f * f_cos(angle) },
        .sequence = (uint8_t)fixture.report_count++,
    };
    poi_report_encode(&report, bytes);
    fixture.clock.now_ns += REPORT_NS;
    hid_port_sim_report(&fixture.wire.port, bytes, sizeof bytes);
}

static int poll(struct poi_sample samples[HAL_POI_SAMPLES_MAX])
{
    const struct hal_poi device = poi_hid_devices(&fixture.poi).poi;
    return device.ops->poll(device.self, samples, HAL_POI_SAMPLES_MAX);
}

static int reopen(void)
{
    const struct hal_poi device = poi_hid_devices(&fixture.poi).poi;
    return device.ops->open(device.self);
}

/* ---- Reports, names and forces -------------------------------------------------------------- */

static void test_absent_and_removed_devices_return_different_errors(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    hid_port_sim_plug(&fixture.wire.port, NULL);
    assert_int_equal(reopen(), HAL_ERR_GONE);
    assert_int_equal(poll(samples), HAL_ERR_GONE);
    hid_port_sim_plug(&fixture.wire.port, &fixture.wire.face);
    assert_int_equal(reopen(), HAL_OK);
    /* The device has not sent a report yet. */
    assert_int_equal(poll(samples), 0);
    fixture.wire.port.port.is_unusable = true;
    assert_int_equal(reopen(), HAL_ERR_ABSENT);
}

static void test_each_report_gives_a_sample_with_its_own_time(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    assert_int_equal(reopen(), HAL_OK);
    for (uint32_t i = 0; i < 10; i++) {
        send_next();
    }
    assert_int_equal(poll(samples), 10);
    for (uint32_t i = 0; i < 10; i++) {
        assert_int_equal(samples[i].time_ns, 1000000000ull + (i + 1u) * REPORT_NS);
    }
    fixture.clock.now_ns += 50000000ull;
    /* Without a new report there is no new sample. */
    assert_int_equal(poll(samples), 0);
}

static void test_force_is_sent_to_a_device_that_supports_it(void **state)
{
    struct poi_force felt;
    uint8_t sequence;
    (void)state;
    begin();
    const struct hal_poi device = poi_hid_devices(&fixture.poi).poi;
    const struct poi_force pull = { .force_n = { 0.0f, -1.5f, 0.0f }, .drag = 0.75f };
    /* The device is not open. */
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_ABSENT);
    reopen();
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_OK);
    assert_true(
        poi_force_decode(fixture.wire.port.sent, fixture.wire.port.sent_size, &felt, &sequence));
    assert_int_equal(sequence, 0);
    assert_float_equal(felt.force_n.y, -1.5f, 1e-3f);
    fixture.wire.port.busy = true;
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_OK);
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_BUSY);
    fixture.wire.port.busy = false;
    fixture.wire.port.port.wake(fixture.wire.port.port.wake_self);
    poi_force_decode(fixture.wire.port.sent, fixture.wire.port.sent_size, &felt, &sequence);
    assert_int_equal(sequence, 1);
    device.ops->set_force(device.self, &pull);
    poi_force_decode(fixture.wire.port.sent, fixture.wire.port.sent_size, &felt, &sequence);
    assert_int_equal(sequence, 2); /* The output report that failed has used no sequence number. */
}

static void test_a_gamepad_gets_no_force_and_a_keyboard_is_no_poi(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    const struct poi_force pull = { .drag = 1.0f };
    (void)state;
    begin();
    wire_load(&fixture.wire, &fixture.clock, "016-ci-dualsense");
    const struct hal_poi device = poi_hid_devices(&fixture.poi).poi;
    reopen();
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_ABSENT);
    begin();
    wire_load(&fixture.wire, &fixture.clock, "012-compact-keyboard-2222-0099-if1");
    assert_int_equal(reopen(), HAL_OK);
    assert_false(fixture.poi.plays);
    assert_non_null(strstr(device.ops->describe(device.self), "cannot be a poi"));
    wire_send(&fixture.wire, 0);
    assert_int_equal(poll(samples), 0);
}

static void record_report(void *self, const struct hid_raw *raw)
{
    uint32_t *count = self;
    *count += raw->size > 0;
}

static void test_reports_of_a_device_without_a_mapping_go_to_the_manager(void **state)
{
    struct poi_sample sample;
    uint32_t count = 0;
    (void)state;
    begin();
    wire_load(&fixture.wire, &fixture.clock, "012-compact-keyboard-2222-0099-if1");
    reopen();
    fixture.poi.watch = (struct hid_watch){ .report = record_report, .self = &count };
    wire_send(&fixture.wire, 0);
    wire_send(&fixture.wire, 0);
    const struct hal_poi device = poi_hid_devices(&fixture.poi).poi;
    assert_int_equal(device.ops->poll(device.self, &sample, 1), 0);
    assert_int_equal(count, 2);
}

/* ---- Connection faults ---------------------------------------------------------------------- */

static void test_reports_before_an_unplug_are_delivered_for_1000_positions(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint32_t at = 0; at < 1000; at++) {
        uint32_t seen = 0;
        int result = 0;
        begin();
        fixture.wire.port.unplug_at = at;
        assert_int_equal(reopen(), HAL_OK);
        while (fixture.report_count <= at + FRAME_REPORTS) {
            for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
                send_next();
            }
            result = poll(samples);
            seen += result > 0 ? (uint32_t)result : 0u;
        }
        assert_int_equal(seen, at);
        assert_int_equal(result > 0 ? poll(samples) : result, HAL_ERR_GONE);
        /* Further polls of a lost device must return the same error. */
        assert_int_equal(poll(samples), HAL_ERR_GONE);
        hid_port_sim_plug(&fixture.wire.port, &fixture.wire.face);
        assert_int_equal(reopen(), HAL_OK);
        send_next();
        assert_int_equal(poll(samples), 1);
    }
}

/* After each fault, all samples must be finite and in order, and valid reports must be accepted
 * again. */
static void test_valid_reports_are_accepted_again_after_each_fault(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint8_t kind = HID_SIM_SILENCE; kind < HID_SIM_KIND_COUNT; kind++) {
        const struct hid_sim_fault fault = { .kind = kind, .from = 20, .to = 60 };
        uint64_t before_ns = 0;
        begin();
        fixture.wire.port.faults = &fault;
        fixture.wire.port.fault_count = 1;
        reopen();
        for (uint32_t frame = 0; frame < 25; frame++) {
            for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
                send_next();
            }
            const int count = poll(samples);
            const int is_fine = frame < 5 || frame >= 15;
            assert_true(count >= 0);
            if (kind == HID_SIM_LONG && frame == 10) {
                assert_int_equal(fixture.wire.port.last.size, POI_REPORT_SIZE + 8u);
            }
            /* After random bytes, the decoder may reject valid reports for a while, because the
             * bytes can be taken for a report with a later sequence number. The number of samples
             * is therefore not checked after this fault. */
            if (is_fine && kind != HID_SIM_GARBAGE) {
                assert_true(count >= (int)FRAME_REPORTS - 1);
            }
            for (int i = 0; i < count; i++) {
                assert_true(v3_is_finite(samples[i].target.position_m));
                assert_true(samples[i].time_ns >= before_ns);
                before_ns = samples[i].time_ns;
            }
        }
    }
}

static void test_duplicate_reports_are_dropped_and_lost_ones_are_counted(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    static const struct hid_sim_fault faults[] = { { HID_SIM_TWICE, 4, 8 },
                                                   { HID_SIM_SILENCE, 10, 13 } };
    (void)state;
    begin();
    fixture.wire.port.faults = faults;
    fixture.wire.port.fault_count = 2;
    reopen();
    for (uint32_t i = 0; i < 20; i++) {
        send_next();
    }
    assert_int_equal(poll(samples), 17);
    assert_int_equal(fixture.poi.decoder.refused_count, 4);
    assert_int_equal(fixture.poi.decoder.gap_count, 3);
}

static void test_a_long_frame_gets_the_newest_report_and_counts_lost_ones(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    reopen();
    for (uint32_t i = 0; i < 2u * HID_REPORTS_MAX + 1u; i++) {
        send_next();
    }
    assert_int_equal(poll(samples), HAL_POI_SAMPLES_MAX);
    assert_int_equal(samples[HAL_POI_SAMPLES_MAX - 1u].time_ns, fixture.clock.now_ns);
    /* The queue was full, so all further reports except the newest one were lost. */
    assert_int_equal(atomic_load(&fixture.wire.port.port.lost), HID_REPORTS_MAX);
    assert_int_equal(poll(samples), 0); /* No report is left. */
}

/* A gamepad sends a report only when a value changes. In one frame of 0.1 s, the stick is moved a
 * little at its end and is then released. No other report follows. If the report of the release
 * were lost, the poi would move on. */
static void test_the_last_report_before_a_pause_is_never_lost(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint32_t burst = 80; burst < 3u * HID_REPORTS_MAX; burst *= 6u) {
        memset(&fixture, 0, sizeof fixture);
        fixture.clock.now_ns = 1000000000ull;
        wire_load(&fixture.wire, &fixture.clock, "010-8bitdo-sn30pro-bt-dinput");
        poi_hid_init(&fixture.poi, &fixture.wire.port.port, sim_clock_device(&fixture.clock),
                     (struct hid_mapper){ 0 }, festival_view());
        reopen();
        const uint8_t id = wire_put(&fixture.wire, -1, USAGE_X, 0x80);
        wire_put(&fixture.wire, id, USAGE_Y, 0x80);
        wire_send(&fixture.wire, id);
        poll(samples);
        for (uint32_t i = 0; i < burst; i++) {
            fixture.clock.now_ns += 100000000ull / burst;
            wire_put(&fixture.wire, id, USAGE_X, 250 + i % 3u);
            wire_put(&fixture.wire, id, USAGE_BUTTON + 1u, 1);
            wire_send(&fixture.wire, id);
        }
        wire_put(&fixture.wire, id, USAGE_X, 0x80);
        wire_put(&fixture.wire, id, USAGE_BUTTON + 1u, 0);
        wire_send(&fixture.wire, id);
        int count = poll(samples);
        assert_true(count > 0);
        const float let_go_m = samples[count - 1].target.position_m.x;
        for (uint32_t i = 0; i < 120; i++) {
            fixture.clock.now_ns += 16666667ull;
            count = poll(samples);
        }
        const vec3 rest_m = samples[count - 1].target.position_m;
        assert_true(rest_m.y > 0.0f);
        /* The poi comes to rest near the point of the release. Without this report, the poi would
         * move on to the end of its range. */
        assert_true(f_abs(rest_m.x - let_go_m) < 0.03f);
    }
}

/* A mouse moves during a frame of half a second, at 1,000 reports per second. The whole
 * displacement must count. */
static void test_no_mouse_displacement_is_lost_in_a_slow_frame(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    float way_m[2];
    (void)state;
    for (uint32_t slow = 0; slow < 2; slow++) {
        memset(&fixture, 0, sizeof fixture);
        fixture.clock.now_ns = 1000000000ull;
        wire_load(&fixture.wire, &fixture.clock, "011-dell-413c-301a-mouse");
        poi_hid_init(&fixture.poi, &fixture.wire.port.port, sim_clock_device(&fixture.clock),
                     (struct hid_mapper){ 0 }, festival_view());
        reopen();
        const uint8_t id = wire_put(&fixture.wire, -1, USAGE_X, 0);
        wire_send(&fixture.wire, id);
        int count = poll(samples);
        const float from_m = samples[count - 1].target.position_m.x;
        for (uint32_t i = 0; i < 500; i++) {
            fixture.clock.now_ns += 1000000ull;
            wire_put(&fixture.wire, id, USAGE_X, i % 5u == 0u);
            wire_send(&fixture.wire, id);
            if (!slow && i % 16u == 0u) {
                poll(samples);
            }
        }
        count = poll(samples);
        way_m[slow] = samples[count - 1].target.position_m.x - from_m;
    }
    assert_true(way_m[0] > 0.01f);
    assert_true(f_abs(way_m[0] - way_m[1]) < 1e-4f);
}

/* ---- A HID poi in the frame loop ------------------------------------------------------------ */

static void frame(void)
{
    for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
        send_next();
    }
    kiosk_frame(&fixture.kiosk, &fixture.hal);
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        frame();
    }
}

static void begin_round(void)
{
    const struct kiosk_config config = { .core = { .seed = 3, .fish_count = 10 } };
    begin();
    fixture.hal = null_hal(NULL);
    fixture.hal.clock = sim_clock_device(&fixture.clock);
    fixture.hal.poi[0] = poi_hid_devices(&fixture.poi).poi;
    assert_int_equal(kiosk_init(&fixture.kiosk, &fixture.hal, &config), CORE_OK);
    frames(20);
    fixture.kiosk.input.pressed = INPUT_START;
    while (fixture.kiosk.core.game.phase != PHASE_ROUND) {
        frame();
        assert_true(fixture.kiosk.core.game.tick < 10u * CORE_TICK_HZ);
    }
    frames(60);
}

static void test_a_poi_that_is_unplugged_in_a_round_is_lost_and_reopened(void **state)
{
    (void)state;
    begin_round();
    assert_false(controller_is_lost(&fixture.kiosk.core.world, 0));
    hid_port_sim_plug(&fixture.wire.port, NULL);
    frames(60);
    assert_true(controller_is_lost(&fixture.kiosk.core.world, 0));
    assert_int_equal(fixture.kiosk.core.game.phase, PHASE_ROUND);
    hid_port_sim_plug(&fixture.wire.port, &fixture.wire.face);
    /* The kiosk opens the device again after at most one second, and accepts its poses after
     * another 0.25 s. */
    frames(150);
    assert_false(controller_is_lost(&fixture.kiosk.core.world, 0));
    assert_int_equal(fixture.kiosk.core.game.phase, PHASE_ROUND);
}

static void test_a_silent_poi_is_lost_until_it_sends_reports_again(void **state)
{
    struct hid_sim_fault fault = { .kind = HID_SIM_SILENCE };
    (void)state;
    begin_round();
    fault.from = fixture.wire.port.report_count;
    fault.to = fault.from + 300u;
    fixture.wire.port.faults = &fault;
    fixture.wire.port.fault_count = 1;
    frames(70);
    assert_true(controller_is_lost(&fixture.kiosk.core.world, 0));
    frames(40);
    assert_false(controller_is_lost(&fixture.kiosk.core.world, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_absent_and_removed_devices_return_different_errors),
        cmocka_unit_test(test_each_report_gives_a_sample_with_its_own_time),
        cmocka_unit_test(test_force_is_sent_to_a_device_that_supports_it),
        cmocka_unit_test(test_a_gamepad_gets_no_force_and_a_keyboard_is_no_poi),
        cmocka_unit_test(test_reports_of_a_device_without_a_mapping_go_to_the_manager),
        cmocka_unit_test(test_reports_before_an_unplug_are_delivered_for_1000_positions),
        cmocka_unit_test(test_valid_reports_are_accepted_again_after_each_fault),
        cmocka_unit_test(test_duplicate_reports_are_dropped_and_lost_ones_are_counted),
        cmocka_unit_test(test_a_long_frame_gets_the_newest_report_and_counts_lost_ones),
        cmocka_unit_test(test_the_last_report_before_a_pause_is_never_lost),
        cmocka_unit_test(test_no_mouse_displacement_is_lost_in_a_slow_frame),
        cmocka_unit_test(test_a_poi_that_is_unplugged_in_a_round_is_lost_and_reopened),
        cmocka_unit_test(test_a_silent_poi_is_lost_until_it_sends_reports_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
