/* test_usb_kind.c -- tests how USB devices are classified by their report descriptors, and which of
 * a device's interfaces the driver claims. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>

#include "drivers/hid/poi_report.h"
#include "drivers/usb/usb_choice.h"

static struct hid_descriptor scratch;

static struct hid_identity identity_of(uint16_t vendor, uint16_t product, const char *serial,
                                       const char *port)
{
    struct hid_identity identity = { .vendor = vendor, .product = product };
    snprintf(identity.serial, sizeof identity.serial, "%s", serial);
    snprintf(identity.port, sizeof identity.port, "%s", port);
    return identity;
}

static void request(struct usb_choice *choice, const char *text, int plays, int kept)
{
    struct usb_key key;
    assert_int_equal(usb_key_read(&key, text), 0);
    usb_choice_request(choice, &key, plays, kept);
}

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

/* A device counts as a keyboard (USB_KIND_KEYS) if it has media keys or typing keys, even if it is
 * also a tablet or a mouse. A device that sends only vendor-defined bytes must be learned
 * (USB_KIND_LEARNABLE). */
static void test_real_devices_are_classified_by_their_descriptors(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint8_t kind;
    } devices[] = {
        { "002-3dconnexion-spacemouse-wireless", USB_KIND_MAPPED },
        { "006-blaze-joypad", USB_KIND_MAPPED },
        { "011-dell-413c-301a-mouse", USB_KIND_MAPPED },
        { "016-ci-dualsense", USB_KIND_MAPPED },
        { "038-hd-sony-054c-0268", USB_KIND_MAPPED },
        { "049-hd-wacom-pen-tablet-056a-0081", USB_KIND_MAPPED },
        { "137-dg-huion-h610-if0", USB_KIND_MAPPED },
        { "196-hr-0003-256c-006e-000a", USB_KIND_MAPPED },
        { "144-dg-kye-easypen-m406-if0", USB_KIND_MAPPED },
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

/* Returns the index of the interface that the driver would claim, out of the `count` interfaces of
 * one device. A null pointer in `names` stands for an interface whose descriptor was not read
 * yet. */
static uint32_t best_of(const struct usb_choice *choice, const char *const names[], uint32_t count)
{
    struct hid_identity identity[4];
    struct usb_candidate subject[4];
    uint32_t best = 0;
    for (uint32_t i = 0; i < count; i++) {
        identity[i] = identity_of(0x256c, 0x006e, "", "1-1");
        identity[i].interface_number = (uint8_t)i;
        subject[i] = names[i] ? subject_of(names[i], &identity[i])
                              : (struct usb_candidate){ .identity = &identity[i] };
        best = i > 0 && usb_choice_is_better(choice, &subject[i], &subject[best]) ? i : best;
    }
    return best;
}

/* A tablet may have one interface for its pen and a second, vendor-defined interface. A wireless
 * receiver may have one interface for a mouse and one for a keyboard. The driver must claim the pen
 * or the mouse. */
static void test_the_most_suitable_of_several_interfaces_is_claimed(void **state)
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
        request(&choice, "256c:006e", 1, 1);
    }
    /* The descriptor of the interface NULL is not known yet. Such an interface must be preferred to
     * a vendor-defined one, which would need learning, but not to a pen. */
    assert_int_equal(best_of(&choice, (const char *const[]){ vendor, NULL }, 2), 1);
    assert_int_equal(best_of(&choice, (const char *const[]){ pen, NULL }, 2), 0);
}

static void test_an_interface_with_typing_keys_is_excluded(void **state)
{
    (void)state;
    static const char *const names[] = {
        "160-dg-xp-pen-star-06-if1",
        "207-hr-libinput-issue366-0003-046d-4082-0",
        "209-hr-libinput-issue410-0003-1532-0224-0",
        "214-hr-libinput-issue477-0003-28de-1142-0",
    };
    struct usb_choice choice = { 0 };
    const struct hid_identity device = identity_of(0x1234, 0x5678, "", "1-1");
    request(&choice, "1234:5678", 1, 1);
    for (uint32_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct usb_candidate subject = subject_of(names[i], &device);
        assert_int_equal(usb_choice_evaluate(&choice, &subject), USB_BARRED);
    }
}

static void test_the_kingyo_descriptor_is_compared_in_every_byte(void **state)
{
    (void)state;
    uint8_t bytes[POI_DESCRIPTOR_SIZE];
    memcpy(bytes, poi_descriptor, sizeof bytes);
    assert_int_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_OWN);
    assert_int_equal(kind_of_bytes(bytes, 0), USB_KIND_UNKNOWN);
    /* With this changed usage page, the descriptor is no longer that of a Kingyo poi. */
    bytes[1] ^= 1u;
    assert_int_not_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_OWN);
    static const uint8_t cut_off[] = { 0x05 };
    assert_int_equal(kind_of_bytes(cut_off, sizeof cut_off), USB_KIND_NOTHING);
}

static void test_devices_without_pointing_or_game_usages_are_excluded(void **state)
{
    (void)state;
    /* Each row has a usage page (low byte first) and a usage: a UPS, a FIDO key and a headset. */
    static const uint8_t pages[][3] = { { 0x84, 0x00, 0x04 },
                                        { 0xd0, 0xf1, 0x01 },
                                        { 0x0b, 0x00, 0x05 } };
    for (uint32_t i = 0; i < sizeof pages / sizeof pages[0]; i++) {
        const uint8_t bytes[] = { 0x06, pages[i][0], pages[i][1], 0x09, pages[i][2], 0xa1, 0x01,
                                  0x09, 0x20,        0x15,        0x00, 0x25,        0x7f, 0x75,
                                  0x08, 0x95,        0x01,        0x81, 0x02,        0xc0 };
        assert_int_equal(kind_of_bytes(bytes, sizeof bytes), USB_KIND_KEYS);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_real_devices_are_classified_by_their_descriptors),
        cmocka_unit_test(test_the_most_suitable_of_several_interfaces_is_claimed),
        cmocka_unit_test(test_an_interface_with_typing_keys_is_excluded),
        cmocka_unit_test(test_the_kingyo_descriptor_is_compared_in_every_byte),
        cmocka_unit_test(test_devices_without_pointing_or_game_usages_are_excluded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
