/* test_morph_pose.c -- checks anchors, which are the points of the skin to which fins and eyes are
 * attached. A fin must stay on the blended skin. An eye must move around the head and never through
 * it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/support/barrel.h"

#define STEPS 1000

static struct barrel barrel;
static struct morph_rig rig;
static struct morph_pose pose;
static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];

static const struct species_mesh *const mesh = &barrel.species.lod[0];

static int new_barrel(void **state)
{
    (void)state;
    barrel_init(&barrel);
    morph_rig_init(&rig, &barrel.species.card, TEMPLATE_OWN);
    return 0;
}

static void shape_at(float progress)
{
    morph_pose(&rig, mesh, progress, &pose);
    morph_shape(mesh, rig.key_count, &pose, positions, normals);
}

static float from_axis(vec3 p)
{
    return f_sqrt(p.x * p.x + p.y * p.y);
}

static void assert_near(vec3 a, vec3 b, float tolerance)
{
    assert_float_equal(a.x, b.x, tolerance);
    assert_float_equal(a.y, b.y, tolerance);
    assert_float_equal(a.z, b.z, tolerance);
}

static void test_an_eye_moves_around_the_head_and_never_through_it(void **state)
{
    (void)state;
    float dip = 1.0f;
    for (int step = 0; step <= STEPS; step++) {
        shape_at((float)step / STEPS);
        /* The cross-section of the skin is a polygon with 16 sides, whose radius at the middle of a
         * side is smaller by the factor 0.981. */
        dip = f_min(dip, from_axis(positions[BARREL_EYE]));
    }
    assert_true(dip > 0.1f * 0.98f + 0.009f);
    shape_at(0.0f);
    assert_near(positions[BARREL_EYE], v3(0.11f, 0.0f, -0.25f), 1e-4f);
    assert_near(normals[BARREL_EYE], v3(1.0f, 0.0f, 0.0f), 0.02f);
    shape_at(0.5f);
    assert_near(positions[BARREL_EYE], v3(0.0f, 0.11f, -0.25f), 1e-4f);
    assert_near(normals[BARREL_EYE], v3(0.0f, 1.0f, 0.0f), 0.02f);
    shape_at(1.0f);
    assert_near(positions[BARREL_EYE], v3(-0.21f, 0.0f, -0.25f), 1e-4f);
    assert_near(normals[BARREL_EYE], v3(-1.0f, 0.0f, 0.0f), 0.02f);
}

/* If the eye moved in a straight line between its two positions, it would pass through the head.
 * This proves that the test above, which requires a path around the head, can fail. */
static void test_a_straight_blend_moves_the_eye_through_the_head(void **state)
{
    (void)state;
    shape_at(0.0f);
    const vec3 right = positions[BARREL_EYE];
    shape_at(1.0f);
    const vec3 middle = v3_lerp(right, positions[BARREL_EYE], 0.4f);
    assert_true(from_axis(middle) < 0.03f);
}

static void test_a_fin_ray_stays_on_the_skin_while_its_root_moves_forward(void **state)
{
    (void)state;
    float before = 1.0f;
    for (int step = 0; step <= STEPS; step++) {
        shape_at((float)step / STEPS);
        const vec3 tip = positions[BARREL_RAY];
        const float radius = from_axis(positions[0]);
        /* Both values are rounded to a step of the table, so the tolerance has room for two
         * steps. */
        assert_float_equal(tip.y, radius + 0.02f, 4e-5f);
        assert_true(tip.z < before);
        before = tip.z;
    }
    assert_float_equal(before, -0.25f, 1e-5f);
}

static void test_an_eye_moves_without_a_jump(void **state)
{
    (void)state;
    shape_at(0.0f);
    vec3 last = positions[BARREL_EYE], facing = normals[BARREL_EYE];
    for (int step = 1; step <= STEPS; step++) {
        shape_at((float)step / STEPS);
        assert_true(v3_length(v3_sub(positions[BARREL_EYE], last)) < 0.001f);
        assert_true(v3_dot(normals[BARREL_EYE], facing) > 0.9995f);
        last = positions[BARREL_EYE];
        facing = normals[BARREL_EYE];
    }
}

