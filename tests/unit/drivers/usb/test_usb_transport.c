/* test_usb_transport.c -- who may play on USB, and who may not, over a bus of memory. */
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

static int choose(uint32_t row)
{
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    return device_list.ops->choose(device_list.self, row);
}

static int release(uint32_t row)
{
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    return device_list.ops->release(device_list.self, row);
}

static const char *described(void)
{
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    return device_list.ops->describe(device_list.self);
}

/* ---- Who plays ------------------------------------------------------------------------------ */

static void test_our_own_poi_plays_whoever_made_it(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 4);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(face.identity.vendor, 0xcafe);
    assert_string_equal(face.identity.name, "Poi");
    assert_string_equal(face.identity.serial, "A1");
    assert_string_equal(face.identity.port, "3-4");
    assert_true(poi_descriptor_is(face.descriptor, face.descriptor_size));
    assert_int_equal(stand_seen(poi).claimed_interfaces, 1);
    assert_int_equal(stand_seen(poi).set_idles, 1);
    assert_int_equal(stand_seen(poi).descriptor_reads, 1); /* A driver may have mended /sys'. */
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_int_equal(bench_row(&bench, 0).seat, 0);
}

static void test_a_poi_that_was_there_before_the_kiosk_plays(void **state)
{
    (void)state;
    stand_plug(&own_poi, 1);
    bench_start(&bench, NULL, 0);
    assert_true(bench_open(&bench, 0, &face));
}

static void test_the_bench_id_is_asked_for_its_descriptor_and_plays_by_it(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&bench_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(poi).descriptor_reads, 1);
}

static void test_somebody_elses_device_under_the_bench_id_is_given_back(void **state)
{
    (void)state;
    static const struct stand_kind foreign = {
        .vendor = 0x1209,
        .product = 0x0001,
        .interface_count = 1,
        .interface = { JOYSTICK_INTERFACE },
    };
    bench_start(&bench, NULL, 0);
    const uint32_t device = stand_plug(&foreign, 1);
    for (uint32_t i = 0; i < 5000 && stand_seen(device).closes == 0; i++) {
        usleep(200);
    }
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(stand_seen(device).releases, 1);
    assert_int_equal(stand_seen(device).closes, 1);
    usleep(300000); /* It is not asked again and again. */
    assert_int_equal(stand_seen(device).opens, 1);
}

static void test_a_stranger_is_not_touched_until_it_is_chosen(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    const uint32_t device = stand_plug(&joystick, 2);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_string_equal(bench_row(&bench, 0).identity.name, "Joystick");
    assert_int_equal(stand_seen(device).opens, 0);
    assert_int_equal(choose(0), HAL_OK);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(device).claimed_interfaces, 1);
    assert_int_equal(release(0), HAL_OK);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    for (uint32_t i = 0; i < 5000 && stand_seen(device).closes == 0; i++) {
        usleep(200);
    }
    assert_int_equal(stand_seen(device).closes, 1);
    assert_int_equal(stand_seen(device).releases, 1); /* The kernel's driver has it again. */
}

static void test_one_chosen_anew_waits_until_it_was_closed(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .cancel_ms = 50 });
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 2);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_int_equal(release(0), HAL_OK);
    assert_int_equal(choose(0), HAL_OK);
    for (uint32_t i = 0; i < 5000 && stand_seen(poi).opens < 2; i++) {
        assert_int_not_equal(bench_row(&bench, 0).state, CONTROLLER_DENIED);
        usleep(200);
    }
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_int_equal(stand_seen(poi).claims, 2);
}

static void test_a_choice_outlives_the_kiosk(void **state)
{
    (void)state;
    bench_start(&bench, NULL, 0);
    stand_plug(&joystick, 2);
    stand_plug(&own_poi, 3);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_true(bench_until(&bench, 1, CONTROLLER_ACTIVE));
    assert_int_equal(choose(0), HAL_OK);
    assert_int_equal(release(1), HAL_OK);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_true(bench_until(&bench, 1, CONTROLLER_FREE));
    usb_transport_stop(bench.seats);
    bench_start(&bench, NULL, 0);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_true(bench_until(&bench, 1, CONTROLLER_FREE));
}

