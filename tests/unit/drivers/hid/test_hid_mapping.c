/* test_hid_mapping.c -- tests which mapping each of 72 real devices gets. Also tests the validation
 * and the text form of mappings. */
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/hid/poi_report.h"
#include "tests/unit/support/hid_wire.h"

static struct clock_sim clock_now;
static struct hid_wire wire;

static struct hid_mapping map_of(const char *name, uint16_t vendor, uint16_t product)
{
    struct hid_mapping map;
    wire_load(&wire, &clock_now, name);
    wire.face.identity.vendor = vendor;
    wire.face.identity.product = product;
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    return map;
}

static const struct hid_binding *binding_of(const struct hid_mapping *map, enum hid_role role)
{
    for (uint32_t i = 0; i < map->count; i++) {
        if (map->binding[i].role == role) {
            return &map->binding[i];
        }
    }
    return NULL;
}

/* ---- Real devices --------------------------------------------------------------------------- */

struct expected {
    const char *name;
    uint8_t style;
    uint8_t manner, x_report; /* Expected binding of the X axis: kind and report id. */
    uint32_t x_offset;
};

/* The expected mappings were derived by hand from the declared fields (tests/hid/good/fields.tsv),
 * not from the output of the code. */
static const struct expected expected[] = {
    { "002-3dconnexion-spacemouse-wireless", HID_STYLE_FLY, HID_BINDING_RATE, 1, 0 },
    { "006-blaze-joypad", HID_STYLE_FLY, HID_BINDING_RATE, 1, 40 },
    { "008-8bitdo-ultimate-bt-adapter", HID_STYLE_FLY, HID_BINDING_RATE, 48, 16 },
    { "010-8bitdo-sn30pro-bt-dinput", HID_STYLE_FLY, HID_BINDING_RATE, 3, 8 },
    { "011-dell-413c-301a-mouse", HID_STYLE_POINTER, HID_BINDING_STEP, 0, 32 },
    { "012-compact-keyboard-2222-0099-if1", HID_STYLE_NONE, 0, 0, 0 },
    { "020-ci-luna-usb", HID_STYLE_FLY, HID_BINDING_RATE, 1, 24 },
    { "023-ci-xusb-arcadestick", HID_STYLE_FLY, HID_BINDING_HAT, 0, 16 },
    { "027-ci-xusb-gamepad2", HID_STYLE_FLY, HID_BINDING_RATE, 0, 0 },
    { "033-ci-xboxone-model-1708-bluetooth", HID_STYLE_FLY, HID_BINDING_RATE, 1, 0 },
    { "036-hd-ion-15e4-0132", HID_STYLE_NONE, 0, 0, 0 },
    { "038-hd-sony-054c-0268", HID_STYLE_FLY, HID_BINDING_RATE, 1, 40 },
    { "041-hd-kye-0458-0138-1", HID_STYLE_NONE, 0, 0, 0 },
    { "064-hd-atmel-03eb-211c", HID_STYLE_POINTER, HID_BINDING_POSITION, 1, 8 },
    { "135-dg-aiptek-apt-2-if0", HID_STYLE_POINTER, HID_BINDING_POSITION, 2, 0 },
    { "137-dg-huion-h610-if0", HID_STYLE_POINTER, HID_BINDING_POSITION, 7, 8 },
    { "144-dg-kye-easypen-m406-if0", HID_STYLE_POINTER, HID_BINDING_POSITION, 16, 8 },
    { "157-dg-xp-pen-deco-01-if0", HID_STYLE_POINTER, HID_BINDING_POSITION, 9, 8 },
    { "173-ha-046d-b010-0002-0001", HID_STYLE_POINTER, HID_BINDING_STEP, 2, 8 },
    { "175-ha-046d-b010-0006-0001", HID_STYLE_NONE, 0, 0, 0 },
    { "187-hr-0003-045e-0040-0004", HID_STYLE_POINTER, HID_BINDING_STEP, 0, 8 },
    { "194-hr-0003-256c-006e-0008", HID_STYLE_POINTER, HID_BINDING_POSITION, 8, 8 },
    { "203-hr-libinput-issue201-0003-06a3-0c2d-0", HID_STYLE_FLY, HID_BINDING_RATE, 0, 0 },
    { "207-hr-libinput-issue366-0003-046d-4082-0", HID_STYLE_NONE, 0, 0, 0 },
};