static void test_coordinates_around_the_girth_count_turns(void **state)
{
    (void)state;
    morph_key_pose(mesh, 3, 0, &pose);
    for (int step = -40; step <= 40; step++) {
        const float v = (float)step / 40.0f;
        const struct anchor_pose once = morph_ride(mesh, 3, &pose, 0.3f, v, true);
        const struct anchor_pose again = morph_ride(mesh, 3, &pose, 0.3f, v + 3.0f, true);
        assert_near(once.position, again.position, 1e-6f);
        assert_near(pose_rotate(once.turn, v3(1.0f, 0.0f, 0.0f)),
                    pose_rotate(again.turn, v3(1.0f, 0.0f, 0.0f)), 1e-4f);
    }
}

static void test_coordinates_beyond_the_ends_stay_on_the_skin(void **state)
{
    (void)state;
    morph_key_pose(mesh, 3, 0, &pose);
    assert_float_equal(morph_ride(mesh, 3, &pose, -0.2f, 0.1f, false).position.z, -0.5f, 1e-4f);
    assert_float_equal(morph_ride(mesh, 3, &pose, 0.0f, 0.1f, false).position.z, -0.5f, 1e-4f);
    assert_float_equal(morph_ride(mesh, 3, &pose, 1.0f, 0.1f, false).position.z, 0.5f, 1e-4f);
    assert_float_equal(morph_ride(mesh, 3, &pose, 1.2f, 0.1f, false).position.z, 0.5f, 1e-4f);
}

/* The importer converts an eye to the frame of the skin, and the blended shape converts it back.
 * The two conversions together must not change a point. */
static void test_a_frame_of_the_skin_converts_forward_and_back(void **state)
{
    (void)state;
    morph_key_pose(mesh, 3, 2, &pose);
    for (int step = 0; step <= 100; step++) {
        const float v = (float)step / 100.0f;
        const struct anchor_pose at = morph_ride(mesh, 3, &pose, 0.4f, v, true);
        const vec3 p = v3(0.03f, -0.2f, 0.11f);
        assert_near(pose_rotate(at.turn, pose_rotate_inverse(at.turn, p)), p, 1e-6f);
        const vec3 out = pose_rotate(at.turn, v3(1.0f, 0.0f, 0.0f));
        assert_true(v3_dot(out, v3(f_sin(v * F_TAU), f_cos(v * F_TAU), 0.0f)) > 0.98f);
        assert_near(pose_rotate(at.turn, v3(0.0f, 0.0f, 1.0f)), v3(0.0f, 0.0f, 1.0f), 0.02f);
    }
}

/* Checks the frame (axes x, y, z) of a patch of skin whose normal is `normal`. The frame must be
 * orthonormal, its x axis must be the normal, and its z axis must not point forward. */
static void assert_a_skin_has_its_turn(vec3 normal)
{
    for (uint32_t k = 0; k < BARREL_GRID; k++) {
        barrel.points[0][k].normal = morph_fold_normal(normal);
    }
    morph_key_pose(mesh, 3, 0, &pose);
    const struct quat turn = pose.anchor[0].turn;
    const vec3 x = pose_rotate(turn, v3(1.0f, 0.0f, 0.0f));
    const vec3 y = pose_rotate(turn, v3(0.0f, 1.0f, 0.0f));
    const vec3 z = pose_rotate(turn, v3(0.0f, 0.0f, 1.0f));
    assert_near(x, morph_normal(morph_fold_normal(normal)), 1e-5f);
    assert_float_equal(v3_dot(x, z), 0.0f, 1e-5f);
    assert_float_equal(v3_length(z), 1.0f, 1e-5f);
    assert_near(y, v3_cross(z, x), 1e-5f);
    assert_true(z.z >= -1e-6f);
}

static void test_every_direction_of_the_skin_has_a_rotation(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 400; i++) {
        const float up = -0.99f + 1.98f * (float)(i % 20u) / 19.0f;
        const float angle = F_TAU * (float)(i / 20u) / 20.0f + 0.01f, flat = f_sqrt(1.0f - up * up);
        assert_a_skin_has_its_turn(v3(flat * f_sin(angle), up, flat * f_cos(angle)));
    }
}

/* The z axis of the frame normally points backward along the skin. This direction is undefined on
 * skin that faces forward (at the snout) or backward (at the tail root). The z axis must then point
 * down. */
