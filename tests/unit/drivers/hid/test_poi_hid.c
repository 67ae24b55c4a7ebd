/* test_poi_hid.c -- a seat's device over a wire that breaks: pulled out at any report, garbage,
 * silence, doubles, and everything that must not reach the frame loop. */
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

#define REPORT_NS 4000000ull /* 250 reports a second: a gadget's slowest. */
#define FRAME_REPORTS 4u

static struct stand {
    struct clock_sim clock;
    struct hid_wire wire;
    struct poi_hid poi;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t report_count;
} stand;

static void begin(void)
{
    memset(&stand, 0, sizeof stand);
    stand.clock.now_ns = 1000000000ull;
    wire_begin(&stand.wire, &stand.clock, poi_descriptor, POI_DESCRIPTOR_SIZE);
    poi_hid_init(&stand.poi, hid_port_sim_port(&stand.wire.port), sim_clock_device(&stand.clock),
                 (struct hid_mapper){ 0 }, stall_view());
}

/* A hand that goes round over the water, a few millimetres a report. */
static void say_next(void)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const float angle = 0.01f * (float)stand.report_count;
    const struct poi_report said = {
        .target.position_m = { 0.1f * f_sin(angle), 0.06f, 0.1f * f_cos(angle) },
        .sequence = (uint8_t)stand.report_count++,
    };
    poi_report_encode(&said, bytes);
    stand.clock.now_ns += REPORT_NS;
    hid_port_sim_report(&stand.wire.port, bytes, sizeof bytes);
}

static int poll(struct poi_sample samples[HAL_POI_SAMPLES_MAX])
{
    const struct hal_poi device = poi_hid_device(&stand.poi);
    return device.ops->poll(device.self, samples, HAL_POI_SAMPLES_MAX);
}

static int reopen(void)
{
    const struct hal_poi device = poi_hid_device(&stand.poi);
    return device.ops->open(device.self);
}

/* ---- The device ----------------------------------------------------------------------------- */

static void test_nobody_ever_and_nobody_now_are_told_apart(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    stand.wire.port.absent = 1;
    assert_int_equal(reopen(), HAL_ERR_GONE);
    assert_int_equal(poll(samples), HAL_ERR_GONE);
    stand.wire.port.absent = 0;
    assert_int_equal(reopen(), HAL_OK);
    assert_int_equal(poll(samples), 0); /* It has not said anything. */
    stand.wire.port.face = NULL;
    assert_int_equal(reopen(), HAL_ERR_ABSENT);
}

static void test_each_report_is_a_sample_of_its_own_time(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    assert_int_equal(reopen(), HAL_OK);
    for (uint32_t i = 0; i < 10; i++) {
        say_next();
    }
    assert_int_equal(poll(samples), 10);
    for (uint32_t i = 0; i < 10; i++) {
        assert_int_equal(samples[i].time_ns, 1000000000ull + (i + 1u) * REPORT_NS);
    }
    stand.clock.now_ns += 50000000ull;
    assert_int_equal(poll(samples), 0); /* Nothing is made up of a true pose. */
}

static void test_the_hand_feels_the_water_if_its_device_can(void **state)
{
    struct poi_force felt;
    uint8_t sequence;
    (void)state;
    begin();
    const struct hal_poi device = poi_hid_device(&stand.poi);
    const struct poi_force pull = { .force_n = { 0.0f, -1.5f, 0.0f }, .drag = 0.75f };
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_ABSENT); /* Not opened. */
    reopen();
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_OK);
    assert_true(poi_feel_decode(stand.wire.port.sent, stand.wire.port.sent_size, &felt, &sequence));
    assert_int_equal(sequence, 0);
    assert_float_equal(felt.force_n.y, -1.5f, 1e-3f);
    stand.wire.port.busy = 1;
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_BUSY);
    stand.wire.port.busy = 0;
    device.ops->set_force(device.self, &pull);
    poi_feel_decode(stand.wire.port.sent, stand.wire.port.sent_size, &felt, &sequence);
    assert_int_equal(sequence, 1); /* What was not sent is not counted. */
}

static void test_a_pad_feels_nothing_and_a_keyboard_is_no_poi(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    const struct poi_force pull = { .drag = 1.0f };
    (void)state;
    begin();
    wire_load(&stand.wire, &stand.clock, "016-ci-dualsense");
    const struct hal_poi device = poi_hid_device(&stand.poi);
    reopen();
    assert_int_equal(device.ops->set_force(device.self, &pull), HAL_ERR_ABSENT);
    begin();
    wire_load(&stand.wire, &stand.clock, "012-compact-keyboard-2222-0099-if1");
    assert_int_equal(reopen(), HAL_OK);
    assert_false(stand.poi.plays);
    assert_non_null(strstr(device.ops->describe(device.self), "cannot be a poi"));
    wire_send(&stand.wire, 0);
    assert_int_equal(poll(samples), 0);
}

static void heard(void *self, const struct hid_raw *raw)
{
    uint32_t *count = self;
    *count += raw->size > 0;
}

