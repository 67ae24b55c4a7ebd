/* test_sweep.c -- checks that no contact between two ticks is missed, even with the fastest motion
 * of a player. At 4 m/s the ring moves by 33 mm per tick, which is more than the thickness of a
 * fish and ten times the thickness of the ring. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"
#include "core/poi/pose.h"

#define HAND_M_S 4.0f

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

static float drawn(uint32_t trial, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 17, trial, which, RNG_TEST }, low, high);
}

/* Starts the ring at `start_m` with the speed `velocity_m_s`, as if it had already followed the
 * player's target for some time. */
static void swing_from(vec3 start_m, struct angles angles, vec3 velocity_m_s)
{
    struct poi *poi = &fixture.poi;
    fixture.has_wrist = 1;
    fixture.hand = (struct poi_target){ start_m, angles };
    poi->position_m = poi->before_m = poi->hand_m = start_m;
    poi->angles = poi->before_angles = angles;
    poi->velocity_m_s = poi->before_m_s = velocity_m_s;
    poi->pace_m_s = v3_length(velocity_m_s);
    const vec3 up = vec_basis_from_angles(angles).up;
    poi->immersed = disc_immersed(POI_RADIUS_M, start_m.y, up.y);
}

static void swing_on(vec3 velocity_m_s)
{
    fixture.hand.position_m = v3_muladd(fixture.hand.position_m, velocity_m_s, CORE_TICK_S);
    fixture_tick(&fixture);
}

/* ---- Sweeps through the water surface ------------------------------------------------------- */

static void test_a_plunge_at_4_m_s_counts_as_a_dip_and_pushes_back(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 40; i++) {
        fixture_init(&fixture, 4, i);
        const vec3 down_m_s = v3(0.0f, -HAND_M_S, 0.0f);
        float slam_n = 0.0f, felt_n = 0.0f;
        swing_from(v3(0.0f, 0.05f + 0.001f * (float)i, 0.0f), (struct angles){ 0 }, down_m_s);
        for (uint32_t tick = 0; tick < 6; tick++) {
            swing_on(down_m_s);
            slam_n = f_max(slam_n, fixture.poi.slam_n);
            felt_n = f_max(felt_n, fixture.force.force_n.y);
        }
        fixture_wait(&fixture, 0.3f);
        assert_int_equal(fixture.poi.dips, 1);
        /* In this tick the disc accelerates 0.1 kg of water to 4 m/s, which would need tens of
         * newtons. The simulated force must be at least 5 N. */
        assert_true(slam_n > 5.0f);
        assert_true(felt_n > 5.0f);
        assert_true(fixture.poi.water_kg > 0.001f);
    }
}

/* The poi is in the water for less than 50 ms. Different start heights shift the dip relative to
 * the ticks. Each dip that is deeper than 6 mm must be counted and must wet the paper. */
static void test_a_50_ms_movement_through_the_surface_counts_as_a_dip(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 33; i++) {
        fixture_init(&fixture, 4, i);
        const vec3 down_m_s = v3(0.0f, -HAND_M_S, 0.0f);
        swing_from(v3(0.0f, 0.03f + 0.001f * (float)i, 0.0f), (struct angles){ 0 }, down_m_s);
        float lowest_m = 1.0f;
        for (uint32_t tick = 0; tick < 4; tick++) {
            swing_on(down_m_s);
            lowest_m = f_min(lowest_m, fixture.poi.position_m.y);
        }
        for (uint32_t tick = 0; tick < 30; tick++) {
            fixture.hand.position_m.y = f_min(0.08f, fixture.hand.position_m.y + 0.033f);
            fixture_tick(&fixture);
            lowest_m = f_min(lowest_m, fixture.poi.position_m.y);
        }
        assert_int_equal(fixture.poi.dips, lowest_m < -0.006f ? 1 : 0);
        assert_int_equal(fixture.poi.sheet.touched, lowest_m < -0.006f);
        assert_true(fixture.poi.position_m.y > 0.03f);
    }
}

/* ---- Sweeps onto fish ----------------------------------------------------------------------- */

static vec3 from_poi(uint32_t fish)
{
    const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
    return vec_basis_to_body(&axes,
                             v3_sub(fixture.tank.fish[fish].position_m, fixture.poi.position_m));
}

/* Returns 1 if a fish passed through the paper on its way from `before` to `after`, which are
 * positions in the poi's axes. A fish that lies on the sagging paper, less than 4 mm below the
 * ring, did not pass. */
