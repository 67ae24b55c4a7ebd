/* test_box.c -- checks the gap between oriented boxes against known distances. Compares also the
 * fast overlap test with the complete test. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/collision/box.h"

#define NEAR 1e-5f

static float draw(uint32_t who, uint32_t purpose, float low, float high)
{
    return rng_range((struct rng_key){ 11, 0, who, purpose }, low, high);
}

static struct box level_box(vec3 centre, float yaw_deg)
{
    return (struct box){ .centre_m = centre,
                         .axes =
                             vec_basis_from_angles((struct angles){ yaw_deg * F_DEG, 0.0f, 0.0f }),
                         .half_m = { 0.005f, 0.010f, 0.025f } };
}

static struct box any_box(uint32_t who, float pitch_max)
{
    struct box box = level_box(
        v3(draw(who, 1, -0.03f, 0.03f), draw(who, 2, -0.02f, 0.02f), draw(who, 3, -0.03f, 0.03f)),
        0.0f);
    box.axes = vec_basis_from_angles((struct angles){ draw(who, 4, -F_PI, F_PI),
                                                      draw(who, 5, -pitch_max, pitch_max),
                                                      draw(who, 6, -pitch_max, pitch_max) });
    return box;
}

static void test_boxes_in_a_row_have_the_distance_of_their_faces(void **state)
{
    (void)state;
    const struct box a = level_box(v3(0.0f, 0.0f, 0.0f), 0.0f),
                     b = level_box(v3(0.013f, 0.0f, 0.0f), 0.0f);
    const struct box_gap gap = box_gap(&a, 0.01f, &b, 0.01f);
    assert_float_equal(gap.body_m, 0.003f, NEAR);
    assert_float_equal(gap.space_m, 0.003f - 0.02f, NEAR);
    assert_float_equal(gap.axis.x, 1.0f, NEAR);
    assert_float_equal(box_depth_m(&a, &b), 0.0f, NEAR);
}

static void test_the_axis_points_from_the_first_to_the_second(void **state)
{
    (void)state;
    const struct box a = level_box(v3(0.0f, 0.0f, 0.0f), 0.0f),
                     b = level_box(v3(0.0f, -0.018f, 0.0f), 30.0f);
    const struct box_gap gap = box_gap(&a, 0.01f, &b, 0.01f);
    assert_float_equal(gap.axis.y, -1.0f, NEAR);
    assert_float_equal(gap.body_m, -0.002f, NEAR);
    assert_float_equal(box_depth_m(&a, &b), 0.002f, NEAR);
}

static void test_moving_along_the_axis_by_the_depth_separates_two_boxes(void **state)
{
    (void)state;
    uint32_t parted = 0;
    for (uint32_t i = 0; i < 4000; i += 2) {
        const struct box a = any_box(i, 0.5f);
        struct box b = any_box(i + 1u, 0.5f);
        const struct box_gap gap = box_gap(&a, 0.0f, &b, 0.0f);
        if (gap.body_m < 0.0f) {
            b.centre_m = v3_muladd(b.centre_m, gap.axis, -gap.body_m + 1e-6f);
            assert_true(box_depth_m(&a, &b) < 1e-6f);
            const vec3 way = v3_sub(b.centre_m, a.centre_m);
            const vec3 same = box_axis(&a.axes, &b.axes, way, gap.which);
            assert_true(v3_dot(same, gap.axis) > 0.9999f);
            parted++;
        }
    }
    assert_true(parted > 200);
}

/* Tests two crossed bars. No normal of a face separates them, but the cross product of two edges
 * does. */
static void test_crossed_edges_separate_boxes_that_no_face_separates(void **state)
{
    (void)state;
    const vec3 half = v3(0.01f, 0.01f, 0.04f);
    const struct angles rolled = { 0.0f, 0.0f, 45.0f * F_DEG },
                        crossed = { 90.0f * F_DEG, 0.0f, 45.0f * F_DEG };
    /* Each bar is rotated by 45 degrees about its axis, so that an edge is on top. This edge is
     * 1.414 cm above the centre of the bar. The centres are 3 cm apart. */
    const struct box a = { v3(0.0f, 0.0f, 0.0f), vec_basis_from_angles(rolled), half },
                     b = { v3(0.0f, 0.030f, 0.0f), vec_basis_from_angles(crossed), half };
    const struct box_gap gap = box_gap(&a, 0.01f, &b, 0.01f);
    assert_float_equal(gap.body_m, 0.030f - 2.0f * 0.01414214f, NEAR);
    assert_float_equal(gap.axis.y, 1.0f, NEAR);
    assert_float_equal(box_depth_m(&a, &b), 0.0f, NEAR);
}

