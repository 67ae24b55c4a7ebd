/* test_life.c -- checks the conversions between age, progress (0 .. 1) and length. They are checked
 * for a fish that only grows, for a fish that shrinks for a time, and for a custom size curve. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/morph.h"

#define STEPS 1000

/* Returns the card of a conger. Its larva grows from 64 to 125.5 mm, shrinks to an eel of 56 mm,
 * and grows again. The longest and the shortest stage are both between two keys, where an
 * interpolation of the keys would miss them. */
static struct species_card conger_card(void)
{
    struct species_card card = {
        .key_count = 4,
        .key_age_days = { 100.0f, 260.0f, 330.0f, 3650.0f },
        .key_length_m = { 0.064f, 0.0804f, 0.0725f, 1.0f },
        .growth = { 1.4f,
                    0.15f,
                    -0.3f,
                    0.4f,
                    6,
                    { { 0.0f, 0.006f },
                      { 100.0f, 0.064f },
                      { 220.0f, 0.1255f },
                      { 260.0f, 0.0804f },
                      { 300.0f, 0.056f },
                      { 330.0f, 0.0725f } } },
        .curve_count = 1,
    };
    card.key_length_m[3] = growth_length_m(&card.growth, card.key_age_days[3]);
    graph_from_template(&card.curves[0], TEMPLATE_PAIRWISE, card.key_count, SIMULTANEOUS_PEAK);
    return card;
}

static void assert_a_key_stands_at_its_age_and_length(const struct species_card *card)
{
    for (uint32_t key = 0; key < card->key_count; key++) {
        const float progress = (float)key / (float)(card->key_count - 1);
        assert_true(life_age_days(card, progress) == card->key_age_days[key]);
        assert_true(life_length_m(card, progress) == card->key_length_m[key]);
        assert_true(life_progress(card, card->key_age_days[key]) == progress);
    }
}

static void test_each_key_has_its_own_age_and_length(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    assert_a_key_stands_at_its_age_and_length(&species_wakin.card);
    assert_a_key_stands_at_its_age_and_length(&conger);
}

static void assert_age_rises_and_leads_back(const struct species_card *card)
{
    float before = -1.0f;
    for (int step = 0; step <= STEPS; step++) {
        const float progress = (float)step / STEPS;
        const float age_days = life_age_days(card, progress);
        assert_true(age_days > before);
        before = age_days;
        assert_float_equal(life_progress(card, age_days), progress, 2e-4f);
    }
}

static void test_age_and_progress_are_monotonic_and_inverse(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    assert_age_rises_and_leads_back(&species_wakin.card);
    assert_age_rises_and_leads_back(&conger);
}

static void test_progress_never_falls_with_age(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    float before = 0.0f;
    for (float age_days = 0.0f; age_days < 5000.0f; age_days += 0.5f) {
        const float progress = life_progress(&conger, age_days);
        assert_true(progress >= before && progress <= 1.0f);
        before = progress;
    }
    assert_true(before == 1.0f);
    assert_true(life_progress(&conger, 99.9f) == 0.0f);
}

static void test_length_is_the_growth_curve_at_that_age(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    const struct species_card *cards[2] = { &species_wakin.card, &conger };
    for (uint32_t i = 0; i < 2; i++) {
        for (int step = 0; step <= STEPS; step++) {
            const float progress = (float)step / STEPS;
            const float length_m = life_length_m(cards[i], progress);
            const float at_age_m =
                growth_length_m(&cards[i]->growth, life_age_days(cards[i], progress));
            assert_float_equal(length_m / at_age_m, 1.0f, 2e-3f);
        }
    }
}

static void test_a_conger_grows_shrinks_and_grows_again(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    float longest = 0.0f, shortest = 1.0f;
    uint32_t turns = 0;
    float before[2] = { life_length_m(&conger, 0.0f), life_length_m(&conger, 1.0f / STEPS) };
    for (int step = 2; step <= STEPS * 2 / 3; step++) {
        const float now = life_length_m(&conger, (float)step / STEPS);
        turns += (now > before[1]) != (before[1] > before[0]);
        before[0] = before[1];
        before[1] = now;
        longest = f_max(longest, now);
        shortest = f_min(shortest, now);
    }
    assert_int_equal(turns, 2);
    assert_float_equal(longest, 0.1255f, 1e-4f);
    assert_float_equal(shortest, 0.056f, 1e-4f);
}

