/* test_view.c -- checks the point of the world that is computed for the position of a pointer. The
 * camera must show this point at the pointer. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/view.h"

static const struct view above = {
    .eye_m = { 0.0f, 0.8f, 0.6f },
    .target_m = { 0.0f, 0.0f, 0.05f },
    .half_height_tan = 0.3f,
    .aspect_min = 1.6f,
};

/* Projects a point of the world to the screen, as the renderer does it. */
static void project(const struct view *view, float aspect, vec3 point, float *x, float *y)
{
    const struct basis axes = view_basis(view);
    const vec3 eye = vec_basis_to_body(&axes, v3_sub(point, view->eye_m));
    const float tan_y = view_half_height_tan(view, aspect);
    *x = eye.x / (-eye.z * tan_y * aspect);
    *y = eye.y / (-eye.z * tan_y);
}

static void assert_ray_comes_back(float aspect, float x, float y)
{
    const vec3 point = view_point_on_plane(&above, aspect, x, y, -0.04f);
    float px, py;
    project(&above, aspect, point, &px, &py);
    assert_true(fabsf(point.y + 0.04f) < 1e-4f);
    assert_true(fabsf(px - x) < 1e-3f && fabsf(py - y) < 1e-3f);
}

static void test_projecting_the_point_under_the_pointer_returns_the_pointer(void **state)
{
    (void)state;
    const float aspects[] = { 0.5625f, 1.3333f, 1.7778f, 2.4f };
    for (uint32_t a = 0; a < 4; a++) {
        for (int i = -9; i <= 9; i++) {
            for (int j = -9; j <= 5; j++) {
                assert_ray_comes_back(aspects[a], (float)i * 0.1f, (float)j * 0.1f);
            }
        }
    }
}

static void test_a_ray_above_the_horizon_ends_at_a_finite_point(void **state)
{
    (void)state;
    const struct view level = { .eye_m = { 0, 0.5f, 1 },
                                .target_m = { 0, 0.5f, 0 },
                                .half_height_tan = 0.5f,
                                .aspect_min = 1.0f };
    const vec3 point = view_point_on_plane(&level, 1.7f, 0.3f, 0.9f, 0.0f);
    assert_true(v3_is_finite(point));
    assert_true(v3_length(v3_sub(point, level.eye_m)) < 4.001f);
}

static void test_a_narrow_screen_keeps_the_minimum_field_of_view(void **state)
{
    (void)state;
    const float at_min = view_half_height_tan(&above, 1.6f) * 1.6f;
    const float narrow = view_half_height_tan(&above, 0.5625f) * 0.5625f;
    assert_true(fabsf(at_min - narrow) < 1e-5f);
    assert_true(view_half_height_tan(&above, 2.4f) == above.half_height_tan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_projecting_the_point_under_the_pointer_returns_the_pointer),
        cmocka_unit_test(test_a_ray_above_the_horizon_ends_at_a_finite_point),
        cmocka_unit_test(test_a_narrow_screen_keeps_the_minimum_field_of_view),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
