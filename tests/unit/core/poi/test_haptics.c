/* test_haptics.c -- checks the force feedback of a poi (the paper scoop). Its forces come from the
 * water, the weight, fish, the floor, walls and tears. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"

#define POI_AREA_M2 (F_PI * POI_RADIUS_M * POI_RADIUS_M)

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

static float weight_n(void)
{
    return (POI_MASS_KG + fixture.poi.water_kg + fixture.poi.carried_kg) * GRAVITY_M_S2;
}

static void test_the_force_of_a_still_poi_in_air_is_its_weight_with_water(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture_wait(&fixture, 1.0f);
    assert_float_equal(fixture.force.force_n.y, -POI_MASS_KG * GRAVITY_M_S2, 1e-4f);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.3f);
    assert_true(fixture.poi.water_kg > 0.003f);
    assert_float_equal(fixture.force.force_n.y, -weight_n(), 0.002f);
    assert_float_equal(fixture.force.force_n.x, 0.0f, 1e-4f);
    assert_float_equal(fixture.force.torque_n_m.x, -0.130f * weight_n(), 0.0003f);
}

static void test_the_drag_on_the_paper_opposes_a_pull_through_water(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; i++) {
        const float course = F_TAU * (float)i / 8.0f, speed_m_s = i % 2u ? 0.3f : 0.2f;
        const vec3 way = v3(f_cos(course), 0.0f, f_sin(course));
        fixture_init(&fixture, 4, 1);
        fixture.tank.size_m = v3(4.0f, 0.5f, 4.0f);
        fixture.hand.position_m = fixture.poi.position_m = v3_muladd(v3(0, -0.2f, 0), way, -0.5f);
        fixture.hand.angles = (struct angles){ .yaw_rad = -course, .roll_rad = 0.5f * F_PI };
        fixture_wait(&fixture, 0.5f);
        fixture_move(&fixture, v3_muladd(v3(0.0f, -0.2f, 0.0f), way, 0.2f), speed_m_s);
        const float drag_n = 0.5f * WATER_KG_M3 * 1.17f * POI_AREA_M2 * speed_m_s * speed_m_s;
        assert_float_equal(v3_dot(fixture.force.force_n, way), -drag_n, 0.1f * drag_n);
        assert_float_equal(fixture.force.drag, drag_n / POI_DRAG_N_FULL, 0.02f);
        assert_float_equal(fixture.force.slap + fixture.force.tear, 0.0f, 0.0f);
    }
}

/* An accelerated disc also accelerates 0.171 kg of water (added mass). At 2 m/s^2 this needs a
 * force of 0.34 N. The motion is so short that the drag stays small. */
static void test_an_acceleration_under_water_adds_the_force_of_the_added_mass(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.tank.size_m = v3(4.0f, 0.5f, 1.0f);
    fixture.hand.position_m = fixture.poi.position_m = v3(0.0f, -0.2f, 0.0f);
    fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad = 0.5f * F_PI;
    fixture_wait(&fixture, 0.5f);
    float most_n = 0.0f;
    /* The position x = t^2 has an acceleration of 2 m/s^2. After these 12 ticks (0.1 s) the speed
     * is 0.2 m/s. */
    for (uint32_t tick = 1; tick <= 12; tick++) {
        const float t = (float)tick * CORE_TICK_S;
        fixture.hand.position_m.x = t * t;
        fixture_tick(&fixture);
        most_n = f_max(most_n, -fixture.force.force_n.x);
    }
    const float drag_n = fixture.poi.drag_n_s_m * fixture.poi.velocity_m_s.x;
    assert_true(most_n - drag_n > 0.15f);
    assert_true(most_n - drag_n < 0.36f);
}

/* Returns the torque in N m while the poi turns about its handle at 10 rad/s. The poi is at the
 * height `height_m` above the water. */
static float turn_torque_n_m(float height_m)
{
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    fixture.hand.position_m = fixture.poi.position_m = v3(0.0f, height_m, 0.0f);
    fixture_wait(&fixture, 0.5f);
    for (uint32_t tick = 0; tick < 12; tick++) {
        fixture.hand.angles.roll_rad += 10.0f * CORE_TICK_S;
        fixture_tick(&fixture);
    }
    return fixture.force.torque_n_m.z;
}

/* The expected torque at omega = 10 rad/s is (1/2) rho 1.17 (8/15) a^5 omega^2 = 3.2 mN m. A roll
 * turns about -z, so the torque of the water, which opposes the roll, is positive about z. */
static void test_water_opposes_a_turning_wrist_and_loads_the_paper(void **state)
{
    (void)state;
    assert_float_equal(turn_torque_n_m(0.10f), 0.0f, 1e-4f);
    assert_float_equal(fixture.poi.pressure_pa, 0.0f, 10.0f);
    assert_float_equal(turn_torque_n_m(-0.075f), 0.0032f, 0.0005f);
    assert_float_equal(f_abs(fixture.poi.pressure_pa), 23.4f, 3.0f);
}

