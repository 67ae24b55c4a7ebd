/* test_hid_live.c -- Tests how kingyoctl shows the values of a live HID device, and the list of
 * plugged-in devices. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "platform/ctl/devices/hid_live.h"
#include "platform/ctl/devices/hid_rows.h"
#include "platform/ctl/devices/hid_source.h"

#define SECOND 1000000000ull

/* Report descriptor of a device with a mouse of five buttons (report id 1), and a hat switch and
 * keys (report id 2). */
static const uint8_t bytes[] = { 0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x01, 0x05, 0x09, 0x19,
                                 0x01, 0x29, 0x05, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x05,
                                 0x81, 0x02, 0x75, 0x03, 0x95, 0x01, 0x81, 0x01, 0x05, 0x01, 0x09,
                                 0x30, 0x09, 0x31, 0x15, 0x81, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02,
                                 0x81, 0x06, 0x85, 0x02, 0x09, 0x39, 0x15, 0x00, 0x25, 0x07, 0x95,
                                 0x01, 0x81, 0x42, 0x05, 0x07, 0x19, 0x00, 0x29, 0x65, 0x15, 0x00,
                                 0x25, 0x65, 0x95, 0x02, 0x81, 0x00, 0xc0 };

static struct hid_descriptor descriptor;
static struct hid_live live;
static char text[HID_LIVE_TEXT];

static int begin(void **state)
{
    (void)state;
    assert_int_equal(hid_descriptor_read(&descriptor, bytes, sizeof bytes), HID_OK);
    hid_live_begin(&live, &descriptor, "/dev/hidraw0");
    return 0;
}

static void send(uint64_t time_ns, const uint8_t *report, size_t size)
{
    hid_live_report(&live, (struct hid_report){ report, size }, time_ns);
}

#define SEND(time_ns, ...)                                                                         \
    send((time_ns), (const uint8_t[]){ __VA_ARGS__ }, sizeof((const uint8_t[]){ __VA_ARGS__ }))

static const char *picture(uint32_t width, uint32_t height)
{
    const size_t length = hid_live_picture(&live, width, height, text);
    assert_int_equal(length, strlen(text));
    return text;
}

static void test_every_row_exists_without_a_value_before_the_first_report(void **state)
{
    (void)state;
    assert_string_equal(picture(44, 24), "/dev/hidraw0\n"
                                         "0 reports, 0 in the last second\n"
                                         "  1 button 1 .. button 5: \n"
                                         "  1 X                               -\n"
                                         "  1 Y                               -\n"
                                         "  2 hat                             -\n"
                                         "  2 key 00 .. key 65: \n");
}

static void test_a_report_changes_only_its_own_rows(void **state)
{
    (void)state;
    SEND(SECOND, 1, 0x12, 0xff, 0x05);
    assert_non_null(strstr(picture(80, 24), "button 1 .. button 5: button 2, button 5\n"));
    assert_non_null(strstr(text, "  2 hat                             -\n"));
    assert_non_null(strstr(text, "  1 X                              -1           -1 in all\n"));
}

static void test_relative_mouse_motion_is_accumulated(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        SEND(SECOND, 1, 0, 0x81, 0x10);
    }
    assert_non_null(strstr(picture(80, 24), "-127         -381 in all\n"));
    assert_non_null(strstr(text, "16           48 in all\n"));
}

static void test_a_bar_shows_its_value_and_has_a_gap_out_of_range(void **state)
{
    (void)state;
    SEND(SECOND, 2, 7, 0x04, 0);
    assert_non_null(strstr(picture(61, 24), "7  [...................#]\n"));
    assert_non_null(strstr(text, "key 00 .. key 65: key 04\n"));
    descriptor.group[2].flags &= ~(uint32_t)HID_NULL_STATE;
    SEND(SECOND, 2, 8, 0, 0);
    assert_non_null(strstr(picture(61, 24), "8  [...................#>\n"));
    SEND(SECOND, 2, 0, 0, 0);
    assert_non_null(strstr(picture(61, 24), "0  [#...................]\n"));
}

static void test_a_hat_at_rest_has_no_value(void **state)
{
    (void)state;
    SEND(SECOND, 2, 8, 0, 0);
    assert_non_null(strstr(picture(80, 24), "8  nothing\n"));
}

static void test_a_vendor_usage_is_labelled_as_such(void **state)
{
    (void)state;
    char name[HID_NAME_SIZE];
    assert_string_equal(hid_usage_name(0xff4b0001, name), "vendor's ff4b:0001");
    assert_string_equal(hid_usage_name(0x00840001, name), "0084:0001");
}

static void test_short_reports_and_unknown_ids_are_only_counted(void **state)
{
    (void)state;
    SEND(SECOND, 1, 0x1f, 3);
    SEND(SECOND, 9, 1, 1, 1);
    SEND(SECOND, 1, 0x01, 2, 2);
    assert_int_equal(live.refused_count, 2);
    assert_non_null(strstr(picture(80, 24), "1 report, 0 in the last second, 2 too short "));
    assert_non_null(strstr(text, "button 5: button 1\n"));
}