static void test_the_mapping_follows_from_the_descriptor(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const struct expected *want = &expected[i];
        const struct hid_mapping map = map_of(want->name, 0x1111, 0x2222);
        const struct hid_binding *x = binding_of(&map, HID_ROLE_X);
        if (map.style != want->style || (want->style && (!x || x->manner != want->manner))) {
            fail_msg("%s is played otherwise", want->name);
        }
        if (x) {
            assert_int_equal(x->report_id, want->x_report);
            assert_int_equal(x->bit_offset, want->x_offset);
        }
    }
}

static bool is_keyboard(const char *name)
{
    static const char *const keyboards[] = {
        "012", "036", "041", "151", "175", "207", "209", "214"
    };
    for (uint32_t i = 0; i < sizeof keyboards / sizeof keyboards[0]; i++) {
        if (strncmp(name, keyboards[i], 3) == 0) {
            return true;
        }
    }
    return false;
}

/* Calls `visit` for the report descriptor of every device in the folder CORPUS. Returns the number
 * of devices that have a mapping. */
static uint32_t each_device(void (*visit)(const char *name, const struct hid_mapping *map))
{
    DIR *folder = opendir(CORPUS);
    const struct dirent *file;
    uint32_t count = 0, playable = 0;
    assert_non_null(folder);
    while ((file = readdir(folder)) != NULL) {
        char name[128];
        const size_t length = strlen(file->d_name);
        if (length < 5 || strcmp(file->d_name + length - 4, ".hid") != 0) {
            continue;
        }
        snprintf(name, sizeof name, "%.*s", (int)(length - 4), file->d_name);
        const struct hid_mapping map = map_of(name, 0x1111, 0x2222);
        visit(name, &map);
        count++;
        playable += map.source != HID_MAPPING_NONE;
    }
    closedir(folder);
    assert_int_equal(count, 72);
    return playable;
}

static void is_sound_or_none(const char *name, const struct hid_mapping *map)
{
    if (map->source != HID_MAPPING_NONE && !hid_mapping_is_sound(map, &wire.descriptor)) {
        fail_msg("%s has a map that is not sound", name);
    }
    if (is_keyboard(name) && map->source != HID_MAPPING_NONE) {
        fail_msg("%s is a keyboard", name);
    }
}

static void test_every_real_device_has_a_valid_mapping_or_none(void **state)
{
    (void)state;
    const uint32_t playable = each_device(is_sound_or_none);
    print_message("%u of 72 real descriptors can be played as they are\n", playable);
    assert_true(playable >= 48);
}

static void expect_round_trip(const char *name, const struct hid_mapping *map)
{
    char text[HID_MAPPING_TEXT_SIZE], why[HAL_TEXT_SIZE] = "";
    struct hid_mapping back;
    if (map->source == HID_MAPPING_NONE) {
        return;
    }
    assert_int_equal(hid_mapping_write(map, text), 0);
    if (hid_mapping_read(&back, text, why) != 0) {
        fail_msg("%s: %s", name, why);
    }
    assert_int_equal(back.count, map->count);
    for (uint32_t i = 0; i < map->count; i++) {
        const struct hid_binding *one = &map->binding[i], *other = &back.binding[i];
        assert_int_equal(one->role, other->role);
        assert_int_equal(one->manner, other->manner);
        assert_int_equal(one->report_id, other->report_id);
        assert_int_equal(one->bit_offset, other->bit_offset);
        assert_int_equal(one->bit_size, other->bit_size);
        assert_int_equal(one->is_signed, other->is_signed);
        assert_int_equal(one->usage, other->usage);
        assert_int_equal(one->rest, other->rest);
        assert_int_equal(one->full, other->full);
        assert_int_equal(one->dead, other->dead);
    }
}

static void test_a_mapping_is_unchanged_by_writing_and_reading(void **state)
{
    (void)state;
    each_device(expect_round_trip);
}

