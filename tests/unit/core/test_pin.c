/* test_pin.c -- checks the salted hash of the operator's PIN, and SHA-256 with the test vectors of
 * its standard, FIPS 180-4. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/sha256.h"
#include "core/pin.h"
#include "core/settings.h"

static void expect_digest(const char *message, const uint32_t expected[SHA256_WORDS])
{
    uint32_t digest[SHA256_WORDS];
    sha256_short((const uint8_t *)message, strlen(message), digest);
    assert_memory_equal(digest, expected, sizeof digest);
}

/* Test vectors from csrc.nist.gov ("Example algorithms"). The second message is empty. */
static void test_digests_equal_those_of_the_standard(void **state)
{
    (void)state;
    static const uint32_t abc[] = { 0xba7816bf, 0x8f01cfea, 0x414140de, 0x5dae2223,
                                    0xb00361a3, 0x96177a9c, 0xb410ff61, 0xf20015ad };
    static const uint32_t empty[] = { 0xe3b0c442, 0x98fc1c14, 0x9afbf4c8, 0x996fb924,
                                      0x27ae41e4, 0x649b934c, 0xa495991b, 0x7852b855 };
    expect_digest("abc", abc);
    expect_digest("", empty);
}

static void test_the_longest_message_fits_beside_its_padding(void **state)
{
    (void)state;
    static const uint32_t expected[] = { 0x9f4390f8, 0xd30c2dd9, 0x2ec9f095, 0xb65e2b9a,
                                         0xe9b0a925, 0xa5258e24, 0x1c9f1e91, 0x0f734318 };
    char message[SHA256_MESSAGE_MAX + 1u];
    memset(message, 'a', SHA256_MESSAGE_MAX);
    message[SHA256_MESSAGE_MAX] = '\0';
    expect_digest(message, expected);
}

static void test_a_hidden_pin_matches_its_digits(void **state)
{
    (void)state;
    for (uint32_t pin = 1; pin <= PIN_MAX; pin++) {
        const int32_t kept = pin_hide(pin, pin * 2654435761u);
        assert_true(kept < 0);
        assert_int_not_equal(kept, PIN_WITHHELD);
        assert_false(pin_is_plain(kept));
        assert_true(pin_matches(kept, pin));
        assert_true(settings_allows(SET_PIN, kept));
    }
}

/* A hash of a PIN has 20 bits, so two different PINs have the same hash in one of about a million
 * cases. The test compares 100 x 9,998 pairs, so about one pair should match. */
static void test_other_pins_rarely_match(void **state)
{
    (void)state;
    uint32_t others = 0;
    for (uint32_t pin = 50; pin <= 5000; pin += 50) {
        const int32_t kept = pin_hide(pin, pin);
        for (uint32_t other = 0; other <= PIN_MAX; other++) {
            others += other != pin && pin_matches(kept, other);
        }
    }
    assert_in_range(others, 0, 5);
}

static void test_equal_pins_with_another_salt_differ(void **state)
{
    (void)state;
    assert_int_not_equal(pin_hide(407, 1), pin_hide(407, 2));
    /* A stored salt of 0 would mean "no salt", so pin_hide() replaces 0 by 1. Larger salts are
     * limited to 11 bits. */
    assert_int_equal(pin_hide(407, 0), pin_hide(407, 1));
    assert_int_equal(pin_hide(407, 2047), pin_hide(407, UINT32_MAX));
}

static void test_plain_absent_and_withheld_pins_are_distinguished(void **state)
{
    (void)state;
    assert_int_equal(pin_hide(0, 7), 0);
    assert_true(pin_is_plain(407) && pin_is_plain(PIN_MAX));
    assert_false(pin_is_plain(0) || pin_is_plain(PIN_MAX + 1) || pin_is_plain(-407));
    assert_true(pin_matches(407, 407));
    assert_false(pin_matches(407, 408));
    for (uint32_t pin = 0; pin <= PIN_MAX; pin++) {
        assert_false(pin_matches(PIN_WITHHELD, pin));
    }
}

static void test_settings_hide_a_plain_pin_once(void **state)
{
    (void)state;
    static struct settings settings;
    settings_reset(&settings);
    settings_hide_pin(&settings, 5);
    assert_int_equal(settings.value[SET_PIN], 0);
    settings.value[SET_PIN] = 407;
    settings_hide_pin(&settings, 5);
    const int32_t kept = settings.value[SET_PIN];
    assert_true(pin_matches(kept, 407));
    settings_hide_pin(&settings, 6);
    assert_int_equal(settings.value[SET_PIN], kept);
    settings_sanitize(&settings);
    assert_int_equal(settings.value[SET_PIN], kept);
}

static void test_only_hashes_of_format_7_include_the_pin(void **state)
{
    (void)state;
    static struct settings settings, other;
    settings_reset(&settings);
    settings_reset(&other);
    other.value[SET_PIN] = 407;
    assert_true(settings_hash(1, &settings, 0) == settings_hash(1, &other, 0));
    assert_true(settings_hash(1, &settings, 1) != settings_hash(1, &other, 1));
    other.value[SET_VOLUME] -= 5;
    assert_true(settings_hash(1, &settings, 0) != settings_hash(1, &other, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_digests_equal_those_of_the_standard),
        cmocka_unit_test(test_the_longest_message_fits_beside_its_padding),
        cmocka_unit_test(test_a_hidden_pin_matches_its_digits),
        cmocka_unit_test(test_other_pins_rarely_match),
        cmocka_unit_test(test_equal_pins_with_another_salt_differ),
        cmocka_unit_test(test_plain_absent_and_withheld_pins_are_distinguished),
        cmocka_unit_test(test_settings_hide_a_plain_pin_once),
        cmocka_unit_test(test_only_hashes_of_format_7_include_the_pin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
