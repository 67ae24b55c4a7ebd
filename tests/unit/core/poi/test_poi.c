/* test_poi.c -- checks how the ring of a poi (the paper scoop) follows the player's pose through
 * air and water, and how the tank's walls and floor stop it. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"
#include "core/poi/poi_fields.h"
#include "core/tank/water.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

static void test_in_air_the_poi_lags_a_moving_hand_by_a_frame_and_a_half(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture.hand.position_m = fixture.poi.position_m = v3(-0.3f, 0.06f, 0.0f);
    fixture_move(&fixture, v3(0.3f, 0.06f, 0.0f), 0.5f);
    const float lag_s = (fixture.hand.position_m.x - fixture.poi.position_m.x) / 0.5f;
    assert_true(lag_s > 0.015f);
    assert_true(lag_s < 0.026f);
}

static void test_the_poi_follows_a_jump_of_the_hand_without_overshoot(void **state)
{
    (void)state;
    const float heights_m[] = { 0.06f, -0.07f };
    for (uint32_t i = 0; i < 2; i++) {
        fixture_init(&fixture, 4, 1);
        fixture.hand.position_m = fixture.poi.position_m = v3(-0.2f, heights_m[i], 0.0f);
        fixture_wait(&fixture, 0.2f);
        fixture.hand.position_m.x = 0.2f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            fixture_tick(&fixture);
            assert_true(fixture.poi.position_m.x < 0.205f);
        }
        assert_float_equal(fixture.poi.position_m.x, 0.2f, 0.001f);
    }
}

static void test_a_hand_that_shakes_wildly_leaves_the_poi_numerically_stable(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    for (uint32_t tick = 0; tick < 1200; tick++) {
        fixture.hand.position_m = tick % 2u ? v3(40.0f, -30.0f, 7.0f) : v3(-40.0f, 30.0f, -7.0f);
        fixture.hand.angles.pitch_rad = tick % 3u ? 3.0f : -3.0f;
        fixture_tick(&fixture);
        assert_true(v3_length(fixture.poi.velocity_m_s) < 20.0f);
        assert_in_range((int)(1000.0f * fixture.poi.position_m.y) + 150, 0, 450);
    }
}

/* Moves the poi broadside at a constant speed. Returns the steady drag in N. */
static float steady_broadside_n(float speed_m_s)
{
    fixture_init(&fixture, 4, 1);
    fixture.tank.size_m = v3(4.0f, 0.5f, 1.0f);
    fixture.hand.position_m = fixture.poi.position_m = v3(-1.0f, -0.2f, 0.0f);
    fixture.hand.angles.roll_rad = 0.5f * F_PI;
    fixture_wait(&fixture, 0.5f);
    fixture_move(&fixture, v3(-0.4f, -0.2f, 0.0f), speed_m_s);
    return fixture.force.force_n.x;
}

static void test_broadside_drag_on_the_hand_at_0_3_m_s_is_0_25_n(void **state)
{
    (void)state;
    assert_float_equal(steady_broadside_n(0.3f), -0.25f, 0.025f);
}

static void test_edge_on_drag_on_the_hand_is_almost_zero(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.hand.position_m = fixture.poi.position_m = v3(-0.3f, -0.07f, 0.0f);
    fixture_wait(&fixture, 0.5f);
    fixture_move(&fixture, v3(0.3f, -0.07f, 0.0f), 0.3f);
    assert_true(fixture.force.force_n.x < 0.0f);
    assert_true(fixture.force.force_n.x > -0.010f);
}

/* Turns the player's wrist at 4 rad/s. Returns the time in seconds by which the ring lags behind.
 * If `about_normal` is set, the wrist turns about the normal of the paper, otherwise it rolls. */
static float turn_lag_s(float height_m, int about_normal)
{
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    fixture.hand.position_m = fixture.poi.position_m = v3(0.0f, height_m, 0.0f);
    fixture_wait(&fixture, 0.5f);
    float *hand = about_normal ? &fixture.hand.angles.yaw_rad : &fixture.hand.angles.roll_rad;
    const float *ring = about_normal ? &fixture.poi.angles.yaw_rad : &fixture.poi.angles.roll_rad;
    for (uint32_t tick = 0; tick < 36; tick++) {
        *hand += 4.0f * CORE_TICK_S;
        fixture_tick(&fixture);
    }
    return (*hand - *ring) / 4.0f;
}

static void test_water_slows_a_ring_that_rolls_and_not_one_that_spins_in_its_plane(void **state)
{
    (void)state;
    const float air_s = turn_lag_s(0.10f, 0), water_s = turn_lag_s(-0.075f, 0);
    assert_true(water_s > 1.1f * air_s);
    /* The water that turns with the ring may increase the lag by at most 40 %. */
    assert_true(water_s < 1.4f * air_s);
    assert_float_equal(turn_lag_s(-0.075f, 1), air_s, 1e-4f);
}

