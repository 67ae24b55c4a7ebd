/* test_wire_fit.c -- tests the straight line that is fitted to the calibration marks of a draw
 * wire. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/draw_wires.h"
#include "core/base/fmath.h"

static struct wire_fit four_marks(float off_m)
{
    static const float steps[4] = { 700.0f, 1500.0f, 2600.0f, 3900.0f };
    struct wire_fit fit = { 0 };
    for (uint32_t i = 0; i < 4; i++) {
        draw_wires_fit_add(&fit, steps[i], 0.21f + 0.000244f * steps[i] + (i % 2 ? off_m : -off_m));
    }
    return fit;
}

static void test_marks_on_a_line_give_that_line(void **state)
{
    (void)state;
    const char *why;
    struct wire_fit fit = four_marks(0.0f);
    assert_true(draw_wires_fit_solve(&fit, &why));
    assert_float_equal(fit.step_m, 0.000244f, 1e-9f);
    assert_float_equal(fit.zero_m, 0.21f, 1e-6f);
    assert_true(fit.miss_m < 1e-6f);
}

static void test_a_converter_that_counts_down_gives_a_line(void **state)
{
    (void)state;
    const char *why;
    struct wire_fit fit = { 0 };
    for (uint32_t i = 0; i < 3; i++) {
        draw_wires_fit_add(&fit, 4000.0f - 1000.0f * (float)i, 0.2f + 0.25f * (float)i);
    }
    assert_true(draw_wires_fit_solve(&fit, &why));
    assert_float_equal(fit.step_m, -0.00025f, 1e-9f);
}

static void test_only_large_deviations_from_the_line_are_reported(void **state)
{
    (void)state;
    const char *why = NULL;
    struct wire_fit hair = four_marks(0.001f), hand = four_marks(0.010f);
    assert_true(draw_wires_fit_solve(&hair, &why));
    assert_true(hair.miss_m > 0.0005f && hair.miss_m < 0.002f);
    assert_false(draw_wires_fit_solve(&hand, &why));
    assert_non_null(strstr(why, "misplaced"));
}

static void test_two_marks_or_a_constant_wire_are_rejected(void **state)
{
    (void)state;
    const char *why = NULL;
    struct wire_fit two = { 0 }, still = { 0 };
    draw_wires_fit_add(&two, 100.0f, 0.3f);
    draw_wires_fit_add(&two, 3000.0f, 0.9f);
    assert_false(draw_wires_fit_solve(&two, &why));
    assert_non_null(strstr(why, "three"));
    for (uint32_t i = 0; i < 4; i++) {
        draw_wires_fit_add(&still, 2000.0f + (float)i, 0.3f + 0.1f * (float)i);
    }
    assert_false(draw_wires_fit_solve(&still, &why));
    assert_non_null(strstr(why, "hardly changed"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_marks_on_a_line_give_that_line),
        cmocka_unit_test(test_a_converter_that_counts_down_gives_a_line),
        cmocka_unit_test(test_only_large_deviations_from_the_line_are_reported),
        cmocka_unit_test(test_two_marks_or_a_constant_wire_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
