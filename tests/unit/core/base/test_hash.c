/* test_hash.c -- the hash that tells two states apart. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"

static void test_bytes_hash_as_fnv_1a_says(void **state)
{
    (void)state;
    /* The reference values of the FNV authors' own test vectors. */
    assert_true(hash_bytes(HASH_START, "", 0) == 0xcbf29ce484222325ull);
    assert_true(hash_bytes(HASH_START, "a", 1) == 0xaf63dc4c8601ec8cull);
    assert_true(hash_bytes(HASH_START, "foobar", 6) == 0x85944171f73967e8ull);
}

static void test_each_bit_of_a_word_counts(void **state)
{
    (void)state;
    for (uint32_t bit = 0; bit < 32; bit++) {
        assert_true(hash_u32(HASH_START, 1u << bit) != hash_u32(HASH_START, 0));
    }
}

static void test_the_order_of_words_counts(void **state)
{
    (void)state;
    assert_true(hash_u32(hash_u32(HASH_START, 1), 2) != hash_u32(hash_u32(HASH_START, 2), 1));
    assert_true(hash_u64(HASH_START, 0x200000001ull) == hash_u32(hash_u32(HASH_START, 1), 2));
}

static void test_the_sign_of_zero_counts(void **state)
{
    (void)state;
    assert_true(hash_float(HASH_START, 0.0f) != hash_float(HASH_START, -0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bytes_hash_as_fnv_1a_says),
        cmocka_unit_test(test_each_bit_of_a_word_counts),
        cmocka_unit_test(test_the_order_of_words_counts),
        cmocka_unit_test(test_the_sign_of_zero_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