static void test_a_skin_that_faces_along_the_body_has_a_rotation(void **state)
{
    (void)state;
    assert_a_skin_has_its_turn(v3(0.0f, 0.0f, -1.0f));
    assert_near(pose_rotate(pose.anchor[0].turn, v3(0.0f, 0.0f, 1.0f)), v3(0.0f, -1.0f, 0.0f),
                1e-5f);
    assert_a_skin_has_its_turn(v3(0.0f, 0.0f, 1.0f));
    assert_near(pose_rotate(pose.anchor[0].turn, v3(0.0f, 0.0f, 1.0f)), v3(0.0f, -1.0f, 0.0f),
                1e-5f);
}

/* The coordinate is 1e-9 of a turn before the seam at 0, so it is rounded to a whole turn. The
 * result must be the point on the seam, and not a point of the next ring of the grid. */
static void test_a_point_just_before_the_seam_is_on_the_seam(void **state)
{
    (void)state;
    morph_key_pose(mesh, 3, 0, &pose);
    for (uint32_t i = 0; i <= 10; i++) {
        const float u = (float)i / 10.0f;
        const struct anchor_pose before = morph_ride(mesh, 3, &pose, u, -1e-9f, true);
        assert_near(before.position, morph_ride(mesh, 3, &pose, u, 0.0f, true).position, 1e-4f);
        assert_near(pose_rotate(before.turn, v3(1.0f, 0.0f, 0.0f)), v3(0.0f, 1.0f, 0.0f), 0.01f);
    }
}

static void test_an_anchor_follows_its_own_curve(void **state)
{
    (void)state;
    struct species_card *card = &barrel.species.card;
    card->curve_count = 2;
    graph_from_template(&card->curves[1], TEMPLATE_ORDINARY, 3, SIMULTANEOUS_PEAK);
    barrel.anchors[1].u[1] = 0.75f;
    morph_rig_init(&rig, card, TEMPLATE_OWN);
    /* In the graph of the whole fish, progress 0.25 blends the first two keys. The anchor has the
     * same place in both keys. */
    shape_at(0.25f);
    assert_float_equal(positions[BARREL_RAY].z, 0.25f, 1e-4f);
    barrel.anchors[1].curve = 1;
    /* The anchor now has its own graph (curve 1), in which it has moved by a quarter of the way to
     * the last key. */
    shape_at(0.25f);
    assert_float_equal(positions[BARREL_RAY].z, 0.125f, 1e-4f);
}

static void test_a_vertex_of_an_absent_anchor_fails_an_assertion(void **state)
{
    (void)state;
    barrel.vertices[BARREL_EYE].anchor = 2;
    expect_assert_failure(shape_at(0.0f));
    barrel.vertices[BARREL_EYE].anchor = 0;
    barrel.species.lod[0].grid_rings = 1;
    expect_assert_failure(shape_at(0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_an_eye_moves_around_the_head_and_never_through_it, new_barrel),
        cmocka_unit_test_setup(test_a_straight_blend_moves_the_eye_through_the_head, new_barrel),
        cmocka_unit_test_setup(test_a_fin_ray_stays_on_the_skin_while_its_root_moves_forward,
                               new_barrel),
        cmocka_unit_test_setup(test_an_eye_moves_without_a_jump, new_barrel),
        cmocka_unit_test_setup(test_coordinates_around_the_girth_count_turns, new_barrel),
        cmocka_unit_test_setup(test_coordinates_beyond_the_ends_stay_on_the_skin, new_barrel),
        cmocka_unit_test_setup(test_a_frame_of_the_skin_converts_forward_and_back, new_barrel),
        cmocka_unit_test_setup(test_every_direction_of_the_skin_has_a_rotation, new_barrel),
        cmocka_unit_test_setup(test_a_skin_that_faces_along_the_body_has_a_rotation, new_barrel),
        cmocka_unit_test_setup(test_a_point_just_before_the_seam_is_on_the_seam, new_barrel),
        cmocka_unit_test_setup(test_an_anchor_follows_its_own_curve, new_barrel),
        cmocka_unit_test_setup(test_a_vertex_of_an_absent_anchor_fails_an_assertion, new_barrel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