/* ---- Forces of fish ------------------------------------------------------------------------- */

/* Runs a tick with a tail slap at a point of the paper. The load is set directly to what
 * catch_tick() would compute. */
static void tick_with_blow(float x_m, float z_m, float force_n)
{
    const struct poi_grip grip = { fixture.hand, 1 };
    fixture.poi.loads[0] = (struct sheet_load){ x_m, z_m, 0.003f, -force_n };
    fixture.poi.load_count = fixture.poi.slap_count = force_n > 0.0f;
    poi_tick(&fixture.poi, &grip, &fixture.tank, &fixture.bowl);
    const struct obstacle ring = poi_obstacle(&fixture.poi);
    poi_apply_reaction(&fixture.poi, &ring);
    poi_haptics(&fixture.poi, &fixture.force);
}

static void test_a_tail_slap_gives_a_force_of_the_same_duration_and_strength(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_wait(&fixture, 1.0f);
    const struct poi_force rest = fixture.force;
    for (uint32_t tick = 0; tick < 3; tick++) {
        tick_with_blow(0.03f, 0.02f, 0.09f);
        assert_float_equal(fixture.force.force_n.y - rest.force_n.y, -0.09f, 0.02f);
        assert_float_equal(fixture.force.slap, 0.6f, 1e-5f);
    }
    /* A load on the right side turns the grip to the right. The load also tips the grip, but by
     * less than a load in the middle of the ring, because the lever is 110 mm instead of 130 mm
     * long. */
    assert_float_equal(fixture.force.torque_n_m.z, -0.03f * 0.09f, 2e-4f);
    assert_float_equal(fixture.force.torque_n_m.x - rest.torque_n_m.x, -0.110f * 0.09f, 0.002f);
    tick_with_blow(0.0f, 0.0f, 0.0f);
    tick_with_blow(0.0f, 0.0f, 0.0f);
    assert_float_equal(fixture.force.force_n.y, rest.force_n.y, 0.02f);
    assert_float_equal(fixture.force.slap, 0.0f, 0.0f);
}

/* Lifts a fish that slaps its tail, and compares the slaps with the force feedback. A slap that
 * catch_tick() computes in one tick acts in the next tick. */
static void test_a_carried_fish_adds_its_weight_and_its_slaps_to_the_force(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    fixture_add_fish(&fixture, v3(0.0f, fixture.poi.position_m.y + 0.03f, 0.0f), 0.05f);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.08f);
    /* Waits until the water that the lift has moved is at rest, so that only the fish changes the
     * force. */
    fixture_wait(&fixture, 0.15f);
    assert_int_equal(fixture.poi.carried_count, 1);
    uint32_t blows = 0, felt = 0;
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ && fixture.poi.carried_count; tick++) {
        const float due_n = fixture.poi.slap_count ? -fixture.poi.loads[0].force_n : 0.0f;
        fixture_tick(&fixture);
        blows += due_n > 0.01f;
        felt += due_n > 0.01f && fixture.force.force_n.y < -weight_n() - 0.5f * due_n &&
                fixture.force.slap > 0.0f;
    }
    assert_true(blows >= 6);
    assert_int_equal(felt, blows);
    assert_float_equal(fixture.poi.carried_kg, fish_mass_kg(0.05f), 1e-6f);
}

/* ---- Floor and walls ------------------------------------------------------------------------ */

static void test_the_floor_pushes_back_at_the_edge_that_touches(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    fixture_move(&fixture, v3(0.0f, -0.07f, 0.0f), 0.2f);
    /* This target is 1 cm below the lowest possible position of the ring, so the ring rests on the
     * floor. */
    fixture.hand.position_m.y = -0.155f;
    fixture_wait(&fixture, 1.0f);
    assert_true(fixture.force.force_n.y > 1.0f);
    assert_true(fixture.force.force_n.y < 3.0f);
    /* The force must be limited, even if the target is far below the floor. */
    fixture.hand.position_m.y = -3.0f;
    fixture_wait(&fixture, 0.5f);
    assert_float_equal(fixture.force.force_n.y, POI_FORCE_N_MAX, 0.5f);
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    fixture_move(&fixture, v3(0.0f, -0.07f, 0.0f), 0.2f);
    /* Rolls the poi, so that only its right side touches the floor. */
    fixture_turn(&fixture, 0.0f, 0.5f, 0.3f);
    fixture.hand.position_m.y = -0.150f;
    fixture_wait(&fixture, 1.0f);
    /* The floor pushes the right side of the ring upward, which is a positive torque about z. */
    assert_true(fixture.force.torque_n_m.z > 0.02f);
}

