/* test_hid_descriptor.c -- Tests the parser of HID report descriptors with valid and malformed
 * descriptors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/hid/hid_descriptor.h"

static struct hid_descriptor read_in;

#define READ(...)                                                                                  \
    hid_descriptor_read(&read_in, (const uint8_t[]){ __VA_ARGS__ },                                \
                        sizeof((const uint8_t[]){ __VA_ARGS__ }))

/* Report payload of a device without report ids. */
#define REPORT(...)                                                                                \
    ((struct hid_report){ (const uint8_t[]){ __VA_ARGS__ },                                        \
                          sizeof((const uint8_t[]){ __VA_ARGS__ }) })

/* Items: usage page Generic Desktop, usage Joystick, begin of a collection of type Application. */
#define JOYSTICK 0x05, 0x01, 0x09, 0x04, 0xa1, 0x01
#define END 0xc0

static void test_a_mouse_has_buttons_and_relative_axes(void **state)
{
    (void)state;
    const enum hid_error error =
        READ(0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x01, 0xa1, 0x00, /* Mouse, Pointer */
             0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, /* Buttons 1 to 3 */
             0x75, 0x01, 0x95, 0x03, 0x81, 0x02, 0x75, 0x05, 0x95, 0x01, 0x81, 0x01, /* padding */
             0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02,
             0x81, 0x06, END, END);
    assert_int_equal(error, HID_OK);
    assert_int_equal(read_in.group_count, 2); /* Padding bits form no group of fields. */
    const struct hid_group *axes = &read_in.group[1];
    assert_int_equal(axes->application, 0x00010002);
    assert_int_equal(axes->bit_offset, 8);
    assert_true(axes->flags & HID_RELATIVE);
    assert_int_equal(hid_usage_at(&read_in, axes, 1), 0x00010031);
    const struct hid_report report = REPORT(0x05, 0xff, 0x10);
    assert_true(hid_report_is_whole(&read_in, report));
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 0, report), 1);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 1, report), 0);
    assert_int_equal(hid_field_value(&read_in, axes, 0, report), -1);
    assert_int_equal(hid_field_value(&read_in, axes, 1, report), 16);
}

static void test_a_short_report_is_not_complete(void **state)
{
    (void)state;
    assert_int_equal(
        READ(JOYSTICK, 0x09, 0x30, 0x26, 0xff, 0x0f, 0x75, 0x0c, 0x95, 0x02, 0x81, 0x02, END),
        HID_OK);
    assert_true(hid_report_is_whole(&read_in, REPORT(1, 2, 3)));
    assert_false(hid_report_is_whole(&read_in, REPORT(1, 2)));
    assert_false(hid_report_is_whole(&read_in, (struct hid_report){ NULL, 0 }));
    const struct hid_report report = REPORT(0x21, 0x43, 0x65);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 0, report), 0x321);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 1, report), 0x654);
}

static void test_each_report_id_has_its_own_bit_offsets(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x01, 0x85, 0x01, 0x09, 0x30, 0x81, 0x02,
                          0x85, 0x02, 0x09, 0x31, 0x81, 0x02, 0x85, 0x01, 0x09, 0x32, 0x81, 0x02,
                          END),
                     HID_OK);
    assert_int_equal(read_in.group[1].bit_offset, 0);
    /* group[2] has the report id 1, as group[0] has, so it begins after the 8 bits of group[0]. */
    assert_int_equal(read_in.group[2].bit_offset, 8);
    assert_int_equal(hid_report_id(&read_in, REPORT(2, 7)), 2);
    assert_true(hid_report_is_whole(&read_in, REPORT(2, 7)));
    assert_false(hid_report_is_whole(&read_in, REPORT(1, 7)));
    assert_false(hid_report_is_whole(&read_in, REPORT(9, 7, 7))); /* The descriptor declares no
                                                                     report 9. */
}

