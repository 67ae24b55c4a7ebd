/* test_carried_water.c -- checks the water that a poi lifts out of the tank: the amount of water,
 * how it drains, and that no water is created. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/ring.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

/* Dips the poi, turns it to the pitch `pitch_rad`, lifts it slowly out of the water, and holds it
 * in the air for `seconds` seconds. */
static void lift_out(float pitch_rad, float speed_m_s, float seconds)
{
    fixture_dip(&fixture);
    fixture.has_wrist = 1;
    fixture_turn(&fixture, pitch_rad, 0.0f, 1.0f);
    fixture_move(&fixture, v3(0.0f, 0.07f, 0.0f), speed_m_s);
    fixture_wait(&fixture, seconds);
}

static void test_a_level_poi_carries_a_film_and_a_pool(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    lift_out(0.0f, 0.15f, 0.3f);
    /* The film of water is 0.3 mm thick on both faces of the paper (50 cm^2 each). The film weighs
     * 3 g. */
    assert_float_equal(fixture.poi.film_kg, 0.003f, 0.0005f);
    const float belly_kg = 0.5f * F_PI * 0.04f * 0.04f * fixture.poi.sheet.sag_m * WATER_KG_M3;
    assert_true(fixture.poi.pool_kg > 0.9f * belly_kg);
    assert_true(fixture.poi.pool_kg > 0.002f);
    assert_true(fixture.poi.pool_kg < 0.005f);
    assert_float_equal(carried_water_m(&fixture.poi),
                       fixture.poi.water_kg / (WATER_KG_M3 * F_PI * 0.04f * 0.04f), 1e-6f);
}

static void test_a_tilted_poi_drains_in_0_15_s_over_the_sine(void **state)
{
    (void)state;
    const float tilts_rad[] = { 0.3f, 0.5f, 0.8f };
    for (uint32_t i = 0; i < 3; i++) {
        fixture_init(&fixture, 6, 1);
        fixture.poi.angles.pitch_rad = fixture.hand.angles.pitch_rad = tilts_rad[i];
        /* Puts 5 g of water on the paper, as after a lift. After the time constant `tau_s`, 1/e
         * (36.8 %) of the water must be left. */
        fixture.poi.pool_kg = 0.005f;
        const float tau_s = 0.15f / f_sin(tilts_rad[i]);
        for (float s = 0.0f; s < tau_s; s += CORE_TICK_S) {
            carried_water_tick(&fixture.poi, f_cos(tilts_rad[i]));
        }
        assert_float_equal(fixture.poi.pool_kg, 0.005f * 0.368f, 0.0003f);
    }
}

static void test_an_inverted_ring_holds_15_g_and_spills_them_when_it_turns(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    lift_out(F_PI, 0.08f, 0.3f);
    assert_true(vec_basis_from_angles(fixture.poi.angles).up.y < -0.999f);
    assert_float_equal(fixture.poi.water_kg, 0.0155f, 0.0015f);
    assert_true(sheet_left(&fixture.poi.sheet) == 1.0f);
    assert_float_equal(fixture.force.force_n.y,
                       -(POI_MASS_KG + fixture.poi.water_kg) * GRAVITY_M_S2, 0.01f);
    /* The poi is upside down and holds the water on the back of its paper. The weight of this water
     * presses on the paper. */
    assert_true(fixture.poi.pressure_pa > 25.0f);
    fixture_turn(&fixture, F_PI - 1.0f, 0.0f, 0.2f);
    fixture_wait(&fixture, 0.5f);
    assert_true(fixture.poi.water_kg < 0.003f);
}

/* Turns and moves the poi at random in air. The amount of water must never increase. */
static void test_a_poi_in_air_gains_no_water(void **state)
{
    (void)state;
    uint32_t dry_ticks = 0;
    for (uint32_t seed = 0; seed < 6; seed++) {
        fixture_init(&fixture, 4, seed);
        fixture.has_wrist = 1;
        assert_float_equal(fixture.poi.water_kg, 0.0f, 0.0f);
        for (uint32_t tick = 0; tick < 2400; tick++) {
            const struct rng_key key = { seed, tick / 40u, 0, RNG_TEST };
            const struct rng_key turn = { seed, tick / 40u, 1, RNG_TEST };
            const float goal_m = rng_range(key, -0.08f, 0.12f) - fixture.hand.position_m.y;
            fixture.hand.position_m.y += f_clamp(goal_m, -0.003f, 0.003f);
            fixture.hand.angles.pitch_rad = rng_range(turn, -3.1f, 3.1f);
            const float before_kg = fixture.poi.water_kg;
            fixture_tick(&fixture);
            assert_true(fixture.poi.water_kg >= 0.0f && fixture.poi.water_kg < 0.025f);
            if (fixture.poi.immersed <= 0.0f) {
                assert_true(fixture.poi.water_kg <= before_kg);
                dry_ticks++;
            }
        }
    }
    assert_true(dry_ticks > 3000);
}

