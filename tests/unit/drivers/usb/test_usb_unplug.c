/* test_usb_unplug.c -- tests that a device can be unplugged after any report, with each order of
 * the bus events.
 *
 * All earlier reports must be delivered in order, and then the port returns HAL_ERR_GONE once. When
 * the device is plugged in again, it gets its former slot. The simulated bus counts objects that
 * are closed too early or twice. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb/usb_fixture.h"

#define INDEX_COUNT 1000u
#define BURST 64u /* Number of reports in a burst, which fits into the ring buffer. */

static struct usb_fixture fixture;
static struct hid_device_info face;

static int set_up(void **state)
{
    (void)state;
    fixture_prepare(&fixture);
    fixture_start(&fixture, NULL, 0);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(fixture_end(&fixture), 0);
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

static uint64_t now_ns(void)
{
    return clock_device().ops->now_ns(NULL);
}

static void take_reports(uint32_t from, uint32_t to)
{
    struct hid_raw raw;
    for (uint32_t i = from; i < to; i++) {
        assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
        assert_int_equal(fixture_number(&raw), i);
    }
}

/* Sends `count` reports in bursts of BURST reports, and takes the reports of each complete burst.
 * If `count` is even, also takes the remaining reports. Otherwise the remaining reports stay in the
 * ring buffer. */
static void send_reports(uint32_t device, uint32_t count)
{
    uint32_t taken = 0;
    for (uint32_t i = 0; i < count; i++) {
        fixture_send(device, i);
        if (i + 1u - taken == BURST) {
            take_reports(taken, i + 1u);
            taken = i + 1u;
        }
    }
    while (usb_sim_waiting(device) > 0) {
        usleep(20);
    }
    if (count % 2u == 0u) {
        take_reports(taken, count);
    }
}

static uint32_t left_to_take(uint32_t count)
{
    return count % 2u == 0u ? count : count / BURST * BURST;
}

static int compare(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static void test_a_device_returns_after_an_unplug_at_each_of_1000_reports(void **state)
{
    (void)state;
    static uint64_t back_ns[INDEX_COUNT];
    struct hid_raw raw;
    for (uint32_t i = 0; i < INDEX_COUNT; i++) {
        const enum usb_sim_unplug_order how = (enum usb_sim_unplug_order)(i % 4u);
        const uint64_t plugged_ns = now_ns();
        const uint32_t poi = usb_sim_plug(&own_poi, 1);
        assert_true(fixture_open(&fixture, 0, &face));
        back_ns[i] = now_ns() - plugged_ns;
        send_reports(poi, i);
        usb_sim_unplug(poi, how);
        take_reports(left_to_take(i), i);
        assert_int_equal(fixture_take(&fixture, 0, &raw), HAL_ERR_GONE);
        if (how == USB_SIM_LATE) {
            usb_sim_announce(poi);
        }
        assert_int_equal(atomic_load(&usb_transport_port(fixture.thread, 0)->lost), 0);
    }
    qsort(back_ns, INDEX_COUNT, sizeof back_ns[0], compare);
    printf("# plugged in to assigned: p50 %.2f ms, p99 %.2f ms, at most %.2f ms\n",
           (double)back_ns[INDEX_COUNT / 2u] / 1e6, (double)back_ns[INDEX_COUNT * 99u / 100u] / 1e6,
           (double)back_ns[INDEX_COUNT - 1u] / 1e6);
    assert_in_range(back_ns[INDEX_COUNT / 2u], 0, 100000000ull);
}

static void test_reports_that_arrive_before_an_unplug_are_a_prefix_of_those_sent(void **state)
{
    (void)state;
    struct hid_raw raw;
    for (uint32_t round = 0; round < 100; round++) {
        const uint32_t poi = usb_sim_plug(&own_poi, 1);
        int result;
        uint32_t count = 0;
        assert_true(fixture_open(&fixture, 0, &face));
        for (uint32_t i = 0; i < 60; i++) {
            fixture_send(poi, i);
        }
        usb_sim_unplug(poi, (enum usb_sim_unplug_order)(round % 2u));
        while ((result = fixture_take(&fixture, 0, &raw)) == 1) {
            assert_int_equal(fixture_number(&raw), count++);
        }
        assert_int_equal(result, HAL_ERR_GONE);
    }
}

static void test_a_lost_poi_keeps_its_row_in_the_device_list(void **state)
{
    (void)state;
    uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    usb_sim_unplug(poi, USB_SIM_IO_FIRST);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_LOST));
    /* The device was plugged into another port, and is identified by its serial number. */
    poi = usb_sim_plug(&own_poi, 5);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_int_equal(fixture_row(&fixture, 0).slot, 0);
    assert_string_equal(fixture_row(&fixture, 0).identity.port, "3-5");
    assert_int_equal(fixture_row(&fixture, 1).state, CONTROLLER_NONE);
    usb_sim_unplug(poi, USB_SIM_GONE);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_LOST));
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    /* The operator releases the lost device, so its row is removed at once. */
    assert_int_equal(device_list.ops->choose(device_list.self, 0, false), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_NONE));
}

