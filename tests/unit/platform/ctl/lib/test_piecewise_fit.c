/* test_piecewise_fit.c -- Tests the conversion of a curve to a table of samples. A more curved part
 * of the curve must get more samples. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "core/base/fmath.h"
#include "platform/ctl/lib/piecewise_fit.h"

#define TOLERANCE 1e-5f

static const float ends[2] = { 0.0f, 1.0f };

static float error(const void *self, const float *from, const float *to, const float *exact)
{
    (void)self;
    return f_abs(0.5f * (from[0] + to[0]) - exact[0]);
}

static void ask_line(const void *self, float progress, float *values)
{
    (void)self;
    values[0] = 3.0f * progress - 1.0f;
}

static void ask_parabola(const void *self, float progress, float *values)
{
    (void)self;
    values[0] = progress * progress;
}

/* Tested curve: 0 up to the progress `*self`, and then a rise with slope 1. */
static void ask_corner(const void *self, float progress, float *values)
{
    const float at = *(const float *)self;
    values[0] = f_max(progress - at, 0.0f);
}

/* Interpolates linearly between the samples, as a program that reads the file does. */
static float read_back(const struct piecewise_fit *track, float progress)
{
    uint32_t i = 1;
    while (track->progress[i] < progress) {
        i++;
    }
    const float from = track->progress[i - 1], to = track->progress[i];
    return f_lerp(track->values[i - 1], track->values[i], (progress - from) / (to - from));
}

static float worst(const struct piecewise_fit *track, const struct piecewise_fit_function *f)
{
    float far = 0.0f, exact;
    for (uint32_t i = 0; i <= 10000; i++) {
        const float progress = (float)i / 10000.0f;
        f->sample(f->self, progress, &exact);
        far = f_max(far, f_abs(read_back(track, progress) - exact));
    }
    return far;
}

static void test_a_straight_line_is_fitted_by_two_samples(void **state)
{
    (void)state;
    struct piecewise_fit track;
    assert_true(piecewise_fit_fit(
        &track, &(struct piecewise_fit_function){ 1, ask_line, error, NULL }, ends, 2, TOLERANCE));
    assert_int_equal(track.count, 2);
    assert_true(track.values[0] == -1.0f && track.values[1] == 2.0f);
    piecewise_fit_free(&track);
}

/* A chord over a step h differs from x^2 by at most h^2 / 4. The step 2^-8 is therefore the first
 * step with an error below about 1e-5, and 256 steps need 257 samples. */
static void test_the_step_of_a_parabola_follows_from_its_curvature(void **state)
{
    (void)state;
    struct piecewise_fit track;
    const struct piecewise_fit_function f = { 1, ask_parabola, error, NULL };
    assert_true(piecewise_fit_fit(&track, &f, ends, 2, TOLERANCE));
    assert_int_equal(track.count, 257);
    assert_true(worst(&track, &f) <= 1.1f * TOLERANCE);
    piecewise_fit_free(&track);
}

static void test_samples_concentrate_at_a_corner(void **state)
{
    (void)state;
    struct piecewise_fit track;
    const float corner = 0.377f;
    const struct piecewise_fit_function f = { 1, ask_corner, error, &corner };
    assert_true(piecewise_fit_fit(&track, &f, ends, 2, TOLERANCE));
    assert_true(track.count < 40);
    /* No sample lies exactly on the corner, so the error there may exceed the tolerance. */
    assert_true(worst(&track, &f) <= 4.0f * TOLERANCE);
    for (uint32_t i = 1; i < track.count; i++) {
        assert_true(track.progress[i] > track.progress[i - 1]);
    }
    piecewise_fit_free(&track);
}

static void test_a_mark_on_the_corner_needs_no_further_samples(void **state)
{
    (void)state;
    struct piecewise_fit track;
    const float corner = 0.375f, marks[3] = { 0.0f, 0.375f, 1.0f };
    const struct piecewise_fit_function f = { 1, ask_corner, error, &corner };
    assert_true(piecewise_fit_fit(&track, &f, marks, 3, TOLERANCE));
    assert_int_equal(track.count, 3);
    piecewise_fit_free(&track);
}

/* Tested curve with a jump, to which no polyline can be fitted within the tolerance. The fit must
 * nevertheless end. */
static void ask_step(const void *self, float progress, float *values)
{
    (void)self;
    values[0] = progress < 0.3f ? 0.0f : 1.0f;
}

static void test_a_discontinuity_stops_at_the_finest_step(void **state)
{
    (void)state;
    struct piecewise_fit track;
    assert_true(piecewise_fit_fit(
        &track, &(struct piecewise_fit_function){ 1, ask_step, error, NULL }, ends, 2, TOLERANCE));
    assert_int_equal(track.count, 2 + PIECEWISE_FIT_HALVINGS);
    piecewise_fit_free(&track);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_straight_line_is_fitted_by_two_samples),
        cmocka_unit_test(test_the_step_of_a_parabola_follows_from_its_curvature),
        cmocka_unit_test(test_samples_concentrate_at_a_corner),
        cmocka_unit_test(test_a_mark_on_the_corner_needs_no_further_samples),
        cmocka_unit_test(test_a_discontinuity_stops_at_the_finest_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
