/* test_bowl.c -- the bowl keeps its fish until it is poured back. */
#include "poi_stand.h"
#include "tests/unit/pond.h"

static struct tank tank;
static struct bowl bowl;

static void fill(uint32_t count)
{
    memset(&tank, 0, sizeof tank);
    tank.seed = 4;
    tank.size_m = v3(0.90f, 0.15f, 0.55f);
    tank.fish_count = count + 1u; /* The last one swims free. */
    bowl_init(&bowl, v3(0.33f, 0.02f, 0.17f));
    for (uint32_t i = 0; i < count; i++) {
        tank.fish[i] = (struct fish){ .position_m = bowl.position_m,
                                      WAKIN(0.035f + 0.002f * (float)(i % 10u)),
                                      .gait = GAIT_BOWL };
    }
    tank.fish[count] = (struct fish){ .position_m = { -0.2f, -0.05f, 0.0f }, WAKIN(0.05f) };
    bowl.fish_count = count;
}

/* Snout and tail of a fish, and the hull: half an ellipsoid. */
static int inside_hull(const struct fish *fish)
{
    const struct basis axes = basis_from_angles(fish->angles);
    for (int end = -1; end <= 1; end++) {
        const vec3 point = v3_mad(fish->position_m, axes.back, 0.45f * (float)end * fish->length_m);
        const vec3 at = v3_sub(point, bowl.position_m);
        const float wide = (at.x * at.x + at.z * at.z) / (BOWL_RADIUS_M * BOWL_RADIUS_M);
        const float deep = at.y * at.y / (BOWL_DEPTH_M * BOWL_DEPTH_M);
        if (at.y > 0.0005f || wide + deep > 1.0f) {
            return 0;
        }
    }
    return 1;
}

static void test_fish_in_the_bowl_swim_and_never_leave_it(void **state)
{
    (void)state;
    fill(40);
    const vec3 start = tank.fish[0].position_m;
    float farthest = 0.0f;
    for (uint32_t tick = 0; tick < 3600; tick++) {
        bowl_fish_tick(&bowl, 0, &tank);
        for (uint32_t i = 0; i < 40; i++) {
            assert_true(inside_hull(&tank.fish[i]));
            assert_true(v3_length(tank.fish[i].velocity_m_s) < 0.25f);
        }
        farthest = f_max(farthest, v3_length(v3_sub(tank.fish[0].position_m, start)));
    }
    assert_true(farthest > 0.01f);
    assert_float_equal(tank.fish[40].position_m.x, -0.2f, 0.0f);
}

static void test_they_swim_at_different_depths(void **state)
{
    (void)state;
    fill(20);
    for (uint32_t tick = 0; tick < 600; tick++) {
        bowl_fish_tick(&bowl, 0, &tank);
    }
    float high = -1.0f, low = 1.0f;
    for (uint32_t i = 0; i < 20; i++) {
        high = f_max(high, tank.fish[i].position_m.y);
        low = f_min(low, tank.fish[i].position_m.y);
    }
    assert_true(high - low > 0.008f);
}

static void test_another_bowls_fish_are_not_moved(void **state)
{
    (void)state;
    fill(2);
    tank.fish[1].holder = 2;
    const vec3 before = tank.fish[1].position_m;
    for (uint32_t tick = 0; tick < 60; tick++) {
        bowl_fish_tick(&bowl, 0, &tank);
    }
    assert_float_equal(v3_length(v3_sub(tank.fish[1].position_m, before)), 0.0f, 0.0f);
}

static void test_pouring_back_puts_every_fish_under_water_beside_the_bowl(void **state)
{
    (void)state;
    fill(60);
    bowl_pour_back(&bowl, 0, &tank);
    assert_int_equal(bowl.fish_count, 0);
    for (uint32_t i = 0; i < 60; i++) {
        const struct fish *fish = &tank.fish[i];
        const float half = 0.5f * fish->height_m;
        assert_int_equal(fish->gait, GAIT_HELD); /* By the water, until it is clear of others. */
        assert_int_equal(fish->holder, FISH_HOLDER_WATER);
        assert_true(fish->position_m.y <= -half);
        assert_true(fish->position_m.y >= half - 0.15f);
        assert_true(f_abs(fish->position_m.x) <= 0.45f - 0.5f * fish->length_m + 1e-5f);
        assert_true(f_abs(fish->position_m.z) <= 0.275f - 0.5f * fish->length_m + 1e-5f);
        const vec3 away = v3(fish->position_m.x - bowl.position_m.x, 0.0f,
                             fish->position_m.z - bowl.position_m.z);
        assert_true(v3_length(away) < 0.20f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_in_the_bowl_swim_and_never_leave_it),
        cmocka_unit_test(test_they_swim_at_different_depths),
        cmocka_unit_test(test_another_bowls_fish_are_not_moved),
        cmocka_unit_test(test_pouring_back_puts_every_fish_under_water_beside_the_bowl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