static void test_a_choice_that_cannot_be_kept_is_told_and_holds_for_today(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    snprintf(bench.choices, sizeof bench.choices, "%s/no/usb.txt", bench.folder);
    bench_start(&bench, NULL, 0);
    stand_plug(&joystick, 2);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_int_equal(bench_told(&bench, line), 1);
    assert_non_null(strstr(line, "no/usb.txt: cannot write: No such file"));
}

static void test_what_the_command_line_lists_plays(void **state)
{
    (void)state;
    struct usb_key keys[2];
    assert_int_equal(usb_key_read(&keys[0], "046d:c215"), 0);
    assert_int_equal(usb_key_read(&keys[1], "046a:0001"), 0);
    bench_start(&bench, keys, 2);
    stand_plug(&joystick, 2);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    const uint32_t keys_device = stand_plug(&keyboard, 3);
    assert_true(bench_until(&bench, 1, CONTROLLER_UNSUPPORTED)); /* A keyboard, whoever names it. */
    assert_int_equal(choose(1), HAL_ERR_ABSENT);
    usleep(200000);
    assert_int_equal(stand_seen(keys_device).opens, 0);
    assert_int_equal(choose(5), HAL_ERR_ABSENT);
}

static void test_other_interfaces_are_left_alone(void **state)
{
    (void)state;
    static const struct stand_kind pad = {
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
    bench_start(&bench, NULL, 0);
    const uint32_t device = stand_plug(&pad, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(device).claimed_interfaces, 1u << 2);
    assert_int_equal(face.identity.interface_number, 2);
}

static void test_a_boot_mouse_is_told_to_speak_in_reports(void **state)
{
    (void)state;
    static const struct stand_kind mouse = {
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
    bench_start(&bench, NULL, 0);
    const uint32_t device = stand_plug(&mouse, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(stand_seen(device).set_protocols, 1);
}

static void test_what_knows_no_requests_plays_all_the_same(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .stalls_requests = 1 });
    bench_start(&bench, NULL, 0);
    stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
}

static void test_one_that_hides_its_descriptor_plays_by_what_the_kernel_read(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .hides_descriptor = 1 });
    bench_start(&bench, NULL, 0);
    stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    assert_true(poi_descriptor_is(face.descriptor, face.descriptor_size));
}

static void test_one_that_is_no_hand_after_all_is_asked_once(void **state)
{
    (void)state;
    static const struct stand_kind disguised = {
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
    bench_start(&bench, NULL, 0);
    const uint32_t device = stand_plug(&disguised, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(choose(0), HAL_OK);
    assert_true(bench_until(&bench, 0, CONTROLLER_UNSUPPORTED));
    usleep(300000);
    assert_int_equal(stand_seen(device).opens, 1);
    assert_int_equal(stand_seen(device).closes, 1);
}

static void test_one_that_is_announced_before_it_is_configured_is_not_overlooked(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .is_unconfigured = 1 });
    bench_start(&bench, NULL, 0);
    stand_plug(&own_poi, 1);
    usleep(50000);
    assert_int_equal(bench_row(&bench, 0).state, CONTROLLER_NONE);
    stand_set_faults(&(struct stand_faults){ 0 }); /* Nothing is said of that on the bus. */
    assert_true(bench_open(&bench, 0, &face));
}

static void test_without_hot_plug_the_bus_is_looked_at_now_and_then(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .no_hotplug = 1 });
    bench_start(&bench, NULL, 0);
    usleep(2100000); /* The bus has settled, as far as anybody can know. */
    stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    assert_non_null(strstr(described(), "no hot-plug"));
}

/* ---- In the way ----------------------------------------------------------------------------- */

