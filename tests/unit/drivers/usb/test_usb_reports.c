/* test_usb_reports.c -- what a poi on USB says and is made to feel, over a bus of memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb_kinds.h"

static struct usb_bench bench;
static struct hid_device_info face;

static int set_up(void **state)
{
    (void)state;
    bench_prepare(&bench);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(bench_end(&bench), 0);
    assert_int_equal(stand_breaches(), 0);
    return 0;
}

/* ---- Reports -------------------------------------------------------------------------------- */

static void test_reports_come_whole_in_order_and_stamped(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    uint64_t last_ns = 0;
    for (uint32_t i = 0; i < 500; i++) {
        const uint64_t before_ns = clock_device().ops->now_ns(NULL);
        bench_say(poi, i);
        assert_int_equal(bench_take(&bench, 0, &raw), 1);
        assert_int_equal(raw.size, POI_REPORT_SIZE);
        assert_int_equal(bench_number(&raw), i);
        assert_true(raw.time_ns >= before_ns && raw.time_ns >= last_ns);
        assert_true(raw.time_ns <= clock_device().ops->now_ns(NULL));
        last_ns = raw.time_ns;
    }
}

static void test_a_short_packet_is_no_report(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    for (uint32_t i = 0; i < 100; i++) {
        bench_say(poi, i);
        stand_report(poi, (const uint8_t *)"", 0);
    }
    for (uint32_t i = 0; i < 50; i++) {
        assert_int_equal(bench_take(&bench, 0, &raw), 1);
        assert_int_equal(bench_number(&raw), i);
    }
}

static void test_transfers_are_always_in_flight(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    bench_say(poi, 1);
    assert_int_equal(bench_take(&bench, 0, &raw), 1);
    usleep(20000);
    assert_in_range(stand_seen(poi).in_flight, 2, 16); /* At rest, too. */
}

/* The ring is full; of ten more the last is heard all the same. */
static void test_a_frame_that_stalls_still_hears_the_newest_and_counts_what_is_lost(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    const struct hid_port port = usb_transport_port(bench.seats, 0);
    assert_true(bench_open(&bench, 0, &face));
    for (uint32_t i = 0; i < HID_REPORTS_MAX + 10u; i++) {
        bench_say(poi, i);
    }
    for (uint32_t i = 0; i < 5000 && port.ops->lost_count(port.self) < 9u; i++) {
        usleep(200);
    }
    assert_int_equal(port.ops->lost_count(port.self), 9);
    for (uint32_t i = 0; i < HID_REPORTS_MAX; i++) {
        assert_int_equal(bench_take(&bench, 0, &raw), 1);
        assert_int_equal(bench_number(&raw), i);
    }
    assert_int_equal(bench_take(&bench, 0, &raw), 1);
    assert_int_equal(bench_number(&raw), HID_REPORTS_MAX + 9u);
    assert_int_equal(port.ops->take(port.self, &raw), 0);
}

static void test_an_error_on_the_wire_costs_no_seat(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    for (uint32_t i = 0; i < 5; i++) {
        stand_fail(poi, LIBUSB_TRANSFER_ERROR);
        usleep(15000);
        bench_say(poi, i);
        assert_int_equal(bench_take(&bench, 0, &raw), 1);
        assert_int_equal(bench_number(&raw), i);
    }
    assert_int_equal(stand_seen(poi).opens, 1);
    usleep(50000);
    assert_int_equal(stand_seen(poi).in_flight, 4); /* None was forgotten. */
}

static void test_a_halted_endpoint_is_cleared_while_nothing_flies(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    stand_fail(poi, LIBUSB_TRANSFER_STALL);
    for (uint32_t i = 0; i < 5000 && stand_seen(poi).clear_halts == 0; i++) {
        usleep(200);
    }
    bench_say(poi, 7);
    assert_int_equal(bench_take(&bench, 0, &raw), 1);
    assert_int_equal(stand_seen(poi).clear_halts, 1);
    assert_int_equal(stand_seen(poi).opens, 1);
}

static void test_one_that_only_fails_is_opened_anew(void **state)
{
    (void)state;
    struct hid_raw raw;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    for (uint32_t i = 0; i < 2000 && stand_seen(poi).closes == 0; i++) {
        stand_fail(poi, LIBUSB_TRANSFER_ERROR);
        usleep(1000);
    }
    assert_int_equal(bench_take(&bench, 0, &raw), HAL_ERR_GONE);
    stand_fail(poi, 0);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(poi).opens, 2);
    bench_say(poi, 3);
    assert_int_equal(bench_take(&bench, 0, &raw), 1);
    assert_int_equal(bench_number(&raw), 3);
}

/* ---- Output --------------------------------------------------------------------------------- */

static const uint8_t blow[POI_FEEL_SIZE] = { POI_FEEL_ID, 9, 1, 2, 3 };

static int send_blow(void)
{
    const struct hid_port port = usb_transport_port(bench.seats, 0);
    return port.ops->send(port.self, blow, sizeof blow);
}

static int until_not_busy(void)
{
    int result = HAL_ERR_BUSY;
    for (uint32_t i = 0; i < 5000 && result == HAL_ERR_BUSY; i++) {
        usleep(200);
        result = send_blow();
    }
    return result;
}