static void test_a_kingyo_poi_of_any_vendor_is_recognized_by_its_descriptor(void **state)
{
    (void)state;
    struct hid_mapping map;
    wire_begin(&wire, &clock_now, poi_descriptor, POI_DESCRIPTOR_SIZE);
    wire.face.identity.vendor = 0x1209;
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(map.source, HID_MAPPING_OWN);
    assert_int_equal(map.style, HID_STYLE_POSE);
    assert_true(map.feels);
    map = map_of("002-3dconnexion-spacemouse-wireless", 0x1209, 0x0001);
    /* With another vendor and product id, a device with six axes is not recognized as a Kingyo
     * poi. */
    assert_int_equal(map.source, HID_MAPPING_AUTO);
}

static void test_a_playstation_gamepad_is_recognized_by_its_usb_ids(void **state)
{
    (void)state;
    const struct hid_mapping known = map_of("016-ci-dualsense", 0x054c, 0x0ce6);
    const struct hid_mapping edge = map_of("016-ci-dualsense", 0x054c, 0x0df2);
    const struct hid_mapping other = map_of("016-ci-dualsense", 0x1234, 0x0ce6);
    assert_int_equal(known.source, HID_MAPPING_KNOWN);
    assert_int_equal(edge.source, HID_MAPPING_KNOWN);
    assert_int_equal(other.source, HID_MAPPING_AUTO);
    /* Bit 69 of this gamepad's report is the button OPTIONS, which must be mapped to START. */
    assert_int_equal(binding_of(&known, HID_ROLE_START)->bit_offset, 69);
    const struct hid_mapping fourth = map_of(KNOWN "054c-05c4-dualshock4", 0x054c, 0x05c4);
    assert_int_equal(fourth.source, HID_MAPPING_KNOWN);
    assert_int_equal(binding_of(&fourth, HID_ROLE_START)->bit_offset, 45);
}

static void test_a_known_mapping_that_does_not_match_the_descriptor_is_unused(void **state)
{
    (void)state;
    const struct hid_mapping map = map_of("187-hr-0003-045e-0040-0004", 0x054c, 0x0ce6);
    /* The USB ids are those of a known gamepad, but the descriptor is that of a mouse. The mapping
     * must follow the descriptor. */
    assert_int_equal(map.source, HID_MAPPING_AUTO);
    assert_int_equal(map.style, HID_STYLE_POINTER);
}

/* The buttons of device 027 have one bit each, but declare a range of 0 to 65535. */
static void test_a_range_wider_than_its_field_is_limited_to_the_field(void **state)
{
    (void)state;
    const struct hid_mapping map = map_of("027-ci-xusb-gamepad2", 0x1111, 0x2222);
    assert_int_equal(binding_of(&map, HID_ROLE_DIP)->full, 1);
}

/* ---- Validation ----------------------------------------------------------------------------- */

static void test_each_invalid_value_makes_a_mapping_invalid(void **state)
{
    (void)state;
    const struct hid_mapping good = map_of("016-ci-dualsense", 0x054c, 0x0ce6);
    assert_true(hid_mapping_is_sound(&good, &wire.descriptor));
#define SPOIL(statement)                                                                           \
    do {                                                                                           \
        struct hid_mapping map = good;                                                             \
        statement;                                                                                 \
        assert_false(hid_mapping_is_sound(&map, &wire.descriptor));                                \
    } while (0)
    SPOIL(map.source = HID_MAPPING_NONE);
    SPOIL(map.source = HID_MAPPING_LEARNED + 1);
    SPOIL(map.style = HID_STYLE_NONE);
    SPOIL(map.style = HID_STYLE_POSE); /* The style for poses is invalid, because only a Kingyo poi
                                          reports poses. */
    /* The pointer style is invalid, because a pointer reports positions and the axes of this device
     * report velocities. */
    SPOIL(map.style = HID_STYLE_POINTER);
    SPOIL(map.count = HID_BINDING_MAX + 1u);
    SPOIL(map.count = 1); /* With one binding, the mapping lacks the Z axis. */
    SPOIL(map.binding[0].role = HID_ROLE_NONE);
    SPOIL(map.binding[0].role = HID_ROLE_COUNT);
    SPOIL(map.binding[0].manner = HID_BINDING_PRESS);
    SPOIL(map.binding[0].manner = HID_BINDING_KIND_COUNT);
    SPOIL(map.binding[0].report_id = 2); /* The descriptor has no report 2. */
    SPOIL(map.binding[0].bit_offset = wire.descriptor.report_bits[1] - 7u);
    SPOIL(map.binding[0].bit_offset = UINT32_MAX);
    SPOIL(map.binding[0].bit_size = 0);
    SPOIL(map.binding[0].bit_size = 33);
    SPOIL(map.binding[0].full = map.binding[0].rest);
    SPOIL(map.binding[0].full = HID_VALUE_MAX + 1);
    SPOIL(map.binding[0].rest = INT64_MIN);
    SPOIL(map.binding[0].dead = -1);
    SPOIL(map.binding[0].dead = 127);
    SPOIL(map.binding[5].usage = 0x00070004); /* The descriptor has no array with this usage. */
#undef SPOIL
    struct hid_mapping last = good;
    /* A binding that ends exactly at the end of the report is valid. */
    last.binding[0].bit_offset = wire.descriptor.report_bits[1] - 8u;
    assert_true(hid_mapping_is_sound(&last, &wire.descriptor));
}

