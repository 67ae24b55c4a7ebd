/* test_ui_lab_preview.c -- Tests that the lab and `kingyoctl morph check` report the same bow of a
 * path. The bow is the largest distance of the path from a straight line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/ctl/morph/morph_survey.h"
#include "platform/render/ui/lab/ui_lab_preview.h"
#include "platform/species/part.h"

/* Largest difference that rounding causes between two computations of the same point, in body
 * lengths. */
#define SAME 1e-5f

static struct ui_lab_preview bench;
static struct morph_survey survey;

static void test_the_lab_and_morph_check_report_the_same_bow(void **state)
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
        assert_int_equal(dorsal->is_there,
                         part_vertex_range(&species->lod[0], PART_DORSAL, SIDE_MIDDLE) !=
                             species->lod[0].vertex_count);
        assert_float_equal(dorsal->bow, survey.dorsal_root, SAME);
        assert_true(eye->is_there);
        assert_true(f_abs(eye->bow - survey.eye_left) < SAME ||
                    f_abs(eye->bow - survey.eye_right) < SAME);
    }
}

/* v3_from_line() returns the perpendicular distance to the infinite line, even for a point beyond
 * the two ends. If the two ends are equal, the function returns the distance to them. */
static void test_the_bow_is_measured_from_an_infinite_line_or_a_point(void **state)
{
    (void)state;
    const vec3 from = { 0.0f, 0.0f, 0.0f }, to = { 0.0f, 0.0f, 2.0f };
    assert_float_equal(v3_from_line(v3(0.0f, 3.0f, 9.0f), from, to), 3.0f, 1e-6f);
    assert_float_equal(v3_from_line(v3(0.0f, 3.0f, 4.0f), from, from), 5.0f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_lab_and_morph_check_report_the_same_bow),
        cmocka_unit_test(test_the_bow_is_measured_from_an_infinite_line_or_a_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