static void test_a_length_reached_three_times_gives_the_first_progress(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    const float first = morph_progress(&conger, 0.09f);
    assert_float_equal(life_length_m(&conger, first), 0.09f, 1e-4f);
    assert_true(life_age_days(&conger, first) < 220.0f);
    /* A length of 60 mm is shorter than the first key (64 mm). The fish reaches this length first
     * while it shrinks, between day 260 and day 300. */
    const float shrunk = morph_progress(&conger, 0.060f);
    assert_float_equal(life_length_m(&conger, shrunk), 0.060f, 1e-4f);
    assert_true(life_age_days(&conger, shrunk) > 260.0f);
    assert_true(life_age_days(&conger, shrunk) < 300.0f);
    assert_true(morph_progress(&conger, 0.055f) == 0.0f);
    assert_true(morph_progress(&conger, 2.0f) == 1.0f);
}

static void test_length_converts_to_progress_and_back(void **state)
{
    (void)state;
    const struct species_card conger = conger_card();
    const struct species_card *cards[2] = { &species_wakin.card, &conger };
    for (uint32_t i = 0; i < 2; i++) {
        for (int step = 0; step <= STEPS; step++) {
            const float length_m = life_length_m(cards[i], (float)step / STEPS);
            const float progress = morph_progress(cards[i], length_m);
            assert_true(progress <= (float)step / STEPS + 1e-4f);
            assert_float_equal(life_length_m(cards[i], progress) / length_m, 1.0f, 1e-3f);
        }
    }
}

static void test_a_custom_size_curve_replaces_growth(void **state)
{
    (void)state;
    struct species_card card = conger_card();
    card.scale_knot_count = 4;
    card.scale_knots[0] = (struct scale_knot){ 0.0f, 0.01f };
    card.scale_knots[1] = (struct scale_knot){ 0.3f, 0.05f };
    card.scale_knots[2] = (struct scale_knot){ 0.6f, 0.03f };
    card.scale_knots[3] = (struct scale_knot){ 1.0f, 0.20f };
    for (uint32_t i = 0; i < 4; i++) {
        assert_true(life_length_m(&card, card.scale_knots[i].progress) ==
                    card.scale_knots[i].length_m);
    }
    for (int step = 0; step <= STEPS; step++) {
        const float length_m = life_length_m(&card, (float)step / STEPS);
        const float progress = morph_progress(&card, length_m);
        assert_true(length_m >= 0.01f && length_m <= 0.20f);
        assert_true(progress <= (float)step / STEPS + 1e-3f);
        assert_float_equal(life_length_m(&card, progress), length_m, 1e-5f);
    }
    assert_true(morph_progress(&card, 0.009f) == 0.0f);
    assert_true(morph_progress(&card, 0.21f) == 1.0f);
    /* The custom size curve must not change the ages. */
    assert_true(life_age_days(&card, 1.0f) == card.key_age_days[3]);
}

/* The lengths of these keys contradict the growth curve. Although no species should be defined like
 * this, the age must rise with the progress. */
static void test_age_rises_even_with_a_wrong_key_age(void **state)
{
    (void)state;
    struct species_card card = species_wakin.card;
    /* At this age the growth curve gives 74 mm, but the length of the key is 45 mm. */
    card.key_age_days[3] = 200.0f;
    assert_age_rises_and_leads_back(&card);
    assert_a_key_stands_at_its_age_and_length(&card);
    /* This length is below that of the previous key. */
    card.key_length_m[3] = 0.030f;
    assert_age_rises_and_leads_back(&card);
    /* This length is above that of the next key. */
    card.key_length_m[3] = 0.300f;
    assert_age_rises_and_leads_back(&card);
}

/* When a user begins to edit the size in the growth lab, the lab creates a custom curve through the
 * keys. This curve must equal the growth curve, because the size of the fish would otherwise
 * jump. */
