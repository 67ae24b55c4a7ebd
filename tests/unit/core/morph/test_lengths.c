/* test_lengths.c -- compares the lengths of the fish with known lengths at certain ages, and with
 * the lengths of the stages in the 2005 thesis. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/morph/morph.h"

#define YEAR 365.25f
/* Relative tolerance for a length that comes from a published or fitted growth curve. */
#define FITTED 0.10f
/* Tolerance for the lengths in the captions of the thesis: half a unit of their last digit. */
#define DRAWN_M 0.00005f

static const struct species_card *card_of(const char *id)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(species_table[i]->card.id, id) == 0) {
            return &species_table[i]->card;
        }
    }
    fail_msg("no species %s", id);
    return NULL;
}

/* Known lengths from von Bertalanffy growth curves. The curves of bigeye (mebachi) and hirame are
 * published. The other curves are fitted to reports of keepers and anglers. Hirame's published
 * total lengths are multiplied by 0.86 to get standard lengths. */
static const struct {
    const char *id;
    float age_years, length_m;
} published[] = {
    { "mebachi", 0.25f, 0.208f },  { "mebachi", 1.0f, 0.60f },   { "mebachi", 3.0f, 1.11f },
    { "mebachi", 5.0f, 1.43f },    { "mebachi", 10.0f, 1.84f },  { "hirame", 3.0f, 0.435f },
    { "hirame", 10.0f, 0.674f },   { "wakin", 0.25f, 0.039f },   { "wakin", 1.0f, 0.116f },
    { "wakin", 3.0f, 0.21f },      { "kurodai", 1.0f, 0.12f },   { "kurodai", 3.0f, 0.22f },
    { "kurodai", 10.0f, 0.43f },   { "shimafugu", 1.0f, 0.18f }, { "shimafugu", 3.0f, 0.38f },
    { "shimafugu", 10.0f, 0.54f }, { "kuroanago", 3.0f, 0.55f }, { "kuroanago", 10.0f, 1.10f },
};

static void test_fish_have_the_known_length_at_their_age(void **state)
{
    (void)state;
    uint32_t missed = 0;
    for (size_t i = 0; i < sizeof published / sizeof published[0]; i++) {
        const struct species_card *card = card_of(published[i].id);
        const float length_m = growth_length_m(&card->growth, published[i].age_years * YEAR);
        if (f_abs(length_m - published[i].length_m) > FITTED * published[i].length_m) {
            missed++;
            print_message("# %s of %.2f years is %.3f m, should be %.3f\n", published[i].id,
                          (double)published[i].age_years, (double)length_m,
                          (double)published[i].length_m);
        }
    }
    assert_int_equal(missed, 0);
}

/* Lengths of the stages in chapter 4 of the 2005 thesis. They are standard lengths (without the
 * tail) for hirame, and total lengths for the others. For example, hirame's first stage has a total
 * length of 11 mm and a standard length of 9.5 mm. */
static const struct {
    const char *id;
    float length_mm[3];
    uint8_t template_id;
} stages[] = {
    { "kurodai", { 1.9f, 5.5f, 12.0f }, TEMPLATE_PAIRWISE },
    { "shimafugu", { 2.65f, 12.2f, 25.8f }, TEMPLATE_PAIRWISE },
    { "kuroanago", { 64.0f, 80.4f, 72.5f }, TEMPLATE_PAIRWISE },
    { "hirame", { 9.5f, 12.0f, 13.0f }, TEMPLATE_SIMULTANEOUS },
};

static void test_the_thesis_stages_have_its_lengths_and_its_templates(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof stages / sizeof stages[0]; i++) {
        const struct species_card *card = card_of(stages[i].id);
        assert_int_equal(card->thesis_template, stages[i].template_id);
        for (uint32_t k = 0; k < 3; k++) {
            assert_float_equal(card->key_length_m[card->thesis_key[k]],
                               0.001f * stages[i].length_mm[k], DRAWN_M);
        }
    }
}

static void test_the_last_key_of_each_fish_is_an_adult(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_card *card = &species_table[i]->card;
        assert_string_equal(card->key_names[card->key_count - 1u], "adult");
        assert_true(card->key_age_days[card->key_count - 1u] > YEAR);
    }
}

/* A page of pictures in the thesis shows nine larvae and young fish with their lengths, in the
 * order of their growth. */
static void test_a_conger_grows_shrinks_and_grows_through_all_nine_measured_lengths(void **state)
{
    (void)state;
    static const float length_mm[] = { 64.0f, 90.5f, 125.5f, 104.5f, 80.4f,
                                       75.0f, 66.5f, 56.0f,  72.5f };
    const struct growth *growth = &card_of("kuroanago")->growth;
    assert_int_equal(growth->point_count, 10); /* The table has nine measured points and the
                                                  hatching. */
    float longest = 0.0f;
    for (uint32_t i = 0; i < 9; i++) {
        const float age_days = growth->points[i + 1u].age_days;
        assert_float_equal(growth_length_m(growth, age_days), 0.001f * length_mm[i], DRAWN_M);
    }
    for (float age_days = 0.0f; age_days <= growth->points[9].age_days; age_days += 0.5f) {
        longest = f_max(longest, growth_length_m(growth, age_days));
    }
    assert_float_equal(longest, 0.1255f, DRAWN_M);
    for (float age_days = growth->points[3].age_days; age_days <= 400.0f; age_days += 0.5f) {
        assert_true(growth_length_m(growth, age_days) >= 0.056f - DRAWN_M);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_have_the_known_length_at_their_age),
        cmocka_unit_test(test_the_thesis_stages_have_its_lengths_and_its_templates),
        cmocka_unit_test(test_the_last_key_of_each_fish_is_an_adult),
        cmocka_unit_test(test_a_conger_grows_shrinks_and_grows_through_all_nine_measured_lengths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