static void test_a_common_point_means_an_overlap(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4000; i += 2) {
        const struct box a = any_box(i, 0.6f);
        struct box b = any_box(i + 1u, 0.6f);
        const vec3 in_a =
            v3(draw(i, 7, -0.9f, 0.9f) * a.half_m.x, draw(i, 8, -0.9f, 0.9f) * a.half_m.y,
               draw(i, 9, -0.9f, 0.9f) * a.half_m.z);
        const vec3 in_b =
            v3(draw(i, 10, -0.9f, 0.9f) * b.half_m.x, draw(i, 11, -0.9f, 0.9f) * b.half_m.y,
               draw(i, 12, -0.9f, 0.9f) * b.half_m.z);
        const vec3 shared = v3_add(a.centre_m, vec_basis_to_world(&a.axes, in_a));
        b.centre_m = v3_sub(shared, vec_basis_to_world(&b.axes, in_b));
        assert_true(box_depth_m(&a, &b) > 0.0f);
    }
}

static void test_enlarged_boxes_meet_before_bodies_do(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4000; i += 2) {
        const struct box a = any_box(i, 0.5f), b = any_box(i + 1u, 0.5f);
        struct box big_a = a, big_b = b;
        big_a.half_m = v3_add(a.half_m, v3(0.004f, 0.004f, 0.004f));
        big_b.half_m = v3_add(b.half_m, v3(0.007f, 0.007f, 0.007f));
        const struct box_gap gap = box_gap(&a, 0.004f, &b, 0.007f);
        const struct box_gap grown = box_gap(&big_a, 0.0f, &big_b, 0.0f);
        assert_int_equal(gap.space_m > 0.0f, grown.body_m > 0.0f);
    }
}

static void test_the_shortest_move_across_a_rod_clears_it(void **state)
{
    (void)state;
    const struct box box = level_box(v3(0.0f, 0.0f, 0.0f), 0.0f);
    const vec3 up = v3(0.0f, 1.0f, 0.0f), right = v3(1.0f, 0.0f, 0.0f);
    const vec3 beside = box_clear_rod(&box, v3(0.007f, 0.0f, 0.0f), up, 0.003f);
    assert_float_equal(beside.x, -0.001f, NEAR);
    assert_float_equal(v3_length(box_clear_rod(&box, v3(0.009f, 0.0f, 0.0f), up, 0.003f)), 0.0f,
                       NEAR);
    /* A rod lies across the fish. The shortest way to free the box must be up or down, never along
     * the rod. */
    const vec3 across = box_clear_rod(&box, v3(0.0f, 0.002f, 0.0f), right, 0.003f);
    assert_float_equal(across.x, 0.0f, NEAR);
    assert_float_equal(across.y, -0.011f, NEAR);
}

static void test_the_axis_aligned_box_contains_every_corner(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 500; i++) {
        const struct box box = any_box(i, 1.5f);
        const vec3 extent = box_extent_m(&box);
        for (int corner = 0; corner < 8; corner++) {
            const vec3 p =
                vec_basis_to_world(&box.axes, v3(corner & 1 ? box.half_m.x : -box.half_m.x,
                                                 corner & 2 ? box.half_m.y : -box.half_m.y,
                                                 corner & 4 ? box.half_m.z : -box.half_m.z));
            assert_true(f_abs(p.x) <= extent.x + 1e-6f);
            assert_true(f_abs(p.y) <= extent.y + 1e-6f);
            assert_true(f_abs(p.z) <= extent.z + 1e-6f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_boxes_in_a_row_have_the_distance_of_their_faces),
        cmocka_unit_test(test_the_axis_points_from_the_first_to_the_second),
        cmocka_unit_test(test_moving_along_the_axis_by_the_depth_separates_two_boxes),
        cmocka_unit_test(test_crossed_edges_separate_boxes_that_no_face_separates),
        cmocka_unit_test(test_a_common_point_means_an_overlap),
        cmocka_unit_test(test_enlarged_boxes_meet_before_bodies_do),
        cmocka_unit_test(test_the_shortest_move_across_a_rod_clears_it),
        cmocka_unit_test(test_the_axis_aligned_box_contains_every_corner),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
