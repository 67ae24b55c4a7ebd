/* test_usb_choice.c -- who may be claimed, and who sits where: rules, and the file of choices. */
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
#include "drivers/usb/usb_sysfs.h"

static struct hid_descriptor scratch;

/* ---- Keys ----------------------------------------------------------------------------------- */

static void test_keys_are_read_as_they_are_written(void **state)
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

static void test_what_is_no_key_is_refused_and_leaves_the_old_one(void **state)
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
    longest[10 + HID_TEXT_SIZE - 1] = '\0'; /* One less fits. */
    assert_int_equal(usb_key_read(&key, longest), 0);
}

/* ---- Verdicts ------------------------------------------------------------------------------- */

static struct hid_identity someone(uint16_t vendor, uint16_t product, const char *serial,
                                   const char *port)
{
    struct hid_identity identity = { .vendor = vendor, .product = product };
    snprintf(identity.serial, sizeof identity.serial, "%s", serial);
    snprintf(identity.port, sizeof identity.port, "%s", port);
    return identity;
}

static enum usb_verdict judge(const struct usb_choice *choice, const struct hid_identity *identity,
                              enum usb_kind kind)
{
    const struct usb_candidate subject = { .identity = identity, .kind = (uint8_t)kind };
    return usb_choice_evaluate(choice, &subject);
}

static void wish(struct usb_choice *choice, const char *text, int plays, int kept)
{
    struct usb_key key;
    assert_int_equal(usb_key_read(&key, text), 0);
    usb_choice_request(choice, &key, plays, kept);
}

static void test_only_our_own_poi_plays_by_itself(void **state)
{
    (void)state;
    const struct usb_choice nothing = { 0 };
    const struct hid_identity any = someone(0x1234, 0x5678, "", "1-1");
    const struct hid_identity bench = someone(USB_BENCH_VENDOR, USB_BENCH_PRODUCT, "", "1-1");
    assert_int_equal(judge(&nothing, &any, USB_KIND_OWN), USB_PLAYS);
    assert_int_equal(judge(&nothing, &any, USB_KIND_HAND), USB_FREE);
    assert_int_equal(judge(&nothing, &any, USB_KIND_LEARNABLE), USB_FREE);
    assert_int_equal(judge(&nothing, &any, USB_KIND_UNKNOWN), USB_FREE); /* Not even asked. */
    assert_int_equal(judge(&nothing, &bench, USB_KIND_UNKNOWN), USB_ASK);
    assert_int_equal(judge(&nothing, &bench, USB_KIND_HAND), USB_FREE);
}

static void test_keys_and_nothings_are_barred_whoever_names_them(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    const struct hid_identity who = someone(0x1234, 0x5678, "", "1-1");
    wish(&choice, "1234:5678", 1, 1);
    assert_int_equal(judge(&choice, &who, USB_KIND_KEYS), USB_BARRED);
    assert_int_equal(judge(&choice, &who, USB_KIND_NOTHING), USB_BARRED);
    assert_int_equal(judge(&choice, &who, USB_KIND_HAND), USB_PLAYS);
    const struct usb_candidate boot = { .identity = &who,
                                        .is_boot_keyboard = 1,
                                        .kind = USB_KIND_OWN };
    assert_int_equal(usb_choice_evaluate(&choice, &boot), USB_BARRED);
}

static void test_a_wish_with_a_serial_number_counts_more_than_one_without(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    const struct hid_identity a = someone(1, 2, "a", ""), b = someone(1, 2, "b", "");
    wish(&choice, "0001:0002:a", 0, 1);
    wish(&choice, "0001:0002", 1, 1);
    assert_int_equal(judge(&choice, &a, USB_KIND_HAND), USB_FREE);
    assert_int_equal(judge(&choice, &b, USB_KIND_HAND), USB_PLAYS);
    assert_int_equal(judge(&choice, &a, USB_KIND_OWN), USB_FREE); /* It rests, ours or not. */
    wish(&choice, "0001:0002:a", 1, 1);
    assert_int_equal(judge(&choice, &a, USB_KIND_HAND), USB_PLAYS);
    assert_int_equal(choice.wish_count, 2); /* In place of the older one. */
}

