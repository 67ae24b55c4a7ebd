/* test_usb_reports.c -- tests the input reports and output reports of a USB poi on a simulated
 * bus. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb/usb_fixture.h"

static struct usb_fixture fixture;
static struct hid_device_info face;

static int set_up(void **state)
{
    (void)state;
    fixture_prepare(&fixture);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(fixture_end(&fixture), 0);
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

/* ---- Reports -------------------------------------------------------------------------------- */

static void test_reports_arrive_complete_in_order_and_with_time_stamps(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    uint64_t last_ns = 0;
    for (uint32_t i = 0; i < 500; i++) {
        const uint64_t before_ns = clock_device().ops->now_ns(NULL);
        fixture_send(poi, i);
        assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
        assert_int_equal(raw.size, POI_REPORT_SIZE);
        assert_int_equal(fixture_number(&raw), i);
        assert_true(raw.time_ns >= before_ns && raw.time_ns >= last_ns);
        assert_true(raw.time_ns <= clock_device().ops->now_ns(NULL));
        last_ns = raw.time_ns;
    }
}

static void test_a_short_packet_is_ignored(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    for (uint32_t i = 0; i < 100; i++) {
        fixture_send(poi, i);
        usb_sim_report(poi, (const uint8_t *)"", 0);
    }
    for (uint32_t i = 0; i < 50; i++) {
        assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
        assert_int_equal(fixture_number(&raw), i);
    }
}

static void test_transfers_are_always_pending(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    fixture_send(poi, 1);
    assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
    usleep(20000);
    /* Some transfers must be pending even while no report arrives, so that the next report is not
     * missed. */
    assert_in_range(usb_sim_seen(poi).in_flight, 2, 16);
}

/* Sends ten reports more than the ring buffer holds. The newest report must be delivered, and nine
 * reports count as lost. */
static void test_a_stalled_frame_gets_the_newest_report_and_counts_lost_ones(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    struct hid_port *const port = usb_transport_port(fixture.thread, 0);
    assert_true(fixture_open(&fixture, 0, &face));
    for (uint32_t i = 0; i < HID_REPORTS_MAX + 10u; i++) {
        fixture_send(poi, i);
    }
    for (uint32_t i = 0; i < 5000 && atomic_load(&port->lost) < 9u; i++) {
        usleep(200);
    }
    assert_int_equal(atomic_load(&port->lost), 9);
    for (uint32_t i = 0; i < HID_REPORTS_MAX; i++) {
        assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
        assert_int_equal(fixture_number(&raw), i);
    }
    assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
    assert_int_equal(fixture_number(&raw), HID_REPORTS_MAX + 9u);
    assert_int_equal(hid_port_take(port, &raw), 0);
}

static void test_a_transfer_error_does_not_release_the_slot(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    for (uint32_t i = 0; i < 5; i++) {
        usb_sim_fail(poi, LIBUSB_TRANSFER_ERROR);
        usleep(15000);
        fixture_send(poi, i);
        assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
        assert_int_equal(fixture_number(&raw), i);
    }
    assert_int_equal(usb_sim_seen(poi).opens, 1);
    usleep(50000);
    /* All four transfers were submitted again. */
    assert_int_equal(usb_sim_seen(poi).in_flight, 4);
}

static void test_a_halted_endpoint_is_cleared_while_no_transfer_is_pending(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_fail(poi, LIBUSB_TRANSFER_STALL);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(poi).clear_halts == 0; i++) {
        usleep(200);
    }
    fixture_send(poi, 7);
    assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
    assert_int_equal(usb_sim_seen(poi).clear_halts, 1);
    assert_int_equal(usb_sim_seen(poi).opens, 1);
}

static void test_a_device_whose_transfers_all_fail_is_reopened(void **state)
{
    (void)state;
    struct hid_raw raw;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    for (uint32_t i = 0; i < 2000 && usb_sim_seen(poi).closes == 0; i++) {
        usb_sim_fail(poi, LIBUSB_TRANSFER_ERROR);
        usleep(1000);
    }
    assert_int_equal(fixture_take(&fixture, 0, &raw), HAL_ERR_GONE);
    usb_sim_fail(poi, 0);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(poi).opens, 2);
    fixture_send(poi, 3);
    assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
    assert_int_equal(fixture_number(&raw), 3);
}

/* ---- Output --------------------------------------------------------------------------------- */

static const uint8_t force_report[POI_FORCE_SIZE] = { POI_FORCE_ID, 9, 1, 2, 3 };

static int send_force(void)
{
    struct hid_port *const port = usb_transport_port(fixture.thread, 0);
    return hid_port_send(port, force_report, sizeof force_report);
}

static int until_not_busy(void)
{
    int result = HAL_ERR_BUSY;
    for (uint32_t i = 0; i < 5000 && result == HAL_ERR_BUSY; i++) {
        usleep(200);
        result = send_force();
    }
    return result;
}

static void test_an_output_report_arrives(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_int_equal(send_force(), HAL_ERR_GONE); /* No device is connected yet. */
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(send_force(), HAL_OK);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(poi).outs == 0; i++) {
        usleep(200);
    }
    assert_int_equal(usb_sim_seen(poi).outs, 1);
    assert_int_equal(usb_sim_seen(poi).out_size, sizeof force_report);
    const struct usb_sim_seen seen = usb_sim_seen(poi);
    assert_memory_equal(seen.out, force_report, sizeof force_report);
}