static void test_a_usage_keeps_the_usage_page_at_its_declaration(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x02, 0x09, 0x30, 0x05, 0x02, 0x0b, 0x07,
                          0x00, 0x0d, 0xff, 0x81, 0x02, END),
                     HID_OK);
    assert_int_equal(hid_usage_at(&read_in, &read_in.group[0], 0), 0x00010030);
    assert_int_equal(hid_usage_at(&read_in, &read_in.group[0], 1), 0xff0d0007);
}

static void test_with_too_few_usages_the_last_one_repeats(void **state)
{
    (void)state;
    assert_int_equal(
        READ(JOYSTICK, 0x75, 0x08, 0x95, 0x04, 0x09, 0x30, 0x09, 0x31, 0x81, 0x02, END), HID_OK);
    assert_int_equal(hid_usage_at(&read_in, &read_in.group[0], 3), 0x00010031);
}

static void test_a_maximum_is_signed_only_below_a_negative_minimum(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x01, 0x15, 0x00, 0x25, 0xff, 0x09, 0x30,
                          0x81, 0x02, 0x15, 0x80, 0x09, 0x31, 0x81, 0x02, END),
                     HID_OK);
    assert_int_equal(read_in.group[0].logical_max, 255);
    assert_int_equal(read_in.group[1].logical_max, -1);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 0, REPORT(0x80, 0x80)), 128);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[1], 0, REPORT(0x80, 0x80)), -128);
}

static void test_an_array_contains_the_pressed_usage(void **state)
{
    (void)state;
    assert_int_equal(READ(0x05, 0x01, 0x09, 0x06, 0xa1, 0x01, 0x05, 0x07, 0x19, 0x04, 0x29, 0x08,
                          0x15, 0x01, 0x25, 0x05, 0x75, 0x08, 0x95, 0x02, 0x81, 0x00, END),
                     HID_OK);
    const struct hid_group *keys = &read_in.group[0];
    assert_int_equal(hid_selected(&read_in, keys, 1), 0x00070004);
    assert_int_equal(hid_selected(&read_in, keys, 5), 0x00070008);
    assert_int_equal(hid_selected(&read_in, keys, 0), 0);
    assert_int_equal(hid_selected(&read_in, keys, 6), 0);
}

static void test_push_saves_the_global_items_and_pop_restores_them(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x01, 0x55, 0x0e, 0x65, 0x11, 0xa4, 0x55,
                          0x00, 0x65, 0x00, 0x09, 0x30, 0x81, 0x02, 0xb4, 0x09, 0x31, 0x81, 0x02,
                          END),
                     HID_OK);
    assert_int_equal(read_in.group[0].unit, 0);
    assert_int_equal(read_in.group[1].unit, 0x11);
    /* The unit exponent is a signed nibble, so 14 means -2. */
    assert_int_equal(read_in.group[1].unit_exponent, -2);
}

static void test_only_the_first_usage_of_a_delimited_set_is_used(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x01, 0xa9, 0x01, 0x09, 0x32, 0x09, 0x33,
                          0xa9, 0x00, 0x81, 0x02, END),
                     HID_OK);
    assert_int_equal(hid_usage_count(&read_in, &read_in.group[0]), 1);
    assert_int_equal(hid_usage_at(&read_in, &read_in.group[0], 0), 0x00010032);
}

static void test_long_and_reserved_items_are_skipped(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0xfe, 0x02, 0xf0, 1, 2, 0xcc, 0x00, 0x75, 0x08, 0x95, 0x01,
                          0x09, 0x30, 0x81, 0x02, END, 0x00),
                     HID_OK);
    assert_int_equal(read_in.group_count, 1);
}