static void test_a_full_list_forgets_its_oldest(void **state)
{
    (void)state;
    struct usb_choice choice = { 0 };
    char text[16];
    for (uint32_t i = 0; i < USB_REQUEST_MAX + 1u; i++) {
        snprintf(text, sizeof text, "0001:%04x", i);
        wish(&choice, text, 1, 1);
    }
    const struct hid_identity first = someone(1, 0, "", ""), second = someone(1, 1, "", "");
    assert_int_equal(choice.wish_count, USB_REQUEST_MAX);
    assert_int_equal(judge(&choice, &first, USB_KIND_HAND), USB_FREE);
    assert_int_equal(judge(&choice, &second, USB_KIND_HAND), USB_PLAYS);
}

/* ---- Kinds: of real devices ----------------------------------------------------------------- */

static uint32_t read_hex(const char *path, uint8_t *out, uint32_t size)
{
    FILE *file = fopen(path, "r");
    uint32_t count = 0;
    unsigned byte;
    assert_non_null(file);
    while (count < size && fscanf(file, "%2x", &byte) == 1) {
        out[count++] = (uint8_t)byte;
    }
    fclose(file);
    return count;
}

static struct usb_candidate subject_of(const char *name, const struct hid_identity *identity)
{
    uint8_t bytes[HID_DESCRIPTOR_MAX];
    char path[128];
    struct usb_candidate subject = { .identity = identity };
    snprintf(path, sizeof path, "tests/hid/good/descriptors/%s.hid", name);
    usb_choice_read(&subject, bytes, read_hex(path, bytes, sizeof bytes), &scratch);
    return subject;
}

static enum usb_kind kind_of_bytes(const uint8_t *bytes, uint32_t size)
{
    const struct hid_identity nobody = { 0 };
    struct usb_candidate subject = { .identity = &nobody };
    usb_choice_read(&subject, bytes, size, &scratch);
    return subject.kind;
}

/* As their makers sell them: media keys are keys; a tablet whose keys type, and a mouse whose do,
 * are keyboards; vendors' own bytes must be learned. */
static void test_real_devices_are_told_apart_by_their_descriptors(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint8_t kind;
    } devices[] = {
        { "002-3dconnexion-spacemouse-wireless", USB_KIND_HAND },
        { "006-blaze-joypad", USB_KIND_HAND },
        { "011-dell-413c-301a-mouse", USB_KIND_HAND },
        { "016-ci-dualsense", USB_KIND_HAND },
        { "038-hd-sony-054c-0268", USB_KIND_HAND },
        { "049-hd-wacom-pen-tablet-056a-0081", USB_KIND_HAND },
        { "137-dg-huion-h610-if0", USB_KIND_HAND },
        { "196-hr-0003-256c-006e-000a", USB_KIND_HAND },
        { "144-dg-kye-easypen-m406-if0", USB_KIND_HAND },
        { "012-compact-keyboard-2222-0099-if1", USB_KIND_KEYS },
        { "036-hd-ion-15e4-0132", USB_KIND_KEYS },
        { "151-dg-ugee-m708-if2", USB_KIND_KEYS },
        { "171-ha-046d-b010-0001-000c", USB_KIND_KEYS },
        { "180-ha-046d-c534-0080-0001", USB_KIND_KEYS },
        { "160-dg-xp-pen-star-06-if1", USB_KIND_KEYS },
        { "207-hr-libinput-issue366-0003-046d-4082-0", USB_KIND_KEYS },
        { "209-hr-libinput-issue410-0003-1532-0224-0", USB_KIND_KEYS },
        { "214-hr-libinput-issue477-0003-28de-1142-0", USB_KIND_KEYS },
        { "166-dg-huion-hs610-if0", USB_KIND_LEARNABLE },
        { "182-ha-047f-c056-0003-ffa0", USB_KIND_LEARNABLE },
    };
    const struct hid_identity nobody = { 0 };
    for (uint32_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        const struct usb_candidate subject = subject_of(devices[i].name, &nobody);
        if (subject.kind != devices[i].kind) {
            fail_msg("%s is %u, not %u", devices[i].name, subject.kind, devices[i].kind);
        }
    }
}