static void test_a_wall_pushes_back(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(0.0f, -0.07f, 0.0f), 0.2f);
    fixture_move(&fixture, v3(0.43f, -0.07f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.5f);
    /* The wall stops the ring 26 mm before the target. The virtual spring between ring and target
     * then pulls with 5.7 N. */
    assert_true(fixture.force.force_n.x < -2.0f);
    assert_true(fixture.force.force_n.x > -7.0f);
}

/* ---- Tears, the limit of the force, and reported slaps -------------------------------------- */

static void test_a_tear_changes_the_force_in_the_same_tick(void **state)
{
    (void)state;
    fixture_init(&fixture, 7, 1);
    fixture_dip(&fixture);
    uint32_t torn = 0, felt = 0;
    for (uint32_t tick = 0; tick < 60; tick++) {
        fixture.hand.position_m.y += 1.2f * CORE_TICK_S;
        fixture_tick(&fixture);
        const float share = f_min(1.0f, (float)fixture.poi.strain.cells_torn / 10.0f);
        assert_float_equal(fixture.force.tear, share, 1e-6f);
        torn += fixture.poi.strain.cells_torn > 0;
        felt += fixture.force.tear > 0.0f;
    }
    assert_true(torn > 0);
    assert_int_equal(felt, torn);
}

static float drawn(uint32_t step, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 5, step, which, RNG_TEST }, low, high);
}

static void test_the_force_is_bounded_for_any_hand_motion(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    for (uint32_t step = 0; step < 3000; step++) {
        fixture.hand.position_m = v3(drawn(step, 0, -2.0f, 2.0f), drawn(step, 1, -1.0f, 0.5f),
                                     drawn(step, 2, -2.0f, 2.0f));
        fixture.hand.angles.pitch_rad = drawn(step, 3, -3.0f, 3.0f);
        fixture.hand.angles.roll_rad = drawn(step, 4, -3.0f, 3.0f);
        fixture_tick(&fixture);
        const vec3 f = fixture.force.force_n, t = fixture.force.torque_n_m;
        assert_true(v3_is_finite(f) && v3_is_finite(t));
        assert_true(f_max(f_abs(f.x), f_max(f_abs(f.y), f_abs(f.z))) <= POI_FORCE_N_MAX);
        assert_true(f_max(f_abs(t.x), f_max(f_abs(t.y), f_abs(t.z))) <= POI_TORQUE_N_M_MAX);
        assert_true(fixture.force.drag >= 0.0f && fixture.force.drag <= 1.0f);
    }
}

/* A frame has two ticks, but the controller gets one output per frame. This output must contain the
 * stronger of the two slaps. */
static void test_a_frame_reports_the_strongest_slap_of_its_ticks(void **state)
{
    (void)state;
    const struct poi_force calm = { .force_n = { 0, -0.07f, 0 }, .drag = 0.2f };
    const struct poi_force blow = { .force_n = { 0, -0.16f, 0 }, .slap = 0.6f, .tear = 0.1f };
    struct poi_force first = { 0 }, last = { 0 }, none = { 0 };
    output_merge_force(&first, &blow);
    output_merge_force(&first, &calm);
    output_merge_force(&last, &calm);
    output_merge_force(&last, &blow);
    output_merge_force(&none, &calm);
    output_merge_force(&none, &calm);
    assert_memory_equal(&first, &last, sizeof first);
    assert_float_equal(first.force_n.y, -0.16f, 0.0f);
    assert_float_equal(first.slap, 0.6f, 0.0f);
    assert_float_equal(first.tear, 0.1f, 0.0f);
    assert_float_equal(first.drag, 0.2f, 0.0f);
    assert_memory_equal(&none, &calm, sizeof none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_force_of_a_still_poi_in_air_is_its_weight_with_water),
        cmocka_unit_test(test_the_drag_on_the_paper_opposes_a_pull_through_water),
        cmocka_unit_test(test_an_acceleration_under_water_adds_the_force_of_the_added_mass),
        cmocka_unit_test(test_water_opposes_a_turning_wrist_and_loads_the_paper),
        cmocka_unit_test(test_a_tail_slap_gives_a_force_of_the_same_duration_and_strength),
        cmocka_unit_test(test_a_carried_fish_adds_its_weight_and_its_slaps_to_the_force),
        cmocka_unit_test(test_the_floor_pushes_back_at_the_edge_that_touches),
        cmocka_unit_test(test_a_wall_pushes_back),
        cmocka_unit_test(test_a_tear_changes_the_force_in_the_same_tick),
        cmocka_unit_test(test_the_force_is_bounded_for_any_hand_motion),
        cmocka_unit_test(test_a_frame_reports_the_strongest_slap_of_its_ticks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