static void test_a_torn_poi_loses_its_water_through_the_holes(void **state)
{
    (void)state;
    float left_kg[2];
    for (uint32_t i = 0; i < 2; i++) {
        fixture_init(&fixture, 6, 1);
        lift_out(0.0f, 0.15f, 0.2f);
        for (uint32_t cell = 0; i == 1 && cell < SHEET_CELL_COUNT / 2u; cell++) {
            if (fixture.poi.sheet.state[cell] == CELL_PAPER) {
                fixture.poi.sheet.state[cell] = CELL_HOLE;
                fixture.poi.sheet.paper_cells--;
            }
        }
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            carried_water_tick(&fixture.poi, 1.0f);
        }
        left_kg[i] = fixture.poi.pool_kg;
    }
    assert_true(left_kg[1] < 0.05f * left_kg[0]);
}

/* ---- The meniscus --------------------------------------------------------------------------- */

/* Lifts the ring, tilted by `pitch_rad`, out of the water. Returns the greatest pull of the
 * meniscus, which is the water that clings to the ring. */
static float most_meniscus_n(float pitch_rad, float *hand_n)
{
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    fixture.has_wrist = 1;
    fixture_turn(&fixture, pitch_rad, 0.0f, 1.0f);
    const uint32_t ticks = 480;
    float most_n = 0.0f;
    *hand_n = 0.0f;
    for (uint32_t tick = 0; tick < ticks; tick++) {
        /* Lifts the ring by 0.3 mm in this tick, which is 36 mm/s. */
        fixture.hand.position_m.y += 0.0003f;
        fixture_tick(&fixture);
        const float weight_n =
            (POI_MASS_KG + fixture.poi.water_kg) * GRAVITY_M_S2 * (1.0f - fixture.poi.immersed);
        if (fixture.poi.meniscus_n > most_n) {
            most_n = fixture.poi.meniscus_n;
            *hand_n = -fixture.force.force_n.y - weight_n;
        }
    }
    assert_true(fixture.poi.position_m.y > 0.05f);
    /* The ring is 5 cm above the water, so the meniscus has broken. */
    assert_float_equal(fixture.poi.meniscus_n, 0.0f, 0.0f);
    return most_n;
}

static void test_the_meniscus_pulls_a_level_ring_more_than_a_slanted_one(void **state)
{
    (void)state;
    float level_n, slanted_n;
    const float level = most_meniscus_n(0.0f, &level_n);
    const float slanted = most_meniscus_n(0.6f, &slanted_n);
    /* The meniscus has two faces, one inside and one outside the ring, which pull with 18 mN
     * each. */
    assert_float_equal(level, 2.0f * F_TAU * 0.04f * 0.072f, 1e-4f);
    assert_true(slanted < 0.35f * level);
    assert_float_equal(level_n, level, 0.4f * level);
    assert_true(slanted_n < level_n);
}

static void test_a_ring_that_was_never_in_water_has_no_meniscus(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.hand.position_m.y = fixture.poi.position_m.y = 0.006f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        fixture_tick(&fixture);
        assert_float_equal(fixture.poi.meniscus_n, 0.0f, 0.0f);
    }
    assert_int_equal(fixture.poi.dips, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_level_poi_carries_a_film_and_a_pool),
        cmocka_unit_test(test_a_tilted_poi_drains_in_0_15_s_over_the_sine),
        cmocka_unit_test(test_an_inverted_ring_holds_15_g_and_spills_them_when_it_turns),
        cmocka_unit_test(test_a_poi_in_air_gains_no_water),
        cmocka_unit_test(test_a_torn_poi_loses_its_water_through_the_holes),
        cmocka_unit_test(test_the_meniscus_pulls_a_level_ring_more_than_a_slanted_one),
        cmocka_unit_test(test_a_ring_that_was_never_in_water_has_no_meniscus),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
