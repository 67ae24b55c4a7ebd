/* test_hash.c -- checks the hash function with which states are compared (FNV-1a). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"

static void test_byte_hashes_equal_fnv_1a(void **state)
{
    (void)state;
    /* Test vectors published by the authors of FNV-1a. */
    assert_true(hash_bytes(HASH_START, "", 0) == 0xcbf29ce484222325ull);
    assert_true(hash_bytes(HASH_START, "a", 1) == 0xaf63dc4c8601ec8cull);
    assert_true(hash_bytes(HASH_START, "foobar", 6) == 0x85944171f73967e8ull);
}

static void test_each_bit_of_a_word_changes_the_hash(void **state)
{
    (void)state;
    for (uint32_t bit = 0; bit < 32; bit++) {
        assert_true(hash_u32(HASH_START, 1u << bit) != hash_u32(HASH_START, 0));
    }
}

static void test_the_order_of_words_changes_the_hash(void **state)
{
    (void)state;
    assert_true(hash_u32(hash_u32(HASH_START, 1), 2) != hash_u32(hash_u32(HASH_START, 2), 1));
    assert_true(hash_u64(HASH_START, 0x200000001ull) == hash_u32(hash_u32(HASH_START, 1), 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_byte_hashes_equal_fnv_1a),
        cmocka_unit_test(test_each_bit_of_a_word_changes_the_hash),
        cmocka_unit_test(test_the_order_of_words_changes_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