static void test_the_force_of_a_poi_at_rest_in_air_is_its_weight(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture_wait(&fixture, 1.0f);
    assert_float_equal(fixture.force.force_n.y, -POI_MASS_KG * GRAVITY_M_S2, 0.002f);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.1f);
    /* The player also holds the weight of the water on the paper and in its sag, which is at least
     * 3 g. */
    assert_true(fixture.force.force_n.y < -(POI_MASS_KG + 0.003f) * GRAVITY_M_S2);
}

/* The centre of the ring is 13 cm from the grip, so the weight of the ring causes a torque about x.
 * A fish on the right side also causes a torque about z. */
static void test_the_load_of_the_fish_adds_a_torque_about_the_grip(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_wait(&fixture, 1.0f);
    const float weight_n = POI_MASS_KG * GRAVITY_M_S2;
    assert_float_equal(fixture.force.torque_n_m.x, -0.130f * weight_n, 0.001f);
    assert_float_equal(fixture.force.torque_n_m.z, 0.0f, 1e-5f);
    /* The load of the fish is set directly to what catch_tick() would compute. */
    fixture.poi.carried_kg = 0.003f;
    fixture.poi.loads[0] = (struct sheet_load){ 0.03f, 0.0f, 0.02f, -0.003f * GRAVITY_M_S2 };
    fixture.poi.load_count = 1;
    const struct poi_grip grip = { fixture.hand, 1 };
    poi_tick(&fixture.poi, &grip, &fixture.tank, &fixture.bowl);
    poi_haptics(&fixture.poi, &fixture.force);
    assert_float_equal(fixture.force.torque_n_m.x, -0.130f * (weight_n + 0.0294f), 0.001f);
    assert_float_equal(fixture.force.torque_n_m.z, -0.03f * 0.0294f, 1e-5f);
}

static void test_the_ring_stays_inside_floor_walls_and_the_reach_of_an_arm(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.hand.position_m = v3(2.0f, -2.0f, -2.0f);
    fixture_wait(&fixture, 3.0f);
    assert_true(fixture.poi.position_m.y > -0.15f);
    assert_true(fixture.poi.position_m.y < -0.14f);
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(0.0f, -0.07f, 0.0f), 0.2f);
    fixture.hand.position_m = v3(2.0f, -0.07f, -2.0f);
    fixture_wait(&fixture, 3.0f);
    assert_float_equal(fixture.poi.position_m.x, 0.45f - POI_OUTER_RADIUS_M, 0.002f);
    assert_float_equal(fixture.poi.position_m.z, -0.275f + POI_OUTER_RADIUS_M, 0.002f);
    fixture.hand.position_m = v3(2.0f, 2.0f, -2.0f);
    fixture_wait(&fixture, 3.0f);
    assert_float_equal(fixture.poi.position_m.y, 0.30f, 0.002f);
    assert_true(fixture.poi.position_m.x > 0.45f);
}

static void test_a_ring_outside_the_tank_lands_on_the_rim_of_the_wall(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(0.0f, 0.20f, 0.0f), 0.5f);
    fixture_move(&fixture, v3(0.50f, 0.20f, 0.0f), 0.5f);
    fixture_move(&fixture, v3(0.50f, -0.10f, 0.0f), 0.5f);
    fixture_wait(&fixture, 1.0f);
    assert_true(fixture.poi.position_m.x > 0.45f);
    /* The target is outside the tank and below the tank's rim. The rim is 5 cm above the water, so
     * the poi must rest on the rim. */
    assert_true(fixture.poi.position_m.y > 0.05f);
}

/* Runs a tick in which the ring must move by less than 40 mm. The spring force of at most 20 N
 * gives a speed of 3.5 m/s, which is 29 mm per tick. The other 11 mm allow for contact with the
 * floor, the rim and the walls while the wrist turns. */
static void tick_without_jump(void)
{
    const vec3 before_m = fixture.poi.position_m;
    fixture_tick(&fixture);
    assert_true(v3_length(v3_sub(fixture.poi.position_m, before_m)) < 0.040f);
}