static void test_a_poi_that_may_not_be_opened_names_the_rule_that_lets_it(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE];
    stand_set_faults(&(struct stand_faults){ .open_error = LIBUSB_ERROR_ACCESS });
    bench_start(&bench, NULL, 0);
    stand_plug(&own_poi, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_DENIED));
    assert_non_null(strstr(described(), "cafe:0b01 at USB port 3-1"));
    assert_non_null(strstr(described(), "70-kingyo.rules"));
    assert_int_equal(bench_told(&bench, line), 1); /* Once, however often it is tried. */
    assert_string_equal(line, described());
    stand_set_faults(&(struct stand_faults){ 0 });
    assert_true(bench_open(&bench, 0, &face)); /* Found out without a replug. */
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
    assert_null(strstr(described(), "rules"));
    assert_int_equal(bench_told(&bench, line), 1);
}

static void test_a_poi_that_another_program_holds_says_so(void **state)
{
    (void)state;
    stand_set_faults(&(struct stand_faults){ .claim_error = LIBUSB_ERROR_BUSY });
    bench_start(&bench, NULL, 0);
    const uint32_t poi = stand_plug(&own_poi, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_DENIED));
    assert_non_null(strstr(described(), "another program"));
    assert_int_equal(stand_seen(poi).closes, stand_seen(poi).opens);
}

static void test_without_usb_nobody_ever_comes(void **state)
{
    (void)state;
    struct hid_raw raw;
    stand_set_faults(&(struct stand_faults){ .init_error = LIBUSB_ERROR_OTHER });
    bench_start(&bench, NULL, 0);
    assert_non_null(strstr(bench.why, "no USB"));
    const struct hid_port port = usb_transport_port(bench.seats, 0);
    assert_int_equal(port.ops->open(port.self, &face), HAL_ERR_ABSENT);
    assert_int_equal(port.ops->take(port.self, &raw), HAL_ERR_ABSENT);
    assert_int_equal(bench_row(&bench, 0).state, CONTROLLER_NONE);
    assert_string_equal(described(), bench.why);
}

static void test_a_bad_line_of_the_file_is_told_and_the_others_count(void **state)
{
    (void)state;
    FILE *file = fopen(bench.choices, "w");
    assert_non_null(file);
    fputs("# by hand\nplays 046d:c215:J7\nplays 46d\n", file);
    fclose(file);
    bench_start(&bench, NULL, 0);
    assert_non_null(strstr(bench.why, "usb.txt:3: '46d'"));
    stand_plug(&joystick, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_our_own_poi_plays_whoever_made_it),
        BENCH(test_a_poi_that_was_there_before_the_kiosk_plays),
        BENCH(test_the_bench_id_is_asked_for_its_descriptor_and_plays_by_it),
        BENCH(test_somebody_elses_device_under_the_bench_id_is_given_back),
        BENCH(test_a_stranger_is_not_touched_until_it_is_chosen),
        BENCH(test_one_chosen_anew_waits_until_it_was_closed),
        BENCH(test_a_choice_outlives_the_kiosk),
        BENCH(test_a_choice_that_cannot_be_kept_is_told_and_holds_for_today),
        BENCH(test_what_the_command_line_lists_plays),
        BENCH(test_other_interfaces_are_left_alone),
        BENCH(test_a_boot_mouse_is_told_to_speak_in_reports),
        BENCH(test_what_knows_no_requests_plays_all_the_same),
        BENCH(test_one_that_hides_its_descriptor_plays_by_what_the_kernel_read),
        BENCH(test_one_that_is_no_hand_after_all_is_asked_once),
        BENCH(test_one_that_is_announced_before_it_is_configured_is_not_overlooked),
        BENCH(test_without_hot_plug_the_bus_is_looked_at_now_and_then),
        BENCH(test_a_poi_that_may_not_be_opened_names_the_rule_that_lets_it),
        BENCH(test_a_poi_that_another_program_holds_says_so),
        BENCH(test_without_usb_nobody_ever_comes),
        BENCH(test_a_bad_line_of_the_file_is_told_and_the_others_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
