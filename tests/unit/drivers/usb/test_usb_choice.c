/* test_usb_choice.c -- tests which USB devices the driver may claim, and which player slot each
 * device gets. Both follow from built-in rules and from the file of the operator's choices. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "drivers/hid/poi_report.h"
#include "drivers/usb/usb_device_list.h"
#include "drivers/usb/usb_choice.h"

/* ---- Keys that identify a device ------------------------------------------------------------ */

static void test_a_key_is_unchanged_by_writing_and_reading(void **state)
{
    (void)state;
    static const char *const good[] = { "1209:0001", "057e:2009:98:B6 e9", "ffff:ffff:x" };
    struct usb_key key;
    char text[USB_KEY_TEXT_SIZE];
    for (uint32_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        assert_int_equal(usb_key_read(&key, good[i]), 0);
        usb_key_write(&key, text);
        assert_string_equal(text, good[i]);
    }
    assert_int_equal(usb_key_read(&key, "057E:2009"), 0);
    assert_int_equal(key.vendor, 0x057e);
}

static void test_an_invalid_key_is_rejected_and_changes_nothing(void **state)
{
    (void)state;
    static const char *const bad[] = { "",           "1209",      "1209:",      "1209:1",
                                       "1209:000g",  "1209-0001", "1209:0001:", "1209:00011",
                                       " 1209:0001", "0x12:0001" };
    struct usb_key key = { .vendor = 7 };
    char longest[10 + HID_TEXT_SIZE + 1] = "1209:0001:";
    memset(longest + 10, 'x', HID_TEXT_SIZE);
    for (uint32_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(usb_key_read(&key, bad[i]), -1);
    }
    assert_int_equal(usb_key_read(&key, longest), -1);
    assert_int_equal(key.vendor, 7);
    longest[10 + HID_TEXT_SIZE - 1] = '\0'; /* After the last byte is removed, the text fits. */
    assert_int_equal(usb_key_read(&key, longest), 0);
}

/* ---- Which devices are opened --------------------------------------------------------------- */

static struct hid_identity identity_of(uint16_t vendor, uint16_t product, const char *serial,
                                       const char *port)
{
    struct hid_identity identity = { .vendor = vendor, .product = product };
    snprintf(identity.serial, sizeof identity.serial, "%s", serial);
    snprintf(identity.port, sizeof identity.port, "%s", port);
    return identity;
}

static enum usb_verdict evaluate(const struct usb_choice *choice,
                                 const struct hid_identity *identity, enum usb_kind kind)
{
    const struct usb_candidate subject = { .identity = identity, .kind = (uint8_t)kind };
    return usb_choice_evaluate(choice, &subject);
}

static void request(struct usb_choice *choice, const char *text, int plays, int kept)
{
    struct usb_key key;
    assert_int_equal(usb_key_read(&key, text), 0);
    usb_choice_request(choice, &key, plays, kept);
}

static void test_only_a_kingyo_poi_is_opened_without_a_choice(void **state)
{
    (void)state;
    const struct usb_choice nothing = { 0 };
    const struct hid_identity any = identity_of(0x1234, 0x5678, "", "1-1");
    const struct hid_identity test_id = identity_of(USB_BENCH_VENDOR, USB_BENCH_PRODUCT, "", "1-1");
    assert_int_equal(evaluate(&nothing, &any, USB_KIND_OWN), USB_PLAYS);
    assert_int_equal(evaluate(&nothing, &any, USB_KIND_MAPPED), USB_FREE);
    assert_int_equal(evaluate(&nothing, &any, USB_KIND_LEARNABLE), USB_FREE);
    /* USB_FREE means that the device is listed but not opened. */
    assert_int_equal(evaluate(&nothing, &any, USB_KIND_UNKNOWN), USB_FREE);
    assert_int_equal(evaluate(&nothing, &test_id, USB_KIND_UNKNOWN), USB_ASK);
    assert_int_equal(evaluate(&nothing, &test_id, USB_KIND_MAPPED), USB_FREE);
}

static void test_keyboards_and_unusable_devices_are_excluded_even_if_chosen(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    const struct hid_identity device = identity_of(0x1234, 0x5678, "", "1-1");
    request(&choice, "1234:5678", 1, 1);
    assert_int_equal(evaluate(&choice, &device, USB_KIND_KEYS), USB_BARRED);
    assert_int_equal(evaluate(&choice, &device, USB_KIND_NOTHING), USB_BARRED);
    assert_int_equal(evaluate(&choice, &device, USB_KIND_MAPPED), USB_PLAYS);
    const struct usb_candidate boot = { .identity = &device,
                                        .is_boot_keyboard = 1,
                                        .kind = USB_KIND_OWN };
    assert_int_equal(usb_choice_evaluate(&choice, &boot), USB_BARRED);
}

