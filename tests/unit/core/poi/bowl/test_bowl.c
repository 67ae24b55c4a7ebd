/* test_bowl.c -- checks that a bowl keeps its fish until they are poured back into the tank. */
#include "tests/unit/support/poi_fixture.h"
#include "tests/unit/support/pond.h"

static struct tank tank;
static struct bowl bowl;

static void fill(uint32_t count)
{
    memset(&tank, 0, sizeof tank);
    tank.seed = 4;
    tank.size_m = v3(0.90f, 0.15f, 0.55f);
    /* Puts `count` fish into the bowl. One more fish stays in the tank. */
    tank.fish_count = count + 1u;
    bowl_init(&bowl, v3(0.33f, 0.02f, 0.17f));
    for (uint32_t i = 0; i < count; i++) {
        tank.fish[i] = (struct fish){ .position_m = bowl.position_m,
                                      WAKIN(0.035f + 0.002f * (float)(i % 10u)),
                                      .gait = GAIT_BOWL };
    }
    tank.fish[count] = (struct fish){ .position_m = { -0.2f, -0.05f, 0.0f }, WAKIN(0.05f) };
    bowl.fish_count = count;
}

/* Returns 1 if the snout and the tail of a fish are both inside the bowl's hull, which is half an
 * ellipsoid. */
