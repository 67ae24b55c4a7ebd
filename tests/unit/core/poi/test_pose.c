/* test_pose.c -- checks how poses are computed: the conversion between angles and axes, limited
 * turns, and interpolation. */
#include "tests/unit/support/poi_fixture.h"

#include "core/poi/pose.h"

static void same_axes(const struct basis *a, const struct basis *b)
{
    assert_float_equal(v3_length(v3_sub(a->right, b->right)), 0.0f, 1e-4f);
    assert_float_equal(v3_length(v3_sub(a->up, b->up)), 0.0f, 1e-4f);
    assert_float_equal(v3_length(v3_sub(a->back, b->back)), 0.0f, 1e-4f);
}

static void test_angles_convert_to_axes_and_back(void **state)
{
    (void)state;
    for (int yaw = -3; yaw <= 3; yaw++) {
        for (int pitch = -3; pitch <= 3; pitch++) {
            for (int roll = -3; roll <= 3; roll++) {
                const struct angles angles = { (float)yaw, 0.5236f * (float)pitch, (float)roll };
                const struct basis axes = vec_basis_from_angles(angles);
                const struct basis again = vec_basis_from_angles(pose_angles(&axes));
                same_axes(&axes, &again);
            }
        }
    }
}

static void test_a_quarter_turn_about_up_turns_left(void **state)
{
    (void)state;
    const struct basis level = vec_basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    const struct basis turned = pose_turn(&level, v3(0.0f, 1.0f, 0.0f), 0.5f * F_PI);
    const struct basis left = vec_basis_from_angles((struct angles){ 0.5f * F_PI, 0.0f, 0.0f });
    same_axes(&turned, &left);
}

static void test_pose_look_faces_forward_with_its_back_up(void **state)
{
    (void)state;
    const vec3 forward = v3(0.6f, 0.0f, -0.8f);
    const struct basis axes = pose_look(forward, v3(0.1f, 1.0f, 0.0f));
    assert_float_equal(v3_dot(axes.back, forward), -1.0f, 1e-5f);
    assert_true(axes.up.y > 0.99f);
    assert_float_equal(v3_dot(v3_cross(axes.right, axes.up), axes.back), 1.0f, 1e-5f);
    /* If the up direction is parallel to the forward direction, it cannot be used. pose_look() must
     * then choose other valid axes. */
    const struct basis odd = pose_look(forward, forward);
    assert_float_equal(v3_dot(v3_cross(odd.right, odd.up), odd.back), 1.0f, 1e-5f);
}

static void test_a_turn_takes_the_short_way_and_at_most_one_step(void **state)
{
    (void)state;
    const struct angles from = { 3.0f, -0.2f, 0.1f }, to = { -3.0f, 0.2f, 0.1f };
    const struct angles half = pose_toward(from, to, 0.5f, 1.0f);
    /* From a yaw of 3 rad to -3 rad, the interpolation must take the shorter way through pi, not
     * through 0. */
    assert_float_equal(f_abs(half.yaw_rad), F_PI, 1e-5f);
    assert_float_equal(half.pitch_rad, 0.0f, 1e-6f);
    assert_float_equal(half.roll_rad, 0.1f, 1e-6f);
    const struct angles step = pose_toward(from, to, 1.0f, 0.05f);
    assert_float_equal(step.yaw_rad, 3.05f, 1e-5f);
    assert_float_equal(step.pitch_rad, -0.15f, 1e-6f);
}

static void test_interpolation_covers_positions_and_turns_of_any_size(void **state)
{
    (void)state;
    const struct poi_target from = { .position_m = { 0.1f, 0.0f, 0.0f },
                                     .angles = { .yaw_rad = -3.1f } };
    const struct poi_target to = { .position_m = { 0.3f, 0.2f, 0.0f },
                                   .angles = { .yaw_rad = 3.1f, .pitch_rad = 3.0f } };
    const struct poi_target middle = pose_between(from, to, 0.5f);
    assert_float_equal(middle.position_m.x, 0.2f, 1e-6f);
    assert_float_equal(middle.position_m.y, 0.1f, 1e-6f);
    assert_float_equal(f_abs(middle.angles.yaw_rad), F_PI, 1e-5f);
    /* pose_between() must not limit the step, so half of the way from 0 to 3 rad is 1.5 rad. */
    assert_float_equal(middle.angles.pitch_rad, 1.5f, 1e-5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_angles_convert_to_axes_and_back),
        cmocka_unit_test(test_a_quarter_turn_about_up_turns_left),
        cmocka_unit_test(test_pose_look_faces_forward_with_its_back_up),
        cmocka_unit_test(test_a_turn_takes_the_short_way_and_at_most_one_step),
        cmocka_unit_test(test_interpolation_covers_positions_and_turns_of_any_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
