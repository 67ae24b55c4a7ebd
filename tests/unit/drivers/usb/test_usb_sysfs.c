/* test_usb_sysfs.c -- tests how texts and serial numbers are read from USB devices and from
 * /sys. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>

#include "drivers/usb/usb_sysfs.h"

/* ---- Texts from devices --------------------------------------------------------------------- */

static void test_control_characters_are_removed_from_device_texts(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        { "Poi \n", "Poi" },
        { "a\x1b[31mb\tc", "a?[31mb?c" },
        /* "Kingyo" (goldfish) in kanji. */
        { "\xe9\x87\x91\xe9\xad\x9a", "\xe9\x87\x91\xe9\xad\x9a" },
        { "x\xff\xfey long", "x??y long" },
        { "\xc2\x9b"
          "31m and more",
          /* U+009B, a C1 control character that starts a terminal control sequence. */
          "?31m and more" },
        { "cut \xe9\x87", "cut " },
        { "cut \xf0\x9f\x90", "cut " },
        { "cut \xc3", "cut " },
        { "\xe9", "" },
        { "odd \x90", "odd ?" },
        { "", "" },
    };
    for (uint32_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char text[HID_TEXT_SIZE];
        snprintf(text, sizeof text, "%s", pairs[i][0]);
        usb_sysfs_clean_text(text);
        assert_string_equal(text, pairs[i][1]);
    }
}

/* ---- Device nodes --------------------------------------------------------------------------- */

/* The input node lies several levels below its device in /sys. A hub two levels above the device
 * has a serial number too, which must not be returned. */
static void test_the_serial_number_of_an_input_node_is_found(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-nodes-XXXXXX", command[640], serial[HID_TEXT_SIZE] = "x";
    assert_non_null(mkdtemp(folder));
    snprintf(command, sizeof command,
             "cd %s && mkdir -p d/usb1/1-2/1-2:1.3/0003.7/input/input9/event5 class/input "
             "d/usb1/1-2/1-2:1.3/hidraw/hidraw3 class/hidraw d/i8042/event0 && "
             "touch d/usb1/idVendor && echo hub > d/usb1/serial && "
             "echo 054c > d/usb1/1-2/idVendor && echo A1 > d/usb1/1-2/serial && "
             "ln -s ../../d/usb1/1-2/1-2:1.3/0003.7/input/input9/event5 class/input/event5 && "
             "ln -s ../../d/usb1/1-2/1-2:1.3/hidraw/hidraw3 class/hidraw/hidraw3 && "
             "ln -s ../../d/i8042/event0 class/input/event0",
             folder);
    assert_int_equal(system(command), 0);
    usb_sysfs_node_serial(folder, "/dev/input/event5", serial);
    assert_string_equal(serial, "A1");
    usb_sysfs_node_serial(folder, "/dev/input/event0", serial);
    assert_string_equal(serial, "");
    usb_sysfs_node_serial(folder, "/dev/hidraw3", serial);
    assert_string_equal(serial, "A1");
    usb_sysfs_node_serial(folder, "", serial);
    assert_string_equal(serial, "");
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_control_characters_are_removed_from_device_texts),
        cmocka_unit_test(test_the_serial_number_of_an_input_node_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
