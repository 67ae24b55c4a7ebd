/* test_bowl_floats.c -- checks floating bowls: their buoyancy and drift, and how fish, rings, walls
 * and other bowls push them. */
#include "core/poi/poi.h"
#include "tests/unit/support/poi_fixture.h"

static struct tank tank;
static struct bowl bowls[POI_MAX];
static struct poi poi;

/* Creates `count` bowls in a tank of 0.9 x 0.55 m. The water is still, and there are no fish. */
static void float_bowls(uint32_t count)
{
    memset(&tank, 0, sizeof tank);
    memset(bowls, 0, sizeof bowls);
    tank.size_m = v3(0.90f, 0.15f, 0.55f);
    tank.wall_height_m = 0.20f;
    for (uint32_t i = 0; i < count; i++) {
        bowl_init(&bowls[i], v3(-0.3f + 0.2f * (float)i, 0.012f, 0.0f));
    }
}

static void wait_for(float seconds)
{
    const struct stall stall = { &tank, bowls, POI_MAX, false };
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        bowl_buoyancy_tick(&stall, NULL, NULL, 0);
    }
}

static void drop_in(float length_m, float off_x_m)
{
    struct fish *fish = &tank.fish[tank.fish_count++];
    *fish = (struct fish){ .position_m = v3_add(bowls[0].position_m, v3(off_x_m, 0.0f, 0.0f)) };
    fish_grow(fish, length_m, tank_behavior_params(&tank));
    bowl_take(&bowls[0], 0, &tank, fish, v3(0.0f, -0.7f, 0.0f));
}

static void test_a_bowl_floats_at_its_home(void **state)
{
    (void)state;
    float_bowls(1);
    wait_for(3.0f);
    const vec3 off_m = v3_sub(bowls[0].position_m, bowls[0].home_m);
    assert_true(v3_length(off_m) < 1e-5f);
    assert_true(bowls[0].water_kg > 0.4f);
    /* The empty bowl must float 13.5 mm deep. At this depth its hull displaces as much water as the
     * bowl weighs. */
    assert_float_equal(bowl_level_m(&bowls[0]), 0.0135f, 0.001f);
}

static void test_the_hulls_volume_and_radius_agree(void **state)
{
    (void)state;
    assert_float_equal(bowl_room_m3(0.0f),
                       2.0f / 3.0f * F_PI * BOWL_RADIUS_M * BOWL_RADIUS_M * BOWL_DEPTH_M, 1e-8f);
    assert_float_equal(bowl_room_m3(BOWL_DEPTH_M), 0.0f, 1e-9f);
    for (float below_m = 0.005f; below_m < BOWL_DEPTH_M - 0.005f; below_m += 0.005f) {
        const float slice_m3 = bowl_room_m3(below_m - 0.001f) - bowl_room_m3(below_m + 0.001f);
        const float radius_m = bowl_hull_radius_m(below_m);
        assert_float_equal(slice_m3 / (F_PI * radius_m * radius_m * 0.002f), 1.0f, 0.01f);
    }
}

static void test_a_bowl_sinks_a_tenth_of_a_millimetre_for_each_fish(void **state)
{
    (void)state;
    float_bowls(1);
    for (uint32_t i = 0; i < 20; i++) {
        drop_in(0.04f, 0.0f);
    }
    wait_for(3.0f);
    const float sunk_m = 0.012f - bowls[0].position_m.y;
    const float kg = 20.0f * fish_mass_kg(0.04f);
    assert_float_equal(sunk_m, kg / (1000.0f * F_PI * 0.0784f * 0.0784f), 1e-4f);
    assert_float_equal(sunk_m / 20.0f, 0.75e-4f, 0.1e-4f);
}

static void test_the_bowls_water_rises_with_its_fish_and_spills_before_the_mouth(void **state)
{
    (void)state;
    float_bowls(1);
    float before_m = bowl_level_m(&bowls[0]);
    for (uint32_t i = 0; i < BOWL_FISH_MAX; i++) {
        drop_in(0.04f, 0.0f);
        wait_for(0.1f);
        assert_true(bowl_level_m(&bowls[0]) <= before_m + 1e-6f);
        before_m = bowl_level_m(&bowls[0]);
    }
    wait_for(3.0f);
    assert_int_equal(bowls[0].fish_count, BOWL_FISH_MAX);
    /* The rim of the full bowl must be 3 to 8 mm above the water. The limits are in units of 0.1
     * mm. */
    assert_in_range((uint32_t)(1e4f * before_m), 30, 80);
    assert_float_equal(bowls[0].position_m.y, 0.004f, 5e-4f);
    /* The fish have displaced a part of the 0.523 kg of water in the bowl. The displaced water
     * flowed over the rim. */
    assert_true(bowls[0].water_kg < 0.520f);
}

