/* test_carried_water.c -- water out of the tank: how much, how it goes, and that it comes from
 * nowhere. */
#include "tests/unit/support/poi_stand.h"

#include "core/base/rng.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/ring.h"

static struct stand stand; /* Too large for some stacks. */

/* Out of the water as it is turned, slowly, and held there for `seconds`. */
static void lift_out(float pitch_rad, float speed_m_s, float seconds)
{
    stand_dip(&stand);
    stand.has_wrist = 1;
    stand_turn(&stand, pitch_rad, 0.0f, 1.0f);
    stand_move(&stand, v3(0.0f, 0.07f, 0.0f), speed_m_s);
    stand_wait(&stand, seconds);
}

static void test_a_level_poi_carries_a_film_and_what_lies_in_its_belly(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    lift_out(0.0f, 0.15f, 0.3f);
    assert_float_equal(stand.poi.film_kg, 0.003f, 0.0005f); /* 0.3 mm on each face. */
    const float belly_kg = 0.5f * F_PI * 0.04f * 0.04f * stand.poi.sheet.sag_m * WATER_KG_M3;
    assert_true(stand.poi.pool_kg > 0.9f * belly_kg);
    assert_true(stand.poi.pool_kg > 0.002f);
    assert_true(stand.poi.pool_kg < 0.005f);
    assert_float_equal(carried_water_m(&stand.poi),
                       stand.poi.water_kg / (WATER_KG_M3 * F_PI * 0.04f * 0.04f), 1e-6f);
}

static void test_a_tilted_one_drains_in_0_15_s_over_the_sine(void **state)
{
    (void)state;
    const float tilts_rad[] = { 0.3f, 0.5f, 0.8f };
    for (uint32_t i = 0; i < 3; i++) {
        stand_init(&stand, 6, 1);
        stand.poi.angles.pitch_rad = stand.hand.angles.pitch_rad = tilts_rad[i];
        stand.poi.pool_kg = 0.005f; /* As if it had come so, in air. */
        const float tau_s = 0.15f / f_sin(tilts_rad[i]);
        for (float s = 0.0f; s < tau_s; s += CORE_TICK_S) {
            carried_water_tick(&stand.poi, f_cos(tilts_rad[i]));
        }
        assert_float_equal(stand.poi.pool_kg, 0.005f * 0.368f, 0.0003f);
    }
}

static void test_upside_down_the_ring_holds_15_g_and_spills_them_when_it_turns(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    lift_out(F_PI, 0.08f, 0.3f);
    assert_true(vec_basis_from_angles(stand.poi.angles).up.y < -0.999f);
    assert_float_equal(stand.poi.water_kg, 0.0155f, 0.0015f);
    assert_true(sheet_left(&stand.poi.sheet) == 1.0f);
    assert_float_equal(stand.force.force_n.y, -(POI_MASS_KG + stand.poi.water_kg) * GRAVITY_M_S2,
                       0.01f);
    assert_true(stand.poi.pressure_pa > 25.0f); /* Through the paper, out of its front. */
    stand_turn(&stand, F_PI - 1.0f, 0.0f, 0.2f);
    stand_wait(&stand, 0.5f);
    assert_true(stand.poi.water_kg < 0.003f);
}

/* Any hand, any turns: in air it can only lose. */
static void test_water_comes_out_of_the_tank_alone(void **state)
{
    (void)state;
    uint32_t dry_ticks = 0;
    for (uint32_t seed = 0; seed < 6; seed++) {
        stand_init(&stand, 4, seed);
        stand.has_wrist = 1;
        assert_float_equal(stand.poi.water_kg, 0.0f, 0.0f);
        for (uint32_t tick = 0; tick < 2400; tick++) {
            const struct rng_key key = { seed, tick / 40u, 0, RNG_TEST };
            const struct rng_key turn = { seed, tick / 40u, 1, RNG_TEST };
            const float goal_m = rng_range(key, -0.08f, 0.12f) - stand.hand.position_m.y;
            stand.hand.position_m.y += f_clamp(goal_m, -0.003f, 0.003f);
            stand.hand.angles.pitch_rad = rng_range(turn, -3.1f, 3.1f);
            const float before_kg = stand.poi.water_kg;
            stand_tick(&stand);
            assert_true(stand.poi.water_kg >= 0.0f && stand.poi.water_kg < 0.025f);
            if (stand.poi.immersed <= 0.0f) {
                assert_true(stand.poi.water_kg <= before_kg);
                dry_ticks++;
            }
        }
    }
    assert_true(dry_ticks > 3000);
}

