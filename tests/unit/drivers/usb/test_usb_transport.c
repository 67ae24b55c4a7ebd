/* test_usb_transport.c -- tests which USB devices the transport opens as controllers, on a
 * simulated bus. */
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

static int choose(uint32_t row)
{
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    return device_list.ops->choose(device_list.self, row, true);
}

static int release(uint32_t row)
{
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    return device_list.ops->choose(device_list.self, row, false);
}

static const char *described(void)
{
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    return device_list.ops->describe(device_list.self);
}

/* ---- Opened devices ------------------------------------------------------------------------- */

static void test_a_kingyo_poi_of_any_vendor_is_opened(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 4);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(face.identity.vendor, 0xcafe);
    assert_string_equal(face.identity.name, "Poi");
    assert_string_equal(face.identity.serial, "A1");
    assert_string_equal(face.identity.port, "3-4");
    assert_true(poi_descriptor_is(face.descriptor, face.descriptor_size));
    assert_int_equal(usb_sim_seen(poi).claimed_interfaces, 1);
    assert_int_equal(usb_sim_seen(poi).set_idles, 1);
    /* The driver has read the descriptor from the device, because a kernel driver may change the
     * descriptor in /sys. */
    assert_int_equal(usb_sim_seen(poi).descriptor_reads, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_int_equal(fixture_row(&fixture, 0).slot, 0);
}

static void test_a_poi_that_is_connected_at_the_start_is_opened(void **state)
{
    (void)state;
    usb_sim_plug(&own_poi, 1);
    fixture_start(&fixture, NULL, 0);
    assert_true(fixture_open(&fixture, 0, &face));
}

static void test_the_test_id_of_pid_codes_is_opened_if_its_descriptor_matches(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&unbound_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(poi).descriptor_reads, 1);
}

static void test_a_foreign_device_with_the_test_id_is_released(void **state)
{
    (void)state;
    static const struct usb_sim_kind foreign = {
        .vendor = 0x1209,
        .product = 0x0001,
        .interface_count = 1,
        .interface = { JOYSTICK_INTERFACE },
    };
    fixture_start(&fixture, NULL, 0);
    const uint32_t device = usb_sim_plug(&foreign, 1);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(device).closes == 0; i++) {
        usleep(200);
    }
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(usb_sim_seen(device).releases, 1);
    assert_int_equal(usb_sim_seen(device).closes, 1);
    usleep(300000); /* If the transport retried, it would open the device again within 0.3 s. */
    assert_int_equal(usb_sim_seen(device).opens, 1);
}

static void test_an_unknown_device_is_not_opened_until_it_is_chosen(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    const uint32_t device = usb_sim_plug(&joystick, 2);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_string_equal(fixture_row(&fixture, 0).identity.name, "Joystick");
    assert_int_equal(usb_sim_seen(device).opens, 0);
    assert_int_equal(choose(0), HAL_OK);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(device).claimed_interfaces, 1);
    assert_int_equal(release(0), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(device).closes == 0; i++) {
        usleep(200);
    }
    assert_int_equal(usb_sim_seen(device).closes, 1);
    /* The interface was released, so the kernel's driver could be attached again. */
    assert_int_equal(usb_sim_seen(device).releases, 1);
}

static void test_a_device_that_is_chosen_again_waits_until_it_is_closed(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .cancel_ms = 50 });
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 2);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_int_equal(release(0), HAL_OK);
    assert_int_equal(choose(0), HAL_OK);
    for (uint32_t i = 0; i < 5000 && usb_sim_seen(poi).opens < 2; i++) {
        assert_int_not_equal(fixture_row(&fixture, 0).state, CONTROLLER_DENIED);
        usleep(200);
    }
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_int_equal(usb_sim_seen(poi).claims, 2);
}

static void test_a_choice_persists_over_a_restart(void **state)
{
    (void)state;
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&joystick, 2);
    usb_sim_plug(&own_poi, 3);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_ACTIVE));
    assert_int_equal(choose(0), HAL_OK);
    assert_int_equal(release(1), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_FREE));
    usb_transport_stop(fixture.thread);
    fixture_start(&fixture, NULL, 0);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_FREE));
}

static void test_an_unwritable_choice_is_reported_and_holds_until_the_restart(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    snprintf(fixture.choices, sizeof fixture.choices, "%s/no/usb.txt", fixture.folder);
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&joystick, 2);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_int_equal(fixture_message(&fixture, line), 1);
    assert_non_null(strstr(line, "no/usb.txt: cannot write: No such file"));
}