static int inside_hull(const struct fish *fish)
{
    const struct basis axes = vec_basis_from_angles(fish->angles);
    for (int end = -1; end <= 1; end++) {
        const vec3 point =
            v3_muladd(fish->position_m, axes.back, 0.45f * (float)end * fish->length_m);
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

static void test_bowl_fish_swim_at_different_depths(void **state)
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

static void test_a_bowl_does_not_move_the_fish_of_another_bowl(void **state)
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
    bowl_empty(&bowl, 0, &tank);
    assert_int_equal(bowl.fish_count, 0);
    for (uint32_t i = 0; i < 60; i++) {
        const struct fish *fish = &tank.fish[i];
        const float half = 0.5f * fish->height_m;
        /* The fish has been poured into the water. It must not swim before it is clear of all other
         * fish. */
        assert_int_equal(fish->gait, GAIT_HELD);
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

/* ---- Capacity ------------------------------------------------------------------------------- */

/* Drops `count` fish of `length_m` into the bowl at a rate of three per second, which several
 * players together can reach. */
static void drop_in_all(uint32_t count, float length_m)
{
    const struct stall stall = { &tank, &bowl, 1, false };
    memset(&tank, 0, sizeof tank);
    tank.size_m = v3(1.36f, 0.10f, 0.65f);
    bowl_init(&bowl, v3(0.53f, 0.012f, 0.225f));
    tank.fish_count = count;
    for (uint32_t i = 0; i < count; i++) {
        struct fish *fish = &tank.fish[i];
        fish_grow(fish, length_m * (0.9f + 0.02f * (float)(i % 11u)), tank_behavior_params(&tank));
        const float x_m = 0.04f * f_sin((float)i), z_m = 0.04f * f_cos(2.0f * (float)i);
        fish->position_m = v3_add(bowl.position_m, v3(x_m, 0.0f, z_m));
        bowl_take(&bowl, 0, &tank, fish, v3(0.0f, -0.5f, 0.0f));
        for (uint32_t tick = 0; tick < 40; tick++) {
            bowl_buoyancy_tick(&stall, NULL, NULL, 0);
            bowl_fish_tick(&bowl, 0, &tank);
        }
    }
}

struct tightness {
    float worst_m;        /* Deepest overlap of two fish in m. */
    float pairs_per_look; /* Mean number of pairs of fish that overlap by more than 1 mm. */
    float fastest_m_s;
};

/* Returns the overlap of two level fish in metres; 0 or less means that they do not overlap. Each
 * fish is modelled as a capsule. The axis of the capsule is 0.64 body lengths long, and its radius
 * is 0.40 body widths. The distance is measured at 41 points of the axis. Vertical distances are
 * scaled, because a fish is higher than wide. */
static float overlap_m(const struct fish *a, const struct fish *b)
{
    const vec3 on_a = v3_heading(a->angles.yaw_rad), on_b = v3_heading(b->angles.yaw_rad);
    float least_m = 1.0f;
    for (int i = -20; i <= 20; i++) {
        const vec3 at = v3_muladd(a->position_m, on_a, 0.016f * (float)i * a->length_m);
        vec3 way = v3_sub(at, b->position_m);
        const float along = v3_dot(way, on_b), half_m = 0.32f * b->length_m;
        way = v3_muladd(way, on_b, -f_clamp(along, -half_m, half_m));
        way.y *= f_min(a->width_m / a->height_m, b->width_m / b->height_m);
        least_m = f_min(least_m, v3_length(way));
    }
    return 0.40f * (a->width_m + b->width_m) - least_m;
}

static struct tightness look_for(float seconds)
{
    const struct stall stall = { &tank, &bowl, 1, false };
    struct tightness sum = { 0 };
    uint32_t looks = 0;
    for (uint32_t tick = 0; (float)tick < seconds * (float)CORE_TICK_HZ; tick++) {
        bowl_buoyancy_tick(&stall, NULL, NULL, 0);
        bowl_fish_tick(&bowl, 0, &tank);
        looks += tick % 30u == 0;
        for (uint32_t i = 0; i < tank.fish_count && tick % 30u == 0; i++) {
            assert_true(inside_hull(&tank.fish[i]));
            sum.fastest_m_s = f_max(sum.fastest_m_s, v3_length(tank.fish[i].velocity_m_s));
            for (uint32_t k = 0; k < i; k++) {
                const float deep_m = overlap_m(&tank.fish[i], &tank.fish[k]);
                sum.worst_m = f_max(sum.worst_m, deep_m);
                sum.pairs_per_look += deep_m > 0.001f;
            }
        }
    }
    sum.pairs_per_look /= (float)looks;
    return sum;
}

static void test_bowl_fish_overlap_little_up_to_the_record_count(void **state)
{
    (void)state;
    const uint32_t counts[] = { 20, 60, 80, 107, BOWL_FISH_MAX };
    const float pairs_max[] = { 0.0f, 0.2f, 1.0f, 4.0f, 5.0f };
    /* Largest permitted overlap for each number of fish, in mm. Fish overlap deeply only for a
     * moment, while they make room for other fish. */
    const float worst_mm[] = { 1.0f, 3.0f, 4.0f, 7.0f, 7.0f };
    for (int i = 0; i < 5; i++) {
        drop_in_all(counts[i], 0.04f);
        const struct tightness tight = look_for(10.0f);
        print_message("%3u fish of 4 cm: %.2f pairs share more than 1 mm, worst %.1f mm\n",
                      counts[i], (double)tight.pairs_per_look, 1e3 * (double)tight.worst_m);
        assert_int_equal(bowl.fish_count, counts[i]);
        assert_true(tight.pairs_per_look <= pairs_max[i]);
        assert_true(1e3f * tight.worst_m < worst_mm[i]);
        assert_true(tight.fastest_m_s < 0.25f);
    }
}

static void test_bowl_fish_circle_the_same_way_and_point_where_they_swim(void **state)
{
    (void)state;
    drop_in_all(30, 0.04f);
    look_for(3.0f);
    for (uint32_t i = 0; i < 30; i++) {
        const struct fish *fish = &tank.fish[i];
        const vec3 at = v3_sub(fish->position_m, bowl.position_m);
        const vec3 v = fish->velocity_m_s;
        const float turn = at.z * v.x - at.x * v.z;
        assert_true(v3_length(at) < 0.015f || turn < 0.0f);
        assert_true(v3_length(v) < 0.02f || v3_dot(v, fish_forward(fish)) > 0.0f);
    }
}

static void test_a_full_bowl_is_poured_back_before_the_next_fish_falls_in(void **state)
{
    (void)state;
    drop_in_all(BOWL_FISH_MAX, 0.04f);
    assert_true(bowl_is_full(&bowl));
    struct fish *last = &tank.fish[tank.fish_count++];
    fish_grow(last, 0.04f, tank_behavior_params(&tank));
    last->position_m = bowl.position_m;
    bowl_take(&bowl, 0, &tank, last, v3(0.0f, -0.5f, 0.0f));
    assert_int_equal(bowl.fish_count, 1);
    assert_float_equal(bowl.fish_kg, fish_mass_kg(last->length_m), 1e-9f);
    assert_int_equal(last->gait, GAIT_BOWL);
    /* The full bowl was emptied into the tank, so its fish are in the water and do not swim yet. */
    for (uint32_t i = 0; i < BOWL_FISH_MAX; i++) {
        assert_int_equal(tank.fish[i].gait, GAIT_HELD);
        assert_int_equal(tank.fish[i].holder, FISH_HOLDER_WATER);
    }
}

static void test_a_bowl_holds_fewer_large_fish(void **state)
{
    (void)state;
    drop_in_all(40, 0.06f);
    /* The bowl can hold 0.172 kg of fish, which is the mass of 33 fish of 6 cm. The bowl was
     * therefore emptied before the 40th fish. */
    assert_true(bowl.fish_count < 40);
    assert_true(bowl.fish_count > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_in_the_bowl_swim_and_never_leave_it),
        cmocka_unit_test(test_bowl_fish_swim_at_different_depths),
        cmocka_unit_test(test_a_bowl_does_not_move_the_fish_of_another_bowl),
        cmocka_unit_test(test_pouring_back_puts_every_fish_under_water_beside_the_bowl),
        cmocka_unit_test(test_bowl_fish_overlap_little_up_to_the_record_count),
        cmocka_unit_test(test_bowl_fish_circle_the_same_way_and_point_where_they_swim),
        cmocka_unit_test(test_a_full_bowl_is_poured_back_before_the_next_fish_falls_in),
        cmocka_unit_test(test_a_bowl_holds_fewer_large_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