static void test_who_cannot_play_is_listened_to_by_the_desk(void **state)
{
    struct poi_sample sample;
    uint32_t count = 0;
    (void)state;
    begin();
    wire_load(&stand.wire, &stand.clock, "012-compact-keyboard-2222-0099-if1");
    reopen();
    poi_hid_set_observer(&stand.poi, (struct hid_watch){ .report = heard, .self = &count });
    wire_send(&stand.wire, 0);
    wire_send(&stand.wire, 0);
    const struct hal_poi device = poi_hid_device(&stand.poi);
    assert_int_equal(device.ops->poll(device.self, &sample, 1), 0);
    assert_int_equal(count, 2);
}

/* ---- The wire breaks ------------------------------------------------------------------------ */

static void test_pulled_out_at_each_of_1000_reports_what_came_before_is_played(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint32_t at = 0; at < 1000; at++) {
        uint32_t seen = 0;
        int result = 0;
        begin();
        stand.wire.port.unplug_at = at;
        assert_int_equal(reopen(), HAL_OK);
        while (stand.report_count <= at + FRAME_REPORTS) {
            for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
                say_next();
            }
            result = poll(samples);
            seen += result > 0 ? (uint32_t)result : 0u;
        }
        assert_int_equal(seen, at);
        assert_int_equal(result > 0 ? poll(samples) : result, HAL_ERR_GONE);
        assert_int_equal(poll(samples), HAL_ERR_GONE); /* And so it stays. */
        assert_int_equal(reopen(), HAL_OK);
        say_next();
        assert_int_equal(poll(samples), 1);
    }
}

