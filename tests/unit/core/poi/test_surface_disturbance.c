/* test_surface_disturbance.c -- what a ring does to the surface that it cuts, and what drips from
 * it. */
#include "tests/unit/support/poi_stand.h"

#include "core/poi/poi.h"

static struct stand stand; /* Too large for some stacks. */

static void tick_on(void)
{
    struct tank *tank = &stand.tank;
    stand_tick(&stand);
    surface_disturbance_tick(&stand.poi, &tank->water, tank->size_m);
    if (stand.tick % 2u == 0) {
        water_step(&tank->water, tank->size_m);
    }
}

/* Mean square of the surface's height in a box of the tank, mm^2. */
static float stir_mm2(float low_x, float high_x, float low_z, float high_z)
{
    float sum = 0.0f;
    uint32_t count = 0;
    for (float x = low_x; x < high_x; x += 0.007f) {
        for (float z = low_z; z < high_z; z += 0.007f) {
            const float mm = 1e3f * water_height_m(&stand.tank.water, stand.tank.size_m, x, z);
            sum += mm * mm;
            count++;
        }
    }
    return sum / (float)count;
}

/* Half in, its far edge down, and gone along +x for 0.5 m. */
static void plough(float speed_m_s)
{
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    stand.poi.damage_immune = 1;
    stand.hand.angles.pitch_rad = stand.poi.angles.pitch_rad = -1.2f;
    stand.hand.position_m = stand.poi.position_m = v3(-0.25f, 0.0f, 0.0f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    water_init(&stand.tank.water);
    while (stand.hand.position_m.x < 0.25f) {
        stand.hand.position_m.x += speed_m_s * CORE_TICK_S;
        tick_on();
    }
}

static void test_a_ring_that_outruns_its_ripples_draws_them_behind_it(void **state)
{
    (void)state;
    plough(0.6f);
    const float ahead = stir_mm2(0.32f, 0.42f, -0.10f, 0.10f);
    const float behind = stir_mm2(0.0f, 0.15f, -0.10f, 0.10f);
    const float aside = stir_mm2(0.10f, 0.30f, 0.15f, 0.25f);
    assert_true(behind > 0.05f);
    assert_true(ahead < 0.05f * behind);
    assert_true(aside < 0.2f * behind); /* A wedge. */
}

/* The ring as a whole presses nothing as far off as its own edge is. */
static void test_each_of_the_two_points_where_it_cuts_the_surface_is_pressed(void **state)
{
    (void)state;
    struct water *water = &stand.tank.water;
    plough(0.6f);
    water_init(water);
    stand.hand.position_m.x += 0.6f * CORE_TICK_S;
    stand_tick(&stand);
    surface_disturbance_tick(&stand.poi, water, stand.tank.size_m);
    const vec3 at = stand.poi.position_m;
    for (float side = -1.0f; side < 2.0f; side += 2.0f) {
        const float x_m = at.x + side * POI_OUTER_RADIUS_M;
        assert_true(water_height_m(water, stand.tank.size_m, x_m, at.z) < -0.0003f);
    }
    assert_float_equal(water_height_m(water, stand.tank.size_m, at.x, at.z + 0.06f), 0.0f, 1e-5f);
}

static void test_a_slow_ring_stirs_less_and_a_still_one_not_at_all(void **state)
{
    (void)state;
    plough(0.6f);
    const float fast = stir_mm2(0.0f, 0.25f, -0.15f, 0.15f);
    plough(0.1f);
    const float slow = stir_mm2(0.0f, 0.25f, -0.15f, 0.15f);
    assert_true(slow < 0.5f * fast);
    water_init(&stand.tank.water);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    water_init(&stand.tank.water);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
    }
    assert_true(stir_mm2(-0.4f, 0.4f, -0.25f, 0.25f) < 1e-6f);
}

static void test_a_wet_poi_drips_where_it_is_lowest_and_then_it_stops(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand.has_wrist = 1;
    stand_move(&stand, v3(0.0f, 0.10f, 0.0f), 0.2f);
    stand_turn(&stand, 0.0f, 0.7f, 0.1f); /* Its right side down. */
    water_init(&stand.tank.water);
    uint32_t drops = 0, late = 0;
    for (uint32_t tick = 0; tick < 24; tick++) {
        tick_on();
        drops += stand.poi.drops;
    }
    assert_true(drops > 10);
    assert_true(stir_mm2(0.02f, 0.07f, -0.03f, 0.03f) >
                3.0f * stir_mm2(-0.07f, -0.02f, -0.03f, 0.03f));
    stand_wait(&stand, 10.0f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_on();
        late += stand.poi.drops;
    }
    assert_true(late <= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_ring_that_outruns_its_ripples_draws_them_behind_it),
        cmocka_unit_test(test_each_of_the_two_points_where_it_cuts_the_surface_is_pressed),
        cmocka_unit_test(test_a_slow_ring_stirs_less_and_a_still_one_not_at_all),
        cmocka_unit_test(test_a_wet_poi_drips_where_it_is_lowest_and_then_it_stops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
