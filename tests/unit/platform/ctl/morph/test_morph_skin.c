/* test_morph_skin.c -- Tests the distance of a point to a closed surface, and whether the point is
 * classified correctly as inside or outside. The surface is a box. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/ctl/morph/morph_survey.h"

/* A box from -1 to 1 in x, -0.5 to 0.5 in y, and -2 to 2 in z, with 8 corners and 12 triangles. */
static const uint16_t box_indices[36] = {
    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
};
static struct species_vertex vertices[8];
static vec3 corners[8];
static struct species_mesh box = {
    .vertex_count = 8, .index_count = 36, .vertices = vertices, .indices = box_indices
};
static struct morph_skin skin;

static int new_box(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; i++) {
        corners[i] = v3(i & 1u ? 1.0f : -1.0f, i & 2u ? 0.5f : -0.5f, i & 4u ? 2.0f : -2.0f);
        vertices[i] = (struct species_vertex){ .part = PART_BODY };
    }
    box.index_count = 36;
    morph_skin_build(&skin, &box, corners, PART_BODY, SIDE_MIDDLE);
    return 0;
}

static void test_the_volume_of_a_closed_box_is_correct(void **state)
{
    (void)state;
    assert_float_equal(morph_skin_volume(&skin), 16.0f / 2.0f, 1e-5f);
    assert_true(morph_skin_is_closed(&skin));
    box.index_count = 33;
    morph_skin_build(&skin, &box, corners, PART_BODY, SIDE_MIDDLE);
    assert_false(morph_skin_is_closed(&skin));
    morph_skin_build(&skin, &box, corners, PART_EYE, SIDE_MIDDLE);
    assert_false(morph_skin_is_closed(&skin));
    assert_false(morph_skin_has(&skin, v3(0.0f, 0.0f, 0.0f)));
}

/* Tests the points of a lattice. Many lines between lattice points pass through corners, edges and
 * diagonals of the box. A wrong ray test counts such a crossing twice or not at all. */
static void test_every_lattice_point_is_classified_as_inside_or_outside(void **state)
{
    (void)state;
    for (int x = -5; x <= 5; x++) {
        for (int y = -8; y <= 8; y++) {
            for (int z = -20; z <= 20; z++) {
                const vec3 p =
                    v3(0.3f * (float)x, 0.0625f * 1.01f * (float)y, 0.125f * 1.01f * (float)z);
                const bool inside = f_abs(p.x) < 1.0f && f_abs(p.y) < 0.5f && f_abs(p.z) < 2.0f;
                assert_int_equal(morph_skin_has(&skin, p), inside);
            }
        }
    }
}

static void test_distances_to_faces_edges_and_corners_are_correct(void **state)
{
    (void)state;
    assert_float_equal(morph_skin_distance(&skin, v3(0.0f, 0.0f, 0.0f)), 0.5f, 1e-6f);
    assert_float_equal(morph_skin_distance(&skin, v3(0.9f, 0.0f, 0.3f)), 0.1f, 1e-6f);
    assert_float_equal(morph_skin_distance(&skin, v3(1.3f, 0.9f, 0.3f)), 0.5f, 1e-6f);
    assert_float_equal(morph_skin_distance(&skin, v3(2.0f, 2.5f, 4.0f)), 3.0f, 1e-6f);
}

static void test_the_exit_distance_is_measured_along_the_given_direction(void **state)
{
    (void)state;
    const vec3 p = v3(0.1f, 0.2f, 0.3f);
    assert_float_equal(morph_skin_way_out(&skin, p, v3(1.0f, 0.0f, 0.0f)), 0.9f, 1e-5f);
    assert_float_equal(morph_skin_way_out(&skin, p, v3(0.0f, -1.0f, 0.0f)), 0.7f, 1e-5f);
    assert_float_equal(morph_skin_way_out(&skin, v3(5.0f, 0.0f, 0.0f), v3(1.0f, 0.0f, 0.0f)), 0.0f,
                       0.0f);
}

static void test_only_the_given_part_and_side_are_used(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; i++) {
        vertices[i].part = PART_EYE;
        vertices[i].side = SIDE_LEFT;
    }
    morph_skin_build(&skin, &box, corners, PART_EYE, SIDE_LEFT);
    assert_true(morph_skin_has(&skin, v3(0.0f, 0.0f, 0.0f)));
    morph_skin_build(&skin, &box, corners, PART_EYE, SIDE_RIGHT);
    assert_false(morph_skin_has(&skin, v3(0.0f, 0.0f, 0.0f)));
    morph_skin_build(&skin, &box, corners, PART_BODY, SIDE_MIDDLE);
    assert_int_equal(skin.triangle_count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_volume_of_a_closed_box_is_correct, new_box),
        cmocka_unit_test_setup(test_every_lattice_point_is_classified_as_inside_or_outside,
                               new_box),
        cmocka_unit_test_setup(test_distances_to_faces_edges_and_corners_are_correct, new_box),
        cmocka_unit_test_setup(test_the_exit_distance_is_measured_along_the_given_direction,
                               new_box),
        cmocka_unit_test_setup(test_only_the_given_part_and_side_are_used, new_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
