/* test_lab_book.c -- checks the hash of the species book, which contains the loaded species and the
 * edited graphs. The hash must depend on each number in the book. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/game_fields.h"
#include "core/base/hash.h"
#include "core/game/lab/lab_edit.h"

static struct lab_book book;

static int setup(void **state)
{
    (void)state;
    memset(&book, 0, sizeof book);
    book.card_count = 1;
    book.cards[0] = species_table[0]->card;
    return 0;
}

/* Checks that a change of `value` changes the hash of the book. */
static void expect_hashed(float *value)
{
    const uint64_t before = field_hash(HASH_START, &lab_book_fields, &book);
    const float kept = *value;
    *value += 0.25f;
    assert_true(field_hash(HASH_START, &lab_book_fields, &book) != before);
    *value = kept;
    assert_true(field_hash(HASH_START, &lab_book_fields, &book) == before);
}

static void test_the_hash_depends_on_each_number_of_a_growth_curve(void **state)
{
    (void)state;
    struct growth *growth = &book.cards[0].growth;
    expect_hashed(&growth->length_inf_m);
    expect_hashed(&growth->k_per_year);
    expect_hashed(&growth->t0_year);
    expect_hashed(&growth->fade_year);
    for (uint32_t i = 0; i < GROWTH_POINT_MAX; i++) {
        expect_hashed(&growth->points[i].age_days);
        expect_hashed(&growth->points[i].length_m);
    }
}

static void test_the_hash_depends_on_each_number_of_a_saved_graph(void **state)
{
    (void)state;
    struct lab_edit *edit = &book.edits[0];
    book.has_edit[0] = 1;
    lab_edit_own(edit, &book.cards[0]);
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        expect_hashed(&edit->graph.knots[i].progress);
        expect_hashed(&edit->scale_knots[i].progress);
        expect_hashed(&edit->scale_knots[i].length_m);
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            expect_hashed(&edit->graph.knots[i].weight[key]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_hash_depends_on_each_number_of_a_growth_curve, setup),
        cmocka_unit_test_setup(test_the_hash_depends_on_each_number_of_a_saved_graph, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