static void test_a_fish_that_drops_in_off_centre_rocks_the_bowl(void **state)
{
    (void)state;
    float_bowls(1);
    drop_in(0.06f, 0.05f);
    float lowest_m = 1.0f, heel_rad = 0.0f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        wait_for(CORE_TICK_S);
        lowest_m = f_min(lowest_m, bowls[0].position_m.y);
        heel_rad = f_max(heel_rad, bowls[0].heel_x);
    }
    print_message("a fish of 5 g from 25 mm: %.2f mm down, heel %.2f degrees\n",
                  1e3 * (double)(0.012f - lowest_m), (double)heel_rad * 57.3);
    assert_true(lowest_m < 0.0115f);
    /* The bowl must tilt toward the side on which the fish dropped in. */
    assert_true(heel_rad > 0.3f * F_DEG);
    assert_true(bowl_angles(&bowls[0]).roll_rad == bowls[0].heel_x);
    wait_for(4.0f);
    assert_true(f_abs(bowls[0].heel_x) < 0.05f * F_DEG);
}

static void test_a_bowl_heaves_and_heels_on_ripples(void **state)
{
    (void)state;
    float_bowls(1);
    water_press(&tank.water, tank.size_m, v3(-0.1f, 0.0f, 0.0f), 0.06f, 0.008f);
    float high_m = 0.0f, low_m = 1.0f, heel_rad = 0.0f;
    for (uint32_t i = 0; i < 3u * CORE_TICK_HZ; i++) {
        if (i % 2u == 0) {
            water_step(&tank.water, tank.size_m);
        }
        wait_for(CORE_TICK_S);
        high_m = f_max(high_m, bowls[0].position_m.y);
        low_m = f_min(low_m, bowls[0].position_m.y);
        heel_rad = f_max(heel_rad, f_abs(bowls[0].heel_x));
    }
    assert_true(high_m > 0.01205f);
    assert_true(low_m < 0.01195f);
    assert_true(heel_rad > 0.1f * F_DEG);
    wait_for(3.0f);
}

static void test_a_displaced_bowl_drifts_home_within_some_seconds(void **state)
{
    (void)state;
    float_bowls(1);
    bowls[0].position_m.x += 0.10f;
    wait_for(1.0f);
    const float left_m = bowls[0].position_m.x - bowls[0].home_m.x;
    /* The mooring pulls the bowl back softly, like an elastic thread. After a second the bowl must
     * still be more than 2 cm away. */
    assert_true(left_m > 0.02f);
    wait_for(5.0f);
    assert_true(f_abs(bowls[0].position_m.x - bowls[0].home_m.x) < 0.003f);
}

/* ---- Bowls that are pushed ------------------------------------------------------------------ */

/* Moves a level ring at 0.2 m/s from 25 cm left of bowl 0 to the position `to_x_m`. Its height is
 * `depth_m`. Checks in every tick that the ring is outside every hull. */
static void push_with_ring(float depth_m, float to_x_m)
{
    const struct stall stall = { &tank, bowls, POI_MAX, false };
    const uint8_t live = 1;
    const float from_x_m = bowls[0].position_m.x - 0.25f, z_m = bowls[0].position_m.z;
    poi_init(&poi, 4, v3(from_x_m, depth_m, z_m), 1);
    const uint32_t ticks = (uint32_t)((to_x_m - from_x_m) / 0.2f * (float)CORE_TICK_HZ);
    for (uint32_t i = 0; i < ticks; i++) {
        struct poi_grip grip = { .has_wrist = 1 };
        grip.target.position_m = v3(from_x_m + 0.2f * CORE_TICK_S * (float)i, depth_m, z_m);
        poi_tick(&poi, &grip, &tank, &bowls[0]);
        for (uint32_t k = 1; k < POI_MAX; k++) {
            poi_constrain_to_bowl(&poi, &bowls[k]);
        }
        bowl_buoyancy_tick(&stall, &poi, &live, 1);
        poi_apply_reaction(&poi, &(struct obstacle){ .centre_m = poi.position_m });
        for (uint32_t k = 0; k < POI_MAX; k++) { /* The ring must stay outside every hull. */
            const vec3 away = v3(poi.position_m.x - bowls[k].position_m.x, 0.0f,
                                 poi.position_m.z - bowls[k].position_m.z);
            const float hull_m = bowl_hull_radius_m(bowls[k].position_m.y - poi.position_m.y);
            assert_true(!bowls[k].present || poi.position_m.y > bowls[k].position_m.y ||
                        v3_length(away) > hull_m + POI_OUTER_RADIUS_M - 0.004f);
        }
    }
}