static void test_each_malformed_descriptor_is_rejected_with_its_error_offset(void **state)
{
    (void)state;
    assert_int_equal(READ(JOYSTICK, 0x26, 0x10), HID_ERR_CUT_OFF);
    assert_int_equal(read_in.error_offset, 6);
    assert_int_equal(READ(JOYSTICK), HID_ERR_OPEN_COLLECTION);
    assert_int_equal(READ(JOYSTICK, END, END), HID_ERR_NO_COLLECTION);
    assert_int_equal(READ(0xb4), HID_ERR_POP);
    assert_int_equal(READ(JOYSTICK, 0x85, 0x00, END), HID_ERR_REPORT_ID);
    assert_int_equal(READ(JOYSTICK, 0x19, 0x05, 0x29, 0x02, END), HID_ERR_USAGE_RANGE);
    assert_int_equal(READ(JOYSTICK, 0xa9, 0x00, END), HID_ERR_DELIMITER);
    assert_int_equal(READ(JOYSTICK, 0xa9, 0x01, 0x09, 0x30, 0x81, 0x02, END), HID_ERR_DELIMITER);
    /* The delimited set should have ended before the main item at this offset, so the error is
     * reported there. */
    assert_int_equal(read_in.error_offset, 10);
    assert_int_equal(READ(JOYSTICK, 0x77, 0xff, 0xff, 0xff, 0xff, 0x97, 0xff, 0xff, 0xff, 0xff,
                          0x09, 0x30, 0x81, 0x02, END),
                     HID_ERR_REPORT_SIZE);
    assert_int_equal(READ(JOYSTICK, 0x76, 0x01, 0x01, 0x95, 0x01, 0x09, 0x30, 0x81, 0x02, END),
                     HID_ERR_FIELD_SIZE);
}

/* Parses `count` copies of `item` followed by `count` copies of `end`. If `end` is 0, nothing
 * follows. */
static enum hid_error repeated(const uint8_t item[2], uint32_t count, uint8_t end)
{
    static uint8_t bytes[HID_DESCRIPTOR_SIZE_MAX + 1u];
    size_t size = 0;
    for (uint32_t i = 0; i < count; i++) {
        bytes[size++] = item[0];
        bytes[size++] = item[1];
    }
    for (uint32_t i = 0; end && i < count; i++) {
        bytes[size++] = end;
    }
    return hid_descriptor_read(&read_in, bytes, size);
}

static void test_each_limit_is_accepted_and_one_more_is_rejected(void **state)
{
    (void)state;
    const uint8_t collection[2] = { 0xa1, 0x00 }, usage[2] = { 0x09, 0x30 };
    assert_int_equal(repeated(collection, HID_DEPTH_MAX, END), HID_OK);
    assert_int_equal(repeated(collection, HID_DEPTH_MAX + 1u, END), HID_ERR_DEPTH);
    assert_int_equal(repeated(usage, HID_RANGE_MAX, 0), HID_OK);
    assert_int_equal(repeated(usage, HID_RANGE_MAX + 1u, 0), HID_ERR_RANGES);
    assert_int_equal(hid_descriptor_read(&read_in, collection, HID_DESCRIPTOR_SIZE_MAX + 1u),
                     HID_ERR_TOO_LONG);
    const uint8_t push[2] = { 0xa4, 0xa4 };
    assert_int_equal(repeated(push, HID_PUSH_MAX / 2u, 0), HID_OK);
    assert_int_equal(repeated(push, HID_PUSH_MAX / 2u + 1u, 0), HID_ERR_PUSH);
}

/* Parses a descriptor of two reports. Report 1 has `count` fields of one bit, and report 2 has one
 * field of one bit. */
static enum hid_error bits(uint32_t count)
{
    const uint8_t low = (uint8_t)count, high = (uint8_t)(count >> 8), more = (uint8_t)(count >> 16);
    return READ(JOYSTICK, 0x75, 0x01, 0x97, low, high, more, 0, 0x85, 0x01, 0x09, 0x30, 0x81, 0x02,
                0x85, 0x02, 0x95, 0x01, 0x09, 0x31, 0x81, 0x02, END);
}

