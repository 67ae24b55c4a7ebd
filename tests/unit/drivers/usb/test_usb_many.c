/* test_usb_many.c -- tests four player slots with more USB devices than slots, and with frequent
 * hot-plug events. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb/usb_fixture.h"

static struct usb_fixture fixture;
static struct hid_device_info face;
/* Twelve pois, each with its own serial number. */
static struct usb_sim_kind kinds[12];
static char serials[12][4];

static int set_up(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 12; i++) {
        snprintf(serials[i], sizeof serials[i], "S%u", i);
        kinds[i] = own_poi;
        kinds[i].serial = serials[i];
    }
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

static int slot_has(uint32_t slot, const char *serial)
{
    for (uint32_t i = 0; i < 25000; i++) {
        struct hid_port *const port = usb_transport_port(fixture.thread, slot);
        if (hid_port_open(port, &face) == HAL_OK && !strcmp(face.identity.serial, serial)) {
            return 1;
        }
        usleep(200);
    }
    return 0;
}

static void test_four_devices_get_slots_and_a_fifth_waits(void **state)
{
    (void)state;
    uint32_t device[5];
    for (uint8_t i = 0; i < 5; i++) {
        device[i] = usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(i == 4 || slot_has(i, serials[i]));
    }
    assert_true(fixture_wait_state(&fixture, 4, CONTROLLER_FREE));
    assert_int_equal(usb_sim_seen(device[4]).opens, 0);
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    assert_int_equal(device_list.ops->choose(device_list.self, 4, true), HAL_ERR_BUSY);
    /* The device has only just been lost, so its slot is still reserved. */
    usb_sim_unplug(device[2], USB_SIM_GONE);
    assert_true(fixture_wait_state(&fixture, 2, CONTROLLER_LOST));
    usleep(100000);
    assert_int_equal(fixture_row(&fixture, 4).state, CONTROLLER_FREE);
    usb_sim_plug(&kinds[2], 9);
    assert_true(slot_has(2, "S2"));
    /* The operator releases the device of slot 1. A poi that waits for a slot must get slot 1. */
    assert_int_equal(device_list.ops->choose(device_list.self, 1, false), HAL_OK);
    assert_true(slot_has(1, "S4"));
    assert_true(fixture_wait_state(&fixture, 4, CONTROLLER_ACTIVE));
    assert_int_equal(fixture_row(&fixture, 4).slot, 1);
}

static void test_four_devices_return_to_their_slots_in_any_order(void **state)
{
    (void)state;
    static const uint8_t order[] = { 2, 0, 3, 1 };
    uint32_t device[4];
    for (uint8_t i = 0; i < 4; i++) {
        device[i] = usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(slot_has(i, serials[i]));
    }
    for (uint32_t i = 0; i < 4; i++) {
        /* All devices of the hub are unplugged together, as when the hub itself is unplugged. */
        usb_sim_unplug(device[i], (enum usb_sim_unplug_order)(i % 2u));
    }
    for (uint32_t i = 0; i < 4; i++) {
        usb_sim_plug(&kinds[order[i]], (uint8_t)(i + 5u));
    }
    for (uint32_t i = 0; i < 4; i++) {
        assert_true(slot_has(i, serials[i]));
        assert_true(fixture_wait_state(&fixture, i, CONTROLLER_ACTIVE));
    }
}

static void test_devices_without_serial_numbers_are_identified_by_port(void **state)
{
    (void)state;
    const uint32_t left = usb_sim_plug(&plain_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    const uint32_t right = usb_sim_plug(&plain_poi, 2);
    assert_true(fixture_open(&fixture, 1, &face));
    usb_sim_unplug(left, USB_SIM_GONE);
    usb_sim_unplug(right, USB_SIM_GONE);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_LOST));
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_LOST));
    usb_sim_plug(&plain_poi, 2);
    assert_true(fixture_open(&fixture, 1, &face));
    assert_string_equal(face.identity.port, "3-2");
    usb_sim_plug(&plain_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_string_equal(face.identity.port, "3-1");
}