static void test_a_custom_size_curve_through_the_keys_equals_growth(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        struct species_card card = species_table[i]->card;
        const uint32_t last = card.key_count - 1u;
        card.scale_knot_count = card.key_count;
        for (uint32_t key = 0; key <= last; key++) {
            card.scale_knots[key] =
                (struct scale_knot){ (float)key / (float)last, card.key_length_m[key] };
        }
        for (int step = 0; step <= STEPS; step++) {
            const float progress = (float)step / STEPS;
            const uint32_t key = (uint32_t)(progress * (float)last);
            const float *age = &card.key_age_days[key < last ? key : last - 1u];
            if (growth_is_one_way(&card.growth, age[0], age[1])) {
                const float before_m = life_length_m(&species_table[i]->card, progress);
                assert_float_equal(life_length_m(&card, progress) / before_m, 1.0f, 1e-5f);
            }
        }
    }
}

static void test_a_custom_size_curve_may_fall(void **state)
{
    (void)state;
    struct species_card card = species_wakin.card;
    card.scale_knot_count = 3;
    card.scale_knots[0] = (struct scale_knot){ 0.0f, 0.08f };
    card.scale_knots[1] = (struct scale_knot){ 0.5f, 0.02f };
    card.scale_knots[2] = (struct scale_knot){ 1.0f, 0.03f };
    assert_float_equal(life_length_m(&card, 0.25f), 0.04f, 1e-7f);
    float before = -1.0f;
    for (int step = 0; step <= STEPS; step++) {
        const float length_m = 0.08f - 0.06f * (float)step / STEPS;
        const float progress = morph_progress(&card, length_m);
        assert_true(progress > before);
        assert_float_equal(life_length_m(&card, progress), length_m, 1e-7f);
        before = progress;
    }
    assert_float_equal(before, 0.5f, 1e-5f);
}

static void test_a_constant_section_of_a_custom_size_curve_gives_its_start(void **state)
{
    (void)state;
    struct species_card card = species_wakin.card;
    card.scale_knot_count = 4;
    card.scale_knots[0] = (struct scale_knot){ 0.0f, 0.01f };
    card.scale_knots[1] = (struct scale_knot){ 0.5f, 0.01f };
    card.scale_knots[2] = (struct scale_knot){ 0.75f, 0.04f };
    card.scale_knots[3] = (struct scale_knot){ 1.0f, 0.04f };
    assert_true(morph_progress(&card, 0.01f) == 0.0f);
    assert_float_equal(morph_progress(&card, 0.04f), 0.75f, 1e-6f);
    /* After these changes, only the section between the knots 1 and 2 has the constant length 0.01
     * m. */
    card.scale_knots[0].length_m = 0.005f;
    card.scale_knots[2].length_m = 0.01f;
    assert_float_equal(morph_progress(&card, 0.01f), 0.5f, 1e-6f);
}

static void test_an_invalid_progress_or_age_fails_an_assertion(void **state)
{
    (void)state;
    const struct species_card *card = &species_wakin.card;
    expect_assert_failure(life_length_m(card, -0.01f));
    expect_assert_failure(life_length_m(card, 1.01f));
    expect_assert_failure(life_age_days(card, 1.01f));
    expect_assert_failure(life_progress(card, -1.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_key_has_its_own_age_and_length),
        cmocka_unit_test(test_age_and_progress_are_monotonic_and_inverse),
        cmocka_unit_test(test_progress_never_falls_with_age),
        cmocka_unit_test(test_length_is_the_growth_curve_at_that_age),
        cmocka_unit_test(test_a_conger_grows_shrinks_and_grows_again),
        cmocka_unit_test(test_a_length_reached_three_times_gives_the_first_progress),
        cmocka_unit_test(test_length_converts_to_progress_and_back),
        cmocka_unit_test(test_a_custom_size_curve_replaces_growth),
        cmocka_unit_test(test_age_rises_even_with_a_wrong_key_age),
        cmocka_unit_test(test_a_custom_size_curve_through_the_keys_equals_growth),
        cmocka_unit_test(test_a_custom_size_curve_may_fall),
        cmocka_unit_test(test_a_constant_section_of_a_custom_size_curve_gives_its_start),
        cmocka_unit_test(test_an_invalid_progress_or_age_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