static void test_a_device_that_the_command_line_lists_is_opened(void **state)
{
    (void)state;
    struct usb_key keys[2];
    assert_int_equal(usb_key_read(&keys[0], "046d:c215"), 0);
    assert_int_equal(usb_key_read(&keys[1], "046a:0001"), 0);
    fixture_start(&fixture, keys, 2);
    usb_sim_plug(&joystick, 2);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    const uint32_t keys_device = usb_sim_plug(&keyboard, 3);
    /* A keyboard is excluded even if the operator has chosen it. */
    assert_true(fixture_wait_state(&fixture, 1, CONTROLLER_UNSUPPORTED));
    assert_int_equal(choose(1), HAL_ERR_ABSENT);
    usleep(200000);
    assert_int_equal(usb_sim_seen(keys_device).opens, 0);
    assert_int_equal(choose(5), HAL_ERR_ABSENT);
}

static void test_only_the_controller_interface_is_claimed(void **state)
{
    (void)state;
    static const struct usb_sim_kind pad = {
        .vendor = 0x054c,
        .product = 0x09cc,
        .name = "Pad",
        .is_bound = 1,
        .interface_count = 4,
        .interface = { VENDOR_INTERFACE,
                       KEYBOARD_INTERFACE,
                       JOYSTICK_INTERFACE,
                       { .class = LIBUSB_CLASS_AUDIO } },
    };
    fixture_start(&fixture, NULL, 0);
    const uint32_t device = usb_sim_plug(&pad, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(device).claimed_interfaces, 1u << 2);
    assert_int_equal(face.identity.interface_number, 2);
}

static void test_a_boot_mouse_is_switched_to_the_report_protocol(void **state)
{
    (void)state;
    static const struct usb_sim_kind mouse = {
        .vendor = 0x046d,
        .product = 0xc077,
        .is_bound = 1,
        .interface_count = 1,
        .interface = { { .class = LIBUSB_CLASS_HID,
                         .subclass = 1,
                         .protocol = 2,
                         .packet_size = 8,
                         .descriptor = joystick_descriptor,
                         .descriptor_size = sizeof joystick_descriptor } },
    };
    fixture_start(&fixture, NULL, 0);
    const uint32_t device = usb_sim_plug(&mouse, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(usb_sim_seen(device).set_protocols, 1);
}

static void test_a_device_that_stalls_class_requests_is_opened(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .stalls_requests = 1 });
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
}

static void test_without_get_descriptor_the_descriptor_in_sys_is_used(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .hides_descriptor = 1 });
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_true(poi_descriptor_is(face.descriptor, face.descriptor_size));
}

static void test_a_device_that_proves_to_be_a_keyboard_is_opened_once(void **state)
{
    (void)state;
    static const struct usb_sim_kind disguised = {
        .vendor = 0x1111,
        .product = 0x2222,
        .name = "Mended keyboard",
        .is_bound = 1,
        .interface_count = 1,
        .interface = { { .class = LIBUSB_CLASS_HID,
                         .packet_size = 8,
                         .descriptor = keyboard_descriptor,
                         .descriptor_size = sizeof keyboard_descriptor,
                         .mended = joystick_descriptor,
                         .mended_size = sizeof joystick_descriptor } },
    };
    fixture_start(&fixture, NULL, 0);
    const uint32_t device = usb_sim_plug(&disguised, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_UNSUPPORTED));
    usleep(300000);
    assert_int_equal(usb_sim_seen(device).opens, 1);
    assert_int_equal(usb_sim_seen(device).closes, 1);
}

static void test_a_device_that_is_announced_unconfigured_is_opened_later(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .is_unconfigured = 1 });
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&own_poi, 1);
    usleep(50000);
    assert_int_equal(fixture_row(&fixture, 0).state, CONTROLLER_NONE);
    /* The bus sends no event when the device gets a configuration. The transport must therefore
     * poll the device. */
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
    assert_true(fixture_open(&fixture, 0, &face));
}

static void test_without_hot_plug_events_the_bus_is_polled(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .no_hotplug = 1 });
    fixture_start(&fixture, NULL, 0);
    usleep(2100000); /* Waits until the more frequent polling after the start, which lasts 2 s, has
                        ended. */
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_non_null(strstr(described(), "no hot-plug"));
}