static void test_the_ring_of_a_poi_pushes_the_bowl(void **state)
{
    (void)state;
    float_bowls(1);
    bowls[0].position_m.x = bowls[0].home_m.x = 0.0f;
    push_with_ring(0.0f, 0.05f);
    print_message("a ring that went on for 17 cm took the bowl %.0f mm along\n",
                  1e3 * (double)bowls[0].position_m.x);
    assert_true(bowls[0].position_m.x > 0.10f);
    assert_true(bowls[0].heel_x != 0.0f);
}

static void test_a_ring_over_the_bowl_or_far_from_it_does_not_push_it(void **state)
{
    (void)state;
    float_bowls(1);
    push_with_ring(0.06f, 0.2f);
    assert_true(f_abs(bowls[0].position_m.x - bowls[0].home_m.x) < 1e-4f);
}

static void test_a_ring_that_rests_on_the_mouth_lowers_the_bowl_a_little(void **state)
{
    (void)state;
    const struct stall stall = { &tank, bowls, POI_MAX, false };
    const uint8_t live = 1;
    float_bowls(1);
    poi_init(&poi, 4, v3(-0.3f, 0.05f, 0.0f), 1);
    float lowest_m = 1.0f;
    for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
        struct poi_grip grip = { .has_wrist = 1 };
        grip.target.position_m = v3(-0.3f, -0.05f, 0.0f);
        poi_tick(&poi, &grip, &tank, &bowls[0]);
        bowl_buoyancy_tick(&stall, &poi, &live, 1);
        poi_apply_reaction(&poi, &(struct obstacle){ .centre_m = poi.position_m });
        lowest_m = f_min(lowest_m, bowls[0].position_m.y);
        /* The rim of the bowl must stay at least 2 mm above the water. */
        assert_true(bowls[0].position_m.y >= 0.002f);
        /* The ring lies on the rim of the bowl and must not sink into the bowl. */
        assert_true(poi.position_m.y > bowls[0].position_m.y);
    }
    assert_true(lowest_m < 0.010f);
}

static void test_walls_stop_a_bowl(void **state)
{
    (void)state;
    float_bowls(1);
    bowls[0].position_m = bowls[0].home_m = v3(0.30f, 0.012f, 0.0f);
    push_with_ring(0.0f, 0.44f);
    assert_true(bowls[0].position_m.x > 0.36f);
    assert_true(bowls[0].position_m.x <= 0.45f - BOWL_RADIUS_M);
    /* Throws the bowl at 2 m/s in 600 directions, so that it hits each wall and corner many
     * times. */
    for (int i = 0; i < 600; i++) {
        bowls[0].velocity_m_s = v3(2.0f * f_cos((float)i), 0.3f, 2.0f * f_sin((float)i));
        wait_for(0.5f);
        assert_true(f_abs(bowls[0].position_m.x) <= 0.45f - BOWL_RADIUS_M);
        assert_true(f_abs(bowls[0].position_m.z) <= 0.275f - BOWL_RADIUS_M);
        assert_true(bowls[0].position_m.y > 0.0f && bowls[0].position_m.y < 0.03f);
    }
}

static void test_bowls_push_each_other_and_never_overlap(void **state)
{
    (void)state;
    float_bowls(3);
    for (uint32_t i = 0; i < 3; i++) {
        bowls[i].position_m.x = bowls[i].home_m.x = -0.10f + 0.18f * (float)i;
    }
    push_with_ring(0.0f, 0.05f);
    assert_true(bowls[1].position_m.x > bowls[1].home_m.x + 0.03f);
    assert_true(bowls[2].position_m.x > bowls[2].home_m.x + 0.01f);
    for (uint32_t i = 1; i < 3; i++) {
        const float apart_m = bowls[i].position_m.x - bowls[i - 1u].position_m.x;
        assert_true(apart_m > 2.0f * BOWL_RADIUS_M - 0.001f);
    }
}

