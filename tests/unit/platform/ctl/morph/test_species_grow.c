/* test_species_grow.c -- Tests that every built-in species grows without a flaw at 1001 ages in
 * both levels of detail. Also compares a flatfish with its ordinary (linear) morph. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/ctl/morph/morph_survey.h"

#define STEPS 1000

static struct morph_survey surveys[SPECIES_MAX][SPECIES_LOD_COUNT];

static int measure_all(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        struct morph_rig rig;
        morph_rig_init(&rig, &species_table[i]->card, TEMPLATE_OWN);
        for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
            morph_survey(species_table[i], &rig, lod, STEPS, &surveys[i][lod]);
        }
    }
    return 0;
}

/* Asserts that a value of the survey is at most `most` for all species and levels of detail. Prints
 * each species that exceeds `most`. */
#define MOST(figure, most)                                                                         \
    for (uint32_t i = 0; i < 2 * species_table_count; i++) {                                       \
        const struct morph_survey *s = &surveys[i / 2][i % 2];                                     \
        if (!(s->figure <= (most))) {                                                              \
            print_error("%s, lod %u: %s is %g\n", species_table[i / 2]->card.id, i % 2, #figure,   \
                        (double)s->figure);                                                        \
        }                                                                                          \
        assert_true(s->figure <= (most));                                                          \
    }

static uint32_t index_of(const char *id)
{
    uint32_t i = 0;
    while (strcmp(species_table[i]->card.id, id) != 0) {
        i++;
        assert_true(i < species_table_count);
    }
    return i;
}

static void test_weights_sum_to_one_at_every_moment(void **state)
{
    (void)state;
    MOST(sum_error, 1e-6f)
    MOST(drawn_sum_error, 2e-6f)
    MOST(weight_min, 1.0f)
    for (uint32_t i = 0; i < 2 * species_table_count; i++) {
        assert_true(surveys[i / 2][i % 2].weight_min >= 0.0f);
    }
}

static void test_every_key_is_reached_with_its_drawn_shape(void **state)
{
    (void)state;
    MOST(key_error.value, 0.0f)
    MOST(size_error.value, 0.01f)
    for (uint32_t i = 0; i < 2 * species_table_count; i++) {
        assert_int_equal(surveys[i / 2][i % 2].keys_alone, species_table[i / 2]->card.key_count);
    }
}

static void test_age_progress_and_length_are_inverse_functions(void **state)
{
    (void)state;
    MOST(moments_not_older, 0u)
    MOST(progress_lost.value, 2e-4f)
    MOST(length_lost.value, 1e-3f)
    MOST(off_growth.value, 0.02f)
}

static void test_no_triangle_turns_over(void **state)
{
    (void)state;
    MOST(flipped_skin, 0u)
    MOST(flipped_fins, 0u)
}

static void test_no_part_penetrates_the_body_beyond_its_limit(void **state)
{
    (void)state;
    MOST(moments_open, 0u)
    MOST(body_in_body.value, 0.0f)
    MOST(fin_in_body.value, 0.0005f)
    MOST(fin_in_eye.value, 0.0f)
    MOST(eye_in_body.value, 0.0f)
    MOST(root_off_skin.value, 0.001f)
}

static void test_no_pupil_is_inside_the_head_or_the_other_eye(void **state)
{
    (void)state;
    MOST(pupil_in_body.value, 0.0f)
    MOST(eye_in_eye.value, 0.0f)
}

static void test_no_stage_is_thinner_than_both_neighbouring_keys(void **state)
{
    (void)state;
    MOST(volume_dip.value, 0.02f)
}

/* The eye of a flatfish migrates to the other side of the head. Along the species' curves, the eye
 * moves around the head. In the ordinary (linear) morph each point moves in a straight line, so the
 * eye moves through the head. */
static void
test_the_migrating_eye_moves_around_the_head_but_through_it_in_the_ordinary_morph(void **state)
{
    (void)state;
    static struct straight_memory memory;
    static struct species straight;
    static struct morph_survey ordinary;
    struct morph_rig rig;
    const uint32_t hirame = index_of("hirame");
    straight_species(species_table[hirame], &memory, &straight);
    morph_rig_init(&rig, &straight.card, TEMPLATE_ORDINARY);
    morph_survey(&straight, &rig, 0, STEPS, &ordinary);
    assert_true(ordinary.pupil_in_body.value > 0.02f);
    assert_true(ordinary.eye_right < 1e-6f);
    assert_true(surveys[hirame][0].pupil_in_body.value == 0.0f);
    assert_true(surveys[hirame][0].eye_right > 0.05f);
}

static void test_the_dorsal_root_of_the_conger_moves_on_a_curve(void **state)
{
    (void)state;
    const struct morph_survey *conger = surveys[index_of("kuroanago")];
    assert_true(conger[0].dorsal_root > 0.005f);
    assert_true(conger[1].dorsal_root > 0.005f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_weights_sum_to_one_at_every_moment),
        cmocka_unit_test(test_every_key_is_reached_with_its_drawn_shape),
        cmocka_unit_test(test_age_progress_and_length_are_inverse_functions),
        cmocka_unit_test(test_no_triangle_turns_over),
        cmocka_unit_test(test_no_part_penetrates_the_body_beyond_its_limit),
        cmocka_unit_test(test_no_pupil_is_inside_the_head_or_the_other_eye),
        cmocka_unit_test(test_no_stage_is_thinner_than_both_neighbouring_keys),
        cmocka_unit_test(
            test_the_migrating_eye_moves_around_the_head_but_through_it_in_the_ordinary_morph),
        cmocka_unit_test(test_the_dorsal_root_of_the_conger_moves_on_a_curve),
    };
    return cmocka_run_group_tests(tests, measure_all, NULL);
}
