/* test_ui_lab_preview.c -- what the lab says of a part's way is what `kingyoctl morph check`
 * says. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/ctl/morph/morph_survey.h"
#include "platform/render/ui/lab/ui_lab_preview.h"

#define SAME 1e-5f /* Body lengths: rounding of two ways to the same point. */

static struct ui_lab_preview bench;
static struct morph_survey survey;

static void test_the_lab_and_check_tell_the_same_bow(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species *species = species_table[i];
        struct morph_rig rig;
        morph_rig_init(&rig, &species->card, TEMPLATE_OWN);
        morph_survey(species, &rig, 0, LAB_PREVIEW_STEPS, &survey);
        ui_lab_preview_set(&bench, species, &species->card);
        const struct lab_preview_path *dorsal = &bench.ways[LAB_PREVIEW_DORSAL],
                                      *eye = &bench.ways[LAB_PREVIEW_EYE];
        assert_int_equal(dorsal->is_there, survey.dorsal_root.vertex != MORPH_SURVEY_NOWHERE);
        assert_float_equal(dorsal->bow, survey.dorsal_root.from_chord, SAME);
        assert_true(eye->is_there);
        assert_true(f_abs(eye->bow - survey.eye_left.from_chord) < SAME ||
                    f_abs(eye->bow - survey.eye_right.from_chord) < SAME);
    }
}

/* The line has no ends: a way that overshoots its last place does not bow for that. */
static void test_a_line_has_no_ends_and_a_point_is_one(void **state)
{
    (void)state;
    const vec3 from = { 0.0f, 0.0f, 0.0f }, to = { 0.0f, 0.0f, 2.0f };
    assert_float_equal(v3_from_line(v3(0.0f, 3.0f, 9.0f), from, to), 3.0f, 1e-6f);
    assert_float_equal(v3_from_line(v3(0.0f, 3.0f, 4.0f), from, from), 5.0f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_lab_and_check_tell_the_same_bow),
        cmocka_unit_test(test_a_line_has_no_ends_and_a_point_is_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