static void test_a_ring_that_turns_on_the_rim_stays_on_the_rim(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 16; i++) {
        const int endwise = i % 2u == 1u;
        fixture_init(&fixture, 4, i);
        const vec3 over = endwise ? v3(0.0f, 0.20f, 0.425f) : v3(0.575f, 0.20f, 0.0f);
        fixture_move(&fixture, v3(0.0f, 0.20f, 0.0f), 0.5f);
        fixture_move(&fixture, over, 0.5f);
        fixture_move(&fixture, v3(over.x, 0.0315f, over.z), 0.5f);
        fixture.hand.angles.roll_rad = i & 2u ? 0.6f : -1.2f;
        fixture.hand.angles.pitch_rad = i & 4u ? 0.35f : -1.2f;
        fixture.hand.angles.pitch_rad *= i & 8u ? 0.0f : 1.0f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            tick_without_jump();
            assert_true(f_abs(fixture.poi.position_m.x) > 0.45f ||
                        f_abs(fixture.poi.position_m.z) > 0.275f);
        }
    }
}

static void test_a_ring_that_turns_level_beside_a_wall_is_pushed_inside(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad = 0.5f * F_PI;
    fixture_move(&fixture, v3(0.0f, -0.05f, 0.0f), 0.3f);
    fixture_move(&fixture, v3(0.50f, -0.05f, 0.0f), 0.3f);
    fixture.hand.angles.roll_rad = 0.0f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_without_jump();
    }
    assert_float_equal(fixture.poi.position_m.x, 0.45f - POI_OUTER_RADIUS_M, 0.002f);
}

static float drawn(uint32_t step, uint32_t which, float low, float high)
{
    const struct rng_key key = { fixture.tank.seed, step, which, RNG_BOT_CHOICE };
    return rng_range(key, low, high);
}

static void test_the_ring_never_jumps_for_any_hand_motion(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 12; seed++) {
        fixture_init(&fixture, 4, seed);
        for (uint32_t step = 0; step < 400; step++) {
            fixture.hand.position_m =
                v3(drawn(step, 0, -0.60f, 0.60f), drawn(step, 1, -0.20f, 0.15f),
                   drawn(step, 2, -0.42f, 0.42f));
            fixture.hand.angles =
                (struct angles){ drawn(step, 3, -3.0f, 3.0f), drawn(step, 4, -1.5f, 1.5f),
                                 drawn(step, 5, -1.5f, 1.5f) };
            for (uint32_t tick = 0; tick < 12; tick++) {
                tick_without_jump();
            }
        }
    }
}

static void test_a_still_pose_tears_nothing_wet_or_dry(void **state)
{
    (void)state;
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        fixture_init(&fixture, grade, grade);
        fixture_wait(&fixture, 5.0f);
        fixture_dip(&fixture);
        fixture_wait(&fixture, 10.0f);
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.15f);
        fixture_wait(&fixture, 20.0f);
        assert_float_equal(sheet_left(&fixture.poi.sheet), 1.0f, 0.0f);
    }
}

static void test_only_the_submerged_part_of_the_paper_gets_wet(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad =
        0.5f * F_PI; /* Rolls the poi by 90 degrees, so that its right edge is the lowest. */
    fixture_move(&fixture, v3(0.0f, 0.0f, 0.0f), 0.2f);
    fixture_wait(&fixture, 3.0f);
    const uint32_t row = SHEET_SIDE / 2u * SHEET_SIDE;
    assert_true(fixture.poi.sheet.wetness[row + SHEET_SIDE - 4u] > 0.9f);
    assert_true(fixture.poi.sheet.wetness[row + 3u] < 0.1f);
    assert_float_equal(fixture.poi.immersed, 0.5f, 0.03f);
}

static int lift_survives(uint8_t grade, uint32_t seed, float speed_m_s)
{
    fixture_init(&fixture, grade, seed);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), speed_m_s);
    return sheet_left(&fixture.poi.sheet) > 0.9f;
}

static void test_a_broadside_lift_tears_wet_grade_6_at_1_m_s_and_not_slowly(void **state)
{
    (void)state;
    uint32_t fast = 0, slow = 0;
    for (uint32_t seed = 0; seed < 40; seed++) {
        fast += (uint32_t)lift_survives(6, seed, 1.0f);
        slow += (uint32_t)lift_survives(6, seed, 0.2f);
    }
    assert_in_range(fast, 0, 2);
    assert_int_equal(slow, 40);
}

/* Sweeps the poi by 55 cm through the water. The paper is rolled by `roll_rad`. Returns the
 * fraction of the paper that is left. */
static float left_after_sweep(float roll_rad, float speed_m_s, uint32_t seed)
{
    fixture_init(&fixture, 6, seed);
    fixture_move(&fixture, v3(-0.30f, 0.06f, 0.0f), 0.5f);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(-0.30f, -0.09f, 0.0f), 0.2f);
    fixture_turn(&fixture, 0.0f, roll_rad, 0.5f);
    fixture_move(&fixture, v3(0.25f, -0.09f, 0.0f), speed_m_s);
    return sheet_left(&fixture.poi.sheet);
}