static int passed_through_paper(vec3 before, vec3 after)
{
    if (before.y * after.y >= 0.0f || f_abs(after.y) < 0.004f) {
        return 0;
    }
    const vec3 at = v3_lerp(before, after, before.y / (before.y - after.y));
    return at.x * at.x + at.z * at.z < 0.9f * POI_RADIUS_M * POI_RADIUS_M;
}

/* Sweeps the poi once through three fish. Returns how many of the fish were moved by at least 1
 * mm. */
static uint32_t swing_at_fish(uint32_t trial, vec3 velocity_m_s, struct angles angles,
                              vec3 turn_rad_s)
{
    const vec3 start_m = v3(-0.20f * velocity_m_s.x / HAND_M_S,
                            f_clamp(-0.07f - 0.20f * velocity_m_s.y / HAND_M_S, -0.13f, 0.10f),
                            -0.20f * velocity_m_s.z / HAND_M_S);
    fixture_init(&fixture, 4, trial);
    for (uint32_t i = 0; i < 3; i++) {
        const vec3 place = v3(0.07f * ((float)i - 1.0f), -0.07f + drawn(trial, 20 + i, 0, 0.02f),
                              drawn(trial, 10 + i, -0.02f, 0.02f));
        const uint32_t fish = fixture_add_fish(&fixture, place, 0.05f);
        fixture.tank.fish[fish].angles.yaw_rad = drawn(trial, 30 + i, -3.0f, 3.0f);
    }
    vec3 began[3];
    /* Makes the paper indestructible, because fish could pass through a hole. */
    fixture.poi.damage_immune = 1;
    swing_from(start_m, angles, velocity_m_s);
    for (uint32_t i = 0; i < 3; i++) {
        began[i] = fixture.tank.fish[i].position_m;
    }
    for (uint32_t tick = 0; tick < 40; tick++) {
        vec3 before[3];
        for (uint32_t i = 0; i < 3; i++) {
            before[i] = from_poi(i);
        }
        fixture.hand.angles.yaw_rad += turn_rad_s.x * CORE_TICK_S;
        fixture.hand.angles.pitch_rad += turn_rad_s.y * CORE_TICK_S;
        fixture.hand.angles.roll_rad += turn_rad_s.z * CORE_TICK_S;
        swing_on(velocity_m_s);
        for (uint32_t i = 0; i < 3; i++) {
            assert_false(passed_through_paper(before[i], from_poi(i)));
        }
    }
    uint32_t met = 0;
    for (uint32_t i = 0; i < 3; i++) {
        met += v3_length(v3_sub(fixture.tank.fish[i].position_m, began[i])) > 0.001f;
    }
    return met;
}

static void test_a_broadside_sweep_at_4_m_s_pushes_the_fish_and_passes_none(void **state)
{
    (void)state;
    for (uint32_t trial = 0; trial < 40; trial++) {
        const struct angles upright = { .roll_rad = 0.5f * F_PI };
        const uint32_t met = swing_at_fish(trial, v3(HAND_M_S, 0.0f, 0.0f), upright, v3(0, 0, 0));
        assert_int_equal(met, 3);
    }
}

static void test_a_fast_ring_from_any_direction_lets_no_fish_through_its_paper(void **state)
{
    (void)state;
    uint32_t met = 0;
    for (uint32_t trial = 0; trial < 300; trial++) {
        const vec3 way = v3_normalize_or(
            v3(drawn(trial, 0, -1, 1), drawn(trial, 1, -1, 1), drawn(trial, 2, -1, 1)),
            v3(1.0f, 0.0f, 0.0f));
        const struct angles angles = { drawn(trial, 3, -3, 3), drawn(trial, 4, -1.5f, 1.5f),
                                       drawn(trial, 5, -1.5f, 1.5f) };
        const vec3 turn_rad_s = v3(0.0f, drawn(trial, 6, -25, 25), drawn(trial, 7, -25, 25));
        met += swing_at_fish(trial, v3_scale(way, HAND_M_S), angles, turn_rad_s);
    }
    assert_true(met > 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_plunge_at_4_m_s_counts_as_a_dip_and_pushes_back),
        cmocka_unit_test(test_a_50_ms_movement_through_the_surface_counts_as_a_dip),
        cmocka_unit_test(test_a_broadside_sweep_at_4_m_s_pushes_the_fish_and_passes_none),
        cmocka_unit_test(test_a_fast_ring_from_any_direction_lets_no_fish_through_its_paper),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
