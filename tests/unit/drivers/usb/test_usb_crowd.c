/* test_usb_crowd.c -- four seats and more controllers than that; buses that do not hold still. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb_kinds.h"

static struct usb_bench bench;
static struct hid_device_info face;
static struct stand_kind kinds[12]; /* Pois with a serial number each. */
static char serials[12][4];

static int set_up(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 12; i++) {
        snprintf(serials[i], sizeof serials[i], "S%u", i);
        kinds[i] = own_poi;
        kinds[i].serial = serials[i];
    }
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

static int sits(uint32_t seat, const char *serial)
{
    for (uint32_t i = 0; i < 25000; i++) {
        const struct hid_port port = usb_transport_port(bench.seats, seat);
        if (port.ops->open(port.self, &face) == HAL_OK && !strcmp(face.identity.serial, serial)) {
            return 1;
        }
        usleep(200);
    }
    return 0;
}

static void test_four_play_and_the_fifth_waits_for_a_seat(void **state)
{
    (void)state;
    uint32_t device[5];
    for (uint8_t i = 0; i < 5; i++) {
        device[i] = stand_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(i == 4 || sits(i, serials[i]));
    }
    assert_true(bench_until(&bench, 4, CONTROLLER_FREE));
    assert_int_equal(stand_seen(device[4]).opens, 0);
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    assert_int_equal(device_list.ops->choose(device_list.self, 4), HAL_ERR_BUSY);
    stand_unplug(device[2], STAND_GONE); /* For a moment only: its seat is kept. */
    assert_true(bench_until(&bench, 2, CONTROLLER_LOST));
    usleep(100000);
    assert_int_equal(bench_row(&bench, 4).state, CONTROLLER_FREE);
    stand_plug(&kinds[2], 9);
    assert_true(sits(2, "S2"));
    assert_int_equal(device_list.ops->release(device_list.self, 1), HAL_OK); /* Now there is one. */
    assert_true(sits(1, "S4"));
    assert_true(bench_until(&bench, 4, CONTROLLER_ACTIVE));
    assert_int_equal(bench_row(&bench, 4).seat, 1);
}

static void test_all_four_come_back_to_their_seats_in_any_order(void **state)
{
    (void)state;
    static const uint8_t order[] = { 2, 0, 3, 1 };
    uint32_t device[4];
    for (uint8_t i = 0; i < 4; i++) {
        device[i] = stand_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(sits(i, serials[i]));
    }
    for (uint32_t i = 0; i < 4; i++) {
        stand_unplug(device[i], (enum stand_parting)(i % 2u)); /* The hub's own cable. */
    }
    for (uint32_t i = 0; i < 4; i++) {
        stand_plug(&kinds[order[i]], (uint8_t)(i + 5u));
    }
    for (uint32_t i = 0; i < 4; i++) {
        assert_true(sits(i, serials[i]));
        assert_true(bench_until(&bench, i, CONTROLLER_ACTIVE));
    }
}