/* ---- Fish in a moving bowl ------------------------------------------------------------------ */

static void test_the_fish_in_a_bowl_move_with_it(void **state)
{
    (void)state;
    float_bowls(1);
    for (uint32_t i = 0; i < 12; i++) {
        drop_in(0.04f, 0.004f * (float)i - 0.02f);
    }
    const struct stall stall = { &tank, bowls, POI_MAX, false };
    /* Moves the mooring far away, which pulls the bowl across the tank. */
    bowls[0].home_m.x = 0.25f;
    for (uint32_t tick = 0; tick < 4u * CORE_TICK_HZ; tick++) {
        bowl_buoyancy_tick(&stall, NULL, NULL, 0);
        bowl_fish_tick(&bowls[0], 0, &tank);
        for (uint32_t i = 0; i < 12; i++) {
            const vec3 at = v3_sub(tank.fish[i].position_m, bowls[0].position_m);
            assert_true(f_sqrt(at.x * at.x + at.z * at.z) < BOWL_RADIUS_M);
            assert_true(at.y < 0.001f && at.y > -BOWL_DEPTH_M);
        }
    }
    assert_true(bowls[0].position_m.x > 0.15f);
}

static void test_tank_fish_avoid_a_drifting_hull(void **state)
{
    (void)state;
    static struct poi_fixture fixture;
    fixture_init(&fixture, 4, 1);
    for (uint32_t i = 0; i < 60; i++) {
        const uint32_t fish =
            fixture_add_fish(&fixture,
                             v3(0.02f + 0.04f * (float)(i % 5u), -0.02f - 0.03f * (float)(i / 20u),
                                0.12f + 0.03f * (float)(i / 5u % 4u)),
                             0.04f);
        fixture.tank.fish[fish].angles.yaw_rad = (float)i;
    }
    bowl_init(&fixture.bowl, v3(0.30f, 0.012f, 0.15f));
    fixture_wait(&fixture, 1.0f);
    fixture.bowl.home_m.x = -0.2f;
    float deepest_m = 0.0f;
    for (uint32_t tick = 0; tick < 6u * CORE_TICK_HZ; tick++) {
        fixture_tick(&fixture);
        const struct obstacle hull = bowl_obstacle(&fixture.bowl);
        for (uint32_t i = 0; i < fixture.tank.fish_count; i++) {
            const struct box box = fish_box(&fixture.tank.fish[i]);
            deepest_m = f_max(deepest_m, -obstacle_touch(&hull, &box).gap_m);
        }
    }
    print_message("no fish was deeper than %.2f mm in the hull\n", 1e3 * (double)deepest_m);
    assert_true(fixture.bowl.position_m.x < 0.0f);
    assert_true(deepest_m < 0.0005f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bowl_floats_at_its_home),
        cmocka_unit_test(test_the_hulls_volume_and_radius_agree),
        cmocka_unit_test(test_a_bowl_sinks_a_tenth_of_a_millimetre_for_each_fish),
        cmocka_unit_test(test_the_bowls_water_rises_with_its_fish_and_spills_before_the_mouth),
        cmocka_unit_test(test_a_fish_that_drops_in_off_centre_rocks_the_bowl),
        cmocka_unit_test(test_a_bowl_heaves_and_heels_on_ripples),
        cmocka_unit_test(test_a_displaced_bowl_drifts_home_within_some_seconds),
        cmocka_unit_test(test_the_ring_of_a_poi_pushes_the_bowl),
        cmocka_unit_test(test_a_ring_over_the_bowl_or_far_from_it_does_not_push_it),
        cmocka_unit_test(test_a_ring_that_rests_on_the_mouth_lowers_the_bowl_a_little),
        cmocka_unit_test(test_walls_stop_a_bowl),
        cmocka_unit_test(test_bowls_push_each_other_and_never_overlap),
        cmocka_unit_test(test_the_fish_in_a_bowl_move_with_it),
        cmocka_unit_test(test_tank_fish_avoid_a_drifting_hull),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
