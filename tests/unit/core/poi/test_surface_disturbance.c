/* test_surface_disturbance.c -- checks the waves that a ring makes at the water surface, and the
 * drops that fall from a wet poi. */
#include "tests/unit/support/poi_fixture.h"

#include "core/poi/poi.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

static void tick_on(void)
{
    struct tank *tank = &fixture.tank;
    fixture_tick(&fixture);
    surface_disturbance_tick(&fixture.poi, &tank->water, tank->size_m);
    if (fixture.tick % 2u == 0) {
        water_step(&tank->water, tank->size_m);
    }
}

/* Returns the mean square of the wave height in the given rectangle of the tank, in mm^2. */
static float stir_mm2(float low_x, float high_x, float low_z, float high_z)
{
    float sum = 0.0f;
    uint32_t count = 0;
    for (float x = low_x; x < high_x; x += 0.007f) {
        for (float z = low_z; z < high_z; z += 0.007f) {
            const float mm = 1e3f * water_height_m(&fixture.tank.water, fixture.tank.size_m, x, z);
            sum += mm * mm;
            count++;
        }
    }
    return sum / (float)count;
}

/* Moves a ring by 0.5 m along +x. The ring is half submerged and tilted steeply. */
static void sweep_half_submerged(float speed_m_s)
{
    fixture_init(&fixture, 4, 1);
    fixture.has_wrist = 1;
    fixture.poi.damage_immune = 1;
    fixture.hand.angles.pitch_rad = fixture.poi.angles.pitch_rad = -1.2f;
    fixture.hand.position_m = fixture.poi.position_m = v3(-0.25f, 0.0f, 0.0f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    memset(&fixture.tank.water, 0, sizeof fixture.tank.water);
    while (fixture.hand.position_m.x < 0.25f) {
        fixture.hand.position_m.x += speed_m_s * CORE_TICK_S;
        tick_on();
    }
}

static void test_a_ring_faster_than_its_ripples_leaves_them_behind(void **state)
{
    (void)state;
    sweep_half_submerged(0.6f);
    const float ahead = stir_mm2(0.32f, 0.42f, -0.10f, 0.10f);
    const float behind = stir_mm2(0.0f, 0.15f, -0.10f, 0.10f);
    const float aside = stir_mm2(0.10f, 0.30f, 0.15f, 0.25f);
    assert_true(behind > 0.05f);
    assert_true(ahead < 0.05f * behind);
    /* The waves form a wedge behind the ring, so the waves at its sides must be small. */
    assert_true(aside < 0.2f * behind);
}

/* A ring that stands on its edge crosses the surface at two points, where it presses the water
 * down. The surface must stay flat at a distance of 6 cm from these points. */
static void test_a_ring_presses_the_surface_at_both_intersection_points(void **state)
{
    (void)state;
    struct water *water = &fixture.tank.water;
    sweep_half_submerged(0.6f);
    memset(water, 0, sizeof *water);
    fixture.hand.position_m.x += 0.6f * CORE_TICK_S;
    fixture_tick(&fixture);
    surface_disturbance_tick(&fixture.poi, water, fixture.tank.size_m);
    const vec3 at = fixture.poi.position_m;
    for (float side = -1.0f; side < 2.0f; side += 2.0f) {
        const float x_m = at.x + side * POI_OUTER_RADIUS_M;
        assert_true(water_height_m(water, fixture.tank.size_m, x_m, at.z) < -0.0003f);
    }
    assert_float_equal(water_height_m(water, fixture.tank.size_m, at.x, at.z + 0.06f), 0.0f, 1e-5f);
}

static void test_a_slow_ring_disturbs_less_and_a_still_ring_not_at_all(void **state)
{
    (void)state;
    sweep_half_submerged(0.6f);
    const float fast = stir_mm2(0.0f, 0.25f, -0.15f, 0.15f);
    sweep_half_submerged(0.1f);
    const float slow = stir_mm2(0.0f, 0.25f, -0.15f, 0.15f);
    assert_true(slow < 0.5f * fast);
    memset(&fixture.tank.water, 0, sizeof fixture.tank.water);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    memset(&fixture.tank.water, 0, sizeof fixture.tank.water);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    assert_true(stir_mm2(-0.4f, 0.4f, -0.25f, 0.25f) < 1e-6f);
}

static void test_a_wet_poi_drips_at_its_lowest_point_and_then_stops(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    fixture.has_wrist = 1;
    fixture_move(&fixture, v3(0.0f, 0.10f, 0.0f), 0.2f);
    /* Rolls the poi, so that the drops fall from its right side. */
    fixture_turn(&fixture, 0.0f, 0.7f, 0.1f);
    memset(&fixture.tank.water, 0, sizeof fixture.tank.water);
    uint32_t drops = 0, late = 0;
    for (uint32_t tick = 0; tick < 24; tick++) {
        tick_on();
        drops += fixture.poi.drops;
    }
    assert_true(drops > 10);
    assert_true(stir_mm2(0.02f, 0.07f, -0.03f, 0.03f) >
                3.0f * stir_mm2(-0.07f, -0.02f, -0.03f, 0.03f));
    fixture_wait(&fixture, 10.0f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
        late += fixture.poi.drops;
    }
    assert_true(late <= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_ring_faster_than_its_ripples_leaves_them_behind),
        cmocka_unit_test(test_a_ring_presses_the_surface_at_both_intersection_points),
        cmocka_unit_test(test_a_slow_ring_disturbs_less_and_a_still_ring_not_at_all),
        cmocka_unit_test(test_a_wet_poi_drips_at_its_lowest_point_and_then_stops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
