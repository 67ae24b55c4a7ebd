/* test_flow.c -- checks the water flow around a moving disc. The flow must equal known solutions,
 * conserve volume, and move fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/base/simd.h"
#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/tank.h"
#include "core/tank/tank_fields.h"
#include "core/tank/water.h"
#include "tests/unit/support/pond.h"

#define RADIUS_M 0.0465f

/* Returns a horizontal disc that is deep under water. */
static struct obstacle disc(vec3 velocity_m_s)
{
    return (struct obstacle){ .kind = OBSTACLE_DISC,
                              .centre_m = { 0.0f, -1.0f, 0.0f },
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .velocity_m_s = velocity_m_s,
                              .radius_m = RADIUS_M };
}

static vec3 near_disc(float x, float y, float z)
{
    return v3(x * RADIUS_M, y * RADIUS_M - 1.0f, z * RADIUS_M);
}

static vec3 broadside_flow(float x, float y, float z)
{
    const struct obstacle moving = disc(v3(0.0f, 1.0f, 0.0f));
    return water_flow_m_s(&moving, near_disc(x, y, z));
}

static float drawn(uint32_t trial, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 3, trial, which, RNG_TEST }, low, high);
}

static void test_water_at_the_face_moves_with_the_disc(void **state)
{
    (void)state;
    assert_float_equal(broadside_flow(0.0f, 0.0f, 0.0f).y, 1.0f, 1e-4f);
    assert_float_equal(broadside_flow(0.2f, 0.001f, 0.1f).y, 1.0f, 0.02f);
    assert_float_equal(broadside_flow(0.2f, -0.001f, 0.1f).y, 1.0f, 0.02f);
}

/* On the axis of the disc, at the distance s in units of the radius, the flow must equal Lamb's
 * exact solution (2 / pi) (acot s - s / (1 + s^2)). */
static void test_the_flow_on_the_axis_equals_lambs_solution(void **state)
{
    (void)state;
    assert_float_equal(broadside_flow(0.0f, 1.0f, 0.0f).y, 0.1817f, 1e-3f);
    assert_float_equal(broadside_flow(0.0f, -2.0f, 0.0f).y, 0.0405f, 1e-3f);
    assert_float_equal(broadside_flow(0.0f, 1.0f, 0.0f).x, 0.0f, 1e-6f);
}

/* Far from a disc with the radius a, the flow must be that of a dipole. Let v be (8 / 3) a^3 / (4
 * pi r^3) at the distance r. The flow is then 2 v on the axis, in the direction of motion. In the
 * plane of the disc it is v, in the opposite direction. */
static void test_the_far_flow_is_the_dipole_of_the_added_mass(void **state)
{
    (void)state;
    const float dipole = 8.0f / 3.0f / (4.0f * F_PI);
    for (uint32_t i = 0; i < 3; i++) {
        const float far = 4.5f + 0.5f * (float)i, cube = far * far * far;
        assert_float_equal(cube * broadside_flow(0.0f, far, 0.0f).y, 2.0f * dipole, 0.04f);
        assert_float_equal(cube * broadside_flow(far, 0.0f, 0.0f).y, -dipole, 0.04f);
    }
}

static void test_the_flow_diverges_ahead_of_the_disc_and_converges_behind(void **state)
{
    (void)state;
    assert_true(broadside_flow(0.7f, 0.4f, 0.0f).x > 0.2f);
    assert_true(broadside_flow(0.7f, -0.4f, 0.0f).x < -0.2f);
    /* Beside the edge of the disc, the water must flow back, against the motion of the disc. */
    assert_true(broadside_flow(1.4f, 0.0f, 0.0f).y < -0.1f);
}