/* Of `count` interfaces the one that would be claimed. */
static uint32_t best_of(const struct usb_choice *choice, const char *const names[], uint32_t count)
{
    struct hid_identity identity[4];
    struct usb_candidate subject[4];
    uint32_t best = 0;
    for (uint32_t i = 0; i < count; i++) {
        identity[i] = someone(0x256c, 0x006e, "", "1-1");
        identity[i].interface_number = (uint8_t)i;
        subject[i] = names[i] ? subject_of(names[i], &identity[i])
                              : (struct usb_candidate){ .identity = &identity[i] };
        best = i > 0 && usb_choice_is_better(choice, &subject[i], &subject[best]) ? i : best;
    }
    return best;
}

/* A tablet hides its pen behind a vendor's interface, a receiver its mouse behind a keyboard. */
static void test_of_several_interfaces_the_one_that_leads_a_hand_best_is_claimed(void **state)
{
    (void)state;
    static const char *const vendor = "166-dg-huion-hs610-if0";
    static const char *const pen = "196-hr-0003-256c-006e-000a";
    static const char *const mouse = "011-dell-413c-301a-mouse";
    static const char *const typing = "207-hr-libinput-issue366-0003-046d-4082-0";
    static const char *const media = "180-ha-046d-c534-0080-0001";
    struct usb_choice choice = { 0 };
    for (uint32_t chosen = 0; chosen < 2; chosen++) {
        assert_int_equal(best_of(&choice, (const char *const[]){ vendor, pen }, 2), 1);
        assert_int_equal(best_of(&choice, (const char *const[]){ pen, vendor }, 2), 0);
        assert_int_equal(best_of(&choice, (const char *const[]){ mouse, pen, vendor }, 3), 1);
        assert_int_equal(best_of(&choice, (const char *const[]){ typing, vendor, mouse }, 3), 2);
        assert_int_equal(best_of(&choice, (const char *const[]){ media, vendor }, 2), 1);
        assert_int_equal(best_of(&choice, (const char *const[]){ mouse, mouse }, 2), 0);
        wish(&choice, "256c:006e", 1, 1);
    }
    /* No driver has bound the second yet: it is asked before the first must be learned. */
    assert_int_equal(best_of(&choice, (const char *const[]){ vendor, NULL }, 2), 1);
    assert_int_equal(best_of(&choice, (const char *const[]){ pen, NULL }, 2), 0);
}

static void test_keys_that_type_are_barred_with_whatever_is_beside_them(void **state)
{
    (void)state;
    static const char *const names[] = {
        "160-dg-xp-pen-star-06-if1",
        "207-hr-libinput-issue366-0003-046d-4082-0",
        "209-hr-libinput-issue410-0003-1532-0224-0",
        "214-hr-libinput-issue477-0003-28de-1142-0",
    };
    struct usb_choice choice = { 0 };
    const struct hid_identity who = someone(0x1234, 0x5678, "", "1-1");
    wish(&choice, "1234:5678", 1, 1);
    for (uint32_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct usb_candidate subject = subject_of(names[i], &who);
        assert_int_equal(usb_choice_evaluate(&choice, &subject), USB_BARRED);
    }
}

static void test_our_own_descriptor_is_known_to_the_last_byte(void **state)
{
    (void)state;
    uint8_t bytes[POI_DESCRIPTOR_SIZE];
    memcpy(bytes, poi_descriptor, sizeof bytes);
    assert_int_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_OWN);
    assert_int_equal(kind_of_bytes(bytes, 0), USB_KIND_UNKNOWN);
    bytes[1] ^= 1u; /* Another page of usages. */
    assert_int_not_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_OWN);
    static const uint8_t cut_off[] = { 0x05 };
    assert_int_equal(kind_of_bytes(cut_off, sizeof cut_off), USB_KIND_NOTHING);
}

static void test_what_no_hand_leads_is_barred(void **state)
{
    (void)state;
    static const uint8_t pages[][3] = { { 0x84, 0x00, 0x04 },
                                        { 0xd0, 0xf1, 0x01 },
                                        { 0x0b, 0x00, 0x05 } }; /* A UPS, a FIDO key, a headset. */
    for (uint32_t i = 0; i < sizeof pages / sizeof pages[0]; i++) {
        const uint8_t bytes[] = { 0x06, pages[i][0], pages[i][1], 0x09, pages[i][2], 0xa1, 0x01,
                                  0x09, 0x20,        0x15,        0x00, 0x25,        0x7f, 0x75,
                                  0x08, 0x95,        0x01,        0x81, 0x02,        0xc0 };
        assert_int_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_KEYS);
    }
}