static void test_a_torn_poi_loses_it_through_its_holes(void **state)
{
    (void)state;
    float left_kg[2];
    for (uint32_t i = 0; i < 2; i++) {
        stand_init(&stand, 6, 1);
        lift_out(0.0f, 0.15f, 0.2f);
        for (uint32_t cell = 0; i == 1 && cell < SHEET_CELL_COUNT / 2u; cell++) {
            if (stand.poi.sheet.state[cell] == CELL_PAPER) {
                stand.poi.sheet.state[cell] = CELL_HOLE;
                stand.poi.sheet.paper_cells--;
            }
        }
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            carried_water_tick(&stand.poi, 1.0f);
        }
        left_kg[i] = stand.poi.pool_kg;
    }
    assert_true(left_kg[1] < 0.05f * left_kg[0]);
}

/* ---- The meniscus --------------------------------------------------------------------------- */

/* The most that the surface pulls while the ring leaves with a tilt. */
static float most_meniscus_n(float pitch_rad, float *hand_n)
{
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand.has_wrist = 1;
    stand_turn(&stand, pitch_rad, 0.0f, 1.0f);
    const uint32_t ticks = 480;
    float most_n = 0.0f;
    *hand_n = 0.0f;
    for (uint32_t tick = 0; tick < ticks; tick++) {
        stand.hand.position_m.y += 0.0003f; /* 36 mm/s. */
        stand_tick(&stand);
        const float weight_n =
            (POI_MASS_KG + stand.poi.water_kg) * GRAVITY_M_S2 * (1.0f - stand.poi.immersed);
        if (stand.poi.meniscus_n > most_n) {
            most_n = stand.poi.meniscus_n;
            *hand_n = -stand.force.force_n.y - weight_n;
        }
    }
    assert_true(stand.poi.position_m.y > 0.05f);
    assert_float_equal(stand.poi.meniscus_n, 0.0f, 0.0f); /* It has let go. */
    return most_n;
}

static void test_the_surface_clings_to_a_level_ring_and_hardly_to_a_slanted_one(void **state)
{
    (void)state;
    float level_n, slanted_n;
    const float level = most_meniscus_n(0.0f, &level_n);
    const float slanted = most_meniscus_n(0.6f, &slanted_n);
    assert_float_equal(level, 2.0f * F_TAU * 0.04f * 0.072f, 1e-4f); /* 18 mN a face. */
    assert_true(slanted < 0.35f * level);
    assert_float_equal(level_n, level, 0.4f * level);
    assert_true(slanted_n < level_n);
}

static void test_a_ring_that_was_never_in_has_nothing_clinging_to_it(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.hand.position_m.y = stand.poi.position_m.y = 0.006f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        stand_tick(&stand);
        assert_float_equal(stand.poi.meniscus_n, 0.0f, 0.0f);
    }
    assert_int_equal(stand.poi.dips, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_level_poi_carries_a_film_and_what_lies_in_its_belly),
        cmocka_unit_test(test_a_tilted_one_drains_in_0_15_s_over_the_sine),
        cmocka_unit_test(test_upside_down_the_ring_holds_15_g_and_spills_them_when_it_turns),
        cmocka_unit_test(test_water_comes_out_of_the_tank_alone),
        cmocka_unit_test(test_a_torn_poi_loses_it_through_its_holes),
        cmocka_unit_test(test_the_surface_clings_to_a_level_ring_and_hardly_to_a_slanted_one),
        cmocka_unit_test(test_a_ring_that_was_never_in_has_nothing_clinging_to_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
