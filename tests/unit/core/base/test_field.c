/* test_field.c -- checks the tables of the members of a struct: their members must be visited in
 * order, and the hash must use each of them. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/field.h"
#include "core/base/hash.h"

struct leaf {
    int8_t sign;
    uint16_t high;
    uint8_t low;
};

struct tree {
    uint32_t count;
    uint8_t scratch[3];
    float number;
    uint16_t later[2];
    struct leaf leaf[3];
    uint16_t used[4];
    uint32_t parts[3];
};

/* clang-format off */
#define STRUCT leaf
static const struct field_table leaf_fields = FIELD_TABLE(leaf,
    FIELD_HIGH(high, 8), FIELD(low), FIELD_SIGN(sign));
#undef STRUCT

#define STRUCT tree
static const struct field_table tree_fields = FIELD_TABLE(tree,
    FIELD(number), FIELD_LATER(later, 7), FIELD_STRUCT_USED(leaf, &leaf_fields, count),
    FIELD(count), FIELD_AGAIN(number), FIELD_USED(used, count), FIELD_RANGE(parts[0], 1),
    FIELD_RANGE_SINCE(8, parts[1], 2, 20), FIELD_SKIP(scratch));
#undef STRUCT
/* clang-format on */

static const struct tree tree = {
    .count = 2,
    .scratch = { 1, 2, 3 },
    .number = 0.5f,
    .later = { 0, 9 },
    .leaf = { { -1, 0x102, 3 }, { 1, 4, 5 }, { 0, 6, 7 } },
    .used = { 11, 12, 13, 14 },
    .parts = { 15, 0, 16 },
};

static void test_the_hash_reads_the_members_in_the_order_of_the_table(void **state)
{
    (void)state;
    uint64_t hash = hash_u32(hash_u32(hash_u32(HASH_START, 0x3f000000), 8), 9);
    hash = hash_u32(hash_u32(hash, 0x10203), 0);
    hash = hash_u32(hash_u32(hash, 0x405), 2);
    hash = hash_u32(hash_u32(hash, 2), 0x3f000000);
    hash = hash_u32(hash_u32(hash, 11), 12);
    hash = hash_u32(hash_u32(hash_u32(hash, 15), 21), 16);
    assert_true(field_hash(HASH_START, &tree_fields, &tree) == hash);
}

static void test_every_bit_of_a_float_changes_the_hash(void **state)
{
    (void)state;
    const float changed[] = { nextafterf(0.5f, 1.0f), -0.5f };
    struct tree other = tree;
    for (size_t i = 0; i < 2; i++) {
        other.number = changed[i];
        assert_true(field_hash(1, &tree_fields, &other) != field_hash(1, &tree_fields, &tree));
    }
    struct tree zero = tree;
    zero.number = 0.0f;
    other.number = -0.0f;
    assert_true(field_hash(1, &tree_fields, &other) != field_hash(1, &tree_fields, &zero));
}

static void test_scratch_and_unused_elements_do_not_change_the_hash(void **state)
{
    (void)state;
    struct tree other = tree;
    memset(other.scratch, 0, sizeof other.scratch);
    other.leaf[2].low = 99;
    assert_true(field_hash(1, &tree_fields, &other) == field_hash(1, &tree_fields, &tree));
    other.leaf[1].low = 99;
    assert_true(field_hash(1, &tree_fields, &other) != field_hash(1, &tree_fields, &tree));
}

static void test_a_visit_in_memory_order_meets_every_member_once(void **state)
{
    (void)state;
    static const char *const names[] = { "count", "scratch",  "number",  "later", "sign",
                                         "high",  "low",      "sign",    "high",  "low",
                                         "used",  "parts[0]", "parts[1]" };
    struct field_cursor cursor = field_begin(&tree_fields, &tree, true);
    const uint8_t *at = NULL, *before = NULL;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct field *field = field_next(&cursor, &at);
        assert_non_null(field);
        assert_string_equal(field->name, names[i]);
        assert_true(before == NULL || at > before);
        before = at;
    }
    assert_null(field_next(&cursor, &at));
    assert_null(field_next(&cursor, &at));
}

static void test_too_many_used_elements_fail_an_assertion(void **state)
{
    (void)state;
    struct tree other = tree;
    other.count = 4;
    expect_assert_failure(field_hash(1, &tree_fields, &other));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_hash_reads_the_members_in_the_order_of_the_table),
        cmocka_unit_test(test_every_bit_of_a_float_changes_the_hash),
        cmocka_unit_test(test_scratch_and_unused_elements_do_not_change_the_hash),
        cmocka_unit_test(test_a_visit_in_memory_order_meets_every_member_once),
        cmocka_unit_test(test_too_many_used_elements_fail_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
