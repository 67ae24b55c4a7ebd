/* test_usb_unplug.c -- a cable may be pulled after any report, in any of the ways that show it.
 *
 * All that was said before is taken, in order; then the port says once that it is gone; then it
 * comes back to its seat. The stand counts whatever is closed too early or twice. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb_kinds.h"

#define INDEX_COUNT 1000u
#define BURST 64u /* No more than the ring holds: none is lost. */

static struct usb_bench bench;
static struct hid_device_info face;

static int set_up(void **state)
{
    (void)state;
    bench_prepare(&bench);
    bench_start(&bench, NULL, 0);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(bench_end(&bench), 0);
    assert_int_equal(stand_breaches(), 0);
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
        assert_int_equal(bench_take(&bench, 0, &raw), 1);
        assert_int_equal(bench_number(&raw), i);
    }
}

/* Leaves the last ones on their way: every transfer has them, but the frame loop has not. */
static void say_reports(uint32_t device, uint32_t count)
{
    uint32_t taken = 0;
    for (uint32_t i = 0; i < count; i++) {
        bench_say(device, i);
        if (i + 1u - taken == BURST) {
            take_reports(taken, i + 1u);
            taken = i + 1u;
        }
    }
    while (stand_waiting(device) > 0) {
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

static void test_pulled_out_at_each_of_a_thousand_reports_it_comes_back(void **state)
{
    (void)state;
    static uint64_t back_ns[INDEX_COUNT];
    struct hid_raw raw;
    for (uint32_t i = 0; i < INDEX_COUNT; i++) {
        const enum stand_parting how = (enum stand_parting)(i % 4u);
        const uint64_t plugged_ns = now_ns();
        const uint32_t poi = stand_plug(&own_poi, 1);
        assert_true(bench_open(&bench, 0, &face));
        back_ns[i] = now_ns() - plugged_ns;
        say_reports(poi, i);
        stand_unplug(poi, how);
        take_reports(left_to_take(i), i);
        assert_int_equal(bench_take(&bench, 0, &raw), HAL_ERR_GONE);
        if (how == STAND_LATE) {
            stand_announce(poi);
        }
        assert_int_equal(usb_transport_port(bench.seats, 0)
                             .ops->lost_count(usb_transport_port(bench.seats, 0).self),
                         0);
    }
    qsort(back_ns, INDEX_COUNT, sizeof back_ns[0], compare);
    printf("# plugged in to seated: p50 %.2f ms, p99 %.2f ms, at most %.2f ms\n",
           (double)back_ns[INDEX_COUNT / 2u] / 1e6, (double)back_ns[INDEX_COUNT * 99u / 100u] / 1e6,
           (double)back_ns[INDEX_COUNT - 1u] / 1e6);
    assert_in_range(back_ns[INDEX_COUNT / 2u], 0, 100000000ull);
}

static void test_reports_still_on_the_wire_are_a_beginning_of_what_was_said(void **state)
{
    (void)state;
    struct hid_raw raw;
    for (uint32_t round = 0; round < 100; round++) {
        const uint32_t poi = stand_plug(&own_poi, 1);
        int result;
        uint32_t count = 0;
        assert_true(bench_open(&bench, 0, &face));
        for (uint32_t i = 0; i < 60; i++) {
            bench_say(poi, i);
        }
        stand_unplug(poi, (enum stand_parting)(round % 2u));
        while ((result = bench_take(&bench, 0, &raw)) == 1) {
            assert_int_equal(bench_number(&raw), count++);
        }
        assert_int_equal(result, HAL_ERR_GONE);
    }
}

static void test_a_lost_poi_has_its_row_while_it_is_away(void **state)
{
    (void)state;
    uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    stand_unplug(poi, STAND_IO_FIRST);
    assert_true(bench_until(&bench, 0, CONTROLLER_LOST));
    poi = stand_plug(&own_poi, 5); /* Elsewhere: its serial number says who it is. */
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_int_equal(bench_row(&bench, 0).seat, 0);
    assert_string_equal(bench_row(&bench, 0).identity.port, "3-5");
    assert_int_equal(bench_row(&bench, 1).state, CONTROLLER_NONE);
    stand_unplug(poi, STAND_GONE);
    assert_true(bench_until(&bench, 0, CONTROLLER_LOST));
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    assert_int_equal(device_list.ops->release(device_list.self, 0),
                     HAL_OK); /* Waited for no more. */
    assert_true(bench_until(&bench, 0, CONTROLLER_NONE));
}

static void test_transfers_that_come_back_late_are_waited_for(void **state)
{
    (void)state;
    struct hid_raw raw;
    stand_set_faults(&(struct stand_faults){ .cancel_ms = 150 });
    const uint32_t first = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    stand_unplug(first, STAND_QUIET);
    assert_int_equal(bench_take(&bench, 0, &raw), HAL_ERR_GONE);
    const uint32_t again = stand_plug(&own_poi, 1); /* While its former self is not closed yet. */
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(first).closes, 0);
    bench_say(again, 1);
    assert_int_equal(bench_take(&bench, 0, &raw), 1);
    for (uint32_t i = 0; i < 5000 && stand_seen(first).closes == 0; i++) {
        usleep(200);
    }
    assert_int_equal(stand_seen(first).closes, 1);
}

static void test_the_end_waits_for_all_that_flies(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .cancel_ms = 100, .hold_outs = 1 });
    const uint32_t poi = stand_plug(&own_poi, 1);
    const uint32_t other = stand_plug(&second_poi, 2);
    const struct hid_port port = usb_transport_port(bench.seats, 0);
    const uint8_t blow[] = { POI_FEEL_ID, 1 };
    assert_true(bench_open(&bench, 0, &face));
    assert_true(bench_open(&bench, 1, &face));
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(port.ops->send(port.self, blow, sizeof blow), HAL_OK);
    usleep(10000);
    usb_transport_stop(bench.seats);
    assert_int_equal(stand_seen(poi).closes, 1);
    assert_int_equal(stand_seen(poi).releases, 1);
    assert_int_equal(stand_seen(other).closes, 1);
    assert_int_equal(stand_end(), 0);
}

/* The last test of all: what the kernel never gave back is left to the end of the process. */
static int tear_down_what_is_left(void **state)
{
    (void)state;
    assert_true(bench_end(&bench) > 0);
    assert_int_equal(stand_breaches(), 0); /* Nothing was closed or freed under it. */
    return 0;
}

static void test_the_end_does_not_wait_for_ever(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .cancel_ms = 3600000 });
    stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    const uint64_t begin_ns = now_ns();
    usb_transport_stop(bench.seats);
    assert_in_range(now_ns() - begin_ns, 1000000000ull, 10000000000ull);
}

static void test_pulled_out_while_it_is_being_opened(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 200; i++) {
        const uint32_t poi = stand_plug(&bench_poi, 1);
        usleep(i % 40u * 10u);
        stand_unplug(poi, (enum stand_parting)(i % 2u));
    }
    stand_plug(&bench_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_pulled_out_at_each_of_a_thousand_reports_it_comes_back),
        BENCH(test_reports_still_on_the_wire_are_a_beginning_of_what_was_said),
        BENCH(test_a_lost_poi_has_its_row_while_it_is_away),
        BENCH(test_transfers_that_come_back_late_are_waited_for),
        BENCH(test_the_end_waits_for_all_that_flies),
        BENCH(test_pulled_out_while_it_is_being_opened),
        cmocka_unit_test_setup_teardown(test_the_end_does_not_wait_for_ever, set_up,
                                        tear_down_what_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