static void test_with_more_than_eight_devices_every_opened_one_has_a_row(void **state)
{
    (void)state;
    for (uint8_t i = 0; i < 6; i++) {
        usb_sim_plug(&keyboard, (uint8_t)(i + 20u));
    }
    assert_true(fixture_wait_state(&fixture, 3, CONTROLLER_UNSUPPORTED));
    for (uint8_t i = 0; i < 4; i++) {
        usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(slot_has(i, serials[i]));
    }
    uint32_t playing = 0;
    for (uint32_t tries = 0; tries < 5000 && playing < 4; tries++) {
        usleep(200);
        playing = 0;
        for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
            playing += fixture_row(&fixture, i).state == CONTROLLER_ACTIVE;
        }
    }
    assert_int_equal(playing, 4);
}

static void test_a_poi_is_opened_beside_more_keyboards_than_the_list_holds(void **state)
{
    (void)state;
    for (uint8_t i = 0; i < 20; i++) {
        usb_sim_plug(&keyboard, (uint8_t)(i + 20u));
    }
    assert_true(fixture_wait_state(&fixture, 3, CONTROLLER_UNSUPPORTED));
    for (uint8_t i = 0; i < 4; i++) {
        usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(slot_has(i, serials[i]));
    }
}

/* ---- Hot-plug storms ------------------------------------------------------------------------ */

#define STORM_ROUNDS 100u

static atomic_int storm_is_over;

/* Runs in a thread of its own. Plugs the eight devices of a hub in and out again and again, with
 * varying pauses and varying orders of the bus events. Sends reports in between. */
static void *storm(void *self)
{
    uint32_t device[8];
    (void)self;
    for (uint32_t round = 0; round < STORM_ROUNDS; round++) {
        for (uint32_t i = 0; i < 8; i++) {
            device[i] = usb_sim_plug(i == 7 ? &keyboard : &kinds[i], (uint8_t)(i + 1u));
            fixture_send(device[i], round);
        }
        usleep(round % 7u * 300u);
        for (uint32_t i = 0; i < 8; i++) {
            fixture_send(device[i], round);
            usb_sim_unplug(device[i], (enum usb_sim_unplug_order)((round + i) % 4u));
            if ((round + i) % 4u == USB_SIM_LATE) {
                usb_sim_announce(device[i]);
            }
        }
    }
    atomic_store(&storm_is_over, 1);
    return NULL;
}

static void test_all_devices_have_slots_after_a_hot_plug_storm(void **state)
{
    (void)state;
    pthread_t thread;
    struct hid_raw raw;
    struct hid_row rows[CONTROLLER_MAX];
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    uint32_t order = 0, device[POI_MAX];
    /* Plugs in a poi for each player slot, so that every slot is reserved for a certain poi. */
    for (uint8_t i = 0; i < POI_MAX; i++) {
        device[i] = usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
        assert_true(slot_has(i, serials[i]));
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        usb_sim_unplug(device[i], USB_SIM_GONE);
    }
    atomic_store(&storm_is_over, 0);
    usb_sim_set_faults(&(struct usb_sim_faults){ .close_ms = 1, .cancel_ms = 2 });
    assert_int_equal(pthread_create(&thread, NULL, storm, NULL), 0);
    /* This loop replaces the kiosk's frame loop, while the thread of storm() plugs devices in and
     * out. */
    while (!atomic_load(&storm_is_over)) {
        for (uint32_t i = 0; i < POI_MAX; i++) {
            struct hid_port *const port = usb_transport_port(fixture.thread, i);
            while (hid_port_take(port, &raw) == 1) {
            }
            hid_port_open(port, &face);
            hid_port_send(port, (const uint8_t *)"\2\1", 2);
        }
        device_list.ops->rows(device_list.self, rows);
        device_list.ops->choose(device_list.self, order++ % CONTROLLER_MAX, true);
        usleep(500);
    }
    pthread_join(thread, NULL);
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
    for (uint8_t i = 0; i < 4; i++) {
        usb_sim_plug(&kinds[i], (uint8_t)(i + 1u));
    }
    for (uint32_t slot = 0; slot < POI_MAX; slot++) {
        assert_true(slot_has(slot, serials[slot]));
    }
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_four_devices_get_slots_and_a_fifth_waits),
        BENCH(test_four_devices_return_to_their_slots_in_any_order),
        BENCH(test_devices_without_serial_numbers_are_identified_by_port),
        BENCH(test_with_more_than_eight_devices_every_opened_one_has_a_row),
        BENCH(test_a_poi_is_opened_beside_more_keyboards_than_the_list_holds),
        BENCH(test_all_devices_have_slots_after_a_hot_plug_storm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