static void test_the_flow_conserves_volume(void **state)
{
    (void)state;
    const float step = 0.02f;
    for (uint32_t i = 0; i < 2000; i++) {
        const float x = drawn(i, 0, -3.0f, 3.0f), y = drawn(i, 1, -3.0f, 3.0f);
        const float z = drawn(i, 2, -3.0f, 3.0f);
        const float off = f_sqrt(x * x + z * z) - 1.0f;
        if (f_abs(y) < 0.1f || y * y + off * off < 0.16f) {
            /* Skips points that are next to the disc or its edge. Near the disc, the finite
             * differences would cross it, and near its edge the flow is limited. */
            continue;
        }
        const float divergence =
            broadside_flow(x + step, y, z).x - broadside_flow(x - step, y, z).x +
            broadside_flow(x, y + step, z).y - broadside_flow(x, y - step, z).y +
            broadside_flow(x, y, z + step).z - broadside_flow(x, y, z - step).z;
        assert_float_equal(divergence / (2.0f * step), 0.0f, 0.01f);
    }
}

static void test_the_flow_is_finite_and_never_faster_than_the_disc(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 20000; i++) {
        struct obstacle moving =
            disc(v3(drawn(i, 0, -4.0f, 4.0f), drawn(i, 1, -4.0f, 4.0f), drawn(i, 2, -4.0f, 4.0f)));
        moving.centre_m.y = drawn(i, 3, -0.06f, 0.03f);
        moving.normal = v3_normalize_or(
            v3(drawn(i, 4, -1.0f, 1.0f), drawn(i, 5, -1.0f, 1.0f), drawn(i, 6, -1.0f, 1.0f)),
            v3(0.0f, 1.0f, 0.0f));
        const vec3 at = v3(drawn(i, 7, -0.1f, 0.1f), drawn(i, 8, -0.1f, 0.02f), 0.0f);
        const vec3 flow = water_flow_m_s(&moving, i % 7u == 0 ? moving.centre_m : at);
        assert_true(v3_is_finite(flow));
        assert_true(v3_length(flow) <= 1.0001f * v3_length(moving.velocity_m_s));
    }
}

static void test_a_disc_in_air_or_at_rest_makes_no_flow(void **state)
{
    (void)state;
    struct obstacle moving = disc(v3(0.0f, 0.3f, 0.0f));
    const struct obstacle still = disc(v3(0.0f, 0.0f, 0.0f));
    assert_float_equal(v3_length(water_flow_m_s(&still, near_disc(0.0f, 0.5f, 0.0f))), 0.0f, 0.0f);
    moving.centre_m.y = 0.01f;
    assert_float_equal(v3_length(water_flow_m_s(&moving, v3(0.0f, -0.01f, 0.0f))), 0.0f, 0.0f);
    /* The centre of the disc is at the surface, so the disc is half submerged and moves half as
     * much water. */
    moving.centre_m.y = 0.0f;
    const float half = water_flow_m_s(&moving, v3(0.0f, -0.02f, 0.0f)).y;
    moving.centre_m.y = -0.5f;
    const float whole = water_flow_m_s(&moving, v3(0.0f, -0.52f, 0.0f)).y;
    assert_float_equal(half, 0.5f * whole, 1e-4f);
}

static void test_torn_paper_reduces_the_flow(void **state)
{
    (void)state;
    struct obstacle torn = disc(v3(0.0f, 0.3f, 0.0f));
    const float whole_m_s = water_flow_m_s(&torn, near_disc(0.0f, 0.6f, 0.0f)).y;
    /* The ring has no paper. 85 % of its area is open, so it moves 15 % of the water. */
    torn.open = 0.85f;
    assert_float_equal(water_flow_m_s(&torn, near_disc(0.0f, 0.6f, 0.0f)).y, 0.15f * whole_m_s,
                       1e-5f);
}

static void test_a_glide_along_the_plane_pushes_by_the_square_of_its_speed(void **state)
{
    (void)state;
    const struct obstacle broad = disc(v3(0.0f, 0.3f, 0.0f)), edge = disc(v3(0.3f, 0.0f, 0.0f));
    const struct obstacle slow = disc(v3(0.0f, 0.15f, 0.0f));
    const float before = water_push_m2_s2(&broad, near_disc(0.0f, 0.6f, 0.0f));
    const float ahead = water_push_m2_s2(&edge, near_disc(1.6f, 0.0f, 0.0f));
    assert_true(ahead > 0.0f);
    assert_true(ahead < 0.12f * before);
    assert_float_equal(water_push_m2_s2(&slow, near_disc(0.0f, 0.6f, 0.0f)), 0.25f * before, 1e-6f);
}