static void test_a_report_can_have_one_field_per_bit(void **state)
{
    (void)state;
    assert_int_equal(bits(HID_FIELD_MAX - 1u), HID_OK);
    assert_int_equal(read_in.field_count, HID_FIELD_MAX);
    assert_int_equal(bits(HID_FIELD_MAX), HID_ERR_FIELDS);
    assert_int_equal(bits(HID_REPORT_BITS_MAX + 1u), HID_ERR_REPORT_SIZE);
}

static void test_a_parsed_descriptor_keeps_nothing_of_the_previous_one(void **state)
{
    (void)state;
    assert_int_equal(bits(100), HID_OK);
    assert_int_equal(READ(JOYSTICK, 0x75, 0x08, 0x95, 0x01, 0x09, 0x32, 0x81, 0x02, END), HID_OK);
    assert_int_equal(read_in.group_count, 1);
    assert_int_equal(read_in.field_count, 1);
    assert_false(read_in.has_report_ids);
    assert_int_equal(read_in.report_bits[1], 0);
    assert_int_equal(READ(0xc0), HID_ERR_NO_COLLECTION);
    assert_int_equal(read_in.group_count, 0);
    assert_int_equal(READ(0x00), HID_OK);
    assert_int_equal(read_in.error_offset, 0);
}

static void test_values_of_any_size_are_read_at_any_bit_offset(void **state)
{
    (void)state;
    /* The descriptor has four fields: 3 bits, 32 bits (signed), 64 bits, and 1 bit (signed). */
    assert_int_equal(READ(JOYSTICK, 0x75, 0x03, 0x95, 0x01, 0x09, 0x30, 0x81, 0x02, 0x17, 0, 0, 0,
                          0x80, 0x27, 0xff, 0xff, 0xff, 0x7f, 0x75, 0x20, 0x09, 0x31, 0x81, 0x02,
                          0x75, 0x40, 0x09, 0x32, 0x81, 0x02, 0x75, 0x01, 0x09, 0x33, 0x81, 0x02,
                          END),
                     HID_OK);
    const struct hid_report report =
        REPORT(0x05, 0, 0, 0, 0xfc, 0x1f, 0x32, 0x54, 0x76, 0, 0, 0, 0x08);
    assert_true(hid_report_is_whole(&read_in, report));
    assert_int_equal(hid_field_value(&read_in, &read_in.group[0], 0, report), 5);
    assert_true(hid_field_value(&read_in, &read_in.group[1], 0, report) == -0x80000000ll);
    /* Of the field with 64 bits, hid_field_value() returns only the lowest 32 bits. */
    assert_true(hid_field_value(&read_in, &read_in.group[2], 0, report) == -0x3579bc01ll);
    assert_int_equal(hid_field_value(&read_in, &read_in.group[3], 0, report), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_mouse_has_buttons_and_relative_axes),
        cmocka_unit_test(test_a_short_report_is_not_complete),
        cmocka_unit_test(test_each_report_id_has_its_own_bit_offsets),
        cmocka_unit_test(test_a_usage_keeps_the_usage_page_at_its_declaration),
        cmocka_unit_test(test_with_too_few_usages_the_last_one_repeats),
        cmocka_unit_test(test_a_maximum_is_signed_only_below_a_negative_minimum),
        cmocka_unit_test(test_an_array_contains_the_pressed_usage),
        cmocka_unit_test(test_push_saves_the_global_items_and_pop_restores_them),
        cmocka_unit_test(test_only_the_first_usage_of_a_delimited_set_is_used),
        cmocka_unit_test(test_long_and_reserved_items_are_skipped),
        cmocka_unit_test(test_each_malformed_descriptor_is_rejected_with_its_error_offset),
        cmocka_unit_test(test_each_limit_is_accepted_and_one_more_is_rejected),
        cmocka_unit_test(test_a_report_can_have_one_field_per_bit),
        cmocka_unit_test(test_a_parsed_descriptor_keeps_nothing_of_the_previous_one),
        cmocka_unit_test(test_values_of_any_size_are_read_at_any_bit_offset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