/* ---- Text form ------------------------------------------------------------------------------ */

static void test_an_invalid_text_is_rejected_with_a_reason(void **state)
{
    static const char *const lines[] = {
        "",
        "learned",
        "none fly",
        "somewhere fly",
        "learned hop",
        "learned fly x",
        "learned fly x=rate",
        "learned fly x=rate:1",
        "learned fly x=rate:1:u8@0",
        "learned fly x=rate:256:u8@0:0..1",
        "learned fly x=rate:-1:u8@0:0..1",
        "learned fly x=rate:1:f8@0:0..1",
        "learned fly x=rate:1:u0@0:0..1",
        "learned fly x=rate:1:u33@0:0..1",
        "learned fly x=rate:1:u8@70000:0..1",
        "learned fly x=rate:1:u8@0:0..4294967296",
        "learned fly x=rate:1:u8@0:0..99999999999999999999",
        "learned fly x=rate:1:u8@0:0..1~0",
        "learned fly x=rate:1:u8@0:0..1/0",
        "learned fly x=rate:1:u8@0:0..1 ",
        "learned fly x=rate:1:u8@0:0..1x",
        "learned fly X=rate:1:u8@0:0..1",
        "learned fly none=rate:1:u8@0:0..1",
        "learned fly x=run:1:u8@0:0..1",
    };
    (void)state;
    for (uint32_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        struct hid_mapping map;
        char why[HAL_TEXT_SIZE] = "";
        const int ends_in_space = strlen(lines[i]) > 0 && lines[i][strlen(lines[i]) - 1] == ' ';
        const int result = hid_mapping_read(&map, lines[i], why);
        if (ends_in_space ? result != 0 : result == 0 || !why[0]) {
            fail_msg("'%s' was taken wrongly: %s", lines[i], why);
        }
    }
}

static void test_a_line_with_too_many_bindings_is_rejected(void **state)
{
    char line[HID_MAPPING_TEXT_SIZE] = "learned fly", why[HAL_TEXT_SIZE] = "";
    struct hid_mapping map;
    (void)state;
    for (uint32_t i = 0; i < HID_BINDING_MAX; i++) {
        strcat(line, " x=rate:1:u8@0:0..1");
    }
    assert_int_equal(hid_mapping_read(&map, line, why), 0);
    assert_int_equal(map.count, HID_BINDING_MAX);
    strcat(line, " x=rate:1:u8@0:0..1");
    assert_int_equal(hid_mapping_read(&map, line, why), -1);
    assert_non_null(strstr(why, "too many bindings"));
}