static void test_a_choice_with_a_serial_number_has_priority(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    const struct hid_identity a = identity_of(1, 2, "a", ""), b = identity_of(1, 2, "b", "");
    request(&choice, "0001:0002:a", 0, 1);
    request(&choice, "0001:0002", 1, 1);
    assert_int_equal(evaluate(&choice, &a, USB_KIND_MAPPED), USB_FREE);
    assert_int_equal(evaluate(&choice, &b, USB_KIND_MAPPED), USB_PLAYS);
    /* The operator has released this device, so it stays free although it is a Kingyo poi. */
    assert_int_equal(evaluate(&choice, &a, USB_KIND_OWN), USB_FREE);
    request(&choice, "0001:0002:a", 1, 1);
    assert_int_equal(evaluate(&choice, &a, USB_KIND_MAPPED), USB_PLAYS);
    /* The list has two choices, because the new choice replaced the old choice of the same key. */
    assert_int_equal(choice.request_count, 2);
}

static void test_a_full_list_drops_its_oldest_choice(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    char text[16];
    for (uint32_t i = 0; i < USB_REQUEST_MAX + 1u; i++) {
        snprintf(text, sizeof text, "0001:%04x", i);
        request(&choice, text, 1, 1);
    }
    const struct hid_identity first = identity_of(1, 0, "", ""), second = identity_of(1, 1, "", "");
    assert_int_equal(choice.request_count, USB_REQUEST_MAX);
    assert_int_equal(evaluate(&choice, &first, USB_KIND_MAPPED), USB_FREE);
    assert_int_equal(evaluate(&choice, &second, USB_KIND_MAPPED), USB_PLAYS);
}

/* ---- Assignment of devices to player slots -------------------------------------------------- */

static struct usb_place place_of(struct hid_identity device, int is_taken, int is_held)
{
    return (struct usb_place){
        .was_taken = 1, .is_taken = is_taken != 0, .is_held = is_held != 0, .identity = device
    };
}

static void test_a_returning_device_gets_its_own_slot(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        [1] = place_of(identity_of(1, 2, "a", "1-1"), 0, 1),
        [2] = place_of(identity_of(1, 2, "b", "1-2"), 0, 1),
    };
    struct hid_identity device = identity_of(1, 2, "b", "1-9");
    assert_int_equal(usb_choice_slot(place, &device), 2);
    /* Only the serial number differs from that of the lost device. Type and port are the same, so
     * the new device gets its slot. */
    device = identity_of(1, 2, "c", "1-1");
    assert_int_equal(usb_choice_slot(place, &device), 1);
    device = identity_of(1, 2, "c", "1-9");
    assert_int_equal(usb_choice_slot(place, &device), 0);
    device = identity_of(1, 3, "a", "1-1");
    assert_int_equal(usb_choice_slot(place, &device), 0);
}

static void test_two_devices_with_equal_serial_numbers_are_identified_by_port(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        place_of(identity_of(1, 2, "123456", "1-1"), 0, 1),
        place_of(identity_of(1, 2, "123456", "1-2"), 0, 1),
    };
    const struct hid_identity device = identity_of(1, 2, "123456", "1-2");
    assert_int_equal(usb_choice_slot(place, &device), 1);
}

static void test_a_device_in_a_new_port_is_identified_if_it_is_the_only_one(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        place_of(identity_of(9, 9, "", "1-8"), 1, 0),
        place_of(identity_of(1, 2, "", "1-1"), 0, 1),
    };
    const struct hid_identity device = identity_of(1, 2, "", "1-7");
    assert_int_equal(usb_choice_slot(place, &device), 1);
    /* Two devices of this type are lost, so the returned device cannot be identified and gets a
     * free slot. */
    place[0] = place_of(identity_of(1, 2, "", "1-8"), 0, 1);
    assert_int_equal(usb_choice_slot(place, &device), 2);
}

static void test_a_slot_is_given_away_after_its_reservation(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX];
    const struct hid_identity unknown = identity_of(7, 7, "", "1-7");
    for (uint32_t i = 0; i < POI_MAX; i++) {
        place[i] = place_of(identity_of(1, (uint16_t)i, "", "1-1"), i != 2, 1);
    }
    assert_int_equal(usb_choice_slot(place, &unknown), POI_MAX);
    place[2].is_held = 0;
    assert_int_equal(usb_choice_slot(place, &unknown), 2);
}

/* ---- Rows of the device list ---------------------------------------------------------------- */