/* Two devices of the same product without serial numbers are lost. The operator excludes the device
 * of slot 0. Slot 1 must stay reserved for the other device. */
static void test_an_exclusion_releases_only_the_slot_of_its_device(void **state)
{
    (void)state;
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    uint32_t plain[2];
    for (uint32_t i = 0; i < 2; i++) {
        plain[i] = usb_sim_plug(&plain_poi, (uint8_t)(i + 1u));
        assert_true(fixture_open(&fixture, i, &face));
    }
    for (uint32_t i = 0; i < 2; i++) {
        usb_sim_unplug(plain[i], USB_SIM_GONE);
        assert_true(fixture_wait_state(&fixture, i, CONTROLLER_LOST));
    }
    assert_string_equal(fixture_row(&fixture, 0).identity.port, "3-1");
    assert_int_equal(device_list.ops->choose(device_list.self, 0, false), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_NONE));
    usb_sim_plug(&unbound_poi, 5);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_plug(&unbound_poi, 6);
    assert_true(fixture_open(&fixture, 2, &face));
    assert_string_equal(face.identity.port, "3-6");
}

static void test_a_close_waits_for_late_transfers(void **state)
{
    (void)state;
    struct hid_raw raw;
    usb_sim_set_faults(&(struct usb_sim_faults){ .cancel_ms = 150 });
    const uint32_t first = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    usb_sim_unplug(first, USB_SIM_QUIET);
    assert_int_equal(fixture_take(&fixture, 0, &raw), HAL_ERR_GONE);
    /* The device is plugged in again before its old handle is closed. */
    const uint32_t again = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(first).closes, 0);
    fixture_send(again, 1);
    assert_int_equal(fixture_take(&fixture, 0, &raw), 1);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(first).closes == 0; i++) {
        usleep(200);
    }
    assert_int_equal(usb_sim_seen(first).closes, 1);
}

static void test_the_thread_waits_for_all_transfers_before_it_ends(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .cancel_ms = 100, .hold_outs = 1 });
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    const uint32_t other = usb_sim_plug(&second_poi, 2);
    struct hid_port *const port = usb_transport_port(fixture.thread, 0);
    const uint8_t blow[] = { POI_FORCE_ID, 1 };
    assert_true(fixture_open(&fixture, 0, &face));
    assert_true(fixture_open(&fixture, 1, &face));
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(hid_port_send(port, blow, sizeof blow), HAL_OK);
    usleep(10000);
    usb_transport_stop(fixture.thread);
    assert_int_equal(usb_sim_seen(poi).closes, 1);
    assert_int_equal(usb_sim_seen(poi).releases, 1);
    assert_int_equal(usb_sim_seen(other).closes, 1);
    assert_int_equal(usb_sim_end(), 0);
}

/* Teardown of the last test. In this test, the simulated kernel never returns some transfers, so
 * their memory stays allocated. */
static int tear_down_what_is_left(void **state)
{
    (void)state;
    assert_true(fixture_end(&fixture) > 0);
    /* A breach is an object that was closed or freed while a pending transfer still needed it. */
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

static void test_the_wait_for_transfers_at_the_end_times_out(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .cancel_ms = 3600000 });
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    const uint64_t begin_ns = now_ns();
    usb_transport_stop(fixture.thread);
    assert_in_range(now_ns() - begin_ns, 1000000000ull, 10000000000ull);
}

static void test_a_device_that_is_unplugged_during_the_open_is_released(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 200; i++) {
        const uint32_t poi = usb_sim_plug(&unbound_poi, 1);
        usleep(i % 40u * 10u);
        usb_sim_unplug(poi, (enum usb_sim_unplug_order)(i % 2u));
    }
    usb_sim_plug(&unbound_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_a_device_returns_after_an_unplug_at_each_of_1000_reports),
        BENCH(test_reports_that_arrive_before_an_unplug_are_a_prefix_of_those_sent),
        BENCH(test_a_lost_poi_keeps_its_row_in_the_device_list),
        BENCH(test_an_exclusion_releases_only_the_slot_of_its_device),
        BENCH(test_a_close_waits_for_late_transfers),
        BENCH(test_the_thread_waits_for_all_transfers_before_it_ends),
        BENCH(test_a_device_that_is_unplugged_during_the_open_is_released),
        cmocka_unit_test_setup_teardown(test_the_wait_for_transfers_at_the_end_times_out, set_up,
                                        tear_down_what_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