static void test_the_longest_mapping_fits_into_its_line(void **state)
{
    char line[HID_MAPPING_TEXT_SIZE], why[HAL_TEXT_SIZE];
    struct hid_mapping map = { .source = HID_MAPPING_AUTO,
                               .style = HID_STYLE_POINTER,
                               .trembles = 1,
                               .feels = 1,
                               .count = HID_BINDING_MAX },
                       back;
    (void)state;
    for (uint32_t i = 0; i < HID_BINDING_MAX; i++) {
        map.binding[i] = (struct hid_binding){
            .role = HID_ROLE_SEQUENCE,
            .manner = HID_BINDING_POSITION,
            .report_id = 255,
            .bit_offset = HID_REPORT_BITS_MAX,
            .bit_size = 32,
            .is_signed = 1,
            .usage = UINT32_MAX,
            .rest = -HID_VALUE_MAX,
            .full = -HID_VALUE_MAX + 1,
            .dead = HID_VALUE_MAX,
        };
    }
    assert_int_equal(hid_mapping_write(&map, line), 0);
    assert_int_equal(hid_mapping_read(&back, line, why), 0);
    assert_int_equal(back.binding[HID_BINDING_MAX - 1u].usage, UINT32_MAX);
    assert_true(back.binding[HID_BINDING_MAX - 1u].rest == -HID_VALUE_MAX);
    assert_true(back.binding[HID_BINDING_MAX - 1u].dead == HID_VALUE_MAX);
}

/* Loads a simulated joystick with two axes. The joystick has four buttons. An array field of
 * `elements` elements reports the numbers of the pressed buttons. */
static void load_array(uint8_t elements)
{
    const uint8_t bytes[] = { 0x05, 1,    0x09, 4,        0xa1, 1, 0x09, 0x30, 0x09, 0x31,
                              0x15, 0x81, 0x25, 127,      0x75, 8, 0x95, 2,    0x81, 2,
                              0x05, 9,    0x19, 1,        0x29, 4, 0x15, 1,    0x25, 4,
                              0x75, 8,    0x95, elements, 0x81, 0, 0xc0 };
    wire_begin(&wire, &clock_now, bytes, sizeof bytes);
}

static void test_an_array_with_many_elements_is_not_bound(void **state)
{
    struct hid_mapping map;
    (void)state;
    load_array(HID_ARRAY_MAX);
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(map.style, HID_STYLE_FLY);
    assert_int_equal(binding_of(&map, HID_ROLE_DIP)->usage, USAGE_BUTTON + 1u);
    load_array(HID_ARRAY_MAX + 1u);
    /* `map` was made for the array of HID_ARRAY_MAX elements, and the device now has a larger
     * array. A mapping file can contain such an outdated mapping, which must be rejected. */
    assert_false(hid_mapping_is_sound(&map, &wire.descriptor));
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    /* The array is too large to be used. There is therefore no button for the dip, and no automatic
     * mapping. */
    assert_int_equal(map.source, HID_MAPPING_NONE);
}

static void test_a_touchpad_with_a_mouse_report_is_mapped_as_a_mouse(void **state)
{
    static const char *const gamepads[] = { "073-hd-elan-04f3-300b",
                                            "211-hr-libinput-issue423-0018-0488-121f-0",
                                            "218-hr-libinput-issue674-0018-0911-5288-0" };
    struct hid_mapping map;
    (void)state;
    for (uint32_t i = 0; i < 3; i++) {
        wire_load(&wire, &clock_now, gamepads[i]);
        hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
        assert_int_equal(map.style, HID_STYLE_POINTER);
        assert_int_equal(binding_of(&map, HID_ROLE_X)->manner, HID_BINDING_STEP);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_mapping_follows_from_the_descriptor),
        cmocka_unit_test(test_every_real_device_has_a_valid_mapping_or_none),
        cmocka_unit_test(test_a_mapping_is_unchanged_by_writing_and_reading),
        cmocka_unit_test(test_a_kingyo_poi_of_any_vendor_is_recognized_by_its_descriptor),
        cmocka_unit_test(test_a_playstation_gamepad_is_recognized_by_its_usb_ids),
        cmocka_unit_test(test_a_known_mapping_that_does_not_match_the_descriptor_is_unused),
        cmocka_unit_test(test_a_range_wider_than_its_field_is_limited_to_the_field),
        cmocka_unit_test(test_each_invalid_value_makes_a_mapping_invalid),
        cmocka_unit_test(test_an_invalid_text_is_rejected_with_a_reason),
        cmocka_unit_test(test_a_line_with_too_many_bindings_is_rejected),
        cmocka_unit_test(test_the_longest_mapping_fits_into_its_line),
        cmocka_unit_test(test_an_array_with_many_elements_is_not_bound),
        cmocka_unit_test(test_a_touchpad_with_a_mouse_report_is_mapped_as_a_mouse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