static struct tank tank;

/* Sweeps a ring for one second through a tank of fish. The flow pushes the fish, and they avoid
 * each other and flee. Returns the hash of the tank. */
static uint64_t hash_after_sweep(uint8_t lanes)
{
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.fish_count = 60;
    config.seed = 5;
    config.lanes = lanes;
    assert_true(tank_open(&tank, &config));
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        struct obstacle moving = disc(v3(0.3f, 0.0f, 0.05f));
        const vec3 step_m = v3_scale(moving.velocity_m_s, CORE_TICK_S);
        moving.centre_m = v3_muladd(v3(-0.2f, -0.06f, 0.0f), step_m, (float)tick);
        moving.normal = v3(0.8f, 0.6f, 0.0f);
        moving.axes = (struct basis){ { 0.6f, -0.8f, 0.0f }, moving.normal, { 0, 0, 1.0f } };
        moving.axes_before = moving.axes;
        moving.step_m = step_m;
        tank_tick(&tank, tick, &moving, 1);
    }
    return field_hash(HASH_START, &tank_quick_fields, &tank);
}

static void test_lanes_of_any_width_give_the_same_drift_bit_for_bit(void **state)
{
    (void)state;
    const uint64_t scalar = hash_after_sweep(0);
    assert_true(hash_after_sweep(4) == scalar);
    if (simd_is_built(8)) {
        assert_true(hash_after_sweep(8) == scalar);
    }
}

/* Places a resting fish half a radius ahead of a moving disc. Returns the drift speed that the fish
 * has in the long run. */
static vec3 carried_m_s(const struct behavior_params *params)
{
    const struct obstacle moving = disc(v3(0.0f, 0.08f, 0.0f));
    struct fish fish = pond_fish(0.05f, GAIT_REST);
    fish.position_m = near_disc(0.0f, 0.5f, 0.0f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        struct perception around = *pond_at(1, tick);
        around.params = params;
        around.size_m = v3(2.0f, 4.0f, 2.0f);
        around.obstacles = &moving;
        around.obstacle_count = 1;
        fish_behavior_tick(&fish, 0, &around);
        /* Multiplies the push by 1 - PUSH_SHARE = 0.656 in every fourth tick, as the tank does at
         * each full query of the broad phase. */
        fish.push_m_s = v3_scale(fish.push_m_s, tick % 4u == 0 ? 0.656f : 1.0f);
        fish.gait = GAIT_REST;
    }
    return fish.push_m_s;
}

static void test_the_flow_moves_fish_except_those_of_the_thesis(void **state)
{
    (void)state;
    const struct obstacle moving = disc(v3(0.0f, 0.08f, 0.0f));
    const vec3 flow = water_flow_m_s(&moving, near_disc(0.0f, 0.5f, 0.0f));
    const vec3 pond = carried_m_s(pond_params());
    const vec3 thesis = carried_m_s(&tank_preset(TANK_PRESET_THESIS)->params);
    assert_true(flow.y > 0.03f);
    assert_float_equal(pond.y - thesis.y, flow.y, 0.25f * flow.y);
    assert_float_equal(thesis.y, 0.0f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_water_at_the_face_moves_with_the_disc),
        cmocka_unit_test(test_the_flow_on_the_axis_equals_lambs_solution),
        cmocka_unit_test(test_the_far_flow_is_the_dipole_of_the_added_mass),
        cmocka_unit_test(test_the_flow_diverges_ahead_of_the_disc_and_converges_behind),
        cmocka_unit_test(test_the_flow_conserves_volume),
        cmocka_unit_test(test_the_flow_is_finite_and_never_faster_than_the_disc),
        cmocka_unit_test(test_a_disc_in_air_or_at_rest_makes_no_flow),
        cmocka_unit_test(test_torn_paper_reduces_the_flow),
        cmocka_unit_test(test_a_glide_along_the_plane_pushes_by_the_square_of_its_speed),
        cmocka_unit_test(test_lanes_of_any_width_give_the_same_drift_bit_for_bit),
        cmocka_unit_test(test_the_flow_moves_fish_except_those_of_the_thesis),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