static void test_the_report_rate_covers_the_last_second(void **state)
{
    (void)state;
    hid_live_time(&live, 10 * SECOND);
    for (uint32_t i = 0; i < 125; i++) {
        SEND(10 * SECOND + i * 8000000ull, 2, 1, 0, 0);
    }
    hid_live_time(&live, 11 * SECOND);
    assert_int_equal(live.per_second, 125);
    hid_live_time(&live, 13 * SECOND);
    assert_int_equal(live.per_second, 0);
}

static void test_the_picture_fits_a_window_of_any_size(void **state)
{
    (void)state;
    SEND(SECOND, 1, 0xff, 0x7f, 0x81);
    SEND(SECOND, 2, 3, 4, 5);
    for (uint32_t width = 0; width < 90; width++) {
        for (uint32_t height = 0; height < 12; height++) {
            picture(width, height);
            uint32_t lines = 0;
            for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
                assert_true((size_t)(strchr(line, '\n') - line) <= width);
                lines++;
            }
            assert_true(lines <= (height > 2 ? height : 2));
        }
    }
    assert_non_null(strstr(picture(80, 4), "3 more rows are below this window"));
}

/* ---- Tests of the list of plugged-in devices ------------------------------------------------ */

static char root[64];

static void put_file(const char *path, const void *data, size_t size)
{
    char whole[256];
    snprintf(whole, sizeof whole, "%s/%s", root, path);
    for (char *slash = whole + strlen(root) + 1; (slash = strchr(slash, '/')); slash++) {
        *slash = '\0';
        mkdir(whole, 0777);
        *slash = '/';
    }
    FILE *file = fopen(whole, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

static int make_root(void **state)
{
    (void)state;
    static const char uevent[] = "DRIVER=hid-generic\nHID_ID=0003:0000054C:00000CE6\n"
                                 "HID_NAME=Sony\tDual\x1bSense\nHID_PHYS=usb-1/input3\n"
                                 "HID_UNIQ=a0\n";
    snprintf(root, sizeof root, "/tmp/kingyo_nodes_XXXXXX");
    assert_non_null(mkdtemp(root));
    put_file("sys/class/hidraw/hidraw10/device/uevent", uevent, sizeof uevent - 1);
    put_file("sys/class/hidraw/hidraw10/device/report_descriptor", bytes, sizeof bytes);
    put_file("sys/class/hidraw/hidraw9/device/uevent", "HID_ID=bad\n", 11);
    put_file("sys/class/hidraw/hidraw9/device/report_descriptor", "\xc0", 1);
    put_file("sys/class/hidraw/other/device/uevent", uevent, sizeof uevent - 1);
    put_file("dev/hidraw10", "", 0);
    return 0;
}

static int remove_root(void **state)
{
    (void)state;
    char command[96];
    snprintf(command, sizeof command, "rm -r '%s'", root);
    return system(command);
}

static void test_nodes_are_sorted_by_number_with_their_kernel_attributes(void **state)
{
    (void)state;
    static struct hid_node nodes[HID_NODES_MAX];
    assert_int_equal(hid_nodes_list(root, nodes), 2);
    assert_int_equal(nodes[0].number, 9);
    assert_int_equal(nodes[0].open_errno, ENOENT);
    assert_int_equal(nodes[1].number, 10);
    assert_int_equal(nodes[1].vendor, 0x054c);
    assert_int_equal(nodes[1].product, 0x0ce6);
    assert_int_equal(nodes[1].open_errno, 0);
    assert_string_equal(nodes[1].driver, "hid-generic");
    assert_string_equal(nodes[1].serial, "a0");
    assert_string_equal(hid_node_bus(&nodes[1]), "USB");
}

static void test_control_characters_of_a_device_name_are_removed(void **state)
{
    (void)state;
    static struct hid_node nodes[HID_NODES_MAX];
    hid_nodes_list(root, nodes);
    assert_string_equal(nodes[1].name, "Sony?Dual?Sense");
}

static void test_a_machine_without_hid_devices_has_an_empty_list(void **state)
{
    (void)state;
    static struct hid_node nodes[HID_NODES_MAX];
    assert_int_equal(hid_nodes_list("/nowhere", nodes), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_every_row_exists_without_a_value_before_the_first_report,
                               begin),
        cmocka_unit_test_setup(test_a_report_changes_only_its_own_rows, begin),
        cmocka_unit_test_setup(test_relative_mouse_motion_is_accumulated, begin),
        cmocka_unit_test_setup(test_a_bar_shows_its_value_and_has_a_gap_out_of_range, begin),
        cmocka_unit_test_setup(test_a_hat_at_rest_has_no_value, begin),
        cmocka_unit_test(test_a_vendor_usage_is_labelled_as_such),
        cmocka_unit_test_setup(test_short_reports_and_unknown_ids_are_only_counted, begin),
        cmocka_unit_test_setup(test_the_report_rate_covers_the_last_second, begin),
        cmocka_unit_test_setup(test_the_picture_fits_a_window_of_any_size, begin),
        cmocka_unit_test(test_nodes_are_sorted_by_number_with_their_kernel_attributes),
        cmocka_unit_test(test_control_characters_of_a_device_name_are_removed),
        cmocka_unit_test(test_a_machine_without_hid_devices_has_an_empty_list),
    };
    return cmocka_run_group_tests_name("hid_live", tests, make_root, remove_root);
}
