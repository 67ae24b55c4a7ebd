/* test_pose.c -- angles and axes, there and back. */
#include "poi_stand.h"

#include "core/poi/pose.h"

static void same_axes(const struct basis *a, const struct basis *b)
{
    assert_float_equal(v3_length(v3_sub(a->right, b->right)), 0.0f, 1e-4f);
    assert_float_equal(v3_length(v3_sub(a->up, b->up)), 0.0f, 1e-4f);
    assert_float_equal(v3_length(v3_sub(a->back, b->back)), 0.0f, 1e-4f);
}

static void test_angles_come_back_from_their_axes(void **state)
{
    (void)state;
    for (int yaw = -3; yaw <= 3; yaw++) {
        for (int pitch = -3; pitch <= 3; pitch++) {
            for (int roll = -3; roll <= 3; roll++) {
                const struct angles angles = { (float)yaw, 0.5236f * (float)pitch, (float)roll };
                const struct basis axes = basis_from_angles(angles);
                const struct basis again = basis_from_angles(pose_angles(&axes));
                same_axes(&axes, &again);
            }
        }
    }
}

static void test_a_quarter_turn_about_up_turns_left(void **state)
{
    (void)state;
    const struct basis level = basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    const struct basis turned = pose_turn(&level, v3(0.0f, 1.0f, 0.0f), 0.5f * F_PI);
    const struct basis left = basis_from_angles((struct angles){ 0.5f * F_PI, 0.0f, 0.0f });
    same_axes(&turned, &left);
}

static void test_a_look_faces_forward_with_its_back_up(void **state)
{
    (void)state;
    const vec3 forward = v3(0.6f, 0.0f, -0.8f);
    const struct basis axes = pose_look(forward, v3(0.1f, 1.0f, 0.0f));
    assert_float_equal(v3_dot(axes.back, forward), -1.0f, 1e-5f);
    assert_true(axes.up.y > 0.99f);
    assert_float_equal(v3_dot(v3_cross(axes.right, axes.up), axes.back), 1.0f, 1e-5f);
    const struct basis odd =
        pose_look(forward, forward); /* No such back: any will do, but axes they are. */
    assert_float_equal(v3_dot(v3_cross(odd.right, odd.up), odd.back), 1.0f, 1e-5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_angles_come_back_from_their_axes),
        cmocka_unit_test(test_a_quarter_turn_about_up_turns_left),
        cmocka_unit_test(test_a_look_faces_forward_with_its_back_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
