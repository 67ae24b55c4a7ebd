/* test_haptics.c -- what the hand feels of water, weight, fish, floor and tears. */
#include "tests/unit/support/poi_stand.h"

#include "core/base/rng.h"

#define POI_AREA_M2 (F_PI * POI_RADIUS_M * POI_RADIUS_M)

static struct stand stand; /* Too large for some stacks. */

static float weight_n(void)
{
    return (POI_MASS_KG + stand.poi.water_kg + stand.poi.carried_kg) * GRAVITY_M_S2;
}

static void test_a_poi_held_still_in_air_weighs_ring_and_water(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand_wait(&stand, 1.0f);
    assert_float_equal(stand.force.force_n.y, -POI_MASS_KG * GRAVITY_M_S2, 1e-4f);
    stand_dip(&stand);
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.2f);
    stand_wait(&stand, 0.3f);
    assert_true(stand.poi.water_kg > 0.003f);
    assert_float_equal(stand.force.force_n.y, -weight_n(), 0.002f);
    assert_float_equal(stand.force.force_n.x, 0.0f, 1e-4f);
    assert_float_equal(stand.force.torque_n_m.x, -0.130f * weight_n(), 0.0003f);
}

static void test_a_pull_through_water_is_opposed_by_the_drag_on_the_paper(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; i++) {
        const float course = F_TAU * (float)i / 8.0f, speed_m_s = i % 2u ? 0.3f : 0.2f;
        const vec3 way = v3(f_cos(course), 0.0f, f_sin(course));
        stand_init(&stand, 4, 1);
        stand.tank.size_m = v3(4.0f, 0.5f, 4.0f);
        stand.hand.position_m = stand.poi.position_m = v3_muladd(v3(0, -0.2f, 0), way, -0.5f);
        stand.hand.angles = (struct angles){ .yaw_rad = -course, .roll_rad = 0.5f * F_PI };
        stand_wait(&stand, 0.5f);
        stand_move(&stand, v3_muladd(v3(0.0f, -0.2f, 0.0f), way, 0.2f), speed_m_s);
        const float drag_n = 0.5f * WATER_KG_M3 * 1.17f * POI_AREA_M2 * speed_m_s * speed_m_s;
        assert_float_equal(v3_dot(stand.force.force_n, way), -drag_n, 0.1f * drag_n);
        assert_float_equal(stand.force.drag, drag_n / POI_DRAG_N_FULL, 0.02f);
        assert_float_equal(stand.force.slap + stand.force.tear, 0.0f, 0.0f);
    }
}

/* 0.171 kg of water starts with the disc: 0.34 N at 2 m/s^2, before there is any drag. */
static void test_a_start_under_water_is_felt_as_the_waters_mass(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.tank.size_m = v3(4.0f, 0.5f, 1.0f);
    stand.hand.position_m = stand.poi.position_m = v3(0.0f, -0.2f, 0.0f);
    stand.hand.angles.roll_rad = stand.poi.angles.roll_rad = 0.5f * F_PI;
    stand_wait(&stand, 0.5f);
    float most_n = 0.0f;
    for (uint32_t tick = 1; tick <= 12; tick++) { /* To 0.2 m/s in a tenth of a second. */
        const float t = (float)tick * CORE_TICK_S;
        stand.hand.position_m.x = t * t;
        stand_tick(&stand);
        most_n = f_max(most_n, -stand.force.force_n.x);
    }
    const float drag_n = stand.poi.drag_n_s_m * stand.poi.velocity_m_s.x;
    assert_true(most_n - drag_n > 0.15f);
    assert_true(most_n - drag_n < 0.36f);
}

/* A turn about the handle, under water, and the same in air. */
static float turn_torque_n_m(float height_m)
{
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    stand.hand.position_m = stand.poi.position_m = v3(0.0f, height_m, 0.0f);
    stand_wait(&stand, 0.5f);
    for (uint32_t tick = 0; tick < 12; tick++) {
        stand.hand.angles.roll_rad += 10.0f * CORE_TICK_S;
        stand_tick(&stand);
    }
    return stand.force.torque_n_m.z;
}