static void test_without_an_out_endpoint_output_is_sent_by_set_report(void **state)
{
    (void)state;
    static const struct usb_sim_kind no_out = {
        .vendor = 0xcafe,
        .product = 2,
        .is_bound = 1,
        .interface_count = 1,
        .interface = { { .class = LIBUSB_CLASS_HID,
                         .packet_size = 64,
                         .descriptor = poi_descriptor,
                         .descriptor_size = POI_DESCRIPTOR_SIZE } },
    };
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&no_out, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(send_force(), HAL_OK);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(poi).set_reports == 0; i++) {
        usleep(200);
    }
    const struct usb_sim_seen seen = usb_sim_seen(poi);
    /* For an output report, wValue contains the report type 0x02 in its high byte and the report id
     * in its low byte. */
    assert_int_equal(seen.set_report_value, 0x0200 | POI_FORCE_ID);
    assert_memory_equal(seen.out, force_report, sizeof force_report);
}

static void test_an_output_report_is_dropped_while_another_is_pending(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_set_faults(&(struct usb_sim_faults){ .hold_outs = 1 });
    assert_int_equal(send_force(), HAL_OK);
    usleep(20000);
    assert_int_equal(send_force(), HAL_ERR_BUSY);
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
    assert_int_equal(until_not_busy(), HAL_OK);
    usleep(20000);
    assert_int_equal(usb_sim_seen(poi).outs, 2);
}

static void test_an_output_report_that_times_out_does_not_block_the_next(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_set_faults(&(struct usb_sim_faults){ .hold_outs = 1, .lets_outs_time_out = 1 });
    assert_int_equal(send_force(), HAL_OK);
    assert_int_equal(until_not_busy(), HAL_OK);
}

/* ---- The frame loop ------------------------------------------------------------------------- */

/* Makes all USB calls that the kiosk makes in one frame. */
static void make_calls_of_a_frame(struct hid_device_list device_list, uint32_t frame)
{
    struct hid_raw raw;
    struct hid_row rows[CONTROLLER_MAX];
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct hid_port *const port = usb_transport_port(fixture.thread, i);
        if (hid_port_take(port, &raw) == HAL_ERR_GONE) {
            hid_port_open(port, &face);
        }
        hid_port_send(port, force_report, sizeof force_report);
    }
    device_list.ops->rows(device_list.self, rows);
    device_list.ops->choose(device_list.self, frame % 2u, false);
    device_list.ops->choose(device_list.self, frame % 2u, true);
}

/* The simulated bus blocks the USB thread in libusb_close(). If a call of the frame loop waited for
 * this thread, the test would block until alarm() ends it. */
static void test_no_call_of_the_frame_loop_waits_for_the_bus(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    const uint32_t first = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_set_faults(&(struct usb_sim_faults){ .holds_close = 1, .cancel_ms = 20 });
    const uint32_t second = usb_sim_plug(&second_poi, 2);
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_ACTIVE));
    alarm(60);
    usb_sim_unplug(first, USB_SIM_QUIET);
    uint32_t frame = 0;
    while (usb_sim_seen(first).closes_begun + usb_sim_seen(second).closes_begun == 0) {
        make_calls_of_a_frame(device_list, frame++);
        usleep(1000);
    }
    for (uint32_t i = 0; i < 300; i++) {
        make_calls_of_a_frame(device_list, frame++);
    }
    alarm(0);
    assert_int_equal(usb_sim_seen(first).closes + usb_sim_seen(second).closes, 0);
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
}

/* The test gives commands faster than the USB thread can write the operator's choices to the disk.
 * The thread must nevertheless find a device that was plugged in. Otherwise the test would block
 * until alarm() ends it. */
static void test_commands_without_end_do_not_keep_the_thread_from_devices(void **state)
{
    (void)state;
    struct hid_row rows[CONTROLLER_MAX];
    fixture_start(&fixture, NULL, 0);
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    const uint32_t second = usb_sim_plug(&second_poi, 2);
    alarm(60);
    while (usb_sim_seen(second).opens == 0) {
        device_list.ops->choose(device_list.self, 0, true);
    }
    alarm(0);
    device_list.ops->rows(device_list.self, rows);
    assert_int_equal(rows[0].state, CONTROLLER_ACTIVE);
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_reports_arrive_complete_in_order_and_with_time_stamps),
        BENCH(test_a_short_packet_is_ignored),
        BENCH(test_transfers_are_always_pending),
        BENCH(test_a_stalled_frame_gets_the_newest_report_and_counts_lost_ones),
        BENCH(test_a_transfer_error_does_not_release_the_slot),
        BENCH(test_a_halted_endpoint_is_cleared_while_no_transfer_is_pending),
        BENCH(test_a_device_whose_transfers_all_fail_is_reopened),
        BENCH(test_an_output_report_arrives),
        BENCH(test_without_an_out_endpoint_output_is_sent_by_set_report),
        BENCH(test_an_output_report_is_dropped_while_another_is_pending),
        BENCH(test_an_output_report_that_times_out_does_not_block_the_next),
        BENCH(test_no_call_of_the_frame_loop_waits_for_the_bus),
        BENCH(test_commands_without_end_do_not_keep_the_thread_from_devices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