static void test_a_fast_broadside_sweep_tears_and_a_glide_along_the_plane_does_not(void **state)
{
    (void)state;
    uint32_t torn = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        torn += left_after_sweep(70.0f * F_DEG, 0.8f, seed) < 0.95f;
        assert_float_equal(left_after_sweep(0.0f, 0.8f, seed), 1.0f, 0.0f);
        assert_float_equal(left_after_sweep(70.0f * F_DEG, 0.2f, seed), 1.0f, 0.0f);
    }
    assert_in_range(torn, 18, 20);
}

/* ---- Counted dips and carried water --------------------------------------------------------- */

static void test_a_dip_counts_once(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    for (uint32_t i = 0; i < 3; i++) {
        fixture_move(&fixture, v3(0.0f, -0.06f, 0.0f), 0.2f);
        fixture_wait(&fixture, 0.3f);
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.2f);
        fixture_wait(&fixture, 0.3f);
    }
    assert_int_equal(fixture.poi.dips, 3);
}

static void test_a_level_poi_keeps_its_pool_and_a_tilted_one_spills_it(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.3f);
    /* Just after the lift, the drag of the lift still pulls the paper down. The paper therefore
     * holds more water than at rest. */
    const float carried = fixture.poi.water_kg;
    fixture_wait(&fixture, 1.0f);
    const float level = fixture.poi.water_kg, pool = fixture.poi.pool_kg;
    fixture_turn(&fixture, 0.8f, 0.0f, 0.2f);
    fixture_wait(&fixture, 0.5f);
    assert_true(carried > 0.005f);
    assert_true(level > 0.004f);
    assert_true(pool > 0.0015f);
    assert_true(fixture.poi.pool_kg < 0.12f * pool);
    assert_true(fixture.poi.water_kg < 0.0025f);
}

static uint64_t played(uint32_t seed)
{
    fixture_init(&fixture, 6, seed);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.2f, 0.06f, 0.1f), 0.6f);
    return field_hash(HASH_START, &poi_fields, &fixture.poi);
}

static void test_the_same_hand_poses_give_the_same_poi_bit_for_bit(void **state)
{
    (void)state;
    const uint64_t first = played(5);
    assert_true(first == played(5));
    assert_true(first != played(6));
}

static void test_a_nan_target_fails_an_assertion(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture.hand.position_m.x = __builtin_nanf("");
    expect_assert_failure(fixture_tick(&fixture));
    fixture_init(&fixture, 6, 1);
    fixture.hand.angles.roll_rad = __builtin_inff();
    expect_assert_failure(fixture_tick(&fixture));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_in_air_the_poi_lags_a_moving_hand_by_a_frame_and_a_half),
        cmocka_unit_test(test_the_poi_follows_a_jump_of_the_hand_without_overshoot),
        cmocka_unit_test(test_a_hand_that_shakes_wildly_leaves_the_poi_numerically_stable),
        cmocka_unit_test(test_broadside_drag_on_the_hand_at_0_3_m_s_is_0_25_n),
        cmocka_unit_test(test_edge_on_drag_on_the_hand_is_almost_zero),
        cmocka_unit_test(test_water_slows_a_ring_that_rolls_and_not_one_that_spins_in_its_plane),
        cmocka_unit_test(test_the_force_of_a_poi_at_rest_in_air_is_its_weight),
        cmocka_unit_test(test_the_ring_stays_inside_floor_walls_and_the_reach_of_an_arm),
        cmocka_unit_test(test_a_ring_outside_the_tank_lands_on_the_rim_of_the_wall),
        cmocka_unit_test(test_a_ring_that_turns_on_the_rim_stays_on_the_rim),
        cmocka_unit_test(test_a_ring_that_turns_level_beside_a_wall_is_pushed_inside),
        cmocka_unit_test(test_the_ring_never_jumps_for_any_hand_motion),
        cmocka_unit_test(test_the_load_of_the_fish_adds_a_torque_about_the_grip),
        cmocka_unit_test(test_a_still_pose_tears_nothing_wet_or_dry),
        cmocka_unit_test(test_only_the_submerged_part_of_the_paper_gets_wet),
        cmocka_unit_test(test_a_broadside_lift_tears_wet_grade_6_at_1_m_s_and_not_slowly),
        cmocka_unit_test(test_a_fast_broadside_sweep_tears_and_a_glide_along_the_plane_does_not),
        cmocka_unit_test(test_a_dip_counts_once),
        cmocka_unit_test(test_a_level_poi_keeps_its_pool_and_a_tilted_one_spills_it),
        cmocka_unit_test(test_the_same_hand_poses_give_the_same_poi_bit_for_bit),
        cmocka_unit_test(test_a_nan_target_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