/* (1/2) rho 1.17 (8/15) a^5 omega^2 = 3.2 mN m at 10 rad/s. Positive roll turns about -z. */
static void test_water_holds_a_turning_wrist_back_and_loads_the_paper(void **state)
{
    (void)state;
    assert_float_equal(turn_torque_n_m(0.10f), 0.0f, 1e-4f);
    assert_float_equal(stand.poi.pressure_pa, 0.0f, 10.0f);
    assert_float_equal(turn_torque_n_m(-0.075f), 0.0032f, 0.0005f);
    assert_float_equal(f_abs(stand.poi.pressure_pa), 23.4f, 3.0f);
}

/* ---- Fish ----------------------------------------------------------------------------------- */

/* A tick with a blow at a place of the paper, as catch_tick() would have gathered it. */
static void tick_with_blow(float x_m, float z_m, float force_n)
{
    const struct poi_grip grip = { stand.hand, 1 };
    stand.poi.loads[0] = (struct sheet_load){ x_m, z_m, 0.003f, -force_n };
    stand.poi.load_count = stand.poi.slap_count = force_n > 0.0f;
    poi_tick(&stand.poi, &grip, &stand.tank, &stand.bowl);
    const struct obstacle ring = poi_obstacle(&stand.poi);
    poi_apply_reaction(&stand.poi, &ring);
    poi_haptics(&stand.poi, &stand.force);
}

static void test_a_blow_of_a_tail_is_a_kick_as_long_and_as_hard_as_it_is(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_wait(&stand, 1.0f);
    const struct poi_force rest = stand.force;
    for (uint32_t tick = 0; tick < 3; tick++) {
        tick_with_blow(0.03f, 0.02f, 0.09f);
        assert_float_equal(stand.force.force_n.y - rest.force_n.y, -0.09f, 0.02f);
        assert_float_equal(stand.force.slap, 0.6f, 1e-5f);
    }
    /* To the right of the handle it rolls the hand to the right, nearer to it it tips it less. */
    assert_float_equal(stand.force.torque_n_m.z, -0.03f * 0.09f, 2e-4f);
    assert_float_equal(stand.force.torque_n_m.x - rest.torque_n_m.x, -0.110f * 0.09f, 0.002f);
    tick_with_blow(0.0f, 0.0f, 0.0f);
    tick_with_blow(0.0f, 0.0f, 0.0f);
    assert_float_equal(stand.force.force_n.y, rest.force_n.y, 0.02f);
    assert_float_equal(stand.force.slap, 0.0f, 0.0f);
}

/* A fish is scooped, and slaps; the blow that a tick's catch gathers is felt in the next. */
static void test_a_real_fish_on_the_paper_is_weighed_and_felt_to_slap(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand_fish(&stand, v3(0.0f, stand.poi.position_m.y + 0.03f, 0.0f), 0.05f);
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.08f);
    stand_wait(&stand, 0.15f); /* The hand has come to rest. */
    assert_int_equal(stand.poi.carried_count, 1);
    uint32_t blows = 0, felt = 0;
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ && stand.poi.carried_count; tick++) {
        const float due_n = stand.poi.slap_count ? -stand.poi.loads[0].force_n : 0.0f;
        stand_tick(&stand);
        blows += due_n > 0.01f;
        felt += due_n > 0.01f && stand.force.force_n.y < -weight_n() - 0.5f * due_n &&
                stand.force.slap > 0.0f;
    }
    assert_true(blows >= 6);
    assert_int_equal(felt, blows);
    assert_float_equal(stand.poi.carried_kg, fish_mass_kg(0.05f), 1e-6f);
}

/* ---- What holds it up ----------------------------------------------------------------------- */

static void test_the_floor_pushes_back_as_the_hand_presses_at_the_edge_that_touches(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    stand_move(&stand, v3(0.0f, -0.07f, 0.0f), 0.2f);
    stand.hand.position_m.y = -0.155f; /* A centimetre too deep. */
    stand_wait(&stand, 1.0f);
    assert_true(stand.force.force_n.y > 1.0f);
    assert_true(stand.force.force_n.y < 3.0f);
    stand.hand.position_m.y = -3.0f; /* Nobody presses harder. */
    stand_wait(&stand, 0.5f);
    assert_float_equal(stand.force.force_n.y, POI_FORCE_N_MAX, 0.5f);
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    stand_move(&stand, v3(0.0f, -0.07f, 0.0f), 0.2f);
    stand_turn(&stand, 0.0f, 0.5f, 0.3f); /* Its right side down. */
    stand.hand.position_m.y = -0.150f;
    stand_wait(&stand, 1.0f);
    assert_true(stand.force.torque_n_m.z > 0.02f); /* Pushed up there, it rolls to the left. */
}