/* ---- Seats ---------------------------------------------------------------------------------- */

static struct usb_place place_of(struct hid_identity who, int is_taken, int is_held)
{
    return (struct usb_place){
        .was_taken = 1, .is_taken = is_taken != 0, .is_held = is_held != 0, .identity = who
    };
}

static void test_who_comes_back_gets_its_own_seat(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        [1] = place_of(someone(1, 2, "a", "1-1"), 0, 1),
        [2] = place_of(someone(1, 2, "b", "1-2"), 0, 1),
    };
    struct hid_identity who = someone(1, 2, "b", "1-9");
    assert_int_equal(usb_choice_slot(place, &who), 2);
    who = someone(1, 2, "c", "1-1"); /* Another of its kind in its place: it was replaced. */
    assert_int_equal(usb_choice_slot(place, &who), 1);
    who = someone(1, 2, "c", "1-9");
    assert_int_equal(usb_choice_slot(place, &who), 0);
    who = someone(1, 3, "a", "1-1");
    assert_int_equal(usb_choice_slot(place, &who), 0);
}

static void test_two_with_the_same_number_are_told_apart_by_their_ports(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        place_of(someone(1, 2, "123456", "1-1"), 0, 1),
        place_of(someone(1, 2, "123456", "1-2"), 0, 1),
    };
    const struct hid_identity who = someone(1, 2, "123456", "1-2");
    assert_int_equal(usb_choice_slot(place, &who), 1);
}

static void test_without_a_number_elsewhere_it_is_known_if_there_is_but_one(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX] = {
        place_of(someone(9, 9, "", "1-8"), 1, 0),
        place_of(someone(1, 2, "", "1-1"), 0, 1),
    };
    const struct hid_identity who = someone(1, 2, "", "1-7");
    assert_int_equal(usb_choice_slot(place, &who), 1);
    place[0] = place_of(someone(1, 2, "", "1-8"), 0, 1); /* Two such are away: who knows. */
    assert_int_equal(usb_choice_slot(place, &who), 2);
}

static void test_a_seat_is_kept_for_a_while_and_then_given_away(void **state)
{
    (void)state;
    struct usb_place place[POI_MAX];
    const struct hid_identity stranger = someone(7, 7, "", "1-7");
    for (uint32_t i = 0; i < POI_MAX; i++) {
        place[i] = place_of(someone(1, (uint16_t)i, "", "1-1"), i != 2, 1);
    }
    assert_int_equal(usb_choice_slot(place, &stranger), POI_MAX);
    place[2].is_held = 0;
    assert_int_equal(usb_choice_slot(place, &stranger), 2);
}

/* ---- Rows ----------------------------------------------------------------------------------- */

static void test_rows_keep_their_places_and_barred_ones_give_way(void **state)
{
    (void)state;
    struct usb_device_table rows;
    usb_device_table_init(&rows);
    for (uint16_t i = 0; i < 6; i++) {
        const struct hid_identity who = someone(1, i, "", "1-1");
        const uint32_t row = usb_device_table_enter(&rows, &who, 1);
        assert_int_equal(row, i < 4 ? i : CONTROLLER_MAX); /* Four stay empty for others. */
    }
    for (uint16_t i = 0; i < 8; i++) {
        const struct hid_identity who = someone(2, i, "", "1-2");
        assert_true(usb_device_table_enter(&rows, &who, 0) < CONTROLLER_MAX);
        assert_true(usb_device_table_find(&rows, &who) < CONTROLLER_MAX);
    }
    const struct hid_identity ninth = someone(2, 9, "", "1-3");
    assert_int_equal(usb_device_table_enter(&rows, &ninth, 0), CONTROLLER_MAX);
    const struct hid_identity lost = someone(2, 5, "", "1-2");
    const uint32_t row = usb_device_table_find(&rows, &lost);
    rows.row[row].state = CONTROLLER_LOST;
    assert_int_equal(usb_device_table_enter(&rows, &lost, 0), row); /* Back in its own. */
    rows.row[row].state = CONTROLLER_LOST;
    assert_int_equal(usb_device_table_enter(&rows, &ninth, 0), row);
}