/* From each fault the samples stay finite, in order, and the next fine report is taken. */
static void test_each_fault_of_a_wire_is_survived(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint8_t kind = HID_SIM_SILENCE; kind < HID_SIM_KIND_COUNT; kind++) {
        const struct hid_sim_fault fault = { .kind = kind, .from = 20, .to = 60 };
        uint64_t before_ns = 0;
        begin();
        stand.wire.port.faults = &fault;
        stand.wire.port.fault_count = 1;
        reopen();
        for (uint32_t frame = 0; frame < 25; frame++) {
            for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
                say_next();
            }
            const int count = poll(samples);
            const int is_fine = frame < 5 || frame >= 15;
            assert_true(count >= 0);
            if (is_fine && kind != HID_SIM_GARBAGE) { /* Any sequence number may come before. */
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

static void test_doubles_are_one_and_lost_ones_are_counted(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    static const struct hid_sim_fault faults[] = { { HID_SIM_TWICE, 4, 8 },
                                                   { HID_SIM_SILENCE, 10, 13 } };
    (void)state;
    begin();
    stand.wire.port.faults = faults;
    stand.wire.port.fault_count = 2;
    reopen();
    for (uint32_t i = 0; i < 20; i++) {
        say_next();
    }
    assert_int_equal(poll(samples), 17);
    assert_int_equal(stand.poi.hand.refused_count, 4);
    assert_int_equal(stand.poi.hand.gap_count, 3);
}

static void test_a_frame_that_took_too_long_hears_the_newest_and_counts_what_it_lost(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    begin();
    reopen();
    for (uint32_t i = 0; i < 2u * HID_REPORTS_MAX; i++) {
        say_next();
    }
    assert_int_equal(poll(samples), HAL_POI_SAMPLES_MAX);
    assert_int_equal(samples[HAL_POI_SAMPLES_MAX - 1u].time_ns, stand.clock.now_ns);
    assert_int_equal(stand.wire.port.lost_count, HID_REPORTS_MAX);
    assert_int_equal(poll(samples), 0); /* Nothing is left for the next frame to be late with. */
}

/* Pads tell only what changes. In one frame of a tenth of a second the stick trembles at its end
 * and is let go; then there is silence, and the hand must not go on. */
static void test_the_last_report_before_a_silence_is_always_heard(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    (void)state;
    for (uint32_t burst = 80; burst < 3u * HID_REPORTS_MAX; burst *= 6u) {
        memset(&stand, 0, sizeof stand);
        stand.clock.now_ns = 1000000000ull;
        wire_load(&stand.wire, &stand.clock, "010-8bitdo-sn30pro-bt-dinput");
        poi_hid_init(&stand.poi, hid_port_sim_port(&stand.wire.port),
                     sim_clock_device(&stand.clock), (struct hid_mapper){ 0 }, stall_view());
        reopen();
        const uint8_t id = wire_put(&stand.wire, -1, USAGE_X, 0x80);
        wire_put(&stand.wire, id, USAGE_Y, 0x80);
        wire_send(&stand.wire, id);
        poll(samples);
        for (uint32_t i = 0; i < burst; i++) {
            stand.clock.now_ns += 100000000ull / burst;
            wire_put(&stand.wire, id, USAGE_X, 250 + i % 3u);
            wire_put(&stand.wire, id, USAGE_BUTTON + 1u, 1);
            wire_send(&stand.wire, id);
        }
        wire_put(&stand.wire, id, USAGE_X, 0x80);
        wire_put(&stand.wire, id, USAGE_BUTTON + 1u, 0);
        wire_send(&stand.wire, id);
        int count = poll(samples);
        assert_true(count > 0);
        const float let_go_m = samples[count - 1].target.position_m.x;
        for (uint32_t i = 0; i < 120; i++) {
            stand.clock.now_ns += 16666667ull;
            count = poll(samples);
        }
        const vec3 rest_m = samples[count - 1].target.position_m;
        assert_true(rest_m.y > 0.0f);
        assert_true(f_abs(rest_m.x - let_go_m) < 0.03f); /* It glides out; the wall is at 0.476. */
    }
}

/* A mouse of 1,000 reports a second is led through a frame of half a second: no way is missing. */
static void test_no_way_of_a_mouse_is_lost_in_a_slow_frame(void **state)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    float way_m[2];
    (void)state;
    for (uint32_t slow = 0; slow < 2; slow++) {
        memset(&stand, 0, sizeof stand);
        stand.clock.now_ns = 1000000000ull;
        wire_load(&stand.wire, &stand.clock, "011-dell-413c-301a-mouse");
        poi_hid_init(&stand.poi, hid_port_sim_port(&stand.wire.port),
                     sim_clock_device(&stand.clock), (struct hid_mapper){ 0 }, stall_view());
        reopen();
        const uint8_t id = wire_put(&stand.wire, -1, USAGE_X, 0);
        wire_send(&stand.wire, id);
        int count = poll(samples);
        const float from_m = samples[count - 1].target.position_m.x;
        for (uint32_t i = 0; i < 500; i++) {
            stand.clock.now_ns += 1000000ull;
            wire_put(&stand.wire, id, USAGE_X, i % 5u == 0u);
            wire_send(&stand.wire, id);
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

/* ---- In the kiosk --------------------------------------------------------------------------- */

static void frame(void)
{
    for (uint32_t i = 0; i < FRAME_REPORTS; i++) {
        say_next();
    }
    kiosk_frame(&stand.kiosk, &stand.hal);
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
    stand.hal = null_hal();
    stand.hal.clock = sim_clock_device(&stand.clock);
    stand.hal.poi[0] = poi_hid_device(&stand.poi);
    assert_int_equal(kiosk_init(&stand.kiosk, &stand.hal, &config), CORE_OK);
    frames(20);
    stand.kiosk.input.pressed = INPUT_START;
    while (stand.kiosk.core.game.phase != PHASE_ROUND) {
        frame();
        assert_true(stand.kiosk.core.game.tick < 10u * CORE_TICK_HZ);
    }
    frames(60);
}

static void test_a_poi_that_is_pulled_out_in_mid_round_is_lost_and_found_again(void **state)
{
    (void)state;
    begin_round();
    assert_false(controller_is_lost(&stand.kiosk.core.world, 0));
    stand.wire.port.absent = 1;
    frames(60);
    assert_true(controller_is_lost(&stand.kiosk.core.world, 0));
    assert_int_equal(stand.kiosk.core.game.phase, PHASE_ROUND);
    stand.wire.port.absent = 0;
    frames(150); /* It is looked for once a second, and believed a quarter of one later. */
    assert_false(controller_is_lost(&stand.kiosk.core.world, 0));
    assert_int_equal(stand.kiosk.core.game.phase, PHASE_ROUND);
}

static void test_a_silent_poi_is_lost_and_one_that_speaks_again_found(void **state)
{
    struct hid_sim_fault fault = { .kind = HID_SIM_SILENCE };
    (void)state;
    begin_round();
    fault.from = stand.wire.port.said_count;
    fault.to = fault.from + 300u;
    stand.wire.port.faults = &fault;
    stand.wire.port.fault_count = 1;
    frames(70);
    assert_true(controller_is_lost(&stand.kiosk.core.world, 0));
    frames(40);
    assert_false(controller_is_lost(&stand.kiosk.core.world, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nobody_ever_and_nobody_now_are_told_apart),
        cmocka_unit_test(test_each_report_is_a_sample_of_its_own_time),
        cmocka_unit_test(test_the_hand_feels_the_water_if_its_device_can),
        cmocka_unit_test(test_a_pad_feels_nothing_and_a_keyboard_is_no_poi),
        cmocka_unit_test(test_who_cannot_play_is_listened_to_by_the_desk),
        cmocka_unit_test(test_pulled_out_at_each_of_1000_reports_what_came_before_is_played),
        cmocka_unit_test(test_each_fault_of_a_wire_is_survived),
        cmocka_unit_test(test_doubles_are_one_and_lost_ones_are_counted),
        cmocka_unit_test(test_a_frame_that_took_too_long_hears_the_newest_and_counts_what_it_lost),
        cmocka_unit_test(test_the_last_report_before_a_silence_is_always_heard),
        cmocka_unit_test(test_no_way_of_a_mouse_is_lost_in_a_slow_frame),
        cmocka_unit_test(test_a_poi_that_is_pulled_out_in_mid_round_is_lost_and_found_again),
        cmocka_unit_test(test_a_silent_poi_is_lost_and_one_that_speaks_again_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