static void test_a_wall_pushes_back(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_move(&stand, v3(0.0f, -0.07f, 0.0f), 0.2f);
    stand_move(&stand, v3(0.43f, -0.07f, 0.0f), 0.2f);
    stand_wait(&stand, 0.5f);
    assert_true(stand.force.force_n.x < -2.0f); /* 26 mm of spring: 5.7 N. */
    assert_true(stand.force.force_n.x > -7.0f);
}

/* ---- The paper ------------------------------------------------------------------------------ */

static void test_a_tear_is_felt_in_its_tick(void **state)
{
    (void)state;
    stand_init(&stand, 7, 1);
    stand_dip(&stand);
    uint32_t torn = 0, felt = 0;
    for (uint32_t tick = 0; tick < 60; tick++) {
        stand.hand.position_m.y += 1.2f * CORE_TICK_S;
        stand_tick(&stand);
        const float share = f_min(1.0f, (float)stand.poi.strain.cells_torn / 10.0f);
        assert_float_equal(stand.force.tear, share, 1e-6f);
        torn += stand.poi.strain.cells_torn > 0;
        felt += stand.force.tear > 0.0f;
    }
    assert_true(torn > 0);
    assert_int_equal(felt, torn);
}

static float drawn(uint32_t step, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 5, step, which, RNG_TEST }, low, high);
}

static void test_however_wild_the_hand_what_it_feels_is_bounded(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    for (uint32_t step = 0; step < 3000; step++) {
        stand.hand.position_m = v3(drawn(step, 0, -2.0f, 2.0f), drawn(step, 1, -1.0f, 0.5f),
                                   drawn(step, 2, -2.0f, 2.0f));
        stand.hand.angles.pitch_rad = drawn(step, 3, -3.0f, 3.0f);
        stand.hand.angles.roll_rad = drawn(step, 4, -3.0f, 3.0f);
        stand_tick(&stand);
        const vec3 f = stand.force.force_n, t = stand.force.torque_n_m;
        assert_true(v3_is_finite(f) && v3_is_finite(t));
        assert_true(f_max(f_abs(f.x), f_max(f_abs(f.y), f_abs(f.z))) <= POI_FORCE_N_MAX);
        assert_true(f_max(f_abs(t.x), f_max(f_abs(t.y), f_abs(t.z))) <= POI_TORQUE_N_M_MAX);
        assert_true(stand.force.drag >= 0.0f && stand.force.drag <= 1.0f);
    }
}

/* Two ticks a frame: the device is told of the harder blow, whichever tick it was in. */
static void test_a_frame_keeps_the_hardest_blow_of_its_ticks(void **state)
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
        cmocka_unit_test(test_a_poi_held_still_in_air_weighs_ring_and_water),
        cmocka_unit_test(test_a_pull_through_water_is_opposed_by_the_drag_on_the_paper),
        cmocka_unit_test(test_a_start_under_water_is_felt_as_the_waters_mass),
        cmocka_unit_test(test_water_holds_a_turning_wrist_back_and_loads_the_paper),
        cmocka_unit_test(test_a_blow_of_a_tail_is_a_kick_as_long_and_as_hard_as_it_is),
        cmocka_unit_test(test_a_real_fish_on_the_paper_is_weighed_and_felt_to_slap),
        cmocka_unit_test(test_the_floor_pushes_back_as_the_hand_presses_at_the_edge_that_touches),
        cmocka_unit_test(test_a_wall_pushes_back),
        cmocka_unit_test(test_a_tear_is_felt_in_its_tick),
        cmocka_unit_test(test_however_wild_the_hand_what_it_feels_is_bounded),
        cmocka_unit_test(test_a_frame_keeps_the_hardest_blow_of_its_ticks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