/* ---- The file ------------------------------------------------------------------------------- */

static void test_the_file_says_what_was_wished_and_is_whole_or_as_before(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-choice-XXXXXX", path[64], part[80], why[HAL_TEXT_SIZE] = "";
    struct usb_choice written = { 0 }, read = { 0 };
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/usb.txt", folder);
    snprintf(part, sizeof part, "%s.part", path);
    assert_int_equal(usb_choice_load(&read, path, why), 0); /* None yet: nothing is wrong. */
    wish(&written, "1209:0001:with space", 1, 1);
    wish(&written, "057e:2009", 0, 1);
    wish(&written, "1111:2222", 1, 0); /* Of the command line: not the file's. */
    assert_int_equal(usb_choice_save(&written, path), 0);
    assert_int_equal(usb_choice_load(&read, path, why), 0);
    assert_int_equal(read.wish_count, 2);
    assert_string_equal(read.wish[0].key.serial, "with space");
    assert_int_equal(read.wish[0].plays, 1);
    assert_int_equal(read.wish[1].key.product, 0x2009);
    assert_int_equal(read.wish[1].plays, 0);
    assert_int_equal(mkdir(part, 0755), 0); /* Nothing can be written beside it now. */
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
    assert_int_equal(choice.wish_count, 2);
    assert_non_null(strstr(why, path));
    unlink(path);
}

/* ---- Texts from devices --------------------------------------------------------------------- */

static void test_texts_cannot_break_a_line_or_a_terminal(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        { "Poi \n", "Poi" },
        { "a\x1b[31mb\tc", "a?[31mb?c" },
        { "\xe9\x87\x91\xe9\xad\x9a", "\xe9\x87\x91\xe9\xad\x9a" }, /* Kingyo. */
        { "x\xff\xfey long", "x??y long" },
        { "\xc2\x9b"
          "31m and more",
          "?31m and more" }, /* CSI in one character. */
        { "cut \xe9\x87", "cut " },
    };
    for (uint32_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char text[HID_TEXT_SIZE];
        snprintf(text, sizeof text, "%s", pairs[i][0]);
        usb_sysfs_clean_text(text);
        assert_string_equal(text, pairs[i][1]);
    }
}

/* ---- Nodes ---------------------------------------------------------------------------------- */

/* A pad's node lies deep under its device; two hubs up there is another one with a number. */
static void test_the_number_of_the_device_behind_a_node_is_found(void **state)
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
        cmocka_unit_test(test_keys_are_read_as_they_are_written),
        cmocka_unit_test(test_what_is_no_key_is_refused_and_leaves_the_old_one),
        cmocka_unit_test(test_only_our_own_poi_plays_by_itself),
        cmocka_unit_test(test_keys_and_nothings_are_barred_whoever_names_them),
        cmocka_unit_test(test_a_wish_with_a_serial_number_counts_more_than_one_without),
        cmocka_unit_test(test_a_full_list_forgets_its_oldest),
        cmocka_unit_test(test_real_devices_are_told_apart_by_their_descriptors),
        cmocka_unit_test(test_of_several_interfaces_the_one_that_leads_a_hand_best_is_claimed),
        cmocka_unit_test(test_keys_that_type_are_barred_with_whatever_is_beside_them),
        cmocka_unit_test(test_our_own_descriptor_is_known_to_the_last_byte),
        cmocka_unit_test(test_what_no_hand_leads_is_barred),
        cmocka_unit_test(test_who_comes_back_gets_its_own_seat),
        cmocka_unit_test(test_two_with_the_same_number_are_told_apart_by_their_ports),
        cmocka_unit_test(test_without_a_number_elsewhere_it_is_known_if_there_is_but_one),
        cmocka_unit_test(test_a_seat_is_kept_for_a_while_and_then_given_away),
        cmocka_unit_test(test_rows_keep_their_places_and_barred_ones_give_way),
        cmocka_unit_test(test_the_file_says_what_was_wished_and_is_whole_or_as_before),
        cmocka_unit_test(test_bad_lines_are_counted_and_named),
        cmocka_unit_test(test_texts_cannot_break_a_line_or_a_terminal),
        cmocka_unit_test(test_the_number_of_the_device_behind_a_node_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