static void test_without_serial_numbers_the_ports_say_who_is_who(void **state)
{
    (void)state;
    const uint32_t left = stand_plug(&plain_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    const uint32_t right = stand_plug(&plain_poi, 2);
    assert_true(bench_open(&bench, 1, &face));
    stand_unplug(left, STAND_GONE);
    stand_unplug(right, STAND_GONE);
    assert_true(bench_until(&bench, 0, CONTROLLER_LOST));
    assert_true(bench_until(&bench, 1, CONTROLLER_LOST));
    stand_plug(&plain_poi, 2);
    assert_true(bench_open(&bench, 1, &face));
    assert_string_equal(face.identity.port, "3-2");
    stand_plug(&plain_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    assert_string_equal(face.identity.port, "3-1");
}

static void test_more_than_eight_have_rows_enough_for_those_that_play(void **state)
{
    (void)state;
    for (uint8_t i = 0; i < 6; i++) {
        stand_plug(&keyboard, (uint8_t)(i + 20u));
    }
    assert_true(bench_until(&bench, 3, CONTROLLER_UNSUPPORTED));
    for (uint8_t i = 0; i < 4; i++) {
        stand_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(sits(i, serials[i]));
    }
    uint32_t playing = 0;
    for (uint32_t tries = 0; tries < 5000 && playing < 4; tries++) {
        usleep(200);
        playing = 0;
        for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
            playing += bench_row(&bench, i).state == CONTROLLER_ACTIVE;
        }
    }
    assert_int_equal(playing, 4);
}

static void test_a_poi_is_seen_among_more_keyboards_than_we_watch(void **state)
{
    (void)state;
    for (uint8_t i = 0; i < 20; i++) {
        stand_plug(&keyboard, (uint8_t)(i + 20u));
    }
    assert_true(bench_until(&bench, 3, CONTROLLER_UNSUPPORTED));
    for (uint8_t i = 0; i < 4; i++) {
        stand_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(sits(i, serials[i]));
    }
}

/* ---- Storms --------------------------------------------------------------------------------- */

#define STORM_ROUNDS 100u

static atomic_int storm_is_over;

/* A child at the hub: every device in and out, reporting while it can. */
static void *storm(void *self)
{
    uint32_t device[8];
    (void)self;
    for (uint32_t round = 0; round < STORM_ROUNDS; round++) {
        for (uint32_t i = 0; i < 8; i++) {
            device[i] = stand_plug(i == 7 ? &keyboard : &kinds[i], (uint8_t)(i + 1u));
            bench_say(device[i], round);
        }
        usleep(round % 7u * 300u);
        for (uint32_t i = 0; i < 8; i++) {
            bench_say(device[i], round);
            stand_unplug(device[i], (enum stand_parting)((round + i) % 4u));
            if ((round + i) % 4u == STAND_LATE) {
                stand_announce(device[i]);
            }
        }
    }
    atomic_store(&storm_is_over, 1);
    return NULL;
}

static void test_a_storm_of_hot_plugs_ends_with_everybody_in_a_seat(void **state)
{
    (void)state;
    pthread_t thread;
    struct hid_raw raw;
    struct hid_row rows[CONTROLLER_MAX];
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    uint32_t order = 0, device[POI_MAX];
    for (uint8_t i = 0; i < POI_MAX; i++) { /* Each slot is then kept for its poi. */
        device[i] = stand_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(sits(i, serials[i]));
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        stand_unplug(device[i], STAND_GONE);
    }
    atomic_store(&storm_is_over, 0);
    stand_set_faults(&(struct stand_faults){ .close_ms = 1, .cancel_ms = 2 });
    assert_int_equal(pthread_create(&thread, NULL, storm, NULL), 0);
    while (!atomic_load(&storm_is_over)) { /* The kiosk plays on meanwhile. */
        for (uint32_t i = 0; i < POI_MAX; i++) {
            const struct hid_port port = usb_transport_port(bench.seats, i);
            while (port.ops->take(port.self, &raw) == 1) {
            }
            port.ops->open(port.self, &face);
            port.ops->send(port.self, (const uint8_t *)"\2\1", 2);
        }
        device_list.ops->rows(device_list.self, rows);
        device_list.ops->choose(device_list.self, order++ % CONTROLLER_MAX);
        usleep(500);
    }
    pthread_join(thread, NULL);
    stand_set_faults(&(struct stand_faults){ 0 });
    for (uint8_t i = 0; i < 4; i++) {
        stand_plug(&kinds[i], (uint8_t)(i + 1u));
    }
    for (uint32_t seat = 0; seat < POI_MAX; seat++) {
        assert_true(sits(seat, serials[seat]));
    }
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_four_play_and_the_fifth_waits_for_a_seat),
        BENCH(test_all_four_come_back_to_their_seats_in_any_order),
        BENCH(test_without_serial_numbers_the_ports_say_who_is_who),
        BENCH(test_more_than_eight_have_rows_enough_for_those_that_play),
        BENCH(test_a_poi_is_seen_among_more_keyboards_than_we_watch),
        BENCH(test_a_storm_of_hot_plugs_ends_with_everybody_in_a_seat),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