static void test_rows_keep_their_index_and_excluded_devices_are_replaced(void **state)
{
    (void)state;
    struct usb_device_table rows;
    usb_device_table_init(&rows);
    for (uint16_t i = 0; i < 6; i++) {
        const struct hid_identity device = identity_of(1, i, "", "1-1");
        const uint32_t row = usb_device_table_enter(&rows, &device, 1);
        /* Excluded devices get at most four rows, so that rows are left for usable devices. */
        assert_int_equal(row, i < 4 ? i : CONTROLLER_MAX);
    }
    for (uint16_t i = 0; i < 8; i++) {
        const struct hid_identity device = identity_of(2, i, "", "1-2");
        assert_true(usb_device_table_enter(&rows, &device, 0) < CONTROLLER_MAX);
        assert_true(usb_device_table_find(&rows, &device) < CONTROLLER_MAX);
    }
    const struct hid_identity ninth = identity_of(2, 9, "", "1-3");
    assert_int_equal(usb_device_table_enter(&rows, &ninth, 0), CONTROLLER_MAX);
    const struct hid_identity lost = identity_of(2, 5, "", "1-2");
    const uint32_t row = usb_device_table_find(&rows, &lost);
    rows.row[row].state = CONTROLLER_LOST;
    /* The returned device gets the row that it had before. */
    assert_int_equal(usb_device_table_enter(&rows, &lost, 0), row);
    rows.row[row].state = CONTROLLER_LOST;
    assert_int_equal(usb_device_table_enter(&rows, &ninth, 0), row);
}

/* ---- File of the operator's choices --------------------------------------------------------- */

static void test_choices_are_stored_completely_or_the_old_file_is_kept(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-choice-XXXXXX", path[64], part[80], why[HAL_TEXT_SIZE] = "";
    struct usb_choice written = { 0 }, read = { 0 };
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/usb.txt", folder);
    snprintf(part, sizeof part, "%s.part", path);
    /* A missing file is not an error. */
    assert_int_equal(usb_choice_load(&read, path, why), 0);
    request(&written, "1209:0001:with space", 1, 1);
    request(&written, "057e:2009", 0, 1);
    /* A choice from the command line is not stored. */
    request(&written, "1111:2222", 1, 0);
    assert_int_equal(usb_choice_save(&written, path), 0);
    assert_int_equal(usb_choice_load(&read, path, why), 0);
    assert_int_equal(read.request_count, 2);
    assert_string_equal(read.request[0].key.serial, "with space");
    assert_int_equal(read.request[0].plays, 1);
    assert_int_equal(read.request[1].key.product, 0x2009);
    assert_int_equal(read.request[1].plays, 0);
    /* A folder has the name of the temporary file, so saving must fail. */
    assert_int_equal(mkdir(part, 0755), 0);
    assert_true(usb_choice_save(&written, path) < 0);
    assert_int_equal(usb_choice_load(&read, path, why), 0);
    assert_int_equal(usb_choice_save(&written, ""), 0);
    rmdir(part);
    unlink(path);
    rmdir(folder);
}

static void test_bad_lines_are_counted_and_named(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-choice-XXXXXX", why[HAL_TEXT_SIZE] = "";
    struct usb_choice choice = { 0 };
    const int fd = mkstemp(path);
    FILE *file = fdopen(fd, "w");
    assert_non_null(file);
    fputs("# words\n\n   \nplays 1209:0001\r\nplay 1209:0002\nrests nonsense\n", file);
    for (uint32_t i = 0; i < 400; i++) {
        fputc('x', file);
    }
    static const char zero_inside[] = "\nplays 1209:0004 \0rests\n";
    fwrite(zero_inside, 1, sizeof zero_inside - 1u, file);
    fputs("rests 1209:0003", file);
    fclose(file);
    assert_int_equal(usb_choice_load(&choice, path, why), 4);
    assert_int_equal(choice.request_count, 2);
    assert_non_null(strstr(why, path));
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_key_is_unchanged_by_writing_and_reading),
        cmocka_unit_test(test_an_invalid_key_is_rejected_and_changes_nothing),
        cmocka_unit_test(test_only_a_kingyo_poi_is_opened_without_a_choice),
        cmocka_unit_test(test_keyboards_and_unusable_devices_are_excluded_even_if_chosen),
        cmocka_unit_test(test_a_choice_with_a_serial_number_has_priority),
        cmocka_unit_test(test_a_full_list_drops_its_oldest_choice),
        cmocka_unit_test(test_a_returning_device_gets_its_own_slot),
        cmocka_unit_test(test_two_devices_with_equal_serial_numbers_are_identified_by_port),
        cmocka_unit_test(test_a_device_in_a_new_port_is_identified_if_it_is_the_only_one),
        cmocka_unit_test(test_a_slot_is_given_away_after_its_reservation),
        cmocka_unit_test(test_rows_keep_their_index_and_excluded_devices_are_replaced),
        cmocka_unit_test(test_choices_are_stored_completely_or_the_old_file_is_kept),
        cmocka_unit_test(test_bad_lines_are_counted_and_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