/* ---- Access errors -------------------------------------------------------------------------- */

static void test_a_denied_device_is_reported_with_the_udev_rule_file(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE];
    usb_sim_set_faults(&(struct usb_sim_faults){ .open_error = LIBUSB_ERROR_ACCESS });
    fixture_start(&fixture, NULL, 0);
    usb_sim_plug(&own_poi, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_DENIED));
    assert_non_null(strstr(described(), "cafe:0b01 at USB port 3-1"));
    assert_non_null(strstr(described(), "70-kingyo.rules"));
    /* The error message must be reported only once, although the transport retries. */
    assert_int_equal(fixture_message(&fixture, line), 1);
    assert_string_equal(line, described());
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
    /* A retry opens the device, although there was no new hot-plug event. */
    assert_true(fixture_open(&fixture, 0, &face));
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
    assert_null(strstr(described(), "rules"));
    assert_int_equal(fixture_message(&fixture, line), 1);
}

static void test_a_busy_device_is_reported(void **state)
{
    (void)state;
    usb_sim_set_faults(&(struct usb_sim_faults){ .claim_error = LIBUSB_ERROR_BUSY });
    fixture_start(&fixture, NULL, 0);
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_DENIED));
    assert_non_null(strstr(described(), "another program"));
    assert_int_equal(usb_sim_seen(poi).closes, usb_sim_seen(poi).opens);
}

static void test_without_libusb_every_port_returns_absent(void **state)
{
    (void)state;
    struct hid_raw raw;
    usb_sim_set_faults(&(struct usb_sim_faults){ .init_error = LIBUSB_ERROR_OTHER });
    fixture_start(&fixture, NULL, 0);
    assert_non_null(strstr(fixture.why, "no USB"));
    struct hid_port *const port = usb_transport_port(fixture.thread, 0);
    assert_int_equal(hid_port_open(port, &face), HAL_ERR_ABSENT);
    assert_int_equal(hid_port_take(port, &raw), HAL_ERR_ABSENT);
    assert_int_equal(fixture_row(&fixture, 0).state, CONTROLLER_NONE);
    assert_string_equal(described(), fixture.why);
}

static void test_an_invalid_line_is_reported_and_the_others_are_applied(void **state)
{
    (void)state;
    FILE *file = fopen(fixture.choices, "w");
    assert_non_null(file);
    fputs("# by hand\nplays 046d:c215:J7\nplays 46d\n", file);
    fclose(file);
    fixture_start(&fixture, NULL, 0);
    assert_non_null(strstr(fixture.why, "usb.txt:3: '46d'"));
    usb_sim_plug(&joystick, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
}

int main(void)
{
#define WITH_BUS(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        WITH_BUS(test_a_kingyo_poi_of_any_vendor_is_opened),
        WITH_BUS(test_a_poi_that_is_connected_at_the_start_is_opened),
        WITH_BUS(test_the_test_id_of_pid_codes_is_opened_if_its_descriptor_matches),
        WITH_BUS(test_a_foreign_device_with_the_test_id_is_released),
        WITH_BUS(test_an_unknown_device_is_not_opened_until_it_is_chosen),
        WITH_BUS(test_a_device_that_is_chosen_again_waits_until_it_is_closed),
        WITH_BUS(test_a_choice_persists_over_a_restart),
        WITH_BUS(test_an_unwritable_choice_is_reported_and_holds_until_the_restart),
        WITH_BUS(test_a_device_that_the_command_line_lists_is_opened),
        WITH_BUS(test_only_the_controller_interface_is_claimed),
        WITH_BUS(test_a_boot_mouse_is_switched_to_the_report_protocol),
        WITH_BUS(test_a_device_that_stalls_class_requests_is_opened),
        WITH_BUS(test_without_get_descriptor_the_descriptor_in_sys_is_used),
        WITH_BUS(test_a_device_that_proves_to_be_a_keyboard_is_opened_once),
        WITH_BUS(test_a_device_that_is_announced_unconfigured_is_opened_later),
        WITH_BUS(test_without_hot_plug_events_the_bus_is_polled),
        WITH_BUS(test_a_denied_device_is_reported_with_the_udev_rule_file),
        WITH_BUS(test_a_busy_device_is_reported),
        WITH_BUS(test_without_libusb_every_port_returns_absent),
        WITH_BUS(test_an_invalid_line_is_reported_and_the_others_are_applied),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