static void test_a_blow_reaches_the_hand(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_int_equal(send_blow(), HAL_ERR_GONE); /* Nobody there yet. */
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(send_blow(), HAL_OK);
    for (uint32_t i = 0; i < 5000 && stand_seen(poi).outs == 0; i++) {
        usleep(200);
    }
    assert_int_equal(stand_seen(poi).outs, 1);
    assert_int_equal(stand_seen(poi).out_size, sizeof blow);
    const struct stand_seen seen = stand_seen(poi);
    assert_memory_equal(seen.out, blow, sizeof blow);
}

static void test_a_device_without_an_out_endpoint_is_told_by_set_report(void **state)
{
    (void)state;
    static const struct stand_kind no_out = {
        .vendor = 0xcafe,
        .product = 2,
        .is_bound = 1,
        .interface_count = 1,
        .interface = { { .class = LIBUSB_CLASS_HID,
                         .packet_size = 64,
                         .descriptor = poi_descriptor,
                         .descriptor_size = POI_DESCRIPTOR_SIZE } },
    };
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&no_out, 1);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(send_blow(), HAL_OK);
    for (uint32_t i = 0; i < 5000 && stand_seen(poi).set_reports == 0; i++) {
        usleep(200);
    }
    const struct stand_seen seen = stand_seen(poi);
    assert_int_equal(seen.set_report_value, 0x0200 | POI_FEEL_ID); /* Output report, its id. */
    assert_memory_equal(seen.out, blow, sizeof blow);
}

static void test_a_blow_is_dropped_while_the_last_one_is_on_its_way(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    stand_set_faults(&(struct stand_faults){ .hold_outs = 1 });
    assert_int_equal(send_blow(), HAL_OK);
    usleep(20000);
    assert_int_equal(send_blow(), HAL_ERR_BUSY);
    stand_set_faults(&(struct stand_faults){ 0 });
    assert_int_equal(until_not_busy(), HAL_OK);
    usleep(20000);
    assert_int_equal(stand_seen(poi).outs, 2);
}

static void test_a_hand_that_takes_no_blow_does_not_stop_the_next(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    stand_set_faults(&(struct stand_faults){ .hold_outs = 1, .lets_outs_time_out = 1 });
    assert_int_equal(send_blow(), HAL_OK);
    assert_int_equal(until_not_busy(), HAL_OK);
}

/* ---- The frame loop ------------------------------------------------------------------------- */

/* The breach count says so, too: any call of libusb from this thread is one. */
static void test_no_call_of_the_frame_loop_waits_however_slow_the_bus_is(void **state)
{
    (void)state;
    struct hid_raw raw;
    struct hid_row rows[CONTROLLER_MAX];
    bench_start(&bench, NULL, 0);
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    const uint32_t first = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    stand_set_faults(&(struct stand_faults){ .close_ms = 400, .cancel_ms = 200 });
    stand_plug(&second_poi, 2);
    assert_true(bench_until(&bench, 1, CONTROLLER_ACTIVE));
    stand_unplug(first, STAND_QUIET); /* The thread is stuck for over half a second from here. */
    uint64_t worst_ns = 0;
    uint32_t frames = 0;
    const uint64_t begin_ns = clock_device().ops->now_ns(NULL);
    while (clock_device().ops->now_ns(NULL) - begin_ns < 800000000ull) {
        const uint64_t frame_ns = clock_device().ops->now_ns(NULL);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            const struct hid_port port = usb_transport_port(bench.seats, i);
            if (port.ops->take(port.self, &raw) == HAL_ERR_GONE) {
                port.ops->open(port.self, &face);
            }
            port.ops->send(port.self, blow, sizeof blow);
            port.ops->describe(port.self);
        }
        device_list.ops->rows(device_list.self, rows);
        device_list.ops->release(device_list.self, frames % 2u);
        device_list.ops->choose(device_list.self, frames % 2u);
        const uint64_t took_ns = clock_device().ops->now_ns(NULL) - frame_ns;
        worst_ns = took_ns > worst_ns ? took_ns : worst_ns;
        frames++;
        usleep(1000);
    }
    assert_true(frames > 100);
    /* A scheduler's turn on a loaded machine at most; the bus was stuck ten times as long. */
    assert_in_range(worst_ns, 0, 50000000ull);
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_reports_come_whole_in_order_and_stamped),
        BENCH(test_a_short_packet_is_no_report),
        BENCH(test_transfers_are_always_in_flight),
        BENCH(test_a_frame_that_stalls_still_hears_the_newest_and_counts_what_is_lost),
        BENCH(test_an_error_on_the_wire_costs_no_seat),
        BENCH(test_a_halted_endpoint_is_cleared_while_nothing_flies),
        BENCH(test_one_that_only_fails_is_opened_anew),
        BENCH(test_a_blow_reaches_the_hand),
        BENCH(test_a_device_without_an_out_endpoint_is_told_by_set_report),
        BENCH(test_a_blow_is_dropped_while_the_last_one_is_on_its_way),
        BENCH(test_a_hand_that_takes_no_blow_does_not_stop_the_next),
        BENCH(test_no_call_of_the_frame_loop_waits_however_slow_the_bus_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
