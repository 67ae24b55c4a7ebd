/* test_obstacle.c -- checks the ring of a poi and the hull of a bowl as obstacles for fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/collision/obstacle.h"
#include "tests/unit/support/pond.h"

static struct obstacle disc_at(vec3 centre, vec3 velocity)
{
    return (struct obstacle){ .kind = OBSTACLE_DISC,
                              .centre_m = centre,
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .velocity_m_s = velocity,
                              .radius_m = 0.0465f };
}

static struct obstacle bowl(void)
{
    return (struct obstacle){ .kind = OBSTACLE_BOWL,
                              .centre_m = { 0.0f, 0.012f, 0.0f },
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .radius_m = 0.075f,
                              .depth_m = 0.055f };
}

static struct box fish_at(vec3 position, float yaw_deg)
{
    const struct fish fish = { .position_m = position,
                               WAKIN(0.04f),
                               .angles = { .yaw_rad = yaw_deg * F_DEG } };
    return fish_box(&fish);
}

static float push_m(const struct obstacle *obstacle, vec3 position, float yaw_deg)
{
    const struct box box = fish_at(position, yaw_deg);
    return v3_length(obstacle_clear(obstacle, &box));
}

static void test_fish_over_and_under_the_paper_are_not_moved(void **state)
{
    (void)state;
    const struct obstacle disc = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.0f, 0.0f, 0.0f));
    assert_true(push_m(&disc, v3(0.0f, -0.042f, 0.0f), 0.0f) == 0.0f);
    assert_true(push_m(&disc, v3(0.01f, -0.058f, 0.01f), 45.0f) == 0.0f);
    /* The fish is in the middle of the ring, in the plane of the paper. The ring itself must not
     * push the fish. */
    assert_true(push_m(&disc, v3(0.0f, -0.05f, 0.0f), 0.0f) == 0.0f);
}

static void test_the_ring_pushes_a_touching_fish_until_it_is_clear(void **state)
{
    (void)state;
    const struct obstacle disc = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.0f, 0.0f, 0.0f));
    uint32_t touched = 0;
    for (uint32_t i = 0; i < 500; i++) {
        const float around = rng_range((struct rng_key){ 1, i, 0, RNG_TEST }, -F_PI, F_PI);
        const float yaw_deg = rng_range((struct rng_key){ 1, i, 1, RNG_TEST }, -180.0f, 180.0f);
        const float out_m = rng_range((struct rng_key){ 1, i, 2, RNG_TEST }, 0.055f, 0.075f);
        struct box box = fish_at(v3(out_m * f_sin(around), -0.05f, out_m * f_cos(around)), yaw_deg);
        touched += v3_length(obstacle_clear(&disc, &box)) > 0.0f;
        for (int round = 0; round < 8; round++) {
            box.centre_m = v3_add(box.centre_m, obstacle_clear(&disc, &box));
        }
        assert_true(v3_length(obstacle_clear(&disc, &box)) < 1e-4f);
    }
    assert_true(touched > 50);
}

static void test_a_hull_keeps_fish_out_sideways_and_downward(void **state)
{
    (void)state;
    const struct obstacle hull = bowl();
    struct box box = fish_at(v3(0.0f, -0.03f, 0.0f), 0.0f);
    for (int round = 0; round < 8; round++) {
        box.centre_m = v3_add(box.centre_m, obstacle_clear(&hull, &box));
    }
    assert_true(box.centre_m.y + box.half_m.y < -0.043f + 0.001f);
    assert_true(push_m(&hull, v3(0.0f, -0.09f, 0.0f), 0.0f) == 0.0f);
    assert_true(push_m(&hull, v3(0.12f, -0.02f, 0.0f), 0.0f) == 0.0f);
    assert_true(push_m(&hull, v3(0.07f, -0.01f, 0.0f), 0.0f) > 0.0f);
}

static void test_a_slow_disc_moves_fish_beside_it_and_not_those_over_it(void **state)
{
    (void)state;
    const struct obstacle disc = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.08f, 0.0f, 0.0f));
    const vec3 beside = obstacle_sidestep_m_s(&disc, v3(0.06f, -0.05f, 0.0f));
    assert_true(beside.x > 0.004f && beside.x < 0.02f);
    assert_true(v3_length(obstacle_sidestep_m_s(&disc, v3(0.03f, -0.04f, 0.0f))) == 0.0f);
    const struct obstacle still = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.0f, 0.0f, 0.0f));
    assert_true(v3_length(obstacle_sidestep_m_s(&still, v3(0.06f, -0.05f, 0.0f))) == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_over_and_under_the_paper_are_not_moved),
        cmocka_unit_test(test_the_ring_pushes_a_touching_fish_until_it_is_clear),
        cmocka_unit_test(test_a_hull_keeps_fish_out_sideways_and_downward),
        cmocka_unit_test(test_a_slow_disc_moves_fish_beside_it_and_not_those_over_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
